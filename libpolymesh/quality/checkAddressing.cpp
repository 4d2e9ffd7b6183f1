// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/quality/checkParts.h"

#include <numeric>

namespace polymesh {

namespace {

/// Tells which points a boundary face uses.
std::vector<char> boundaryPoints(const PolyMesh& mesh) {
    std::vector<char> isBoundary(mesh.points.size(), 0);
    for (Label face = mesh.internalFaceCount(); face < mesh.faceCount(); ++face)
        for (const Label point : mesh.faces[face])
            isBoundary[index(point)] = 1;
    return isBoundary;
}

/// The undirected edges of boundary faces, ascending.
std::vector<Edge> boundaryEdges(const PolyMesh& mesh) {
    PolyMesh boundary; // of the boundary faces alone
    boundary.points.resize(mesh.points.size());
    for (Label face = mesh.internalFaceCount(); face < mesh.faceCount(); ++face)
        boundary.faces.add(mesh.faces[face]);
    return edges(boundary);
}

void countEdges(const CheckContext& context, const std::vector<char>& isBoundary) {
    TopologyFacts& facts = context.report.topology;
    const std::vector<Edge> all = edges(context.mesh);
    const std::vector<Edge> outer = boundaryEdges(context.mesh);
    facts.edges = toLabel(all.size());
    facts.internalEdges = toLabel(all.size() - outer.size());
    for (const Edge& edge : all) {
        if (std::binary_search(outer.begin(), outer.end(), edge)) continue;
        const int ends = isBoundary[index(edge[0])] + isBoundary[index(edge[1])];
        facts.internalEdgesWithOneBoundaryPoint += ends == 1 ? 1 : 0;
        facts.internalEdgesWithTwoBoundaryPoints += ends == 2 ? 1 : 0;
    }
}

void countPoints(const CheckContext& context) {
    const std::vector<char> isBoundary = boundaryPoints(context.mesh);
    const Label internal =
        toLabel(static_cast<std::size_t>(std::count(isBoundary.begin(), isBoundary.end(), 0)));
    // Unused points count as internal but may stand anywhere.
    for (Label face = 0; face < context.mesh.internalFaceCount(); ++face)
        for (const Label point : context.mesh.faces[face])
            if (isBoundary[index(point)] == 0 && point >= internal) return;
    context.report.topology.internalPoints = internal;
    if (context.report.options.allTopology) countEdges(context, isBoundary);
}

void checkPatchRanges(const CheckContext& context) {
    const PolyMesh& mesh = context.mesh;
    Label next = mesh.internalFaceCount();
    Label emptyFaces = 0;
    for (const Patch& patch : mesh.patches) {
        if (patch.start != next) context.report.topology.boundaryDefinitionOk = false;
        next = patch.start + patch.size;
        if (patch.type == "empty") emptyFaces += patch.size;
    }
    context.report.topology.emptyFacesDivisible =
        mesh.cellCount == 0 || emptyFaces % mesh.cellCount == 0;
}

void checkPointUse(const CheckContext& context) {
    const PolyMesh& mesh = context.mesh;
    std::vector<char> used(mesh.points.size(), 0);
    for (const Label point : mesh.faces.values)
        used[index(point)] = 1;
    store(context, CheckId::unusedPoints, gather(mesh.pointCount(), [&](Label point) {
              return used[index(point)] == 0;
          }));
}

/// The higher neighbours of one cell, ascending, each with its face; stable.
std::vector<std::pair<Label, Label>> higherNeighbours(const CheckContext& context, Label cell) {
    std::vector<std::pair<Label, Label>> result;
    for (const Label face : context.facesOf[cell]) {
        if (!context.mesh.isInternal(face)) continue;
        const Label neighbour = context.mesh.neighbour[index(face)];
        const Label other = neighbour == cell ? context.mesh.owner[index(face)] : neighbour;
        if (cell < other) result.emplace_back(other, face);
    }
    std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
        return a.first < b.first;
    });
    return result;
}

/// Whether the faces to the higher neighbours ascend with them, and whether some neighbour has
/// several. Marks the faces of OpenFOAM's set.
struct CellOrder {
    bool isOrdered = true;
    bool hasMultiple = false;
};

CellOrder cellOrder(const CheckContext& context, Label cell, std::vector<Label>& marked) {
    const auto higher = higherNeighbours(context, cell);
    CellOrder result;
    for (std::size_t i = 1; i < higher.size(); ++i) {
        const auto& [previousCell, previousFace] = higher[i - 1];
        const auto& [thisCell, thisFace] = higher[i];
        if (thisCell == previousCell) {
            result.hasMultiple = true;
            marked.insert(marked.end(), {previousFace, thisFace});
        } else if (thisFace < previousFace) {
            result.isOrdered = false;
            marked.push_back(thisFace);
        }
    }
    return result;
}

void checkFaceOrder(const CheckContext& context) {
    const PolyMesh& mesh = context.mesh;
    std::vector<Label> marked = gather(mesh.internalFaceCount(), [&](Label face) {
        return mesh.owner[index(face)] >= mesh.neighbour[index(face)];
    });
    bool failed = !marked.empty();
    for (Label cell = 0; cell < mesh.cellCount; ++cell) {
        const CellOrder order = cellOrder(context, cell, marked);
        failed = failed || !order.isOrdered;
        if (order.hasMultiple) ++context.report.topology.multipleFaceCells;
    }
    std::sort(marked.begin(), marked.end());
    marked.erase(std::unique(marked.begin(), marked.end()), marked.end());
    store(context, CheckId::faceOrder, std::move(marked));
    context.report[CheckId::faceOrder].failed = failed;
}

/// How many points of a face have come before in it.
Label repeatedPoints(std::span<const Label> points) {
    Label count = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        count +=
            std::find(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i), points[i]) !=
                    points.begin() + static_cast<std::ptrdiff_t>(i)
                ? 1
                : 0;
    return count;
}

void checkFaceVertices(const CheckContext& context) {
    const std::vector<Label> repeated = valuesOf(context.mesh.faceCount(), [&](Label face) {
        return repeatedPoints(context.mesh.faces[face]);
    });
    store(context, CheckId::faceVertices, gather(context.mesh.faceCount(), [&](Label face) {
              return repeated[index(face)] > 0;
          }));
    CheckResult& result = context.report[CheckId::faceVertices];
    result.count = std::accumulate(repeated.begin(), repeated.end(), Label{0});
    result.failed = result.count > 0;
}

/// For each point of the boundary the region that uses it; regions that share one are marked.
std::vector<Label> multiRegionPoints(const PolyMesh& mesh, TopologyFacts& facts) {
    constexpr Label none = -1;
    constexpr Label several = -2;
    std::vector<Label> regionOf(mesh.points.size(), none);
    std::vector<Label> shared;
    for (Label face = mesh.internalFaceCount(); face < mesh.faceCount(); ++face) {
        const Label region = facts.cellRegion[index(mesh.owner[index(face)])];
        for (const Label point : mesh.faces[face]) {
            Label& own = regionOf[index(point)];
            if (own == none) {
                own = region;
            } else if (own == several) {
                facts.regionTouchesOther[index(region)] = true;
            } else if (own != region) {
                facts.regionTouchesOther[index(region)] = true;
                facts.regionTouchesOther[index(own)] = true;
                own = several;
                shared.push_back(point);
            }
        }
    }
    std::sort(shared.begin(), shared.end());
    return shared;
}

CellZoneFacts cellZoneFacts(const CheckContext& context, const Zone& zone) {
    CellZoneFacts facts;
    facts.name = zone.name;
    facts.cells = toLabel(zone.labels.size());
    std::vector<char> used(context.mesh.points.size(), 0);
    for (const Label cell : zone.labels) {
        facts.volume += context.geometry.cellVolumes[index(cell)];
        for (const Label face : context.facesOf[cell])
            for (const Label point : context.mesh.faces[face]) {
                facts.points += used[index(point)] == 0 ? 1 : 0;
                used[index(point)] = 1;
                facts.box.add(context.mesh.points[index(point)]);
            }
    }
    return facts;
}

} // namespace

void checkAddressing(const CheckContext& context) {
    context.report.figures.bounds = boundingBox(context.mesh.points);
    countPoints(context);
    checkPatchRanges(context);
    store(context, CheckId::cellFaces, gather(context.mesh.cellCount, [&](Label cell) {
              return context.facesOf.rowSize(cell) < 4;
          }));
    checkPointUse(context);
    checkFaceOrder(context);
    checkFaceVertices(context);
    for (const CheckId id : {CheckId::cellFaces, CheckId::unusedPoints})
        context.report[id].failed = context.report[id].count > 0;
}

void checkRegions(const CheckContext& context) {
    TopologyFacts& facts = context.report.topology;
    facts.cellRegion = cellRegions(context.mesh);
    Label count = 0;
    for (const Label region : facts.cellRegion)
        count = std::max(count, region + 1);
    facts.regionSizes.assign(index(count), 0);
    for (const Label region : facts.cellRegion)
        ++facts.regionSizes[index(region)];
    if (!context.report.options.allTopology || count < 2) return;
    facts.regionTouchesOther.assign(index(count), false);
    store(context, CheckId::multiRegionPoints, multiRegionPoints(context.mesh, facts));
}

void checkSurfaces(const CheckContext& context) {
    const PolyMesh& mesh = context.mesh;
    TopologyFacts& facts = context.report.topology;
    for (const Patch& patch : mesh.patches) {
        std::vector<Label> faces(index(patch.size));
        std::iota(faces.begin(), faces.end(), patch.start);
        facts.patches.push_back(patchTopology(mesh, patch.name, faces));
    }
    for (const Zone& zone : mesh.faceZones)
        facts.faceZones.push_back(patchTopology(mesh, zone.name, zone.labels));
    for (const Zone& zone : mesh.cellZones)
        facts.cellZones.push_back(cellZoneFacts(context, zone));
    std::vector<Label> conflicting;
    for (const auto* list : {&facts.patches, &facts.faceZones})
        for (const PatchTopology& surface : *list)
            conflicting.insert(conflicting.end(),
                               surface.conflictingPoints.begin(),
                               surface.conflictingPoints.end());
    std::sort(conflicting.begin(), conflicting.end());
    conflicting.erase(std::unique(conflicting.begin(), conflicting.end()), conflicting.end());
    store(context, CheckId::nonManifoldPoints, std::move(conflicting));
}

} // namespace polymesh
