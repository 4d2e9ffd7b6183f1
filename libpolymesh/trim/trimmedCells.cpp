// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/trimmedCells.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/geometry/solidAngle.h"
#include "libpolymesh/trim/cellShells.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numbers>
#include <span>

namespace polymesh {

namespace {

/// A polygon of one cell: of a mesh face (boundary false) or of the surface.
struct CellPolygon {
    Label polygon;
    bool isBoundary;
    bool isTurned;    // its normal points into the cell
    Label piece = -1; // number of the piece in the cell
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
        shells_.clear();
        for (const CellPolygon& polygon : polygons_)
            shells_.add(points(polygon), polygon.isTurned);
        shells_.join();
        if (!shells_.isClosed()) refuse(cell, shells_.openPoint());
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
                polygons_.push_back({k, false, isTurned});
        }
        for (Label k = boundary_.offsets[index(cell)]; k < boundary_.offsets[index(cell) + 1]; ++k)
            polygons_.push_back({k, true, false});
    }

    [[noreturn]] void refuse(Label cell, Label point) const {
        const Vec3& p = positions_[index(point)];
        throw WorkError(fmt::format("mesh cell {} is left open at ({} {} {}); please report this "
                                    "surface and mesh",
                                    probe_.cells[index(cell)],
                                    p.x,
                                    p.y,
                                    p.z));
    }

    /// Six times the volume of a piece that has no faces of the mesh.
    double signedVolume(Label piece, const Vec3& apex) {
        double volume = 0;
        for (Label i = 0; i < toLabel(polygons_.size()); ++i) {
            if (shells_.shellOf(i) != piece) continue;
            const auto polygon = points(polygons_[index(i)]);
            for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
                volume += dot(positions_[index(polygon[0])] - apex,
                              cross(positions_[index(polygon[k])] - apex,
                                    positions_[index(polygon[k + 1])] - apex));
        }
        return volume;
    }

    /// The part of all directions from which a piece is seen from inside: 1 round a point inside
    /// it, 0 round one outside. A face that is not plane is the fan round the mean of its points,
    /// as where it is cut: a void may be near it.
    double windingOf(Label piece, const Vec3& at) {
        double sum = 0;
        for (Label i = 0; i < toLabel(polygons_.size()); ++i) {
            if (shells_.shellOf(i) != piece) continue;
            const auto polygon = points(polygons_[index(i)]);
            const double sign = polygons_[index(i)].isTurned ? -1 : 1;
            Vec3 mean = at; // taken from there, where it is small
            for (const Label p : polygon)
                mean += (positions_[index(p)] - at) / static_cast<double>(polygon.size());
            for (std::size_t k = 0; k < polygon.size(); ++k)
                sum += sign * solidAngle(at,
                                         mean,
                                         positions_[index(polygon[k])],
                                         positions_[index(polygon[(k + 1) % polygon.size()])]);
        }
        return sum / (4 * std::numbers::pi);
    }

    /// Voids (pieces of surface alone that enclose a negative volume) go to the piece that holds
    /// them.
    void adoptVoids() {
        std::vector<Label> pieces;
        std::vector<bool> hasMeshFace(polygons_.size(), false);
        for (Label i = 0; i < toLabel(polygons_.size()); ++i) {
            const Label piece = shells_.shellOf(i);
            if (i == piece) pieces.push_back(piece);
            if (!polygons_[index(i)].isBoundary) hasMeshFace[index(piece)] = true;
        }
        if (pieces.size() < 2) return;
        const Vec3 apex = positions_[index(points(polygons_[0])[0])];
        const auto isVoid = [&](Label piece) {
            return !hasMeshFace[index(piece)] && signedVolume(piece, apex) < 0;
        };
        const auto firstVoid =
            std::stable_partition(pieces.begin(), pieces.end(), std::not_fn(isVoid));
        const std::span<const Label> bodies(pieces.begin(), firstVoid);
        const std::span<const Label> voids(firstVoid, pieces.end());
        std::vector<std::array<Label, 2>> adoptions; // all found before pieces change
        for (const Label piece : voids)
            if (const Label holder = holderOf(piece, bodies); holder >= 0)
                adoptions.push_back({piece, holder});
        for (const auto& [piece, holder] : adoptions)
            shells_.unite(piece, holder);
    }

    /// The one of the bodies that surrounds a void most, -1 when none does.
    Label holderOf(Label voidPiece, std::span<const Label> bodies) {
        const Vec3 at = middleOf(voidPiece);
        Label holder = -1;
        double most = 0.01;
        for (const Label body : bodies)
            if (const double winding = windingOf(body, at); winding > most) {
                most = winding;
                holder = body;
            }
        return holder;
    }

    /// Mean of the polygons' means: a point of a void that touches its holder lies on neither.
    Vec3 middleOf(Label piece) {
        Vec3 sum;
        double count = 0;
        for (Label i = 0; i < toLabel(polygons_.size()); ++i) {
            if (shells_.shellOf(i) != piece) continue;
            for (const Label p : points(polygons_[index(i)])) {
                sum += positions_[index(p)];
                ++count;
            }
        }
        return sum / count;
    }

    Label numberPieces() {
        adoptVoids();
        Label count = 0;
        std::vector<Label> numbers(polygons_.size(), -1);
        for (Label i = 0; i < toLabel(polygons_.size()); ++i) {
            Label& number = numbers[index(shells_.shellOf(i))];
            if (number < 0) number = count++;
            polygons_[index(i)].piece = number;
        }
        return count;
    }

    const Probe& probe_;
    const PointPositions& positions_;
    const FaceLoops& loops_;
    const BoundaryPolygons& boundary_;
    std::vector<CellPolygon> polygons_;
    CellShells shells_;
};

/// Makes the numbers of pieces in each cell numbers of pieces in the mesh.
void numberThrough(const Probe& probe,
                   const FaceLoops& loops,
                   const BoundaryPolygons& boundary,
                   const std::vector<Label>& first,
                   TrimmedCells& cells) {
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
}

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
    numberThrough(probe, loops, boundary, first, cells);
    return cells;
}

} // namespace polymesh
