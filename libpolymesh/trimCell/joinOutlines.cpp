// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trimCell/joinOutlines.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/trim/bridges.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace polymesh {

namespace {

/// A face, or a facet of one that is taken by facets.
struct Polygon {
    std::span<const Label> nodes;
    std::span<const Label> edges; // to the next node
};

/// An outline on a face in a form that does not depend on the cell that has found it.
struct Outline {
    Label facet = -1;
    bool isClosedCurve = false;    // it does not touch the outline of the face
    std::pair<Label, Label> start; // where it begins, for the order of outlines
    std::vector<Label> points;

    // NOLINTNEXTLINE(modernize-use-nullptr): what the compiler makes of it compares with 0
    auto operator<=>(const Outline&) const = default;
};

/// Collects the polygons of a block of faces.
struct Collected {
    Rows<Label> polygons;
    std::vector<Label> counts; // polygons per face
    std::vector<Label> needed; // points that must stay
    Rows<Segment> segments;    // per facet
    Label holeCount = 0;
};

class OutlineJoiner {
public:
    OutlineJoiner(const JoinInputs& inputs,
                  const PointPositions& positions,
                  const Arrangement& arrangement)
        : inputs_(inputs), probe_(inputs.probe), positions_(positions), arrangement_(arrangement) {}

    void joinFace(Label f, Collected& out) const {
        const auto& [owner, neighbour] = probe_.faceCells[index(f)];
        std::vector<Outline> outlines = outlinesOf(owner >= 0 ? owner : neighbour, f);
        if (owner >= 0 && neighbour >= 0 && outlinesOf(neighbour, f) != outlines)
            refuseDifference("what is left of a mesh face",
                             probe_.nodePoints[index(probe_.faceNodes[f][0])]);
        addSegments(owner >= 0 ? owner : neighbour, f, out);
        const Label before = out.polygons.size();
        if (!outlines.empty() && outlines.front().facet >= 0)
            emitByFacets(f, outlines, out);
        else
            emit(faceOf(f), outlines, out);
        out.counts.push_back(out.polygons.size() - before);
    }

private:
    Polygon faceOf(Label f) const {
        const auto nodes = probe_.faceNodes[f];
        return {nodes,
                {probe_.faceEdges.data() + probe_.faceNodes.offsets[index(f)], nodes.size()}};
    }

    Polygon facetOf(Label k) const {
        const auto nodes = probe_.facetNodes[k];
        return {nodes,
                {probe_.facetEdges.data() + probe_.facetNodes.offsets[index(k)], nodes.size()}};
    }

    /// The outlines that a cell has found on a face, in order.
    std::vector<Outline> outlinesOf(Label cell, Label f) const {
        std::vector<Outline> outlines;
        for (const FaceLoop& loop : inputs_.cuts[index(cell)].faceLoops)
            if (loop.face == f) outlines.push_back(outlineOf(loop));
        std::ranges::sort(outlines);
        return outlines;
    }

    /// Begins a loop where it first runs along the outline, a closed curve at its lowest point.
    Outline outlineOf(const FaceLoop& loop) const {
        const Polygon polygon = loop.facet >= 0 ? facetOf(loop.facet) : faceOf(loop.face);
        Outline outline;
        outline.facet = loop.facet;
        outline.isClosedCurve = std::ranges::all_of(
            loop.steps, [](const FaceStep& step) { return step.triangle >= 0; });
        outline.start.first = std::numeric_limits<Label>::max();
        std::size_t first = 0;
        for (std::size_t i = 0; i < loop.steps.size(); ++i) {
            const Label point = labelOf(inputs_, arrangement_, loop.steps[i].point);
            outline.points.push_back(point);
            if (!outline.isClosedCurve && loop.steps[i].triangle >= 0) continue;
            const auto start = outline.isClosedCurve
                                   ? std::pair(point, Label{0})
                                   : placeOnOutline(polygon, loop.steps[i].point, point);
            if (start >= outline.start) continue;
            outline.start = start;
            first = i;
        }
        std::rotate(outline.points.begin(),
                    outline.points.begin() + static_cast<std::ptrdiff_t>(first),
                    outline.points.end());
        return outline;
    }

    /// How far along the outline of a polygon a node or a crossing comes: side, place on it.
    std::pair<Label, Label>
    placeOnOutline(const Polygon& polygon, const PointName& name, Label point) const {
        const bool isNode = name.kind == PointName::Kind::node;
        const auto found = std::ranges::find(isNode ? polygon.nodes : polygon.edges, name.first);
        const std::size_t side =
            static_cast<std::size_t>(found - (isNode ? polygon.nodes : polygon.edges).begin());
        if (isNode) return {toLabel(side), 0};
        const Label rank = point - arrangement_.firstCrossing() -
                           arrangement_.crossings.offsets[index(name.first)];
        const bool isForward = probe_.edges[index(name.first)][0] == polygon.nodes[side];
        return {toLabel(side),
                isForward ? rank + 1 : arrangement_.crossings.rowSize(name.first) - rank};
    }

    /// Lists the segments on the face's facets, as its outlines run along them.
    void addSegments(Label cell, Label f, Collected& out) const {
        const Label first = probe_.facetOffsets[index(f)];
        std::vector<std::vector<Segment>> rows(index(probe_.facetOffsets[index(f) + 1] - first));
        for (const FaceLoop& loop : inputs_.cuts[index(cell)].faceLoops) {
            if (loop.face != f) continue;
            for (std::size_t i = 0; i < loop.steps.size(); ++i) {
                const FaceStep& step = loop.steps[i];
                if (step.triangle < 0) continue;
                const FaceStep& next = loop.steps[(i + 1) % loop.steps.size()];
                rows[index(step.facet - first)].push_back(
                    {step.triangle,
                     labelOf(inputs_, arrangement_, step.point),
                     labelOf(inputs_, arrangement_, next.point)});
            }
        }
        for (auto& row : rows) {
            std::ranges::sort(row, {}, &Segment::from);
            out.segments.add(row);
        }
    }

    bool isCrossed(const Polygon& polygon) const {
        return std::ranges::any_of(polygon.edges,
                                   [&](Label e) { return arrangement_.crossings.rowSize(e) > 0; });
    }

    void emit(const Polygon& polygon, std::span<const Outline> outlines, Collected& out) const {
        CurvesOnFace curves;
        for (const Outline& outline : outlines)
            (outline.isClosedCurve ? curves.closed : curves.polygons)
                .emplace_back(outline.points.begin(), outline.points.end());
        curves.isPlainOutline = curves.polygons.size() == 1 && !isCrossed(polygon);
        Vec3 area;
        const auto at = [&](std::size_t i) { return probe_.nodePoints[index(polygon.nodes[i])]; };
        for (std::size_t i = 1; i + 1 < polygon.nodes.size(); ++i)
            area += cross(at(i) - at(0), at(i + 1) - at(0));
        out.holeCount += openHoles(positions_, area, curves, out.needed);
        for (const LoopPolygon& loop : curves.polygons)
            out.polygons.add(std::span<const Label>(loop.data(), loop.size()));
    }

    /// The same facet by facet; no point of a facet's outline may go.
    void emitByFacets(Label f, std::span<const Outline> outlines, Collected& out) const {
        for (Label k = probe_.facetOffsets[index(f)]; k < probe_.facetOffsets[index(f) + 1]; ++k) {
            const Polygon facet = facetOf(k);
            for (const Label e : facet.edges)
                for (Label x = arrangement_.crossings.offsets[index(e)];
                     x < arrangement_.crossings.offsets[index(e) + 1];
                     ++x)
                    out.needed.push_back(arrangement_.firstCrossing() + x);
            const std::span<const Outline> here(
                std::ranges::lower_bound(outlines, k, {}, &Outline::facet),
                std::ranges::upper_bound(outlines, k, {}, &Outline::facet));
            emit(facet, here, out);
        }
    }

    const JoinInputs& inputs_;
    const Probe& probe_;
    const PointPositions& positions_;
    const Arrangement& arrangement_;
};

/// Marks the points that faces need: crossings of mesh edges, and what the parts have collected.
void markNeeded(const Probe& probe,
                const Arrangement& arrangement,
                const std::vector<Collected>& parts,
                FaceLoops& loops) {
    loops.isNeeded.assign(index(arrangement.firstVertex() - arrangement.nodeCount), 0);
    for (const Collected& part : parts)
        for (const Label p : part.needed)
            if (!arrangement.isNode(p)) loops.isNeeded[index(p - arrangement.nodeCount)] = 1;
    for (Label e = 0; e < probe.edgeCount(); ++e)
        for (Label x = arrangement.crossings.offsets[index(e)];
             x < arrangement.crossings.offsets[index(e) + 1];
             ++x)
            if (probe.isFanEdge[index(e)] == 0) loops.isNeeded[index(x)] = 1;
}

} // namespace

FaceLoops
joinOutlines(const JoinInputs& inputs, const PointPositions& positions, Arrangement& arrangement) {
    constexpr Label block = 1024;
    const Label faces = inputs.probe.faceCount();
    const OutlineJoiner joiner(inputs, positions, arrangement);
    std::vector<Collected> parts(index((faces + block - 1) / block));
    parallelBlocks(faces, block, [&](Label part, Label first, Label last) {
        for (Label f = first; f < last; ++f)
            joiner.joinFace(f, parts[index(part)]);
    });
    FaceLoops loops;
    loops.offsets.assign(1, 0);
    markNeeded(inputs.probe, arrangement, parts, loops);
    std::vector<Rows<Label>> polygons;
    std::vector<Rows<Segment>> segments;
    for (Collected& part : parts) {
        for (const Label count : part.counts)
            loops.offsets.push_back(loops.offsets.back() + count);
        loops.holeCount += part.holeCount;
        polygons.push_back(std::move(part.polygons));
        segments.push_back(std::move(part.segments));
    }
    loops.polygons = joined(polygons);
    arrangement.segments = joined(segments);
    return loops;
}

} // namespace polymesh
