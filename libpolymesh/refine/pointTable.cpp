// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/refine/pointTable.h"

#include "libpolymesh/base/freshList.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace polymesh {
namespace {

using Keys = std::vector<PointKey>;

constexpr Label blockSize = 256; // trees that a thread takes at a time

/// For each direction 0 at the lower end of a tree, 2 at the upper, 1 between; and how many ends.
struct Ends {
    std::array<int, 3> at{};
    int count = 0;

    explicit Ends(const LatticePoint& p) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            at[axis] = p[axis] == 0 ? 0 : p[axis] == latticeSize ? 2 : 1;
            if (at[axis] != 1) ++count;
        }
    }

    int code() const { return at[0] + 3 * at[1] + 9 * at[2]; }

    /// The side of the tree, of a point on one.
    std::size_t side() const {
        const std::size_t axis = at[0] != 1 ? 0 : at[1] != 1 ? 1 : 2;
        return 2 * axis + (at[axis] == 2 ? 1 : 0);
    }

    /// The direction of the tree's edge, of a point on one.
    std::size_t along() const { return at[0] == 1 ? 0 : at[1] == 1 ? 1 : 2; }

    /// The ends of the tree's edge, of a point on one.
    std::array<std::size_t, 2> edge() const {
        std::size_t corner = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (at[axis] == 2) corner |= std::size_t{1} << axis;
        return {corner, corner | std::size_t{1} << along()};
    }
};

/// The point at `distance` from corner a of a tree on the edge to its corner b.
LatticePoint pointOnEdge(std::size_t a, std::size_t b, std::int32_t distance) {
    LatticePoint p{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int32_t end = (a >> axis & 1U) != 0 ? latticeSize : 0;
        const bool isAlong = ((a ^ b) >> axis & 1U) != 0;
        p[axis] = !isAlong ? end : end == 0 ? distance : latticeSize - distance;
    }
    return p;
}

/// Collects the points of one tree: those of its own octants, and what octants of other trees
/// leave on its sides and edges.
class PointCollector {
public:
    PointCollector(const MacroMesh& mesh, const TreeOctants& octants, Label tree)
        : mesh_(mesh), octants_(octants), tree_(tree) {}

    const Keys& collect();

private:
    void addOwn();
    void addAcross(std::size_t side);
    void addRound(const std::array<std::size_t, 2>& ends);
    bool isAcross(Label other) const;

    const MacroMesh& mesh_;
    const TreeOctants& octants_;
    Label tree_;
    Keys keys_;
};

/// Calls visit(point) for the middles of an octant, its sides and its edges.
template<class Visit>
void forMiddles(const Octant& octant, Visit&& visit) {
    const std::int32_t half = octant.size() / 2;
    for (int i = 0; i < 27; ++i) {
        const LatticePoint step{i % 3, i / 3 % 3, i / 9};
        if (step[0] != 1 && step[1] != 1 && step[2] != 1) continue;
        visit(LatticePoint{octant.anchor[0] + step[0] * half,
                           octant.anchor[1] + step[1] * half,
                           octant.anchor[2] + step[2] * half});
    }
}

void PointCollector::addOwn() {
    for (const OctantCode code : octants_.of(tree_))
        forMiddles(octantOf(code), [&](const LatticePoint& p) { keys_.push_back(pointKey(p)); });
}

void PointCollector::addAcross(std::size_t side) {
    const Label other = mesh_.neighbour(tree_, side);
    if (other < 0 || octants_.of(other).empty()) return;
    std::size_t back = 0;
    while (mesh_.neighbour(other, back) != tree_)
        ++back;
    const Passage passage(mesh_, other, back);
    const std::size_t normal = back / 2;
    const std::int32_t plane = back % 2 == 0 ? 0 : latticeSize;
    for (const OctantCode code : octants_.of(other)) {
        const Octant octant = octantOf(code);
        if (octant.anchor[normal] != plane && octant.anchor[normal] + octant.size() != plane)
            continue;
        forMiddles(octant, [&](const LatticePoint& p) {
            if (p[normal] == plane) keys_.push_back(pointKey(passage.point(p)));
        });
    }
}

bool PointCollector::isAcross(Label other) const {
    for (std::size_t side = 0; side < 6; ++side)
        if (mesh_.neighbour(tree_, side) == other) return true;
    return false;
}

void PointCollector::addRound(const std::array<std::size_t, 2>& ends) {
    mesh_.forCellsAtEdge(tree_, ends, [&](Label other, std::size_t a, std::size_t b) {
        if (other == tree_ || octants_.of(other).empty() || isAcross(other)) return;
        for (const OctantCode code : octants_.of(other)) {
            const Octant octant = octantOf(code);
            // The octant's corners that lie on the edge, if they do, and the distance from a.
            const LatticePoint first = octant.corner(a);
            std::int32_t distance = 0;
            bool isOnEdge = true;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::int32_t end = (a >> axis & 1U) != 0 ? latticeSize : 0;
                if (((a ^ b) >> axis & 1U) != 0)
                    distance = std::abs(first[axis] - end) + octant.size() / 2;
                else
                    isOnEdge = isOnEdge && first[axis] == end;
            }
            if (isOnEdge) keys_.push_back(pointKey(pointOnEdge(ends[0], ends[1], distance)));
        }
    });
}

const Keys& PointCollector::collect() {
    addOwn();
    for (std::size_t side = 0; side < 6; ++side)
        addAcross(side);
    for (std::size_t corner = 0; corner < 8; ++corner)
        for (std::size_t axis = 0; axis < 3; ++axis)
            if ((corner >> axis & 1U) == 0) addRound({corner, corner | std::size_t{1} << axis});
    std::ranges::sort(keys_);
    keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
    return keys_;
}

Rows<PointKey>
pointsOfTrees(const MacroMesh& mesh, const TreeOctants& octants, const std::vector<char>& inSight) {
    const Label count = mesh.cellCount();
    std::vector<Rows<PointKey>> parts(index((count + blockSize - 1) / blockSize));
    parallelBlocks(count, blockSize, [&](Label block, Label first, Label last) {
        for (Label tree = first; tree < last; ++tree) {
            if (octants.highest[index(tree)] == 0 || inSight[index(tree)] == 0)
                parts[index(block)].add({});
            else
                parts[index(block)].add(PointCollector(mesh, octants, tree).collect());
        }
    });
    return joined(parts);
}

/// The lowest tree that has the point.
Label ownerOf(const MacroMesh& mesh, Label tree, const Ends& ends) {
    if (ends.count == 0) return tree;
    if (ends.count == 1) {
        const Label other = mesh.neighbour(tree, ends.side());
        return other < 0 ? tree : std::min(tree, other);
    }
    Label lowest = tree;
    mesh.forCellsAtEdge(tree, ends.edge(), [&](Label other, std::size_t, std::size_t) {
        lowest = std::min(lowest, other);
    });
    return lowest;
}

} // namespace

int levelOfPoint(const LatticePoint& p) {
    const auto bits = static_cast<unsigned>(p[0] | p[1] | p[2] | latticeSize);
    return latticeBits - std::countr_zero(bits);
}

PointTable::PointTable(const MacroMesh& mesh,
                       const TreeOctants& octants,
                       const Partition& partition,
                       const Processes& processes)
    : mesh_(mesh),
      partition_(partition),
      keys_(pointsOfTrees(mesh, octants, treesInSight(mesh, partition))) {
    countOwned(processes);
    setLabels();
}

/// Numbers the points within their owners; those of other trees get -1.
void PointTable::countOwned(const Processes& processes) {
    const Label trees = mesh_.cellCount();
    labels_ = freshList<Label>(keys_.values.size());
    std::vector<Label> counts(index(trees), 0);
    parallelFor(trees, [&](Label tree) {
        constexpr Label unknown = -1;
        std::array<Label, 27> owners{};
        owners.fill(unknown);
        Label& count = counts[index(tree)];
        for (Label slot = keys_.offsets[index(tree)]; slot < keys_.offsets[index(tree) + 1];
             ++slot) {
            const Ends ends(latticePoint(keys_.values[index(slot)]));
            Label& owner = owners[static_cast<std::size_t>(ends.code())];
            if (owner == unknown) owner = ownerOf(mesh_, tree, ends);
            labels_[index(slot)] = owner == tree ? count++ : -1;
        }
    });
    counts = processes.gather(
        std::vector<Label>(counts.begin() + partition_.first(), counts.begin() + partition_.end()));
    firstOwned_.assign(1, mesh_.pointCount());
    firstOwned_.insert(firstOwned_.end(), counts.begin(), counts.end());
    std::partial_sum(firstOwned_.begin(), firstOwned_.end(), firstOwned_.begin());
}

void PointTable::setLabels() {
    parallelFor(mesh_.cellCount(), [&](Label tree) {
        for (Label slot = keys_.offsets[index(tree)]; slot < keys_.offsets[index(tree) + 1]; ++slot)
            if (labels_[index(slot)] >= 0) labels_[index(slot)] += firstOwned_[index(tree)];
    });
    forOwnSlots([&](Label tree, std::size_t slot) {
        if (labels_[slot] < 0) labels_[slot] = homeOf(tree, latticePoint(keys_.values[slot])).label;
    });
}

Label PointTable::slotOf(Label tree, const LatticePoint& p) const {
    const std::span<const PointKey> row = keys_[tree];
    const PointKey key = pointKey(p);
    const auto found = std::lower_bound(row.begin(), row.end(), key);
    if (found == row.end() || *found != key) return -1;
    return keys_.offsets[index(tree)] + static_cast<Label>(found - row.begin());
}

/// Requires: another tree owns the point.
PointTable::Home PointTable::homeOf(Label tree, const LatticePoint& p) const {
    const Ends ends(p);
    Home home;
    if (ends.count == 1) {
        const Passage passage(mesh_, tree, ends.side());
        home = {-1, passage.cell(), passage.point(p)};
    } else {
        const std::int32_t distance = p[ends.along()];
        mesh_.forCellsAtEdge(tree, ends.edge(), [&](Label other, std::size_t a, std::size_t b) {
            if (home.tree < 0) home = {-1, other, pointOnEdge(a, b, distance)}; // the lowest
        });
    }
    home.label = labels_[index(slotOf(home.tree, home.point))];
    return home;
}

Label PointTable::find(Label tree, const LatticePoint& p) const {
    std::size_t corner = 0;
    bool isCorner = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (p[axis] == latticeSize)
            corner |= std::size_t{1} << axis;
        else if (p[axis] != 0)
            isCorner = false;
    }
    if (isCorner) return mesh_.corners(tree)[corner];
    const Label slot = slotOf(tree, p);
    return slot < 0 ? -1 : labels_[index(slot)];
}

} // namespace polymesh
