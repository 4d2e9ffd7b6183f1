// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// classifyCells: constant/polyMesh -> shape of each cell, counts, fields for ParaView; with -split
// the mesh is divided where a cell has no acceptable shape.

#include "formats/foam/polyMeshIo.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/reference/tetgen.h"
#include "libpolymesh/shapeSplit/splitCells.h"
#include "tools/classifyReport.h"
#include "tools/mpsSplitSets.h"
#include "tools/toolMain.h"

namespace polymesh::tools {

namespace {

const std::vector<Option> options{
    {"split", "", "replace each cell that STAR-CD does not accept by cells that it accepts"},
    {"listShapes", "", "print the shapes that STAR-CD accepts, and how many there are", false},
    {"noFields", "", "do not write the shape of each cell to 0/cellShape and 0/cellBaseShape"}};

/// Splits the mesh and writes it in place of the old one.
void split(ToolRun& tool, PolyMesh& mesh) {
    const foam::WriteFormat format = tool.writeFormat();
    tool.clock.start("check mesh");
    if (const std::vector<Defect> defects = validate(mesh); !defects.empty())
        throw InputError(fmt::format("{}: {}; mend the mesh first (checkMesh says more)",
                                     tool.meshDir().string(),
                                     defects.front().message));
    const TravellingSets travelling = takeSets(tool.meshDir(), mesh);
    tool.clock.start("split");
    const double volume = boundedVolume(mesh);
    const ShapeSplitCounts counts = splitUnacceptableCells(
        mesh, {{travelling.cellZones, travelling.faceZones}, tetgenTetrahedraliser()});
    const PolyMesh sets = removeSets(travelling, mesh);
    tool.clock.start("validate");
    requireValid(mesh, "the split mesh");
    tool.clock.start("write");
    foam::writePolyMesh(mesh, tool.meshDir(), format);
    writeSets(tool.meshDir(), sets);
    reportSplit(tool, counts, volume, boundedVolume(mesh));
}

ExitCode run(ToolRun& tool) {
    if (tool.settings.isOn("listShapes")) {
        listShapes(tool);
        return ExitCode::success;
    }
    const bool isSplit = tool.settings.isOn("split");
    tool.clock.start("read");
    PolyMesh mesh = foam::readPolyMesh(tool.meshDir());
    if (isSplit) split(tool, mesh);
    tool.clock.start("classify");
    const Rows<Label> facesOfCells = cellFaces(mesh);
    const std::vector<CellShape> shapes = classifyCells(mesh, facesOfCells);
    tool.clock.start("write fields");
    if (!tool.settings.isOn("noFields")) writeShapes(tool, mesh, shapes);
    tool.clock.stop();
    const Label unrecognised = reportShapes(tool, shapes);
    reportObstacles(tool, mesh, facesOfCells, shapes);
    return isSplit && unrecognised > 0 ? ExitCode::failure : ExitCode::success;
}

} // namespace

Tool thisTool() {
    return {"classifyCells",
            "recognises the cells that STAR-CD accepts, and splits the others",
            options,
            run};
}

} // namespace polymesh::tools
