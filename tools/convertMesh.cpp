// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// convertMesh: a mesh of one form -> the same mesh in another.

#include "tools/convertMeshFiles.h"
#include "tools/toolMain.h"

namespace polymesh::tools {

namespace {

const std::vector<Option> options{
    {"in",
     "NAME",
     "mesh to read: an OpenFOAM case, or the name of STAR-CD files without .vrt, .cel, ...; also "
     "the first word that stands alone"},
    {"out", "NAME", "mesh to write, likewise; also the second word"},
    {"from", "FORM", "what -in is: foam, star4, star3; default: by what is there"},
    {"to",
     "FORM",
     "what -out is; default: foam for a directory and for STAR-CD files as input, else star4"},
    {"scale",
     "F",
     "factor of coordinates; default 1000 from foam to star4, 0.001 back, 1 to and from star3"}};

/// Says how large the mesh is and what became of it.
void report(ToolRun& tool, const Conversion& conversion, const ConvertedMesh& converted) {
    const PolyMesh& mesh = converted.mesh;
    tool.say("read       {} ({})", conversion.in.path.string(), nameOf(conversion.in.form));
    tool.say("cells      {}", mesh.cellCount);
    tool.say("faces      {}, {} of them in {} patches",
             mesh.faceCount(),
             mesh.faceCount() - mesh.internalFaceCount(),
             mesh.patches.size());
    tool.say("points     {}", mesh.pointCount());
    tool.say("cell zones {}", mesh.cellZones.size());
    tool.say("scale      {}", conversion.scale);
    tool.say("written    {} ({})", conversion.out.path.string(), nameOf(conversion.out.form));
    for (const std::string& note : converted.notes)
        fmt::print(stderr, "convertMesh: note: {}\n", note);
    tool.report["cells"] = mesh.cellCount;
    tool.report["faces"] = mesh.faceCount();
    tool.report["points"] = mesh.pointCount();
    tool.report["patches"] = mesh.patches.size();
    tool.report["cellZones"] = mesh.cellZones.size();
    tool.report["scale"] = conversion.scale;
    tool.report["notes"] = converted.notes;
}

ExitCode run(ToolRun& tool) {
    const Conversion conversion = conversionOf(tool);
    tool.clock.start("read");
    ConvertedMesh converted = readMesh(conversion);
    tool.clock.start("check mesh");
    refuseUnwritable(conversion, converted);
    tool.clock.start("write");
    writeMesh(tool, conversion, converted);
    tool.clock.start("report");
    report(tool, conversion, converted);
    return ExitCode::success;
}

} // namespace

Tool thisTool() {
    return {"convertMesh",
            "convertMesh IN OUT converts a mesh between OpenFOAM cases and STAR-CD files of "
            "version 4 and 3",
            options,
            run,
            {},
            {"in", "out"}};
}

} // namespace polymesh::tools
