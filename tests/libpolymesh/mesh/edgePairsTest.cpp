// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mesh/edgePairs.h"

#include "libpolymesh/mesh/topology.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace polymesh {
namespace {

using Ends = std::pair<Label, Label>;

/// How often each directed edge is used, by a map.
std::map<Ends, int> usesOf(const PolyMesh& mesh, Label cell, std::span<const Label> faces) {
    std::map<Ends, int> uses;
    for (const Label face : faces) {
        const auto points = mesh.faces[face];
        for (std::size_t i = 0; i < points.size(); ++i) {
            Ends ends{points[i], points[(i + 1) % points.size()]};
            if (mesh.owner[index(face)] != cell) std::swap(ends.first, ends.second);
            ++uses[ends];
        }
    }
    return uses;
}

bool isPaired(const std::map<Ends, int>& uses, const Ends& edge) {
    const auto count = [&](const Ends& ends) {
        const auto found = uses.find(ends);
        return found == uses.end() ? 0 : found->second;
    };
    return edge.first != edge.second && count(edge) == 1 && count({edge.second, edge.first}) == 1;
}

/// The edge that is named is at fault, and none is named only where none is.
void expectRight(const PolyMesh& mesh, Label cell, std::span<const Label> faces) {
    EdgePairs pairs;
    const Ends found = unpairedEdge(mesh, cell, faces, pairs);
    const auto uses = usesOf(mesh, cell, faces);
    if (found.first >= 0) {
        EXPECT_FALSE(isPaired(uses, found));
        return;
    }
    for (const auto& [edge, count] : uses)
        EXPECT_TRUE(isPaired(uses, edge)) << edge.first << ' ' << edge.second;
}

TEST(EdgePairs, areOfEveryCellOfTheSupport) {
    for (const PolyMesh& mesh : {test::unitCube(),
                                 test::box(3, 4, 5),
                                 test::prismFan(7),
                                 test::lShapedCell(),
                                 test::tetrahedron(),
                                 test::pyramid(),
                                 test::hangingNodes()}) {
        EdgePairs pairs;
        const Rows<Label> faces = cellFaces(mesh);
        for (Label c = 0; c < mesh.cellCount; ++c)
            EXPECT_EQ(unpairedEdge(mesh, c, faces[c], pairs), Ends(-1, -1));
    }
}

TEST(EdgePairs, ofSpoiltCellsAreThoseOfAMap) {
    std::mt19937 random(7);
    const auto below = [&](std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
    };
    int closed = 0;
    for (int i = 0; i < 3000; ++i) {
        PolyMesh mesh = i % 2 == 0 ? test::unitCube() : test::prismFan(6);
        Rows<Label> faces = cellFaces(mesh);
        for (std::size_t change = below(3); change > 0; --change) {
            auto points = mesh.faces[toLabel(below(index(mesh.faceCount())))];
            if (below(2) == 0)
                std::ranges::reverse(points);
            else
                points[below(points.size())] = toLabel(below(mesh.points.size()));
        }
        EdgePairs pairs;
        closed += unpairedEdge(mesh, 0, faces[0], pairs).first < 0 ? 1 : 0;
        expectRight(mesh, 0, faces[0]);
    }
    EXPECT_GT(closed, 500); // the unchanged ones at least
    EXPECT_LT(closed, 2500);
}

TEST(EdgePairs, ofACellWithoutAFaceAreOpen) {
    const PolyMesh mesh = test::unitCube();
    const Rows<Label> faces = cellFaces(mesh);
    EdgePairs pairs;
    EXPECT_GE(unpairedEdge(mesh, 0, faces[0].subspan(1), pairs).first, 0);
}

} // namespace
} // namespace polymesh
