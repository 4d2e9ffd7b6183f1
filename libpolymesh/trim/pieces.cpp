// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/pieces.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/parallel.h"

#include <algorithm>
#include <span>

namespace polymesh {

namespace {

/// A segment as the outline of a triangle's part in a cell runs along it.
struct Arc {
    Label triangle;
    Label start;
    Label end;
    bool isUsed = false;
};

/// Collects the pieces of a block of cells.
struct Collected {
    Rows<Label> polygons;
    std::vector<Label> intervals;
    std::vector<Label> triangle;
    std::vector<Label> counts;
};

void listArcs(const Probe& probe,
              const Arrangement& arrangement,
              Label cell,
              std::vector<Arc>& arcs) {
    arcs.clear();
    for (const Label f : probe.cellFaces[cell]) {
        const bool isOwner = probe.faceCells[index(f)][0] == cell;
        for (Label k = probe.facetOffsets[index(f)]; k < probe.facetOffsets[index(f) + 1]; ++k)
            for (const Segment& s : arrangement.segments[k])
                // Against the face's own polygon, which runs from -> to for the owner.
                arcs.push_back(isOwner ? Arc{s.triangle, s.to, s.from}
                                       : Arc{s.triangle, s.from, s.to});
    }
    std::ranges::sort(arcs, [](const Arc& a, const Arc& b) {
        return a.triangle != b.triangle ? a.triangle < b.triangle : a.start < b.start;
    });
}

[[noreturn]] void refuseCell(Label meshCell) {
    throw WorkError(
        fmt::format("the surface inside mesh cell {} does not close; please report this "
                    "surface and mesh",
                    meshCell));
}

/// Walks the outline of one triangle's part.
class TriangleWalk {
public:
    TriangleWalk(const Intersection& cut, Label cell, std::span<Arc> arcs, Collected& out)
        : probe_(cut.probe),
          cutter_(cut.cutter),
          arrangement_(cut.arrangement),
          cell_(cell),
          arcs_(arcs),
          out_(out) {}

    void run() {
        for (Arc& arc : arcs_)
            if (!arc.isUsed) walkFrom(arc);
    }

private:
    void add(Label point, Label interval) {
        out_.polygons.values.push_back(point);
        out_.intervals.push_back(interval);
    }

    Arc* arcFrom(Label point) {
        for (Arc& arc : arcs_)
            if (arc.start == point) return &arc;
        return nullptr;
    }

    void walkFrom(Arc& first) {
        Arc* arc = &first;
        do {
            if (arc == nullptr || arc->isUsed) refuseCell(probe_.cells[index(cell_)]);
            arc->isUsed = true;
            add(arc->start, -1);
            const Label at = arc->end;
            arc = arcFrom(arrangement_.isPierce(at) ? alongEdges(at) : at);
        } while (arc != &first);
        out_.polygons.offsets.push_back(toLabel(out_.polygons.values.size()));
        out_.triangle.push_back(first.triangle);
    }

    /// From a pierce along the triangle's edges, over its corners, to the next pierce.
    Label alongEdges(Label pierce) {
        const Label triangle = arcs_[0].triangle;
        const auto& sides = cutter_.edges.ofTriangle[index(triangle)];
        const Label x = pierce - arrangement_.firstPierce();
        std::size_t side = 0;
        while (side < 2 && sides[side] != arrangement_.pierces.values[index(x)].edge)
            ++side;
        Label from = pierce;
        Label rank = arrangement_.pierceRank[index(x)];
        for (int corners = 0; corners <= 3; ++corners, side = (side + 1) % 3) {
            const Label e = sides[side];
            const auto row = arrangement_.surfacePierces[e];
            const auto size = toLabel(row.size());
            const bool isForward = cutter_.edges.edges[index(e)].left == triangle;
            if (corners > 0) rank = isForward ? -1 : size; // at the corner
            const Label next = isForward ? rank + 1 : rank - 1;
            add(from, intervalLabel(arrangement_, e, isForward ? rank + 1 : rank));
            if (next >= 0 && next < size) return arrangement_.firstPierce() + row[index(next)];
            from = arrangement_.firstVertex() +
                   cutter_.surface->triangles[index(triangle)][(side + 1) % 3];
        }
        refuseCell(probe_.cells[index(cell_)]);
    }

    const Probe& probe_;
    const CuttingSurface& cutter_;
    const Arrangement& arrangement_;
    Label cell_;
    std::span<Arc> arcs_;
    Collected& out_;
};

void addWholeTriangle(const CuttingSurface& cutter,
                      const Arrangement& arrangement,
                      Label triangle,
                      Collected& out) {
    for (std::size_t i = 0; i < 3; ++i) {
        const Label corner = cutter.surface->triangles[index(triangle)][i];
        out.polygons.values.push_back(arrangement.firstVertex() + corner);
        out.intervals.push_back(
            intervalLabel(arrangement, cutter.edges.ofTriangle[index(triangle)][i], 0));
    }
    out.polygons.offsets.push_back(toLabel(out.polygons.values.size()));
    out.triangle.push_back(triangle);
}

/// Triangles that no facet cuts, by the cell that holds them.
Rows<Label>
wholeTriangles(const Probe& probe, const CuttingSurface& cutter, const Arrangement& arrangement) {
    std::vector<std::uint8_t> isCut(cutter.surface->triangles.size(), 0);
    for (const Segment& s : arrangement.segments.values)
        isCut[index(s.triangle)] = 1;
    Rows<Label> rows;
    rows.offsets.assign(index(probe.cellCount()) + 1, 0);
    const auto cellOf = [&](Label t) {
        return isCut[index(t)] != 0
                   ? Label{-1}
                   : arrangement.vertexCell[index(cutter.surface->triangles[index(t)][0])];
    };
    for (Label t = 0; t < cutter.surface->triangleCount(); ++t)
        if (const Label c = cellOf(t); c >= 0) ++rows.offsets[index(c) + 1];
    for (std::size_t c = 1; c < rows.offsets.size(); ++c)
        rows.offsets[c] += rows.offsets[c - 1];
    rows.values.resize(index(rows.offsets.back()));
    std::vector<Label> next(rows.offsets.begin(), rows.offsets.end() - 1);
    for (Label t = 0; t < cutter.surface->triangleCount(); ++t)
        if (const Label c = cellOf(t); c >= 0) rows.values[index(next[index(c)]++)] = t;
    return rows;
}

void cutCell(const Intersection& cut,
             std::span<const Label> whole,
             Label cell,
             std::vector<Arc>& arcs,
             Collected& out) {
    listArcs(cut.probe, cut.arrangement, cell, arcs);
    std::size_t w = 0;
    std::size_t first = 0;
    while (first < arcs.size() || w < whole.size()) {
        if (first == arcs.size() || (w < whole.size() && whole[w] < arcs[first].triangle)) {
            addWholeTriangle(cut.cutter, cut.arrangement, whole[w++], out);
            continue;
        }
        std::size_t last = first;
        while (last < arcs.size() && arcs[last].triangle == arcs[first].triangle)
            ++last;
        TriangleWalk(cut, cell, std::span<Arc>(arcs).subspan(first, last - first), out).run();
        first = last;
    }
}

} // namespace

std::vector<Label> edgeOfIntervals(const Arrangement& arrangement) {
    const Label edges = arrangement.surfacePierces.size();
    std::vector<Label> edgeOf(index(arrangement.pierceCount() + edges));
    parallelFor(edges, [&](Label e) {
        const Label first = intervalLabel(arrangement, e, 0);
        for (Label k = 0; k <= arrangement.surfacePierces.rowSize(e); ++k)
            edgeOf[index(first + k)] = e;
    });
    return edgeOf;
}

CellPieces
cutTriangles(const Probe& probe, const CuttingSurface& cutter, const Arrangement& arrangement) {
    const Rows<Label> whole = wholeTriangles(probe, cutter, arrangement);
    constexpr Label block = 512;
    std::vector<Collected> parts(index((probe.cellCount() + block - 1) / block));
    parallelBlocks(probe.cellCount(), block, [&](Label part, Label first, Label last) {
        std::vector<Arc> arcs;
        Collected& out = parts[index(part)];
        for (Label c = first; c < last; ++c) {
            const Label before = out.polygons.size();
            cutCell({probe, cutter, arrangement}, whole[c], c, arcs, out);
            out.counts.push_back(out.polygons.size() - before);
        }
    });
    CellPieces pieces;
    pieces.offsets.assign(1, 0);
    std::vector<Rows<Label>> rows;
    for (Collected& part : parts) {
        for (const Label count : part.counts)
            pieces.offsets.push_back(pieces.offsets.back() + count);
        pieces.intervals.insert(
            pieces.intervals.end(), part.intervals.begin(), part.intervals.end());
        pieces.triangle.insert(pieces.triangle.end(), part.triangle.begin(), part.triangle.end());
        rows.push_back(std::move(part.polygons));
    }
    pieces.polygons = joined(rows);
    return pieces;
}

} // namespace polymesh
