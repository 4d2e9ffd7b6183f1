// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mesh/valences.h"

#include "tests/support/meshes.h"

#include <gtest/gtest.h>

namespace polymesh::test {

TEST(CountValences, countsNodesCellByCell) {
    const ValenceCounts cubes = countValences(twoHexes(), 0);
    EXPECT_EQ(cubes.trivalent, 16U);
    EXPECT_EQ(cubes.more + cubes.bends, 0U);
    EXPECT_EQ(cubes.trivalentShare(), 1);
    const ValenceCounts one = countValences(pyramid(), 0);
    EXPECT_EQ(one.trivalent, 4U);
    EXPECT_EQ(one.more, 1U); // the apex
    EXPECT_DOUBLE_EQ(one.trivalentShare(), 0.8);
}

TEST(CountValences, seesHangingNodesAndBends) {
    // The large cell has four nodes on edges of one face (three edges each) and one inside it.
    const ValenceCounts counts = countValences(hangingNodes(), 0);
    EXPECT_EQ(counts.more, 1U);
    EXPECT_EQ(counts.bends, 0U);
    PolyMesh bent = unitCube();
    bent.points.push_back({0.5, 0, 0}); // on the edge of two faces
    Rows<Label> faces;
    for (Label f = 0; f < bent.faceCount(); ++f) {
        std::vector<Label> face(bent.faces[f].begin(), bent.faces[f].end());
        for (std::size_t i = 0; i < face.size(); ++i) {
            const Label a = face[i];
            const Label b = face[(i + 1) % face.size()];
            if (std::min(a, b) != 0 || std::max(a, b) != 1) continue;
            face.insert(face.begin() + static_cast<std::ptrdiff_t>(i) + 1, 8);
            break;
        }
        faces.add(face);
    }
    bent.faces = faces;
    EXPECT_EQ(countValences(bent, 0).bends, 1U);
    EXPECT_EQ(countValences(bent, 0).trivalentShare(), 1);
}

TEST(CountValences, countsOnlyCellsAtTheGivenPart) {
    const PolyMesh mesh = box(4, 1, 1);
    const Label last = mesh.faceCount() - 1; // belongs to one cell
    EXPECT_EQ(countValences(mesh, last).trivalent, 8U);
    EXPECT_EQ(countValences(mesh, mesh.faceCount()).trivalent, 0U);
    EXPECT_EQ(countValences(mesh, mesh.faceCount()).trivalentShare(), 1);
}

} // namespace polymesh::test
