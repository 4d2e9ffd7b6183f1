// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/shapes/baseShapes.h"

#include <array>
#include <compare>
#include <cstdint>
#include <span>

namespace polymesh {

/// What a walk over a face graph from one of its darts sees; two graphs have a dart with the same
/// code if and only if they are the same graph with the same orientation.
struct RootedCode {
    std::array<std::uint64_t, 3> words{};

    auto operator<=>(const RootedCode&) const = default;
};

/// The faces of a polyhedron as a graph on the sphere, without memory from the heap: points have
/// local numbers in the order of their first use; a dart is an edge in the direction in which one
/// face uses it. Holds what the catalogue may hold, no more: 12 points, 8 faces of 3 to 6 points.
class FaceGraph {
public:
    static constexpr std::size_t maxDarts = 36;

    /// Adds a face, its points anticlockwise seen from outside, or clockwise if `reversed`. False
    /// when there is no room or the face has a directed edge of another.
    bool addFace(std::span<const Label> points, bool reversed);

    /// To be called after the last face: false unless the faces make a closed surface, every edge
    /// used once in each direction, with V - E + F = 2. What is pinched at a point shows in `walk`.
    bool close();

    /// A walk over the whole graph: the points in the order in which they are met, and the code.
    struct Walk {
        RootedCode code;
        std::array<std::uint8_t, maxShapePoints> points{}; // local numbers
        bool complete = false; // false when not everything can be reached: no polyhedron
    };

    /// The walk from a dart: round each point met, in order of meeting, from the dart by which it
    /// was met, the numbers of the points that edges lead to. Cost: linear.
    Walk walk(std::size_t root) const;

    std::size_t pointCount() const { return pointCount_; }

    std::size_t dartCount() const { return dartCount_; }

    std::size_t faceCount() const { return faceCount_; }

    /// The label of the point with a local number.
    Label label(std::size_t point) const { return labels_[point]; }

private:
    static constexpr std::uint8_t none = 0xff;

    std::uint8_t localNumber(Label point);

    std::array<Label, maxShapePoints> labels_{};
    std::array<std::uint8_t, maxDarts> origin_{};
    std::array<std::uint8_t, maxDarts> target_{};
    std::array<std::uint8_t, maxDarts> next_{};              // the dart after it in its face
    std::array<std::uint8_t, maxDarts> turned_{};            // the next dart from the same point
    std::array<std::uint8_t, maxShapePoints * 16> dartOf_{}; // [from * 16 + to] 1 + dart; 0: none
    std::size_t pointCount_ = 0;
    std::size_t faceCount_ = 0;
    std::size_t dartCount_ = 0;
};

} // namespace polymesh
