// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/cutCells.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/surface/boxTree.h"
#include "libpolymesh/surface/check.h"
#include "libpolymesh/surface/triangleBoxes.h"
#include "libpolymesh/trim/coincident.h"
#include "libpolymesh/trim/dropOutside.h"
#include "libpolymesh/trim/farCells.h"
#include "libpolymesh/trim/loops.h"
#include "libpolymesh/trim/nodes.h"
#include "libpolymesh/trim/pieces.h"
#include "libpolymesh/trim/settleNodes.h"
#include "libpolymesh/trim/sharpness.h"
#include "libpolymesh/trim/simplify.h"
#include "libpolymesh/trim/touching.h"

#include <algorithm>
#include <cmath>

namespace polymesh {

namespace {

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

/// The mean of the points of a probed cell's faces.
Vec3 middleOf(const Probe& probe, Label c) {
    Vec3 sum;
    double count = 0;
    for (const Label f : probe.cellFaces[c])
        for (const Label node : probe.faceNodes[f]) {
            sum += probe.nodePoints[index(node)];
            ++count;
        }
    return sum / count;
}

/// The last place that holds the middle of each probed cell, -1 where there is none.
std::vector<Label> placesOfCells(const Probe& probe, std::span<const FidelityPlace> places) {
    std::vector<Label> placeOf(index(probe.cellCount()), -1);
    if (places.empty()) return placeOf;
    std::vector<Box> boxes;
    for (const FidelityPlace& place : places)
        boxes.push_back(place.box);
    const BoxTree tree(boxes);
    parallelFor(probe.cellCount(), [&](Label c) {
        const Vec3 middle = middleOf(probe, c);
        Label& last = placeOf[index(c)];
        tree.forEachNear({middle, middle}, [&](Label i) {
            if (boxes[index(i)].contains(middle)) last = std::max(last, i);
        });
    });
    return placeOf;
}

/// How far what is kept of the surface may be from it in each probed cell [m].
std::vector<double> tolerancesOf(std::span<const double> cellSizes,
                                 double deviation,
                                 std::span<const FidelityPlace> places,
                                 std::span<const Label> placeOf) {
    std::vector<double> tolerances(cellSizes.size());
    for (std::size_t c = 0; c < tolerances.size(); ++c) {
        const double factor = placeOf[c] < 0 ? 1 : places[index(placeOf[c])].factor;
        tolerances[c] = deviation * cellSizes[c] * factor;
    }
    return tolerances;
}

/// Marks the cells in which features are not kept.
std::vector<std::uint8_t> bluntCells(std::span<const FidelityPlace> places,
                                     std::span<const Label> placeOf) {
    std::vector<std::uint8_t> isBlunt;
    if (std::ranges::none_of(places, &FidelityPlace::isBlunt)) return isBlunt;
    for (const Label place : placeOf)
        isBlunt.push_back(place >= 0 && places[index(place)].isBlunt);
    return isBlunt;
}

Label countRemade(std::span<const FidelityPlace> places, std::span<const Label> placeOf) {
    const auto isRemade = [&](Label place) {
        return place >= 0 && (places[index(place)].factor != 1 || places[index(place)].isBlunt);
    };
    return toLabel(static_cast<std::size_t>(std::ranges::count_if(placeOf, isRemade)));
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

} // namespace

MeshCut findCut(PolyMesh& mesh,
                const FeaturedSurface& surface,
                const AdjustedNodes& adjusted,
                const TrimOptions& options) {
    const CuttingSurface& cutter = surface.cutter;
    MeshCut cut;
    options.onStage("candidates");
    const int shift = options.keep == Keep::outside ? 1 : 0;
    Probe& probe = cut.probe;
    probe = findProbe(mesh, *cutter.surface, cutter.triangleBoxes);
    cut.settled = probedNodes(probe, adjusted.settled);
    cut.cellWinding = windFarCells(mesh, probe, cutter, shift);
    dropOutside(mesh, probe, cut.cellWinding);
    addFacets(cutter.triangleBoxes, probe);

    options.onStage("edges");
    crossEdges(probe, cutter, cut.arrangement);
    windNodes(probe, cutter, shift, cut.arrangement);
    checkFarCells(mesh, probe, cut.cellWinding, cut.arrangement);

    options.onStage("faces");
    pierceFacets(probe, cutter, cut.arrangement);
    locateVertices(mesh, probe, cutter, cut.arrangement);
    cut.positions = placePoints(probe, cutter, cut.arrangement);
    return cut;
}

Pieces makePieces(PolyMesh& mesh,
                  MeshCut& cut,
                  const FeaturedSurface& featured,
                  const TrimOptions& options,
                  std::span<const FidelityPlace> places) {
    const auto& [cutter, features] = featured;
    auto& [probe, settled, cellWinding, arrangement, positions, faces] = cut;
    const TriSurface& surface = *cutter.surface;
    FaceLoops loops = faces ? faces->loops : walkFaces(probe, arrangement, positions);

    options.onStage("cells");
    const CellPieces pieces = faces ? faces->pieces : cutTriangles(probe, cutter, arrangement);

    options.onStage("simplify");
    const std::vector<double> cellSizes = probedCellSizes(probe);
    const std::vector<Label> placeOf = placesOfCells(probe, places);
    const std::vector<double> tolerances =
        tolerancesOf(cellSizes, options.deviation, places, placeOf);
    const Fidelity fidelity{options.deviation <= 0,
                            tolerances,
                            edgeSharpness(surface, cutter.edges, features),
                            features.isCorner,
                            options.featureAngle,
                            bluntCells(places, placeOf)};
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
        countRemade(places, placeOf),
        mayTouch(probe, cutter, arrangement),
        isPinched(cutter.edges),
    };
}

} // namespace polymesh
