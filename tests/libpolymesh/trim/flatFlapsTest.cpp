// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/flatFlaps.h"

#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/quality/validateEdit.h"
#include "tests/support/editedMesh.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace polymesh::test {

namespace {

/// A cube, and where `hasCellAbove` a cell twice as long on top of it. The top of the cube is as
/// long too; beyond the cube it is covered by a flap, which is `height` below it.
PolyMesh cubeWithAFlap(bool hasCellAbove, double height) {
    const double z = 1 - height;
    std::vector<Vec3> points{{0, 0, 0},
                             {1, 0, 0},
                             {1, 1, 0},
                             {0, 1, 0}, // the bottom of the cube
                             {0, 0, 1},
                             {1, 0, z},
                             {2, 0, 1},
                             {2, 1, 1},
                             {1, 1, z},
                             {0, 1, 1}, // its top and the flap
                             {0, 0, 2},
                             {2, 0, 2},
                             {2, 1, 2},
                             {0, 1, 2}};
    const Polyhedron cube{{0, 3, 2, 1},
                          {0, 1, 5, 4},
                          {1, 2, 8, 5},
                          {2, 3, 9, 8},
                          {3, 0, 4, 9},
                          {5, 8, 7, 6},
                          {4, 5, 6, 7, 8, 9}};
    const Polyhedron above{{4, 9, 8, 7, 6, 5},
                           {10, 11, 12, 13},
                           {4, 5, 6, 11, 10},
                           {6, 7, 12, 11},
                           {7, 8, 9, 13, 12},
                           {9, 4, 10, 13}};
    if (!hasCellAbove) {
        points.resize(10);
        return meshOf(points, {cube});
    }
    return meshOf(points, {cube, above}, [](const Vec3& centre) -> std::string {
        return centre.z == 1 ? "flap" : "walls";
    });
}

TEST(RemoveFlatFlaps, givesWhatAFlapCoversToTheCellBeyond) {
    EditedMesh edited(cubeWithAFlap(true, 0));
    EXPECT_EQ(removeFlatFlaps(edited.editor), 1);
    const PolyMesh mesh = edited.result();
    EXPECT_TRUE(validate(mesh).empty());
    ASSERT_EQ(mesh.cellCount, 2);
    ASSERT_EQ(mesh.internalFaceCount(), 1);
    EXPECT_EQ(mesh.faces.rowSize(0), 4U);
    ASSERT_EQ(mesh.patches[0].name, "flap");
    ASSERT_EQ(mesh.patches[0].size, 1);
    EXPECT_EQ(mesh.owner[index(mesh.patches[0].start)], 1);
}

TEST(RemoveFlatFlaps, takesOneOnTheBoundaryAway) {
    EditedMesh edited(cubeWithAFlap(false, 0));
    EXPECT_EQ(removeFlatFlaps(edited.editor), 1);
    EXPECT_EQ(validateEdit(edited.part.mesh), std::vector<std::string>{});
    const PolyMesh mesh = edited.result();
    ASSERT_EQ(mesh.faceCount(), 6);
    for (Label f = 0; f < 6; ++f)
        EXPECT_EQ(mesh.faces.rowSize(f), 4U);
}

TEST(RemoveFlatFlaps, leavesOneWithThickness) {
    for (const bool hasCellAbove : {false, true}) {
        EditedMesh edited(cubeWithAFlap(hasCellAbove, 1e-3));
        EXPECT_EQ(removeFlatFlaps(edited.editor), 0);
    }
}

} // namespace

} // namespace polymesh::test
