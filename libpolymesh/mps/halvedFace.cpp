// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/halvedFace.h"

#include <algorithm>

namespace polymesh {

namespace {

/// The face beginning at another corner.
HalvedFace from(const HalvedFace& face, std::size_t first) {
    HalvedFace turned = face;
    const auto by = static_cast<std::ptrdiff_t>(first);
    std::rotate(turned.corners.begin(), turned.corners.begin() + by, turned.corners.end());
    std::rotate(turned.middles.begin(), turned.middles.begin() + by, turned.middles.end());
    return turned;
}

HalvedPieces withOneMiddle(const HalvedFace& face) {
    const auto& [a, b, c, d] = face.corners;
    const Label m = face.middles[0];
    return {{a, m, d}, {m, b, c}, {m, c, d}};
}

HalvedPieces withOppositeMiddles(const HalvedFace& face) {
    const auto& [a, b, c, d] = face.corners;
    const Label m = face.middles[0];
    const Label n = face.middles[2];
    return {{a, m, n, d}, {m, b, c, n}};
}

/// The middles are those of the first two edges.
HalvedPieces withNeighbouringMiddles(const HalvedFace& face) {
    const auto& [a, b, c, d] = face.corners;
    const Label m = face.middles[0];
    const Label n = face.middles[1];
    return {{m, b, n}, {m, n, d}, {a, m, d}, {n, c, d}};
}

/// The last edge is whole.
HalvedPieces withThreeMiddles(const HalvedFace& face) {
    const auto& [a, b, c, d] = face.corners;
    const auto& [m, n, o, none] = face.middles;
    return {{a, m, o, d}, {m, b, n}, {n, c, o}, {m, n, o}};
}

HalvedPieces roundTheCentre(const HalvedFace& face) {
    HalvedPieces pieces;
    for (std::size_t i = 0; i < 4; ++i)
        pieces.push_back(
            {face.corners[i], face.middles[i], face.centre, face.middles[(i + 3) % 4]});
    return pieces;
}

} // namespace

HalvedPieces piecesOf(const HalvedFace& face) {
    const auto isHalved = [&](std::size_t i) { return face.middles[i % 4] >= 0; };
    const auto count = 4 - std::ranges::count(face.middles, -1);
    if (count == 4) return roundTheCentre(face);
    for (std::size_t i = 0; i < 4; ++i) {
        if (count == 1 && isHalved(i)) return withOneMiddle(from(face, i));
        if (count == 2 && isHalved(i) && isHalved(i + 1))
            return withNeighbouringMiddles(from(face, i));
        if (count == 2 && isHalved(i) && isHalved(i + 2)) return withOppositeMiddles(from(face, i));
        if (count == 3 && !isHalved(i)) return withThreeMiddles(from(face, i + 1));
    }
    const auto& [a, b, c, d] = face.corners;
    return {{a, b, c, d}};
}

} // namespace polymesh
