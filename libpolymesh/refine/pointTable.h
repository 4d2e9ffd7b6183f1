// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/refine/partition.h"

#include <vector>

namespace polymesh {

/// A point of a tree.
using PointKey = std::uint64_t;

constexpr PointKey pointKey(const LatticePoint& p) {
    constexpr unsigned bits = latticeBits + 1;
    return static_cast<PointKey>(p[0]) | static_cast<PointKey>(p[1]) << bits |
           static_cast<PointKey>(p[2]) << 2 * bits;
}

constexpr LatticePoint latticePoint(PointKey key) {
    constexpr unsigned bits = latticeBits + 1;
    constexpr PointKey mask = (PointKey{1} << bits) - 1;
    return {static_cast<std::int32_t>(key & mask),
            static_cast<std::int32_t>(key >> bits & mask),
            static_cast<std::int32_t>(key >> 2 * bits)};
}

/// How often a tree is halved until this point comes up; 0 for its corners.
int levelOfPoint(const LatticePoint& p);

/// The numbers of the points of a refined mesh. Corners of trees keep the numbers that they have
/// in the macro-mesh; the others follow tree by tree, each with the lowest tree that has it.
class PointTable {
public:
    /// With several processes each knows the points of its trees.
    /// Cost: n log n in the points of a tree, in parallel; 12 bytes a point and tree that has it.
    PointTable(const MacroMesh& mesh,
               const TreeOctants& octants,
               const Partition& partition,
               const Processes& processes);

    Label pointCount() const { return firstOwned_.back(); }

    /// The number of a point of a tree, -1 when the mesh has none there.
    Label find(Label tree, const LatticePoint& p) const;

    /// Calls visit(point, number) for the points of a tree except its corners.
    template<class Visit>
    void forPointsOf(Label tree, Visit&& visit) const {
        for (Label slot = keys_.offsets[index(tree)]; slot < keys_.offsets[index(tree) + 1]; ++slot)
            visit(latticePoint(keys_.values[index(slot)]), labels_[index(slot)]);
    }

    /// A point and the lowest tree that has it, from which its coordinates come.
    struct Home {
        Label label = -1;
        Label tree = -1;
        LatticePoint point{};
    };

    /// Calls visit(home) for the points that trees of this process own, in parallel. Corners of
    /// trees are not visited.
    template<class Visit>
    void forOwnedPoints(Visit&& visit) const {
        forOwnSlots([&](Label tree, std::size_t slot) {
            if (labels_[slot] >= firstOwned_[index(tree)])
                visit(Home{labels_[slot], tree, latticePoint(keys_.values[slot])});
        });
    }

    /// The same for those that trees of other processes own, some more than once.
    template<class Visit>
    void forForeignPoints(Visit&& visit) const {
        for (Label tree = partition_.first(); tree < partition_.end(); ++tree)
            for (Label slot = keys_.offsets[index(tree)]; slot < keys_.offsets[index(tree) + 1];
                 ++slot)
                if (labels_[index(slot)] < firstOwned_[index(partition_.first())])
                    visit(homeOf(tree, latticePoint(keys_.values[index(slot)])));
    }

private:
    template<class Visit>
    void forOwnSlots(Visit&& visit) const {
        parallelFor(partition_.end() - partition_.first(), [&](Label i) {
            const Label tree = partition_.first() + i;
            for (Label slot = keys_.offsets[index(tree)]; slot < keys_.offsets[index(tree) + 1];
                 ++slot)
                visit(tree, index(slot));
        });
    }

    void countOwned(const Processes& processes);
    void setLabels();
    Home homeOf(Label tree, const LatticePoint& p) const;
    Label slotOf(Label tree, const LatticePoint& p) const;

    const MacroMesh& mesh_;
    const Partition& partition_;
    Rows<PointKey> keys_;           // of each tree, ascending, its corners left out
    std::vector<Label> labels_;     // of each key
    std::vector<Label> firstOwned_; // the first number of each tree's own points, and the count
};

} // namespace polymesh
