// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/error.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/geometry/predicates.h"
#include "libpolymesh/trim/arrangement.h"

#include <boost/container/small_vector.hpp>

#include <algorithm>

namespace polymesh {

namespace {

/// A facet with what every test on it needs.
struct FacetView {
    boost::container::small_vector<Vec3, 8> points;
    std::array<Vec3, 3> plane; // three points that are not collinear, unless all are
    Box box;
};

void setPlane(FacetView& view) {
    const auto& points = view.points;
    view.plane = {points[0], points[1], points[2]};
    for (std::size_t i = 3; i < points.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis)
            if (normalSign(view.plane[0], view.plane[1], view.plane[2], axis) != 0) return;
        view.plane[2] = points[i];
    }
}

void setView(const Probe& probe, Label facet, FacetView& view) {
    view.points.clear();
    view.box = Box{};
    for (const Label n : probe.facetNodes[facet]) {
        view.points.push_back(probe.nodePoints[index(n)]);
        view.box.add(view.points.back());
    }
    setPlane(view);
}

/// Appends the pierce of the facet by a surface edge, if there is one.
void pierce(const FacetView& view,
            const CuttingSurface& cutter,
            Label facet,
            Label edge,
            std::vector<FacePierce>& found) {
    const SurfaceEdge& ends = cutter.edges.edges[index(edge)];
    const Vec3& p = cutter.surface->points[index(ends.start)];
    const Vec3& q = cutter.surface->points[index(ends.end)];
    Box box;
    box.add(p);
    box.add(q);
    if (!overlaps(box, view.box)) return;
    const MovedSign atP = sideOfMeshPlane(view.plane, p);
    const MovedSign atQ = sideOfMeshPlane(view.plane, q);
    if (atP.sign == atQ.sign) return;
    std::uint32_t zeros = (atP.wasZero ? 1U : 0U) | (atQ.wasZero ? 2U : 0U);
    std::int8_t side = 0;
    const std::size_t n = view.points.size();
    for (std::size_t i = 0; i < n; ++i) {
        const MovedSign passing = passingSide(view.points[i], view.points[(i + 1) % n], p, q);
        if (i > 0 && passing.sign != side) return;
        side = passing.sign;
        if (passing.wasZero) zeros |= 4U << std::min<std::size_t>(i, 29);
    }
    found.push_back({edge, facet, atQ.sign, zeros});
}

/// The local cell whose triangles are looked at for a face.
Label searchCell(const Probe& probe, Label face) {
    const auto& cells = probe.faceCells[index(face)];
    if (cells[0] < 0) return cells[1];
    if (cells[1] < 0) return cells[0];
    return probe.triangles.rowSize(cells[0]) <= probe.triangles.rowSize(cells[1]) ? cells[0]
                                                                                  : cells[1];
}

void findPierces(const Probe& probe, const CuttingSurface& cutter, Arrangement& arrangement) {
    constexpr Label block = 1024;
    std::vector<Rows<FacePierce>> parts(index((probe.facetCount() + block - 1) / block));
    parallelBlocks(probe.facetCount(), block, [&](Label part, Label first, Label last) {
        std::vector<FacePierce> found;
        FacetView view;
        for (Label k = first; k < last; ++k) {
            found.clear();
            setView(probe, k, view);
            // A surface edge that pierces the facet brings both its triangles' boxes here.
            for (const Label t : probe.triangles[searchCell(probe, probe.facetFace[index(k)])]) {
                if (!overlaps(cutter.triangleBoxes[index(t)], view.box)) continue;
                for (const Label e : cutter.edges.ofTriangle[index(t)])
                    if (cutter.edges.edges[index(e)].left == t) pierce(view, cutter, k, e, found);
            }
            parts[index(part)].add(found);
        }
    });
    arrangement.pierces = joined(parts);
}

/// One end of a segment, before the two are brought together.
struct SegmentEnd {
    Label triangle;
    Label point;
    bool isFrom;
};

/// Lists the ends of the facet's segments. With N the facet's normal and n the triangle's, the
/// segment runs along N x n: it leaves the facet's outline where that passes out of the domain, and
/// the triangle's outline where that goes against N.
void listEnds(const Probe& probe,
              const CuttingSurface& cutter,
              const Arrangement& arrangement,
              Label facet,
              std::vector<SegmentEnd>& ends) {
    const auto nodes = probe.facetNodes[facet];
    const Label firstCorner = probe.facetNodes.offsets[index(facet)];
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Label e = probe.facetEdges[index(firstCorner) + i];
        const bool isForward = probe.edges[index(e)][0] == nodes[i];
        for (Label x = arrangement.crossings.offsets[index(e)];
             x < arrangement.crossings.offsets[index(e) + 1];
             ++x) {
            const EdgeCrossing& crossing = arrangement.crossings.values[index(x)];
            const bool leavesDomain = (crossing.sign < 0) == isForward;
            ends.push_back({crossing.triangle, arrangement.firstCrossing() + x, leavesDomain});
        }
    }
    for (Label x = arrangement.pierces.offsets[index(facet)];
         x < arrangement.pierces.offsets[index(facet) + 1];
         ++x) {
        const FacePierce& pierce = arrangement.pierces.values[index(x)];
        const SurfaceEdge& edge = cutter.edges.edges[index(pierce.edge)];
        ends.push_back({edge.left, arrangement.firstPierce() + x, pierce.sign < 0});
        ends.push_back({edge.right, arrangement.firstPierce() + x, pierce.sign > 0});
    }
}

[[noreturn]] void refuseFacet(const Probe& probe, Label facet) {
    const Vec3& p = probe.nodePoints[index(probe.facetNodes[facet][0])];
    throw WorkError(
        fmt::format("the surface and the mesh face at ({} {} {}) meet in a line without "
                    "two ends; please report this surface and mesh",
                    p.x,
                    p.y,
                    p.z));
}

void findSegments(const Probe& probe, const CuttingSurface& cutter, Arrangement& arrangement) {
    constexpr Label block = 1024;
    std::vector<Rows<Segment>> parts(index((probe.facetCount() + block - 1) / block));
    parallelBlocks(probe.facetCount(), block, [&](Label part, Label first, Label last) {
        std::vector<SegmentEnd> ends;
        std::vector<Segment> found;
        for (Label k = first; k < last; ++k) {
            ends.clear();
            found.clear();
            listEnds(probe, cutter, arrangement, k, ends);
            std::ranges::sort(ends, [](const SegmentEnd& a, const SegmentEnd& b) {
                return a.triangle != b.triangle ? a.triangle < b.triangle : a.isFrom > b.isFrom;
            });
            if (ends.size() % 2 != 0) refuseFacet(probe, k);
            for (std::size_t i = 0; i < ends.size(); i += 2) {
                const bool isPair = ends[i].triangle == ends[i + 1].triangle && ends[i].isFrom &&
                                    !ends[i + 1].isFrom;
                if (!isPair) refuseFacet(probe, k);
                found.push_back({ends[i].triangle, ends[i].point, ends[i + 1].point});
            }
            std::ranges::sort(found, {}, &Segment::from);
            parts[index(part)].add(found);
        }
    });
    arrangement.segments = joined(parts);
}

} // namespace

void pierceFacets(const Probe& probe, const CuttingSurface& cutter, Arrangement& arrangement) {
    findPierces(probe, cutter, arrangement);
    findSegments(probe, cutter, arrangement);
}

} // namespace polymesh
