// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/trimReport.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/mesh/boundingBox.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/surface/features.h"

#include <algorithm>

namespace polymesh::tools {

namespace {

void reportCells(ToolRun& tool, const TrimRun& run) {
    const TrimSummary& s = run.trimmed.summary;
    tool.say("cells      {}: {} untouched, {} trimmed; {} small ones merged",
             run.trimmed.mesh.cellCount,
             s.untouchedCells,
             s.trimmedCells,
             s.mergedCells);
    tool.say(
        "clean-up   {} edges collapsed, {} cuts of concave cells, {} repairs; {} bad cells left",
        s.collapsedEdges,
        s.splitCells,
        s.repairs,
        s.badCells);
    tool.report["cells"] = run.trimmed.mesh.cellCount;
    tool.report["untouched"] = s.untouchedCells;
    tool.report["trimmed"] = s.trimmedCells;
    tool.report["merged"] = s.mergedCells;
    tool.report["collapsedEdges"] = s.collapsedEdges;
    tool.report["splitCells"] = s.splitCells;
    tool.report["repairs"] = s.repairs;
    tool.report["badCells"] = s.badCells;
    tool.report["holedFaces"] = s.holedFaces;
}

/// Where the mesh lacks features of the surface, so that it is not what the user asked for.
void warnOfLostFeatures(const ToolRun& tool, const std::vector<FidelityPlace>& places) {
    const auto blunt = std::ranges::count_if(places, &FidelityPlace::isBlunt);
    if (blunt == 0) return;
    const Vec3 p = std::ranges::find_if(places, &FidelityPlace::isBlunt)->box.centre();
    tool.warn(
        "features of the surface are left out in up to {} places, where cells are too large "
        "for them, one at ({:.6g} {:.6g} {:.6g}): smaller cells there keep them; with -concave "
        "keep they stay, in cells that checkMesh may fail",
        blunt,
        p.x,
        p.y,
        p.z);
}

/// Which cells got another deviation, because with the one asked for some came out bad.
void reportRemade(ToolRun& tool, const TrimSummary& summary) {
    tool.report["remadeCells"] = summary.remadeCells;
    tool.report["remadePlaces"] = nlohmann::ordered_json::array();
    if (summary.remadeCells == 0) return;
    for (const FidelityPlace& place : summary.remadePlaces) {
        const auto& [min, max] = place.box;
        tool.report["remadePlaces"].push_back({{"min", {min.x, min.y, min.z}},
                                               {"max", {max.x, max.y, max.z}},
                                               {"factor", place.factor},
                                               {"keepsFeatures", !place.isBlunt}});
    }
    const FidelityPlace& last = summary.remadePlaces.back();
    const Vec3 middle = last.box.centre();
    tool.say("remade     {} cells with another deviation since some came out bad, one of {} places "
             "at ({:.6g} {:.6g} {:.6g}), {:g} times the deviation",
             summary.remadeCells,
             summary.remadePlaces.size(),
             middle.x,
             middle.y,
             middle.z,
             last.factor);
    warnOfLostFeatures(tool, summary.remadePlaces);
}

/// The first of the patches that the surface's regions have become.
std::size_t firstPatchOf(const TrimRun& run) {
    return run.trimmed.mesh.patches.size() - run.surface.regionNames.size();
}

ValenceCounts countNodes(const TrimRun& run) {
    const PolyMesh& mesh = run.trimmed.mesh;
    const std::size_t first = firstPatchOf(run);
    return countValences(mesh, first < mesh.patches.size() ? mesh.patches[first].start : 0);
}

/// Corners of the surface's features, and which of them the mesh has.
void findCorners(const TrimRun& run, TrimFigures& figures) {
    const SurfaceFeatures features =
        findFeatures(run.surface, pairEdges(run.surface), run.options.featureAngle);
    std::vector<Vec3> corners;
    for (std::size_t p = 0; p < features.isCorner.size(); ++p)
        if (features.isCorner[p] != 0 && run.initial.box.contains(run.surface.points[p]))
            corners.push_back(run.surface.points[p]);
    std::ranges::sort(corners);
    std::vector<char> isFound(corners.size(), 0);
    const PolyMesh& mesh = run.trimmed.mesh;
    for (Label f = mesh.internalFaceCount(); f < mesh.faceCount() && !corners.empty(); ++f)
        for (const Label p : mesh.faces[f]) {
            const auto at = std::ranges::lower_bound(corners, mesh.points[index(p)]);
            if (at != corners.end() && *at == mesh.points[index(p)])
                isFound[static_cast<std::size_t>(at - corners.begin())] = 1;
        }
    figures.cornersWithin = corners.size();
    figures.cornersFound = static_cast<std::size_t>(std::ranges::count(isFound, char{1}));
}

/// Area [m^2] of the faces of a patch.
double areaOf(const PolyMesh& mesh, const Patch& patch) {
    return parallelSum(patch.size, 0.0, [&](Label i) {
        return norm(faceGeometry(mesh.points, mesh.faces[patch.start + i]).area);
    });
}

/// How many nodes of the cells at the surface are trivalent: each of these is one hexahedron for
/// mpsSplit.
void reportNodes(ToolRun& tool, const ValenceCounts& nodes) {
    tool.say("nodes      of cells at the surface: {:.2f} % have three edges, {} have more",
             100 * nodes.trivalentShare(),
             nodes.more);
    tool.report["trivalentNodes"] = nodes.trivalent;
    tool.report["nodesOfMoreEdges"] = nodes.more;
}

void reportFeatures(ToolRun& tool, const TrimSummary& summary, const TrimFigures& figures) {
    tool.say("features   {} edges of the surface; {} of {} corners are points of the mesh",
             summary.featureEdges,
             figures.cornersFound,
             figures.cornersWithin);
    tool.report["featureEdges"] = summary.featureEdges;
    tool.report["featureCorners"] = summary.featureCorners;
    tool.report["cornersInMesh"] = figures.cornersWithin;
    tool.report["cornersCaptured"] = figures.cornersFound;
}

/// One line: a figure of the mesh, and the surface's where it should be the same.
void compare(ToolRun& tool,
             const TrimRun& run,
             const std::string& what,
             const std::string& unit,
             const std::array<double, 2>& figures) {
    const auto& [found, wanted] = figures;
    tool.report[what] = found;
    if (!run.isSurfaceWithin) {
        tool.say("{:<10} {:.12g} {}", what, found, unit);
        return;
    }
    const double error = wanted == 0 ? 0 : found / wanted - 1;
    tool.say("{:<10} {:.12g} {}; by the surface {:.12g}, relative difference {:.2g}",
             what,
             found,
             unit,
             wanted,
             error);
    tool.report[what + "Error"] = error;
}

void reportSize(ToolRun& tool, const TrimRun& run, const TrimFigures& figures) {
    const SurfaceMeasure& part = figures.surface;
    const bool isOutside = run.options.keep == Keep::outside;
    const double wanted = isOutside ? run.initial.volume - part.volume : part.volume;
    compare(tool, run, "volume", "m^3", {figures.volume, wanted});
    double area = 0;
    for (std::size_t region = 0; region < figures.patchArea.size(); ++region) {
        const Patch& patch = run.trimmed.mesh.patches[firstPatchOf(run) + region];
        area += figures.patchArea[region];
        tool.report["patches"][patch.name] = {{"faces", patch.size},
                                              {"area", figures.patchArea[region]},
                                              {"surfaceArea", part.regionArea[region]}};
    }
    compare(tool, run, "area", "m^2", {area, part.area});
    tool.report["surfaceVolume"] = part.volume;
    tool.report["surfaceArea"] = part.area;
}

void reportZones(ToolRun& tool, const InitialMesh& initial) {
    tool.report["droppedZones"] = initial.faceZones + initial.pointZones;
    if (initial.faceZones + initial.pointZones > 0)
        tool.say("zones      {} faceZones and {} pointZones are dropped (cellZones are kept)",
                 initial.faceZones,
                 initial.pointZones);
}

void reportTime(ToolRun& tool) {
    tool.clock.stop();
    std::string stages;
    for (const Stage& stage : tool.clock.stages())
        stages += fmt::format("{}{} {:.3f}", stages.empty() ? "" : ", ", stage.name, stage.seconds);
    tool.say("time       {:.3f} s: {}", tool.clock.seconds(), stages);
    tool.say("memory     {} MB at most", peakMemoryBytes() / 1000000);
}

} // namespace

InitialMesh describe(const PolyMesh& mesh) {
    return {boundingBox(mesh), boundedVolume(mesh), mesh.faceZones.size(), mesh.pointZones.size()};
}

void reportAdjust(ToolRun& tool, Adjust how, const AdjustCounts& a) {
    if (how == Adjust::none) return;
    if (how == Adjust::project)
        tool.say("adjusted   {} nodes onto corners, {} onto edges, {} onto faces; {} refused",
                 a.corners,
                 a.edges,
                 a.faces,
                 a.refused);
    else
        tool.say("adjusted   {} nodes moved away from the surface; {} refused", a.away, a.refused);
    if (how == Adjust::avoid)
        tool.say("           edges near feature edges: {} before, {} now; faces near corners: {} "
                 "before, {} now",
                 a.closeBefore.edges,
                 a.closeAfter.edges,
                 a.closeBefore.faces,
                 a.closeAfter.faces);
    tool.report["adjusted"] = {{"corners", a.corners},
                               {"edges", a.edges},
                               {"faces", a.faces},
                               {"away", a.away},
                               {"refused", a.refused}};
    if (how != Adjust::avoid) return;
    tool.report["closeEdges"] = {a.closeBefore.edges, a.closeAfter.edges};
    tool.report["closeFaces"] = {a.closeBefore.faces, a.closeAfter.faces};
}

TrimFigures measureTrim(const TrimRun& run) {
    const PolyMesh& mesh = run.trimmed.mesh;
    TrimFigures figures;
    figures.nodes = countNodes(run);
    findCorners(run, figures);
    figures.surface = measure(run.surface);
    figures.volume = boundedVolume(mesh);
    for (std::size_t p = firstPatchOf(run); p < mesh.patches.size(); ++p)
        figures.patchArea.push_back(areaOf(mesh, mesh.patches[p]));
    return figures;
}

void reportTrim(ToolRun& tool, const TrimRun& run, const TrimFigures& figures) {
    reportAdjust(tool, run.options.adjust.how, run.trimmed.summary.adjusted);
    reportCells(tool, run);
    reportRemade(tool, run.trimmed.summary);
    reportNodes(tool, figures.nodes);
    reportFeatures(tool, run.trimmed.summary, figures);
    reportSize(tool, run, figures);
    reportZones(tool, run.initial);
    reportTime(tool);
}

} // namespace polymesh::tools
