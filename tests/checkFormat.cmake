# Fails when clang-format would change a source file. Run: cmake -DROOT=.. -DCLANG_FORMAT=.. -P this.
set(files "")
foreach(folder IN ITEMS libpolymesh formats tools tests benchmarks)
  file(GLOB_RECURSE found ${ROOT}/${folder}/*.h ${ROOT}/${folder}/*.cpp)
  list(APPEND files ${found})
endforeach()
execute_process(COMMAND ${CLANG_FORMAT} --dry-run --Werror ${files}
  WORKING_DIRECTORY ${ROOT} RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "run: clang-format -i on the files above")
endif()
