// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trimCell/meetings.h"

#include "libpolymesh/geometry/predicates.h"

#include <algorithm>

namespace polymesh {

namespace {

/// What the sides of a polygon say about a line that may pass through it.
struct Passing {
    bool isThrough = false;  // it passes all sides in the same sense
    std::uint32_t zeros = 0; // bit i: it meets side i (the last bit: one of all further ones)
};

/// `sideOf(i)` tells how the line passes the polygon's i-th side.
template<class SideOf>
Passing pass(std::size_t sides, SideOf&& sideOf) {
    constexpr std::size_t lastBit = 29;
    Passing passing{true, 0};
    const MovedSign first = sideOf(std::size_t{0});
    for (std::size_t i = 0; i < sides && passing.isThrough; ++i) {
        const MovedSign side = i == 0 ? first : sideOf(i);
        passing.isThrough = side.sign == first.sign;
        if (side.wasZero) passing.zeros |= 1U << std::min(i, lastBit);
    }
    return passing;
}

unsigned zerosOfEnds(const MovedSign& atStart, const MovedSign& atEnd) {
    return (atStart.wasZero ? 1U : 0U) | (atEnd.wasZero ? 2U : 0U);
}

} // namespace

std::array<Vec3, 3> planeOf(std::span<const Vec3> facet) {
    for (std::size_t i = 1; i + 1 < facet.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            if (normalSign(facet[0], facet[i], facet[i + 1], axis) != 0)
                return {facet[0], facet[i], facet[i + 1]};
    return {facet[0], facet[1], facet[2]};
}

std::optional<EdgeCrossing>
meetTriangle(const Vec3& a, const Vec3& b, const std::array<Vec3, 3>& triangle) {
    const MovedSign atA = sideOfTriangle(triangle, a);
    const MovedSign atB = sideOfTriangle(triangle, b);
    if (atA.sign == atB.sign) return std::nullopt;
    const Passing passing = pass(
        3, [&](std::size_t i) { return passingSide(a, b, triangle[i], triangle[(i + 1) % 3]); });
    if (!passing.isThrough) return std::nullopt;
    EdgeCrossing crossing;
    crossing.sign = atA.sign; // the domain is on the negative side: from 1 to -1 is into it
    crossing.zeros = static_cast<std::uint8_t>(zerosOfEnds(atA, atB) | passing.zeros << 2U);
    return crossing;
}

std::optional<FacePierce> meetFacet(std::span<const Vec3> facet, const Vec3& p, const Vec3& q) {
    const std::array<Vec3, 3> plane = planeOf(facet);
    const MovedSign atP = sideOfMeshPlane(plane, p);
    const MovedSign atQ = sideOfMeshPlane(plane, q);
    if (atP.sign == atQ.sign) return std::nullopt;
    const Passing passing = pass(facet.size(), [&](std::size_t i) {
        return passingSide(facet[i], facet[(i + 1) % facet.size()], p, q);
    });
    if (!passing.isThrough) return std::nullopt;
    FacePierce pierce;
    pierce.sign = atQ.sign;
    pierce.zeros = zerosOfEnds(atP, atQ) | passing.zeros << 2U;
    return pierce;
}

} // namespace polymesh
