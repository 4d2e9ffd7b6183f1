// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/loops.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/trim/bridges.h"

#include <algorithm>
#include <span>

namespace polymesh {

namespace {

/// A node or a crossing on the outline of a face, in the outline's direction.
struct OutlineItem {
    Label point = -1;
    bool isNode = false;
    bool insideBefore = false;
    bool insideAfter = false;
    bool isDone = false; // the part of the outline after it has been walked
};

/// What the walks read.
struct Plan {
    const Probe& probe;
    const Arrangement& arrangement;
    const PointPositions& positions;
};

/// Everything needed to walk one face (or one facet, when a face is done by facets).
struct Walk {
    std::vector<OutlineItem> outline;
    std::vector<Segment> segments; // by ascending `from`
    std::vector<std::uint8_t> isUsed;
    CurvesOnFace curves; // the closed ones are of pierces and inner crossings alone

    void clear() {
        outline.clear();
        segments.clear();
        curves.polygons.clear();
        curves.closed.clear();
    }
};

bool isInside(int winding) {
    return winding >= 1;
}

void addOutline(const Plan& plan,
                std::span<const Label> nodes,
                std::span<const Label> edges,
                Walk& walk) {
    const Arrangement& arrangement = plan.arrangement;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const std::int8_t ofNode = arrangement.winding[index(nodes[i])];
        int winding = ofNode;
        walk.outline.push_back({nodes[i], true, isInside(winding), isInside(winding), false});
        const Label e = edges[i];
        const bool isForward = plan.probe.edges[index(e)][0] == nodes[i];
        const Label first = arrangement.crossings.offsets[index(e)];
        const Label last = arrangement.crossings.offsets[index(e) + 1];
        for (Label k = 0; k < last - first; ++k) {
            const Label x = isForward ? first + k : last - 1 - k;
            const bool before = isInside(winding);
            const int sign = arrangement.crossings.values[index(x)].sign;
            winding += isForward ? sign : -sign;
            walk.outline.push_back(
                {arrangement.firstCrossing() + x, false, before, isInside(winding), false});
        }
    }
}

[[noreturn]] void refuseFace(const Vec3& p) {
    throw InputError(fmt::format(
        "the surface intersects itself near ({} {} {}), so that inside and outside are not defined "
        "there; repair the surface (unite overlapping parts) and try again",
        p.x,
        p.y,
        p.z));
}

/// The place in walk.segments of the segment that begins at a point, or -1.
std::ptrdiff_t segmentFrom(const Walk& walk, Label point) {
    const auto found = std::ranges::lower_bound(walk.segments, point, {}, &Segment::from);
    if (found == walk.segments.end() || found->from != point) return -1;
    return found - walk.segments.begin();
}

/// Follows the curve that begins at the crossing `start` to the outline; returns the item there.
std::size_t
followCurve(Walk& walk, Label start, const PointPositions& positions, LoopPolygon& loop) {
    Label at = start;
    while (true) {
        const std::ptrdiff_t s = segmentFrom(walk, at);
        if (s < 0 || walk.isUsed[static_cast<std::size_t>(s)] != 0)
            refuseFace(positions[index(at)]);
        walk.isUsed[static_cast<std::size_t>(s)] = 1;
        at = walk.segments[static_cast<std::size_t>(s)].to;
        const auto item = std::ranges::find(walk.outline, at, &OutlineItem::point);
        if (item != walk.outline.end()) {
            if (item->insideBefore || !item->insideAfter) refuseFace(positions[index(at)]);
            return static_cast<std::size_t>(item - walk.outline.begin());
        }
        loop.push_back(at);
    }
}

void walkOutline(Walk& walk, const PointPositions& positions) {
    const std::size_t n = walk.outline.size();
    for (std::size_t start = 0; start < n; ++start) {
        if (walk.outline[start].isDone || !walk.outline[start].insideAfter) continue;
        LoopPolygon loop;
        std::size_t i = start;
        while (!walk.outline[i].isDone) {
            OutlineItem& item = walk.outline[i];
            item.isDone = true;
            const bool isStatusKept = item.insideBefore == item.insideAfter;
            if (item.isNode || !isStatusKept) loop.push_back(item.point);
            i = (i + 1) % n;
            const OutlineItem& next = walk.outline[i];
            if (next.insideBefore && !next.insideAfter) {
                loop.push_back(next.point);
                i = followCurve(walk, next.point, positions, loop);
            }
        }
        if (i != start) refuseFace(positions[index(walk.outline[i].point)]);
        walk.curves.polygons.push_back(std::move(loop));
    }
}

void walkClosedCurves(Walk& walk) {
    for (std::size_t s = 0; s < walk.segments.size(); ++s) {
        if (walk.isUsed[s] != 0) continue;
        LoopPolygon loop;
        auto at = static_cast<std::ptrdiff_t>(s);
        while (at >= 0 && walk.isUsed[static_cast<std::size_t>(at)] == 0) {
            const Segment& segment = walk.segments[static_cast<std::size_t>(at)];
            walk.isUsed[static_cast<std::size_t>(at)] = 1;
            loop.push_back(segment.from);
            at = segmentFrom(walk, segment.to);
        }
        // A curve that ends on the outline lies where the surface overlaps itself: no boundary.
        if (at == static_cast<std::ptrdiff_t>(s)) walk.curves.closed.push_back(std::move(loop));
    }
}

void run(Walk& walk, const PointPositions& positions) {
    walk.isUsed.assign(walk.segments.size(), 0);
    walkOutline(walk, positions);
    walkClosedCurves(walk);
}

/// Collects the polygons of a block of faces.
struct Collected {
    Rows<Label> polygons;
    std::vector<Label> counts; // polygons per face
    std::vector<Label> needed; // points that must stay
    Label holeCount = 0;
};

/// Adds the segments of the facets [first, last).
void addSegments(const Arrangement& arrangement, Label first, Label last, Walk& walk) {
    for (Label k = first; k < last; ++k) {
        const auto row = arrangement.segments[k];
        walk.segments.insert(walk.segments.end(), row.begin(), row.end());
    }
    if (last - first > 1) std::ranges::sort(walk.segments, {}, &Segment::from);
}

void emit(Walk& walk, const PointPositions& positions, const Vec3& normal, Collected& out) {
    walk.curves.isPlainOutline =
        !walk.outline.empty() && walk.curves.polygons.size() == 1 &&
        std::ranges::all_of(walk.outline, [](const OutlineItem& i) { return i.isNode; });
    out.holeCount += openHoles(positions, normal, walk.curves, out.needed);
    for (const LoopPolygon& loop : walk.curves.polygons)
        out.polygons.add(std::span<const Label>(loop.data(), loop.size()));
}

Vec3 areaVector(const Probe& probe, std::span<const Label> nodes) {
    Vec3 area;
    const Vec3& a = probe.nodePoints[index(nodes[0])];
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i)
        area +=
            cross(probe.nodePoints[index(nodes[i])] - a, probe.nodePoints[index(nodes[i + 1])] - a);
    return area;
}

void setFaceWalk(const Plan& plan, Label f, Walk& walk) {
    const Probe& probe = plan.probe;
    walk.clear();
    const auto nodes = probe.faceNodes[f];
    const std::span<const Label> edges{probe.faceEdges.data() + probe.faceNodes.offsets[index(f)],
                                       nodes.size()};
    addOutline(plan, nodes, edges, walk);
    addSegments(
        plan.arrangement, probe.facetOffsets[index(f)], probe.facetOffsets[index(f) + 1], walk);
}

/// Walks each facet of a fan by itself: used where a closed curve runs on a face that is not plane,
/// so that what lies in what is a question of one plane again.
void walkByFacets(const Plan& plan, Label f, Collected& out) {
    const Probe& probe = plan.probe;
    Walk walk;
    for (Label k = probe.facetOffsets[index(f)]; k < probe.facetOffsets[index(f) + 1]; ++k) {
        walk.clear();
        const auto nodes = probe.facetNodes[k];
        const std::span<const Label> edges{
            probe.facetEdges.data() + probe.facetNodes.offsets[index(k)], nodes.size()};
        addOutline(plan, nodes, edges, walk);
        addSegments(plan.arrangement, k, k + 1, walk);
        run(walk, plan.positions);
        for (const OutlineItem& item : walk.outline)
            if (!item.isNode) out.needed.push_back(item.point);
        emit(walk, plan.positions, areaVector(probe, nodes), out);
    }
}

void walkFace(const Plan& plan, Label f, Walk& walk, Collected& out) {
    const Probe& probe = plan.probe;
    setFaceWalk(plan, f, walk);
    run(walk, plan.positions);
    const bool isFan = probe.facetOffsets[index(f) + 1] - probe.facetOffsets[index(f)] > 1;
    if (isFan && !walk.curves.closed.empty())
        walkByFacets(plan, f, out);
    else
        emit(walk, plan.positions, areaVector(probe, probe.faceNodes[f]), out);
}

} // namespace

FaceLoops
walkFaces(const Probe& probe, const Arrangement& arrangement, const PointPositions& positions) {
    const Plan plan{probe, arrangement, positions};
    constexpr Label block = 1024;
    std::vector<Collected> parts(index((probe.faceCount() + block - 1) / block));
    parallelBlocks(probe.faceCount(), block, [&](Label part, Label first, Label last) {
        Walk walk;
        Collected& out = parts[index(part)];
        for (Label f = first; f < last; ++f) {
            const Label before = out.polygons.size();
            walkFace(plan, f, walk, out);
            out.counts.push_back(out.polygons.size() - before);
        }
    });
    FaceLoops loops;
    loops.offsets.assign(1, 0);
    loops.isNeeded.assign(index(arrangement.firstVertex() - arrangement.nodeCount), 0);
    std::vector<Rows<Label>> rows;
    for (Collected& part : parts) {
        for (const Label count : part.counts)
            loops.offsets.push_back(loops.offsets.back() + count);
        for (const Label p : part.needed)
            if (!arrangement.isNode(p)) loops.isNeeded[index(p - arrangement.nodeCount)] = 1;
        loops.holeCount += part.holeCount;
        rows.push_back(std::move(part.polygons));
    }
    loops.polygons = joined(rows);
    for (Label e = 0; e < probe.edgeCount(); ++e)
        if (probe.isFanEdge[index(e)] == 0)
            for (Label x = arrangement.crossings.offsets[index(e)];
                 x < arrangement.crossings.offsets[index(e) + 1];
                 ++x)
                loops.isNeeded[index(x)] = 1;
    return loops;
}

} // namespace polymesh
