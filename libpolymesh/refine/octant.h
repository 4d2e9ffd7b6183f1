// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace polymesh {

/// Each hexahedron of the initial mesh is a tree of octants. Inside it points have whole
/// coordinates from 0 to latticeSize, so that also the middles of the finest octants have some.
inline constexpr int mostLevel = 11;
inline constexpr int latticeBits = mostLevel + 1;
inline constexpr std::int32_t latticeSize = 1 << latticeBits;

using LatticePoint = std::array<std::int32_t, 3>;

/// A cube of a tree: its lowest corner and how often the tree was halved to get it.
struct Octant {
    LatticePoint anchor{};
    int level = 0;

    std::int32_t size() const { return latticeSize >> level; }

    /// Corner c: upper in x when bit 0 is set, in y bit 1, in z bit 2.
    LatticePoint corner(std::size_t c) const {
        LatticePoint p = anchor;
        for (std::size_t axis = 0; axis < 3; ++axis)
            if ((c >> axis & 1U) != 0) p[axis] += size();
        return p;
    }

    Octant child(std::size_t c) const {
        Octant octant{anchor, level + 1};
        octant.anchor = octant.corner(c);
        return octant;
    }

    bool operator==(const Octant&) const = default;
};

/// Moves the twelve or so low bits of a number three places apart.
constexpr std::uint64_t spread(std::uint64_t bits) {
    bits = (bits | bits << 16U) & 0x0000ff0000ffULL;
    bits = (bits | bits << 8U) & 0x00f00f00f00fULL;
    bits = (bits | bits << 4U) & 0x0c30c30c30c3ULL;
    return (bits | bits << 2U) & 0x249249249249ULL;
}

constexpr std::uint64_t gather(std::uint64_t bits) {
    bits &= 0x249249249249ULL;
    bits = (bits | bits >> 2U) & 0x0c30c30c30c3ULL;
    bits = (bits | bits >> 4U) & 0x00f00f00f00fULL;
    bits = (bits | bits >> 8U) & 0x0000ff0000ffULL;
    return (bits | bits >> 16U) & 0x00000000ffffULL;
}

/// The place of an anchor on the space-filling curve of its tree. Requires: 0 <= p < latticeSize.
constexpr std::uint64_t curvePlace(const LatticePoint& p) {
    return spread(static_cast<std::uint64_t>(p[0])) |
           spread(static_cast<std::uint64_t>(p[1])) << 1U |
           spread(static_cast<std::uint64_t>(p[2])) << 2U;
}

constexpr LatticePoint anchorAt(std::uint64_t place) {
    return {static_cast<std::int32_t>(gather(place)),
            static_cast<std::int32_t>(gather(place >> 1U)),
            static_cast<std::int32_t>(gather(place >> 2U))};
}

inline constexpr unsigned placeBits = 3 * latticeBits;

/// An octant of a forest, its level apart: ascending keys run through the trees in their order and
/// in each along its curve.
using OctantKey = std::uint64_t;

constexpr OctantKey octantKey(Label tree, const LatticePoint& anchor) {
    return static_cast<std::uint64_t>(tree) << placeBits | curvePlace(anchor);
}

constexpr Label treeOf(OctantKey key) {
    return static_cast<Label>(key >> placeBits);
}

constexpr LatticePoint anchorOf(OctantKey key) {
    return anchorAt(key & ((OctantKey{1} << placeBits) - 1));
}

/// An octant inside a known tree; ascending along the curve.
using OctantCode = std::uint64_t;
inline constexpr unsigned levelBits = 4;

constexpr OctantCode octantCode(const Octant& octant) {
    return curvePlace(octant.anchor) << levelBits | static_cast<std::uint64_t>(octant.level);
}

constexpr int levelOf(OctantCode code) {
    return static_cast<int>(code & ((1U << levelBits) - 1));
}

constexpr Octant octantOf(OctantCode code) {
    return {anchorAt(code >> levelBits), levelOf(code)};
}

} // namespace polymesh
