// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// mpsSplit: constant/polyMesh -> mid-point subdivision -> constant/polyMesh.

#include "formats/foam/polyMeshIo.h"
#include "formats/surfaceIo.h"
#include "libpolymesh/mps/makeDivisible.h"
#include "libpolymesh/mps/projectBoundary.h"
#include "libpolymesh/mps/relaxPoints.h"
#include "libpolymesh/reference/tetgen.h"
#include "libpolymesh/surface/orient.h"
#include "tools/mpsSplitReport.h"
#include "tools/mpsSplitSets.h"
#include "tools/toolMain.h"

namespace polymesh::tools {

namespace {

const std::vector<Option> options{
    surfaceOption("put new boundary points, where that inverts nothing, onto this closed surface"),
    {"featureAngle", "DEG", "with -surface: edges sharper than this are kept [deg]; default 30"},
    {"only",
     "polyhedra",
     "leave hexahedra alone but those next to what is divided, which become a layer of pyramids "
     "and tetrahedra"}};

void project(ToolRun& tool, Divisible& divisible) {
    if (!tool.settings.has("surface")) return;
    const std::string file = tool.surfaceFile(tool.settings.text("surface")).string();
    tool.clock.start("project");
    TriSurface surface = readSurface(file);
    orientSurface(surface); // as trimSurface does
    reportProjection(
        tool,
        projectBoundary(
            divisible.mesh, divisible.plan, surface, tool.settings.angle("featureAngle", 30)));
}

/// Whether hexahedra stay. Throws InputError where they cannot.
bool keepsHexahedra(const ToolRun& tool, const PolyMesh& mesh) {
    if (!tool.settings.has("only")) return false;
    tool.settings.word("only", {"polyhedra"}, "polyhedra");
    for (const Patch& patch : mesh.patches)
        require(!patch.type.starts_with("cyclic"),
                "{}: patch {} is {}: the two sides of cyclic patches could be divided differently; "
                "leave the option out",
                tool.settings.place("only"),
                patch.name,
                patch.type);
    return true;
}

/// Divides as planned, all cells or what is no hexahedron, moves new points for the sake of
/// quality, and puts down the figures.
PolyMesh
divideAsAsked(ToolRun& tool, Divisible& divisible, bool keepsHexahedra, MpsFigures& figures) {
    if (!keepsHexahedra) {
        const std::vector<char> isGood = partsOfBoxes(divisible.mesh, divisible.plan);
        PolyMesh result = divide(divisible.mesh, std::move(divisible.plan));
        tool.clock.start("relax");
        figures.relaxed = relaxPoints(result, divisible.mesh.pointCount(), isGood);
        return result;
    }
    const std::vector<Fate> fates = fatesOf(divisible.mesh, divisible.plan, divisible.bends);
    const PolyMesh divided = divide(divisible.mesh, std::move(divisible.plan));
    PartlyDivided partly = keepHexahedra(divisible, fates, divided);
    takeOnlyDivided(divisible, fates, partly, figures);
    tool.clock.start("relax");
    figures.relaxed = relaxPoints(partly.mesh, divisible.mesh.pointCount());
    return std::move(partly.mesh);
}

ExitCode run(ToolRun& tool) {
    const foam::WriteFormat format = tool.writeFormat();
    tool.clock.start("read");
    PolyMesh mesh = foam::readPolyMesh(tool.meshDir());
    tool.clock.start("check mesh");
    refuseInvalid(tool, mesh);
    const bool keeps = keepsHexahedra(tool, mesh);
    const TravellingSets travelling = takeSets(tool.meshDir(), mesh);
    tool.clock.start("plan");
    const UndividedMesh undivided = describe(mesh);
    Divisible divisible =
        makeDivisible(std::move(mesh),
                      {{travelling.cellZones, travelling.faceZones}, tetgenTetrahedraliser()},
                      keeps ? Hexahedra::kept : Hexahedra::divided);
    project(tool, divisible);
    MpsFigures figures = figuresOf(undivided, divisible);
    tool.clock.start("divide");
    PolyMesh result = divideAsAsked(tool, divisible, keeps, figures);
    const PolyMesh sets = removeSets(travelling, result);
    tool.clock.start("validate");
    requireConformal(result, figures);
    tool.clock.start("write");
    foam::writePolyMesh(result, tool.meshDir(), format);
    writeSets(tool.meshDir(), sets);
    tool.clock.start("report");
    return reportSplit(tool, figures, result) ? ExitCode::success : ExitCode::failure;
}

} // namespace

Tool thisTool() {
    return {"mpsSplit",
            "divides every cell of the mesh into hexahedra and a few pyramids",
            options,
            run};
}

} // namespace polymesh::tools
