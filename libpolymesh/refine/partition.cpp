// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/refine/partition.h"

namespace polymesh {

Partition evenPartition(Label trees, const Processes& processes) {
    Partition partition{{}, processes.rank()};
    for (int r = 0; r <= processes.count(); ++r)
        partition.firstTree.push_back(
            static_cast<Label>(std::int64_t{trees} * r / processes.count()));
    return partition;
}

Partition partitionByLeaves(const TreeOctants& octants, const Processes& processes) {
    const Label trees = toLabel(octants.rowOf.size());
    const std::int64_t leaves = trees + 7 * static_cast<std::int64_t>(octants.rows.values.size());
    Partition partition{{0}, processes.rank()};
    std::int64_t before = 0;
    for (Label tree = 0; tree < trees; ++tree) {
        const auto next = static_cast<std::int64_t>(partition.firstTree.size());
        if (next < processes.count() && before >= leaves * next / processes.count())
            partition.firstTree.push_back(tree);
        before += octants.leafCount(tree);
    }
    partition.firstTree.resize(static_cast<std::size_t>(processes.count()) + 1, trees);
    return partition;
}

std::vector<char> treesInSight(const MacroMesh& mesh, const Partition& partition) {
    std::vector<char> inSight(index(mesh.cellCount()), partition.isWhole() ? 1 : 0);
    if (partition.isWhole()) return inSight;
    for (Label tree = partition.first(); tree < partition.end(); ++tree)
        for (const Label p : mesh.corners(tree))
            for (const Label other : mesh.cellsAt(p))
                inSight[index(other)] = 1;
    return inSight;
}

} // namespace polymesh
