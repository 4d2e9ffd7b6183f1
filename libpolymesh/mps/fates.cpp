// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/mps/halvedFaces.h"
#include "libpolymesh/mps/keepHexahedra.h"
#include "libpolymesh/quality/standardShape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace polymesh {

namespace {

/// A hexahedron of three edges at each corner, without bent edges.
bool isPlainHexahedron(const PolyMesh& mesh,
                       const SubdivisionPlan& plan,
                       const Bends& bends,
                       Label cell) {
    const std::size_t c = index(cell);
    if (plan.firstPart[c + 1] - plan.firstPart[c] != 8 ||
        plan.firstApex[c + 1] != plan.firstApex[c] ||
        standardShape(mesh, cell, plan.cellFaces) != StandardShape::hexahedron)
        return false;
    if (bends.empty()) return true;
    for (const Label f : plan.cellFaces[cell]) {
        const auto points = mesh.faces[f];
        for (std::size_t i = 0; i < points.size(); ++i)
            if (findBend(bends, points[i], points[(i + 1) % points.size()])) return false;
    }
    return true;
}

/// Whether the corners and middles of a face that is halved in part are in one plane.
bool isFlat(const HalvedPieces& pieces, std::span<const Vec3> corners, std::span<const Vec3> all) {
    const Vec3 diagonal = corners[2] - corners[0];
    const Vec3 normal = cross(diagonal, corners[3] - corners[1]);
    constexpr double rounding = 1e-12; // of the diagonal
    return std::ranges::all_of(pieces, [&](const HalvedPiece& piece) {
        return std::ranges::all_of(piece, [&](Label p) {
            const double height = dot(normal, all[index(p)] - corners[0]);
            return std::abs(height) <= rounding * norm(normal) * norm(diagonal);
        });
    });
}

/// Whether the volume under a boundary face stays when it is cut into these pieces: it is whole,
/// or flat.
bool keepsVolume(const PolyMesh& mesh,
                 std::span<const Vec3> points,
                 const HalvedPieces& pieces,
                 Label face) {
    if (pieces.size() == 1) return true;
    std::array<Vec3, 4> corners;
    for (std::size_t i = 0; i < 4; ++i)
        corners[i] = mesh.points[index(mesh.faces[face][i])];
    return isFlat(pieces, corners, points);
}

/// Whether the cones over a piece, seen from outside, have positive corners at the centre's side.
bool isRight(const HalvedPiece& piece,
             bool isReversed,
             const Vec3& centre,
             std::span<const Vec3> points) {
    const std::size_t n = piece.size();
    for (std::size_t i = 0; i < n; ++i) {
        const auto at = [&](std::size_t k) { return points[index(piece[k % n])]; };
        const Vec3 next = at(i + 1) - at(i);
        const Vec3 previous = at(i + n - 1) - at(i);
        if (isReversed ? isInverted(next, previous, centre - at(i))
                       : isInverted(previous, next, centre - at(i)))
            return false;
    }
    return true;
}

/// Whether a hexahedron of the layer can be: its cones are right, and its volume stays.
bool canBeLayer(const PolyMesh& mesh,
                const SubdivisionPlan& plan,
                const HalvedFaces& halved,
                Label cell) {
    const Vec3& centre = plan.points[index(plan.layout.firstCell + cell)];
    for (const Label f : plan.cellFaces[cell]) {
        const HalvedPieces pieces = halved.piecesOf(f);
        if (!mesh.isInternal(f) && !keepsVolume(mesh, plan.points, pieces, f)) return false;
        const bool isReversed = mesh.owner[index(f)] != cell;
        for (const HalvedPiece& piece : pieces)
            if (!isRight(piece, isReversed, centre, plan.points)) return false;
    }
    return true;
}

} // namespace

std::vector<Fate> fatesOf(const PolyMesh& mesh, const SubdivisionPlan& plan, const Bends& bends) {
    const Label cells = mesh.cellCount;
    std::vector<Fate> fates(index(cells));
    parallelFor(cells, [&](Label c) {
        fates[index(c)] = isPlainHexahedron(mesh, plan, bends, c) ? Fate::whole : Fate::divided;
    });
    while (true) {
        const HalvedFaces halved(mesh, plan, fates);
        std::vector<Fate> next = fates;
        parallelFor(cells, [&](Label c) {
            if (fates[index(c)] == Fate::divided) return;
            const bool isTouched = halved.hasHalvedEdge(c);
            next[index(c)] = !isTouched                          ? Fate::whole
                             : canBeLayer(mesh, plan, halved, c) ? Fate::layer
                                                                 : Fate::divided;
        });
        const bool isSettled =
            std::ranges::count(next, Fate::divided) == std::ranges::count(fates, Fate::divided);
        fates = std::move(next);
        if (isSettled) return fates;
    }
}

} // namespace polymesh
