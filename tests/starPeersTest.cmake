# Takes the mesh of CASE, a tutorial that has run, to STAR-CD files of version 4 and back, once with
# each of OpenFOAM's converters as the other side. Fails unless cells, faces, patches and points
# (to the digits that are printed) stay the same and OpenFOAM's checkMesh says the same of both.
# Then, split into shapes that STAR-CD accepts, to version 4, back, to version 3 and back.
# Run: cmake -DCASE=<case> -DWORK=<folder to use> -DBIN=<programs> -DSAME=<sameMesh> -P this.
file(REMOVE_RECURSE ${WORK})
foreach(name IN ITEMS given theirs back split once twice)
  file(COPY ${CASE}/system DESTINATION ${WORK}/${name})
endforeach()
file(COPY ${CASE}/constant/polyMesh DESTINATION ${WORK}/given/constant)

function(run folder)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK}/${folder}
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message("${output}")
    message(FATAL_ERROR "${ARGN}: status ${status}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

# What checkMesh says from the counts on, without the names of patches and without what the other
# beginning of loops of points changes: openness, which is round-off, and digits after the seventh.
function(verdict folder result)
  run(${folder} /usr/bin/checkMesh -allTopology -constant)
  string(REGEX REPLACE ".*\nMesh stats" "Mesh stats" text "${output}")
  string(REGEX REPLACE "\n *[^ \n]+ +([0-9]+ +[0-9]+ +)" "\n\\1" text "${text}")
  string(REGEX REPLACE "\n[^\n]*openness[^\n]*" "" text "${text}")
  string(REGEX REPLACE "([0-9]\\.0*[0-9][0-9][0-9][0-9][0-9][0-9])[0-9]+" "\\1" text "${text}")
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

if(NOT DEFINED ENV{WM_PROJECT_DIR})
  set(ENV{WM_PROJECT_DIR} /usr/share/openfoam)
endif()
# star4ToFoam of v1912 has an option -scale, but takes the coordinates as they are.
run(given ${BIN}/convertMesh . ours -scale 1)
run(theirs /usr/bin/star4ToFoam ../given/ours)
run(. ${SAME} given theirs 1e-15) # its numbers are not always rounded correctly
verdict(given said)
verdict(theirs saidOfTheirs)
if(NOT said STREQUAL saidOfTheirs)
  message("${said}\n${saidOfTheirs}")
  message(FATAL_ERROR "checkMesh says something else of what star4ToFoam made of our files")
endif()
run(given /usr/bin/foamToStarMesh)
run(back ${BIN}/convertMesh ../given/meshExport .)
run(. ${SAME} given back 1e-9) # it writes ten digits

file(COPY ${CASE}/constant/polyMesh DESTINATION ${WORK}/split/constant)
run(split ${BIN}/classifyCells -split -noFields)
if(NOT output MATCHES "\nunrecognised 0\n")
  message(FATAL_ERROR "${output}")
endif()
run(split ${BIN}/convertMesh . four)
run(once ${BIN}/convertMesh ../split/four .)
run(once ${BIN}/convertMesh . three -to star3)
run(twice ${BIN}/convertMesh ../once/three .)
run(. ${SAME} split twice 1e-8) # version 3 has 9 digits at least
