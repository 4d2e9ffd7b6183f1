// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/touching.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/geometry/predicates.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <span>

namespace polymesh {

namespace {

/// The triangles that lie on one face of the mesh and look the same way.
class TouchingTriangles {
public:
    TouchingTriangles(const Probe& probe, const CuttingSurface& cutter, Label face)
        : cutter_(cutter) {
        const auto nodes = probe.faceNodes[face];
        const auto at = [&](std::size_t i) { return probe.nodePoints[index(nodes[i])]; };
        Box box;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            box.add(at(i));
            if (i > 1) normal_ += cross(at(i - 1) - at(0), at(i) - at(0));
        }
        const Label cell = probe.faceCells[index(face)][0];
        for (const Label t : probe.triangles[cell]) {
            if (!overlaps(cutter.triangleBoxes[index(t)], box)) continue;
            const std::array<Vec3, 3> corners = cutter.triangle(t);
            const bool isInPlane = std::ranges::all_of(nodes, [&](Label n) {
                const Vec3& p = probe.nodePoints[index(n)];
                return orient3d(corners[0], corners[1], corners[2], p) == 0;
            });
            if (isInPlane && dot(normalOf(corners), normal_) > 0) triangles_.push_back(t);
        }
    }

    /// The region that lies on a polygon of the face, or -1. Looks between the middle of the
    /// polygon and its sides.
    Label regionOn(const PointPositions& positions, std::span<const Label> polygon) const {
        if (triangles_.empty()) return -1;
        Vec3 middle;
        for (const Label p : polygon)
            middle += positions[index(p)];
        middle = middle / static_cast<double>(polygon.size());
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vec3& a = positions[index(polygon[i])];
            const Vec3& b = positions[index(polygon[(i + 1) % polygon.size()])];
            for (const Label t : triangles_)
                if (holds(t, (a + b + middle) / 3)) return cutter_.surface->region[index(t)];
        }
        return -1;
    }

private:
    static Vec3 normalOf(const std::array<Vec3, 3>& t) { return cross(t[1] - t[0], t[2] - t[0]); }

    bool holds(Label t, const Vec3& p) const {
        const std::array<Vec3, 3> c = cutter_.triangle(t);
        for (std::size_t i = 0; i < 3; ++i)
            if (dot(cross(c[(i + 1) % 3] - c[i], p - c[i]), normal_) < 0) return false;
        return true;
    }

    const CuttingSurface& cutter_;
    Vec3 normal_;
    std::vector<Label> triangles_;
};

/// Whether a surface point lies exactly in the plane of a facet of its cell.
bool isOnFacet(const Probe& probe, Label cell, const Vec3& p) {
    for (const Label f : probe.cellFaces[cell])
        for (Label k = probe.facetOffsets[index(f)]; k < probe.facetOffsets[index(f) + 1]; ++k) {
            const auto nodes = probe.facetNodes[k];
            const auto at = [&](std::size_t i) { return probe.nodePoints[index(nodes[i])]; };
            if (orient3d(at(0), at(1), at(2), p) == 0) return true;
        }
    return false;
}

} // namespace

bool mayTouch(const Probe& probe, const CuttingSurface& cutter, const Arrangement& arrangement) {
    const auto hasZeros = [](const auto& place) { return place.zeros != 0; };
    if (std::ranges::any_of(arrangement.crossings.values, hasZeros) ||
        std::ranges::any_of(arrangement.pierces.values, hasZeros))
        return true;
    std::atomic<bool> isFound = false;
    parallelFor(cutter.surface->pointCount(), [&](Label v) {
        const Label cell = arrangement.vertexCell[index(v)];
        if (cell >= 0 && !isFound.load(std::memory_order_relaxed) &&
            isOnFacet(probe, cell, cutter.surface->points[index(v)]))
            isFound.store(true, std::memory_order_relaxed);
    });
    return isFound;
}

std::vector<Label> touchedRegions(const PolyMesh& mesh,
                                  const Probe& probe,
                                  const CuttingSurface& cutter,
                                  const PointPositions& positions,
                                  const FaceLoops& loops) {
    std::vector<Label> regions(index(loops.polygons.size()), -1);
    parallelFor(probe.faceCount(), [&](Label f) {
        const Label first = loops.offsets[index(f)];
        const Label last = loops.offsets[index(f) + 1];
        const bool isPlane = probe.facetOffsets[index(f) + 1] - probe.facetOffsets[index(f)] == 1;
        if (first == last || !isPlane || mesh.isInternal(probe.faces[index(f)])) return;
        const TouchingTriangles touching(probe, cutter, f);
        for (Label k = first; k < last; ++k)
            regions[index(k)] = touching.regionOn(positions, loops.polygons[k]);
    });
    return regions;
}

} // namespace polymesh
