// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mesh/internalFaces.h"

#include "libpolymesh/base/threadLimit.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace polymesh {
namespace {

/// Adds up in each cell the labels of its internal faces: a lost update would show.
std::vector<std::int64_t> sumsOfCells(const PolyMesh& mesh) {
    std::vector<std::int64_t> sums(index(mesh.cellCount), 0);
    forInternalFaces(mesh, [&](Label f) {
        sums[index(mesh.owner[index(f)])] += f + 1;
        sums[index(mesh.neighbour[index(f)])] += f + 1;
    });
    return sums;
}

std::vector<std::int64_t> expectedSums(const PolyMesh& mesh) {
    std::vector<std::int64_t> sums(index(mesh.cellCount), 0);
    for (Label f = 0; f < mesh.internalFaceCount(); ++f)
        for (const Label c : {mesh.owner[index(f)], mesh.neighbour[index(f)]})
            sums[index(c)] += f + 1;
    return sums;
}

TEST(ForInternalFaces, visitsEachOnceWhateverTheNumberOfThreads) {
    for (const PolyMesh& mesh : {test::box(1, 1, 1), test::box(3, 1, 1), test::box(40, 40, 40)})
        for (const std::size_t threads : {1U, 2U, 8U}) {
            const ThreadLimit limit(threads);
            EXPECT_EQ(sumsOfCells(mesh), expectedSums(mesh));
        }
}

TEST(ForInternalFaces, acceptsFacesAndSidesInAnyOrder) {
    PolyMesh mesh = test::box(30, 20, 20);
    for (Label f = 0; f < mesh.internalFaceCount(); f += 3) // owners still ascend
        std::swap(mesh.owner[index(f)], mesh.neighbour[index(f)]);
    std::sort(mesh.owner.begin(), mesh.owner.begin() + mesh.internalFaceCount());
    EXPECT_EQ(sumsOfCells(mesh), expectedSums(mesh));
    std::reverse(mesh.owner.begin(), mesh.owner.begin() + mesh.internalFaceCount());
    EXPECT_EQ(sumsOfCells(mesh), expectedSums(mesh));
}

} // namespace
} // namespace polymesh
