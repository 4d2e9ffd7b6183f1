// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"

#include <algorithm>
#include <array>
#include <span>

namespace polymesh::star {

/// A face as seen from its lowest point: walked towards the lower one of the two next to it, so
/// that faces with the same points in the same cyclic order, either way round, look the same.
class FaceView {
public:
    FaceView(std::span<const Label> loop, Label face) : loop_(loop), face_(face) {
        const auto lowest = std::ranges::min_element(loop);
        start_ = static_cast<std::size_t>(lowest - loop.begin());
        const Label after = loop[start_ + 1 == loop.size() ? 0 : start_ + 1];
        const Label before = loop[start_ == 0 ? loop.size() - 1 : start_ - 1];
        isForward_ = after < before;
        key_ = {*lowest, std::min(after, before), std::max(after, before), toLabel(loop.size())};
    }

    Label face() const { return face_; }

    /// Whether the loop itself runs in the direction in which it is walked.
    bool isForward() const { return isForward_; }

    /// Whether the other face has the same points in the same cyclic order, either way round.
    bool isSame(const FaceView& other) const {
        return key_ == other.key_ && compareRest(other) == 0;
    }

    /// Faces that are the same are beside each other, the lower one first.
    bool operator<(const FaceView& other) const {
        if (key_ != other.key_) return key_ < other.key_;
        const int order = compareRest(other);
        return order != 0 ? order < 0 : face_ < other.face_;
    }

private:
    Label corner(std::size_t i) const {
        const std::size_t n = loop_.size();
        return loop_[(isForward_ ? start_ + i : start_ + n - i) % n];
    }

    int compareRest(const FaceView& other) const {
        for (std::size_t i = 2; i + 1 < loop_.size(); ++i)
            if (corner(i) != other.corner(i)) return corner(i) < other.corner(i) ? -1 : 1;
        return 0;
    }

    std::span<const Label> loop_;
    Label face_ = -1;
    std::size_t start_ = 0;
    bool isForward_ = true;
    std::array<Label, 4> key_{}; // the lowest point and those beside it, number of corners
};

} // namespace polymesh::star
