// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trimCell/joinPieces.h"

#include "libpolymesh/base/parallel.h"

#include <algorithm>

namespace polymesh {

namespace {

/// A piece with labels, begun at the lowest point from which it runs along a facet; one that is the
/// whole triangle, at its first corner.
struct Piece {
    Label triangle = -1;
    Label start = -1;
    std::vector<Label> points;
    std::vector<Label> intervals;
};

class PieceJoiner {
public:
    PieceJoiner(const JoinInputs& inputs, const Arrangement& arrangement)
        : inputs_(inputs), cutter_(inputs.cutter), arrangement_(arrangement) {}

    /// The pieces of a cell in order: by triangle, then by where they begin.
    std::vector<Piece> piecesOf(Label cell) const {
        std::vector<Piece> pieces;
        for (const PieceLoop& loop : inputs_.cuts[index(cell)].pieces)
            pieces.push_back(pieceOf(loop));
        std::ranges::sort(pieces, [](const Piece& a, const Piece& b) {
            return a.triangle != b.triangle ? a.triangle < b.triangle : a.start < b.start;
        });
        return pieces;
    }

private:
    Piece pieceOf(const PieceLoop& loop) const {
        const bool isWhole = std::ranges::all_of(
            loop.steps, [](const PieceStep& step) { return step.surfaceEdge >= 0; });
        Piece piece;
        piece.triangle = loop.triangle;
        std::size_t first = 0;
        for (std::size_t i = 0; i < loop.steps.size(); ++i) {
            const PieceStep& step = loop.steps[i];
            const Label point = labelOf(inputs_, arrangement_, step.point);
            piece.points.push_back(point);
            piece.intervals.push_back(step.surfaceEdge < 0 ? -1 : intervalOf(loop.triangle, step));
            const bool mayStart = isWhole ? point - arrangement_.firstVertex() ==
                                                cutter_.surface->triangles[index(loop.triangle)][0]
                                          : step.surfaceEdge < 0;
            if (!mayStart || (piece.start >= 0 && piece.start <= point)) continue;
            piece.start = point;
            first = i;
        }
        const auto begin = static_cast<std::ptrdiff_t>(first);
        std::rotate(piece.points.begin(), piece.points.begin() + begin, piece.points.end());
        std::rotate(
            piece.intervals.begin(), piece.intervals.begin() + begin, piece.intervals.end());
        return piece;
    }

    /// The interval of a surface edge that a step of a triangle's outline runs along.
    Label intervalOf(Label triangle, const PieceStep& step) const {
        const Label e = step.surfaceEdge;
        const bool isForward = cutter_.edges.edges[index(e)].left == triangle;
        if (step.point.kind == PointName::Kind::vertex)
            return intervalLabel(
                arrangement_, e, isForward ? 0 : arrangement_.surfacePierces.rowSize(e));
        const Label pierce =
            labelOf(inputs_, arrangement_, step.point) - arrangement_.firstPierce();
        const Label rank = arrangement_.pierceRank[index(pierce)];
        return intervalLabel(arrangement_, e, isForward ? rank + 1 : rank);
    }

    const JoinInputs& inputs_;
    const CuttingSurface& cutter_;
    const Arrangement& arrangement_;
};

} // namespace

CellPieces joinPieces(const JoinInputs& inputs, const Arrangement& arrangement) {
    const PieceJoiner joiner(inputs, arrangement);
    const Label cells = inputs.probe.cellCount();
    std::vector<std::vector<Piece>> found(index(cells));
    parallelFor(cells, [&](Label c) { found[index(c)] = joiner.piecesOf(c); });
    CellPieces pieces;
    pieces.offsets.assign(1, 0);
    for (const std::vector<Piece>& ofCell : found) {
        for (const Piece& piece : ofCell) {
            pieces.polygons.add(piece.points);
            pieces.intervals.insert(
                pieces.intervals.end(), piece.intervals.begin(), piece.intervals.end());
            pieces.triangle.push_back(piece.triangle);
        }
        pieces.offsets.push_back(pieces.offsets.back() + toLabel(ofCell.size()));
    }
    return pieces;
}

} // namespace polymesh
