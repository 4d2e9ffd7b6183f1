// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// trimSurface: constant/polyMesh and a surface -> trim -> constant/polyMesh.

#include "formats/foam/polyMeshIo.h"
#include "formats/surfaceIo.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/surface/check.h"
#include "libpolymesh/surface/measure.h"
#include "libpolymesh/surface/orient.h"
#include "libpolymesh/trim/trim.h"
#include "tools/toolMain.h"

#include <numbers>
#include <numeric>

namespace polymesh::tools {

namespace {

const ToolDescription description{
    "trimSurface", "trims the mesh of the case by a closed surface; regions become patches", {}};

const std::vector<Option> options{
    {"surface", "FILE", "closed surface (STL, OBJ, OFF, PLY, also .gz) [m]"},
    {"keep", "SIDE", "inside (default) or outside the surface"},
    {"deviation",
     "F",
     "largest distance of the mesh from the surface, fraction of the cell size; 0: exact; "
     "default 0.05"},
    {"featureAngle", "DEG", "keep edges of the surface sharper than this [deg]; default 30"},
    {"minEdge", "F", "collapse shorter edges, fraction of the cell size; 0: off; default 0.05"},
    {"minVolume", "F", "merge smaller cells, fraction of the uncut cell; 0: off; default 0.05"},
    {"concave", "WHAT", "split (default) or keep cells that are concave or fail checkMesh"},
    {"patchType", "TYPE", "OpenFOAM type of the surface's patches; default wall"}};

TrimOptions trimOptions(const Settings& settings) {
    TrimOptions trim;
    trim.keep = settings.word("keep", {"inside", "outside"}, "inside") == "outside" ? Keep::outside
                                                                                    : Keep::inside;
    trim.deviation = settings.numberOr(trim.deviation, "deviation", 0);
    trim.featureAngle =
        settings.numberOr(30, "featureAngle", 0, 180) * std::numbers::pi / 180; // deg to rad
    trim.minEdge = settings.numberOr(trim.minEdge, "minEdge", 0, 0.5);
    trim.minVolume = settings.numberOr(trim.minVolume, "minVolume", 0, 0.5);
    // An exact trim without clean-up stays just that.
    const bool isPlain = trim.deviation == 0 && trim.minEdge == 0 && trim.minVolume == 0;
    trim.mendsCells =
        settings.word("concave", {"split", "keep"}, isPlain ? "keep" : "split") == "split";
    return trim;
}

/// Refuses a surface that bounds nothing; turns one that is inside out; tells what it did.
void prepare(const ToolRun& tool, const std::string& file, TriSurface& surface) {
    const SurfaceDefects defects = checkSurface(surface);
    const auto& open = defects.openEdges;
    require(
        open.count == 0,
        "{}: the surface is open: {} edges without a partner, one at ({} {} {}); close the gaps "
        "(or join points that should be one) and try again",
        file,
        open.count,
        open.first.x,
        open.first.y,
        open.first.z);
    const OrientationReport turned = orientSurface(surface);
    if (turned.turnedTriangles > 0)
        tool.say("turned     {} triangles, so that normals leave the part{}",
                 turned.turnedTriangles,
                 turned.turnedAll ? " (the surface was inside out)" : "");
    const SurfaceDefects left = checkSurface(surface);
    const auto& bad = left.misorientedEdges;
    require(bad.count == 0,
            "{}: {} edges are used twice in the same direction, one at ({} {} {}), and turning "
            "triangles does not help; repair the surface",
            file,
            bad.count,
            bad.first.x,
            bad.first.y,
            bad.first.z);
}

void report(ToolRun& tool, const TriSurface& surface, const Trimmed& trimmed) {
    const TrimSummary& s = trimmed.summary;
    const PolyMesh& mesh = trimmed.mesh;
    tool.say("cells      {}: {} untouched, {} trimmed; {} small ones merged",
             mesh.cellCount,
             s.untouchedCells,
             s.trimmedCells,
             s.mergedCells);
    tool.say(
        "clean-up   {} edges collapsed, {} cuts of concave cells, {} repairs; {} bad cells left",
        s.collapsedEdges,
        s.splitCells,
        s.repairs,
        s.badCells);
    tool.say("features   {} edges, {} corners kept", s.featureEdges, s.featureCorners);
    const MeshGeometry geometry = computeGeometry(mesh);
    const SurfaceMeasure wanted = measure(surface);
    const double volume =
        std::accumulate(geometry.cellVolumes.begin(), geometry.cellVolumes.end(), 0.0);
    tool.say("volume     {:.12g} m^3 (surface: {:.12g})", volume, wanted.volume);
    tool.report["cells"] = mesh.cellCount;
    tool.report["untouched"] = s.untouchedCells;
    tool.report["trimmed"] = s.trimmedCells;
    tool.report["merged"] = s.mergedCells;
    tool.report["volume"] = volume;
    tool.report["surfaceVolume"] = wanted.volume;
}

ExitCode run(ToolRun& tool) {
    const auto file = tool.surfaceFile(tool.settings.text("surface"));
    TrimOptions how = trimOptions(tool.settings);
    how.onStage = [&](const std::string& name) { tool.clock.start(name); };
    tool.clock.start("read");
    TriSurface surface = readSurface(file);
    tool.say("surface    {}, {} triangles", file.string(), surface.triangleCount());
    const PolyMesh mesh = foam::readPolyMesh(tool.meshDir());
    tool.clock.start("check surface");
    prepare(tool, file.string(), surface);
    how.regionTypes.assign(surface.regionNames.size(), tool.settings.text("patchType", "wall"));
    const Trimmed trimmed = trim(mesh, surface, how);
    tool.clock.start("validate");
    requireValid(trimmed.mesh, "the trimmed mesh");
    tool.clock.start("write");
    foam::writePolyMesh(trimmed.mesh, tool.meshDir(), tool.writeFormat());
    tool.clock.stop();
    report(tool, surface, trimmed);
    return ExitCode::success;
}

} // namespace

} // namespace polymesh::tools

int main(int argc, char** argv) {
    using namespace polymesh::tools;
    return runTool(argc, argv, description, options, run);
}
