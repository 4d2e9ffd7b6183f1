// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"

#include <boost/container/static_vector.hpp>

#include <array>

namespace polymesh {

using HalvedPiece = boost::container::static_vector<Label, 4>;
using HalvedPieces = boost::container::static_vector<HalvedPiece, 4>;

/// A quadrilateral of which some edges are halved: edge i runs from corner i to the next.
struct HalvedFace {
    std::array<Label, 4> corners{};
    std::array<Label, 4> middles{-1, -1, -1, -1}; // -1: the edge is whole
    Label centre = -1;                            // used when all are halved
};

/// Cuts it into triangles and quadrilaterals that have all its corners and middles, by a rule that
/// is the same from both sides and wherever the face begins:
/// one middle gives 3 triangles; two give 2 quadrilaterals when they are opposite, else 4
/// triangles; three give a quadrilateral at the whole edge and 3 triangles; four give 4
/// quadrilaterals round the centre. Pieces run round as the face does.
HalvedPieces piecesOf(const HalvedFace& face);

} // namespace polymesh
