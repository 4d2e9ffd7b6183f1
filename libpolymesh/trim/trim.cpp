// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/trim.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/cleanUp.h"
#include "libpolymesh/quality/collapsePoints.h"
#include "libpolymesh/quality/editQuality.h"
#include "libpolymesh/quality/meshEditor.h"
#include "libpolymesh/quality/removeZeroSize.h"
#include "libpolymesh/surface/check.h"
#include "libpolymesh/surface/features.h"
#include "libpolymesh/surface/triangleBoxes.h"
#include "libpolymesh/trim/adjustNodes.h"
#include "libpolymesh/trim/arrangement.h"
#include "libpolymesh/trim/assemble.h"
#include "libpolymesh/trim/coincident.h"
#include "libpolymesh/trim/dropOutside.h"
#include "libpolymesh/trim/editPart.h"
#include "libpolymesh/trim/farCells.h"
#include "libpolymesh/trim/flatFlaps.h"
#include "libpolymesh/trim/loops.h"
#include "libpolymesh/trim/nodes.h"
#include "libpolymesh/trim/pieces.h"
#include "libpolymesh/trim/settleNodes.h"
#include "libpolymesh/trim/sharpness.h"
#include "libpolymesh/trim/simplify.h"
#include "libpolymesh/trim/touching.h"
#include "libpolymesh/trim/trimmedCells.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace polymesh {

namespace {

void turnInsideOut(TriSurface& surface) {
    for (auto& triangle : surface.triangles)
        std::swap(triangle[1], triangle[2]);
}

/// Edge length of the cube with the volume of each probed cell [m].
std::vector<double> probedCellSizes(const Probe& probe) {
    std::vector<double> sizes(probe.cells.size());
    parallelFor(probe.cellCount(), [&](Label c) {
        double volume = 0;
        const Label firstNode = probe.faceNodes[probe.cellFaces[c][0]][0];
        const Vec3& apex = probe.nodePoints[index(firstNode)];
        for (const Label f : probe.cellFaces[c]) {
            const auto nodes = probe.faceNodes[f];
            double cone = 0;
            for (std::size_t i = 1; i + 1 < nodes.size(); ++i)
                cone += dot(probe.nodePoints[index(nodes[0])] - apex,
                            cross(probe.nodePoints[index(nodes[i])] - apex,
                                  probe.nodePoints[index(nodes[i + 1])] - apex));
            volume += probe.faceCells[index(f)][0] == c ? cone : -cone;
        }
        sizes[index(c)] = std::cbrt(std::max(volume / 6, 0.0));
    });
    return sizes;
}

void refuseBroken(Label cells) {
    if (cells == 0) return;
    throw WorkError(
        fmt::format("clean-up left {} cells open; please report this surface and mesh", cells));
}

Label countBroken(const EditMesh& mesh) {
    Label count = 0;
    for (Label c = 0; c < toLabel(mesh.cells.size()); ++c) {
        const EditCell& cell = mesh.cells[index(c)];
        const bool isChecked = !cell.frozen && !cell.isRemoved();
        count += isChecked && cellShape(mesh, c) == CellShape::broken ? 1 : 0;
    }
    return count;
}

/// Takes away what has no thickness between the surface and faces of the mesh on which it lies.
void tidyTouchingFaces(EditPart& part, TrimSummary& summary) {
    MeshEditor editor(part.mesh);
    const CollapseCounts collapsed = collapsePoints(editor, part.representative);
    const ZeroSizeCounts zero = removeZeroSize(editor);
    removeFlatFlaps(editor);
    // Points that fall together but for rounding can leave a cell open until they are joined.
    if (collapsed.brokenCells > 0) refuseBroken(countBroken(part.mesh));
    summary.mergedCells += collapsed.removedCells + zero.cells;
}

/// Collapses what coincides, then what the user wants cleaned up.
void tidy(EditPart& part, const TrimOptions& options, TrimSummary& summary) {
    const CleanUpCounts counts = cleanUp(part.mesh,
                                         part.representative,
                                         {.minEdge = options.minEdge,
                                          .minVolume = options.minVolume,
                                          .mendsCells = options.mendsCells});
    summary.mergedCells += counts.zeroCells + counts.mergedCells;
    summary.collapsedEdges = counts.collapsedEdges;
    summary.splitCells = counts.cutCells;
    summary.repairs = counts.repairs;
    summary.badCells = counts.badCells;
    refuseBroken(counts.brokenCells);
}

void count(const EditPart& part, const PolyMesh& result, TrimSummary& summary) {
    Label cut = 0;
    for (Label c = 0; c < part.cutCellCount; ++c)
        if (!part.mesh.cells[index(c)].isRemoved()) ++cut;
    summary.trimmedCells = cut;
    summary.untouchedCells = result.cellCount - cut;
}

/// Throws where the surface intersects itself: what has failed then is its fault.
void refuseSelfIntersections(const TriSurface& surface) {
    const SelfIntersections found = findSelfIntersections(surface, 1);
    if (found.count == 0) return;
    const std::vector<Box> boxes = triangleBoxes(surface);
    const Box& a = boxes[index(found.first[0][0])];
    const Box& b = boxes[index(found.first[0][1])];
    Vec3 place;
    for (int axis = 0; axis < 3; ++axis)
        place[axis] = (std::max(a.min[axis], b.min[axis]) + std::min(a.max[axis], b.max[axis])) / 2;
    throw InputError(
        fmt::format("the surface intersects itself near ({} {} {}) ({} pairs of triangles do), so "
                    "that cells cannot be closed; repair the surface (unite overlapping parts) and "
                    "try again",
                    place.x,
                    place.y,
                    place.z,
                    found.count));
}

TrimmedCells divideOrRefuse(const TriSurface& surface,
                            const Probe& probe,
                            const PointPositions& positions,
                            const FaceLoops& loops,
                            const BoundaryPolygons& boundary) {
    try {
        return divideCells(probe, positions, loops, boundary);
    } catch (const WorkError&) {
        refuseSelfIntersections(surface);
        throw;
    }
}

/// A trimmed mesh, and boxes round the cells that came out bad, wider by half a cell [m].
struct Cut {
    Trimmed trimmed;
    std::vector<Box> badPlaces;
    bool isOpen = false; // there is no mesh: those cells do not close
};

/// The places of the cells that are open, or else of those that checkMesh fails.
std::vector<Box> findBadPlaces(EditPart& part, bool isOpen) {
    std::vector<Box> places;
    MeshEditor editor(part.mesh);
    for (Label c = 0; c < editor.cellCount(); ++c) {
        const EditCell& cell = editor.cell(c);
        if (cell.frozen || cell.isRemoved()) continue;
        const bool isBad =
            isOpen ? cellShape(part.mesh, c) == CellShape::broken : isFailing(editor, c);
        if (!isBad) continue;
        Box box;
        for (const Label f : cell.faces)
            for (const Label p : editor.face(f).points)
                box.add(editor.point(p));
        const Vec3 half = 0.5 * cell.size * Vec3{1, 1, 1};
        places.push_back({box.min - half, box.max + half});
    }
    return places;
}

/// The pieces of the cells as the surface cuts them, before clean-up.
struct Pieces {
    EditPart part;
    Label holedFaces = 0;
    bool mayTouch = false; // the surface may lie on faces of the mesh
};

/// Finds the pieces; cells that are far outside go from the mesh.
Pieces cutCells(PolyMesh& mesh,
                const CuttingSurface& cutter,
                const SurfaceFeatures& features,
                const AdjustedNodes& adjusted,
                const TrimOptions& options) {
    const TriSurface& surface = *cutter.surface;
    options.onStage("candidates");
    const int shift = options.keep == Keep::outside ? 1 : 0;
    Probe probe = findProbe(mesh, surface, cutter.triangleBoxes);
    const std::vector<SettledNode> settled = probedNodes(probe, adjusted.settled);
    std::vector<std::int8_t> cellWinding = windFarCells(mesh, probe, cutter, shift);
    dropOutside(mesh, probe, cellWinding);
    addFacets(cutter.triangleBoxes, probe);

    options.onStage("edges");
    Arrangement arrangement;
    crossEdges(probe, cutter, arrangement);
    windNodes(probe, cutter, shift, arrangement);
    checkFarCells(mesh, probe, cellWinding, arrangement);

    options.onStage("faces");
    pierceFacets(probe, cutter, arrangement);
    locateVertices(mesh, probe, cutter, arrangement);
    PointPositions positions = placePoints(probe, cutter, arrangement);
    FaceLoops loops = walkFaces(probe, arrangement, positions);

    options.onStage("cells");
    const CellPieces pieces = cutTriangles(probe, cutter, arrangement);

    options.onStage("simplify");
    const std::vector<double> cellSizes = probedCellSizes(probe);
    const Fidelity fidelity{options.deviation,
                            edgeSharpness(surface, cutter.edges, features),
                            features.isCorner,
                            options.featureAngle,
                            cellSizes};
    const BoundaryPolygons boundary =
        simplify({probe, cutter, arrangement}, positions, pieces, fidelity, loops);
    const TrimmedCells cells = divideOrRefuse(surface, probe, positions, loops, boundary);

    options.onStage("clean up");
    const auto joined = pointsAtNodes(probe, cutter, features, {arrangement, positions}, settled);
    placeSettled(settled, mesh, probe, positions);
    const TrimResult found{mesh,
                           probe,
                           cutter,
                           arrangement,
                           positions,
                           loops,
                           boundary,
                           cells,
                           touchedRegions(mesh, probe, cutter, positions, loops),
                           cellWinding,
                           cellSizes,
                           settled,
                           options.minEdge};
    return {
        buildEditPart(found, features, mergeCoincident(probe, cutter, arrangement, joined)),
        loops.holeCount,
        mayTouch(probe, cutter, arrangement),
    };
}

/// Trims a mesh whose nodes have been adjusted.
Cut cutMesh(PolyMesh mesh,
            const CuttingSurface& cutter,
            const SurfaceFeatures& features,
            const AdjustedNodes& adjusted,
            const TrimOptions& options) {
    Cut cut;
    Trimmed& result = cut.trimmed;
    const TriSurface& surface = *cutter.surface;
    auto [part, holedFaces, mayTouch] = cutCells(mesh, cutter, features, adjusted, options);
    result.summary.adjusted = adjusted.counts;
    result.summary.holedFaces = holedFaces;
    try {
        if (mayTouch) tidyTouchingFaces(part, result.summary);
        tidy(part, options, result.summary);
    } catch (const WorkError&) {
        if (adjusted.moved.empty()) throw;
        return {{}, findBadPlaces(part, true), true};
    }
    if (!adjusted.moved.empty() && result.summary.badCells > 0)
        cut.badPlaces = findBadPlaces(part, false);

    options.onStage("assemble");
    std::vector<std::string> types = options.regionTypes;
    types.resize(surface.regionNames.size(), "wall");
    result.mesh = assemble(mesh, part, surface.regionNames, types);
    require(result.mesh.cellCount > 0,
            "nothing is left: the surface and the mesh have no volume in common on the side to "
            "keep; check the surface's unit and place, and -keep");
    count(part, result.mesh, result.summary);
    result.summary.featureEdges =
        toLabel(static_cast<std::size_t>(std::ranges::count(features.isFeature, char{1})));
    result.summary.featureCorners =
        toLabel(static_cast<std::size_t>(std::ranges::count(features.isCorner, char{1})));
    return cut;
}

/// Adds the moved nodes that are in one of the boxes to `kept`; false when there are none.
bool keepNodes(const AdjustedNodes& adjusted,
               const std::vector<Box>& boxes,
               std::vector<Label>& kept) {
    const std::size_t before = kept.size();
    for (const MovedNode& node : adjusted.moved)
        if (std::ranges::any_of(boxes, [&](const Box& box) { return box.contains(node.place); }))
            kept.push_back(node.node);
    std::ranges::sort(kept);
    return kept.size() > before;
}

/// Adjusts nodes and trims. Where that leaves bad cells it is done again without the
/// nodes round these, and the best result counts; if there is none, no node is moved.
Trimmed trimAdjusted(const PolyMesh& mesh,
                     const CuttingSurface& cutter,
                     const SurfaceFeatures& features,
                     TrimOptions options) {
    constexpr int mostTries = 4;
    std::optional<Trimmed> best;
    for (int i = 0; i < mostTries; ++i) {
        PolyMesh moved = mesh;
        const AdjustedNodes adjusted = adjustNodes(moved, cutter, features, options.adjust);
        Cut cut = cutMesh(std::move(moved), cutter, features, adjusted, options);
        if (!cut.isOpen && (!best || cut.trimmed.summary.badCells < best->summary.badCells))
            best = std::move(cut.trimmed);
        if (!keepNodes(adjusted, cut.badPlaces, options.adjust.kept)) break;
        if (i == 0) options.onStage("try again");
        options.onStage = [](const std::string&) {};
    }
    return best ? std::move(*best) : cutMesh(mesh, cutter, features, {}, options).trimmed;
}

} // namespace

Trimmed trim(PolyMesh mesh, TriSurface surface, const TrimOptions& options) {
    options.onStage("features");
    if (options.keep == Keep::outside) turnInsideOut(surface);
    const CuttingSurface cutter{&surface, pairEdges(surface), triangleBoxes(surface)};
    const SurfaceFeatures features = findFeatures(surface, cutter.edges, options.featureAngle);
    if (options.adjust.how == Adjust::none)
        return cutMesh(std::move(mesh), cutter, features, {}, options).trimmed;
    options.onStage("adjust");
    return trimAdjusted(mesh, cutter, features, options);
}

} // namespace polymesh
