// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/checkCompare.h"

#include "formats/surfaceIo.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/quality/compareSurface.h"
#include "libpolymesh/quality/standardShape.h"
#include "libpolymesh/reference/tetgen.h"
#include "libpolymesh/surface/check.h"
#include "tools/repairSurface.h"
#include "tools/turnedText.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace polymesh::tools {

namespace {

using Json = nlohmann::ordered_json;

Json toJson(const DistanceFigures& d) {
    return {{"max", d.max}, {"mean", d.mean}, {"where", {d.where.x, d.where.y, d.where.z}}};
}

Json toJson(const PatchComparison& patch) {
    return {{"name", patch.name},
            {"area", patch.area},
            {"surfaceArea", patch.surfaceArea},
            {"maxDistance", std::max(patch.meshToSurface.max, patch.surfaceToMesh.max)},
            {"meanDistance", std::max(patch.meshToSurface.mean, patch.surfaceToMesh.mean)},
            {"meshToSurface", toJson(patch.meshToSurface)},
            {"surfaceToMesh", toJson(patch.surfaceToMesh)}};
}

Json toJson(const SurfaceComparison& c) {
    Json json{{"volume", c.volume},
              {"area", c.area},
              {"surfaceVolume", c.surfaceVolume},
              {"surfaceArea", c.surfaceArea},
              {"volumeError", c.volumeError()},
              {"areaError", c.areaError()},
              {"maxDistance", c.maxDistance()},
              {"meanDistance", c.meanDistance()},
              {"meshToSurface", toJson(c.meshToSurface)},
              {"surfaceToMesh", toJson(c.surfaceToMesh)},
              {"missingPatches", c.missing},
              {"patches", Json::array()}};
    for (const PatchComparison& patch : c.patches)
        json["patches"].push_back(toJson(patch));
    return json;
}

std::string distanceText(const DistanceFigures& d) {
    return fmt::format("largest {:.6g} mean {:.6g}, largest at ({:.6g} {:.6g} {:.6g})",
                       d.max,
                       d.mean,
                       d.where.x,
                       d.where.y,
                       d.where.z);
}

/// Largest relative difference between our and TetGen's volumes of cells.
struct CellAgreement {
    Label compared = 0;
    std::vector<Label> failed; // cells that TetGen could not mesh
    double maxError = 0;
    Label worstCell = -1;
};

CellAgreement compareCells(const PolyMesh& mesh) {
    const Rows<Label> facesOf = cellFaces(mesh);
    const MeshGeometry geometry = computeGeometry(mesh, facesOf);
    std::vector<Label> cells;
    for (Label cell = 0; cell < mesh.cellCount; ++cell)
        if (standardShape(mesh, cell, facesOf) != StandardShape::hexahedron) cells.push_back(cell);
    const auto volumes = tetgenVolumes(mesh, facesOf, cells);
    CellAgreement result;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (!volumes[i]) {
            result.failed.push_back(cells[i]);
            continue;
        }
        ++result.compared;
        const double error = std::abs(geometry.cellVolumes[index(cells[i])] / *volumes[i] - 1);
        if (error <= result.maxError) continue;
        result.maxError = error;
        result.worstCell = cells[i];
    }
    return result;
}

void sayCells(ToolRun& tool, const PolyMesh& mesh) {
    const CellAgreement cells = compareCells(mesh);
    tool.say("    Cells that are no hexahedra: {} compared, largest difference of volume {:.3g}{}",
             cells.compared,
             cells.maxError,
             cells.worstCell < 0 ? "" : fmt::format(" in cell {}", cells.worstCell));
    if (!cells.failed.empty())
        tool.say("    TetGen failed on {} cells, the first is cell {}",
                 cells.failed.size(),
                 cells.failed.front());
    tool.report["tetgen"]["cells"] = cells.compared;
    tool.report["tetgen"]["failedCells"] = cells.failed;
    tool.report["tetgen"]["maxCellVolumeError"] = cells.maxError;
    tool.report["tetgen"]["worstCell"] = cells.worstCell;
}

} // namespace

TriSurface readToCompare(ToolRun& tool, const std::string& file) {
    TriSurface surface = readSurface(file);
    const std::string closed =
        checkSurface(surface).openEdges.count > 0 ? closeCracks(tool, surface) : "";
    const OrientationReport turned = orientSurface(surface);
    const Finding open = checkSurface(surface).openEdges;
    tool.report["surface"]["turnedTriangles"] = turned.turnedTriangles;
    tool.report["surface"]["openEdges"] = open.count;
    tool.say("Comparing with the surface...");
    if (turned.turnedTriangles > 0) tool.say("    Turned {}", turnedText(turned));
    if (!closed.empty()) tool.say("    Closed: {}", closed);
    if (open.count == 0 && findSelfIntersections(surface, 1).count > 0)
        if (const std::string united = uniteParts(tool, surface); !united.empty())
            tool.say("    United: {}", united);
    if (open.count > 0)
        tool.say("    Open: {} edges without a partner, one at ({:.6g} {:.6g} {:.6g}); its volume "
                 "means nothing",
                 open.count,
                 open.first.x,
                 open.first.y,
                 open.first.z);
    return surface;
}

void compareWithSurface(ToolRun& tool, const PolyMesh& mesh, const TriSurface& surface) {
    const SurfaceComparison c = compareSurface(mesh, surface);
    tool.report["surface"].update(toJson(c));
    tool.say("    Volume {:.12g}, of the surface {:.12g}, relative error {:.3g}",
             c.volume,
             c.surfaceVolume,
             c.volumeError());
    tool.say("    Area {:.12g}, of the surface {:.12g}, relative error {:.3g}",
             c.area,
             c.surfaceArea,
             c.areaError());
    tool.say("    Distance mesh to surface: {}", distanceText(c.meshToSurface));
    tool.say("    Distance surface to mesh: {}", distanceText(c.surfaceToMesh));
    if (!c.patches.empty())
        tool.say("    {:<20}{:<14}{:<14}{:<14}{:<14}",
                 "Patch",
                 "Area",
                 "Surface area",
                 "Max distance",
                 "Mean distance");
    for (const PatchComparison& patch : c.patches)
        tool.say("    {:<19} {:<13.6g} {:<13.6g} {:<13.6g} {:<13.6g}",
                 patch.name,
                 patch.area,
                 patch.surfaceArea,
                 std::max(patch.meshToSurface.max, patch.surfaceToMesh.max),
                 std::max(patch.meshToSurface.mean, patch.surfaceToMesh.mean));
    for (const std::string& name : c.missing)
        tool.say("    Region {} of the surface is no patch of the mesh", name);
    tool.say("");
}

void compareWithTetgen(ToolRun& tool, const PolyMesh& mesh, const TriSurface* surface) {
    require(hasTetgen(), "option -tetgen: this program was built without TetGen");
    tool.say("Comparing with TetGen...");
    if (surface != nullptr) {
        const double ours = compareSurface(mesh, *surface).volume;
        const std::optional<double> theirs = tetgenVolume(*surface);
        if (theirs)
            tool.say("    Surface: TetGen's volume {:.12g}, ours {:.12g}, relative error {:.3g}",
                     *theirs,
                     ours,
                     ours / *theirs - 1);
        else
            tool.say("    Surface: TetGen failed on it");
        tool.report["tetgen"]["surfaceVolume"] = theirs ? Json(*theirs) : Json();
        tool.report["tetgen"]["volumeError"] = theirs ? Json(ours / *theirs - 1) : Json();
    }
    sayCells(tool, mesh);
    tool.say("");
}

} // namespace polymesh::tools
