// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/freshList.h"
#include "libpolymesh/base/label.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace polymesh {

/// Disjoint sets of the labels [0, count), each known by its lowest member: so results depend on
/// what was joined, not on the order. A member points to a lower one of its set, the lowest to
/// itself.
/// Cost: O(log count) for each call, amortised, nearly constant in practice; memory: one label
/// for each member. Source: path halving, Tarjan and van Leeuwen, J. ACM 31 (1984) 245-281.
class DisjointSets {
public:
    /// The sets by number, in order of their lowest members.
    struct Numbers {
        Label count = 0;
        std::vector<Label> of; // one per member
    };

    DisjointSets() = default;

    /// Every label is a set of its own.
    explicit DisjointSets(Label count) : lower_(freshList<Label>(index(count))) {
        std::iota(lower_.begin(), lower_.end(), Label{0});
    }

    /// Begins anew, in the same memory.
    void reset(Label count) {
        lower_.resize(index(count));
        std::iota(lower_.begin(), lower_.end(), Label{0});
    }

    /// Adds a set of one: the label count().
    void add() { lower_.push_back(count()); }

    /// The number of members of all sets.
    Label count() const { return toLabel(lower_.size()); }

    /// The lowest member of the set of `member`. Not const: it shortens the way there.
    Label lowest(Label member) {
        while (lower_[index(member)] != member) {
            Label& lower = lower_[index(member)];
            lower = lower_[index(lower)];
            member = lower;
        }
        return member;
    }

    /// Makes one set of those of a and b.
    void join(Label a, Label b) {
        a = lowest(a);
        b = lowest(b);
        lower_[index(std::max(a, b))] = std::min(a, b);
    }

    /// The lowest member of the set of each; the sets are used up.
    std::vector<Label> lowestOfEach() && {
        for (Label& lower : lower_)
            lower = lower_[index(lower)]; // that one has been done
        return std::move(lower_);
    }

    /// The number of the set of each; the sets are used up.
    Numbers numbers() && {
        Numbers numbers;
        for (Label member = 0; member < count(); ++member) {
            Label& lower = lower_[index(member)];
            lower = lower == member ? numbers.count++ : lower_[index(lower)]; // that one has its
        }
        numbers.of = std::move(lower_);
        return numbers;
    }

private:
    std::vector<Label> lower_;
};

} // namespace polymesh
