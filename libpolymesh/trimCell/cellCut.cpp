// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trimCell/cellCut.h"

#include "libpolymesh/trimCell/graphLoops.h"

#include <algorithm>

namespace polymesh {

namespace {

class CellCutter {
public:
    CellCutter(const CellInputs& inputs, Label cell) : inputs_(inputs) {
        cut_.sites = findSites(inputs, cell);
        isByFacets_.assign(cut_.sites.facets.size(), 0);
    }

    CellCut run() {
        findFaces();
        if (divideFans()) findFaces();
        for (GraphLoop& loop : loops_)
            if (carrierOf(loop).triangle < 0)
                addFaceLoop(loop);
            else
                addPiece(loop);
        return std::move(cut_);
    }

private:
    void findFaces() {
        graph_ = buildGraph(inputs_, cut_.sites, isByFacets_);
        loops_ = findLoops(inputs_, graph_);
    }

    const Carrier& carrierOf(const GraphLoop& loop) const {
        return graph_.carriers[index(loop.carrier)];
    }

    const GraphEdge& edgeOf(const LoopStep& step) const { return graph_.edges[index(step.edge)]; }

    /// Whether a loop on a face does not touch the face's outline.
    bool isClosedCurve(const GraphLoop& loop) const {
        return carrierOf(loop).triangle < 0 &&
               std::ranges::all_of(loop.steps, [&](const LoopStep& step) {
                   return edgeOf(step).kind == GraphEdge::Kind::segment;
               });
    }

    /// Marks faces of several facets on which a curve closes: what lies in what is asked on each
    /// facet, which is plane. False when there are none.
    bool divideFans() {
        bool isAny = false;
        for (const GraphLoop& loop : loops_) {
            if (!isClosedCurve(loop)) continue;
            const Label face = carrierOf(loop).face;
            const auto& offsets = inputs_.probe.facetOffsets;
            if (offsets[index(face) + 1] - offsets[index(face)] == 1) continue;
            for (std::size_t i = 0; i < isByFacets_.size(); ++i)
                if (cut_.sites.facets[i].face == face) isByFacets_[i] = 1;
            isAny = true;
        }
        return isAny;
    }

    void addFaceLoop(GraphLoop& loop) {
        const Carrier& carrier = carrierOf(loop);
        const bool isTurned = inputs_.probe.faceCells[index(carrier.face)][0] != cut_.sites.cell;
        if (isTurned) turn(loop);
        FaceLoop& face = cut_.faceLoops.emplace_back();
        face.face = carrier.face;
        face.facet = carrier.facet;
        for (const LoopStep& step : loop.steps) {
            const GraphEdge& edge = edgeOf(step);
            const bool isSegment = edge.kind == GraphEdge::Kind::segment;
            face.steps.push_back(
                {edge.points[step.from],
                 isSegment ? edge.source : -1,
                 isSegment ? graph_.carriers[index(edge.carriers[1])].triangle : -1});
        }
    }

    void addPiece(const GraphLoop& loop) {
        PieceLoop& piece = cut_.pieces.emplace_back();
        piece.triangle = carrierOf(loop).triangle;
        for (const LoopStep& step : loop.steps) {
            const GraphEdge& edge = edgeOf(step);
            const bool isSurface = edge.kind == GraphEdge::Kind::surface;
            piece.steps.push_back({edge.points[step.from], isSurface ? edge.source : -1});
        }
    }

    const CellInputs& inputs_;
    CellCut cut_;
    std::vector<std::uint8_t> isByFacets_;
    CellGraph graph_;
    std::vector<GraphLoop> loops_;
};

} // namespace

CellCut cutOneCell(const CellInputs& inputs, Label cell) {
    return CellCutter(inputs, cell).run();
}

} // namespace polymesh
