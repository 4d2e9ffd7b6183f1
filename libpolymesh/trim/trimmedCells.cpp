// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/trimmedCells.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/parallel.h"

#include <algorithm>
#include <span>

namespace polymesh {

namespace {

/// A polygon of one cell: of a mesh face (boundary false) or of the surface.
struct CellPolygon {
    Label polygon;
    bool isBoundary;
    bool isTurned; // its normal points into the cell
    Label piece;   // representative while joining, then the number of the piece in the cell
};

struct EdgeUse {
    Label low;
    Label high;
    Label polygon; // place in the cell's list
    bool isForward;
};

class CellDivision {
public:
    CellDivision(const Probe& probe,
                 const PointPositions& positions,
                 const FaceLoops& loops,
                 const BoundaryPolygons& boundary)
        : probe_(probe), positions_(positions), loops_(loops), boundary_(boundary) {}

    const std::vector<CellPolygon>& polygons() const { return polygons_; }

    /// Divides a cell; returns the number of its pieces.
    Label divide(Label cell) {
        list(cell);
        joinAcrossEdges(cell);
        return numberPieces();
    }

private:
    std::span<const Label> points(const CellPolygon& p) const {
        return p.isBoundary ? boundary_.polygons[p.polygon] : loops_.polygons[p.polygon];
    }

    void list(Label cell) {
        polygons_.clear();
        for (const Label f : probe_.cellFaces[cell]) {
            const bool isTurned = probe_.faceCells[index(f)][0] != cell;
            for (Label k = loops_.offsets[index(f)]; k < loops_.offsets[index(f) + 1]; ++k)
                polygons_.push_back({k, false, isTurned, toLabel(polygons_.size())});
        }
        for (Label k = boundary_.offsets[index(cell)]; k < boundary_.offsets[index(cell) + 1]; ++k)
            polygons_.push_back({k, true, false, toLabel(polygons_.size())});
    }

    Label root(Label i) {
        while (polygons_[index(i)].piece != i)
            i = polygons_[index(i)].piece;
        return i;
    }

    void joinAcrossEdges(Label cell) {
        uses_.clear();
        for (Label i = 0; i < toLabel(polygons_.size()); ++i) {
            const auto polygon = points(polygons_[index(i)]);
            for (std::size_t k = 0; k < polygon.size(); ++k) {
                const Label a = polygon[k];
                const Label b = polygon[(k + 1) % polygon.size()];
                const bool isForward = (a < b) != polygons_[index(i)].isTurned;
                uses_.push_back({std::min(a, b), std::max(a, b), i, isForward});
            }
        }
        std::ranges::sort(uses_, [](const EdgeUse& a, const EdgeUse& b) {
            if (a.low != b.low) return a.low < b.low;
            if (a.high != b.high) return a.high < b.high;
            return a.polygon < b.polygon;
        });
        for (auto first = uses_.begin(); first != uses_.end();) {
            const auto last = std::find_if(first, uses_.end(), [&](const EdgeUse& use) {
                return use.low != first->low || use.high != first->high;
            });
            int balance = 0;
            for (auto use = first; use != last; ++use) {
                balance += use->isForward ? 1 : -1;
                join(first->polygon, use->polygon);
            }
            if (balance != 0) refuse(cell, *first);
            first = last;
        }
    }

    void join(Label i, Label k) {
        const Label a = root(i);
        const Label b = root(k);
        polygons_[index(std::max(a, b))].piece = std::min(a, b);
    }

    [[noreturn]] void refuse(Label cell, const EdgeUse& use) const {
        const Vec3& p = positions_[index(use.low)];
        throw WorkError(fmt::format("mesh cell {} is left open at ({} {} {}); please report this "
                                    "surface and mesh",
                                    probe_.cells[index(cell)],
                                    p.x,
                                    p.y,
                                    p.z));
    }

    double signedVolume(Label piece, const Vec3& apex) {
        double volume = 0;
        for (Label i = 0; i < toLabel(polygons_.size()); ++i) {
            if (root(i) != piece) continue;
            const auto polygon = points(polygons_[index(i)]);
            for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
                volume += dot(positions_[index(polygon[0])] - apex,
                              cross(positions_[index(polygon[k])] - apex,
                                    positions_[index(polygon[k + 1])] - apex));
        }
        return volume;
    }

    /// Voids (pieces of surface alone that enclose a negative volume) go to the first piece.
    void adoptVoids() {
        std::vector<Label> roots;
        std::vector<bool> hasMeshFace(polygons_.size(), false);
        for (Label i = 0; i < toLabel(polygons_.size()); ++i) {
            const Label r = root(i);
            if (i == r) roots.push_back(r);
            if (!polygons_[index(i)].isBoundary) hasMeshFace[index(r)] = true;
        }
        if (roots.size() < 2) return;
        const Vec3 apex = positions_[index(points(polygons_[0])[0])];
        for (const Label r : roots) {
            if (r == roots.front() || hasMeshFace[index(r)] || signedVolume(r, apex) >= 0) continue;
            polygons_[index(r)].piece = roots.front();
        }
    }

    Label numberPieces() {
        adoptVoids();
        Label count = 0;
        const Label n = toLabel(polygons_.size());
        std::vector<Label> numbers(polygons_.size(), -1);
        for (Label i = 0; i < n; ++i) {
            Label& number = numbers[index(root(i))];
            if (number < 0) number = count++;
        }
        std::vector<Label> pieces;
        for (Label i = 0; i < n; ++i)
            pieces.push_back(numbers[index(root(i))]);
        for (Label i = 0; i < n; ++i)
            polygons_[index(i)].piece = pieces[index(i)];
        return count;
    }

    const Probe& probe_;
    const PointPositions& positions_;
    const FaceLoops& loops_;
    const BoundaryPolygons& boundary_;
    std::vector<CellPolygon> polygons_;
    std::vector<EdgeUse> uses_;
};

} // namespace

TrimmedCells divideCells(const Probe& probe,
                         const PointPositions& positions,
                         const FaceLoops& loops,
                         const BoundaryPolygons& boundary) {
    TrimmedCells cells;
    cells.polygonCells.assign(index(loops.polygons.size()), {-1, -1});
    cells.boundaryCells.assign(index(boundary.polygons.size()), -1);
    std::vector<Label> first(index(probe.cellCount()) + 1, 0);
    constexpr Label block = 512;
    parallelBlocks(probe.cellCount(), block, [&](Label, Label begin, Label end) {
        CellDivision division(probe, positions, loops, boundary);
        for (Label c = begin; c < end; ++c) {
            first[index(c) + 1] = division.divide(c);
            for (const CellPolygon& p : division.polygons()) {
                if (p.isBoundary)
                    cells.boundaryCells[index(p.polygon)] = p.piece;
                else
                    cells.polygonCells[index(p.polygon)][p.isTurned ? 1 : 0] = p.piece;
            }
        }
    });
    for (Label c = 0; c < probe.cellCount(); ++c) {
        first[index(c) + 1] += first[index(c)];
        cells.localCell.insert(
            cells.localCell.end(), index(first[index(c) + 1] - first[index(c)]), c);
    }
    parallelFor(probe.faceCount(), [&](Label f) {
        const auto& [own, other] = probe.faceCells[index(f)];
        for (Label k = loops.offsets[index(f)]; k < loops.offsets[index(f) + 1]; ++k) {
            auto& polygon = cells.polygonCells[index(k)];
            if (own >= 0) polygon[0] += first[index(own)];
            if (other >= 0) polygon[1] += first[index(other)];
        }
    });
    parallelFor(probe.cellCount(), [&](Label c) {
        for (Label k = boundary.offsets[index(c)]; k < boundary.offsets[index(c) + 1]; ++k)
            cells.boundaryCells[index(k)] += first[index(c)];
    });
    return cells;
}

} // namespace polymesh
