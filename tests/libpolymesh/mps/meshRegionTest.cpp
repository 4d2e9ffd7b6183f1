// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/meshRegion.h"

#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/mps/cones.h"
#include "libpolymesh/mps/joinCells.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace polymesh {

namespace {

/// A row of boxes with a zone of every second cell and one of all internal faces.
PolyMesh row(Label n) {
    PolyMesh mesh = test::box(n, 1, 1);
    Zone cells{"even", {}, {}};
    for (Label cell = 0; cell < n; cell += 2)
        cells.labels.push_back(cell);
    Zone faces{"between", {}, {}};
    for (Label face = 0; face < mesh.internalFaceCount(); ++face) {
        faces.labels.push_back(face);
        faces.flip.push_back(face % 2 != 0);
    }
    mesh.cellZones.push_back(cells);
    mesh.faceZones.push_back(faces);
    return mesh;
}

} // namespace

TEST(MeshRegion, hasTwoRingsAndARim) {
    const MeshRegion region = regionRound(unedited(row(9)), std::vector<Label>{4});
    EXPECT_EQ(region.part.cellFrom, (std::vector<Label>{2, 3, 4, 5, 6}));
    EXPECT_EQ(region.part.rimFaces, 2);
    EXPECT_TRUE(validate(region.part.mesh).empty());
    EXPECT_EQ(region.part.mesh.cellZones[0].labels, (std::vector<Label>{0, 2, 4}));
    EXPECT_EQ(region.part.mesh.faceZones[0].labels.size(), 4U);
}

TEST(MeshRegion, goesBackAsItWas) {
    const EditedMesh whole = unedited(row(9));
    const MeshRegion region = regionRound(whole, std::vector<Label>{1, 7});
    const EditedMesh back = withRegion(whole, region, region.part).whole;
    EXPECT_EQ(back.mesh, whole.mesh);
    EXPECT_EQ(back.cellFrom, whole.cellFrom);
    EXPECT_EQ(back.boundaryFrom, whole.boundaryFrom);
}

TEST(MeshRegion, regionOfARegionGoesBackThroughBoth) {
    const EditedMesh whole = unedited(row(9));
    const MeshRegion outer = regionRound(whole, std::vector<Label>{4});
    const MeshRegion inner = regionRound(outer.part, std::vector<Label>{0});
    EXPECT_EQ(inner.part.rimFaces, 2); // one of either rim
    const EditedMesh part = withRegion(outer.part, inner, inner.part).whole;
    EXPECT_EQ(part.rimFaces, 2);
    EXPECT_EQ(withRegion(whole, outer, part).whole.mesh, whole.mesh);
}

TEST(MeshRegion, newCellsComeLastAndZonesFollow) {
    const EditedMesh whole = unedited(row(9));
    const MeshRegion region = regionRound(whole, std::vector<Label>{4});
    EditedMesh part = region.part;
    const CellCones cones{2, {{0.5, 0.5, 0.5}}, {0, 1, 2, 3, 4, 5}, 6};
    part.mesh = withCones(part.mesh, cellFaces(part.mesh), std::vector{cones});
    part.cellFrom.resize(index(part.mesh.cellCount), part.cellFrom[2]);
    const auto [back, cells] = withRegion(whole, region, part);
    EXPECT_TRUE(validate(back.mesh).empty());
    EXPECT_EQ(back.mesh.cellCount, 14);
    EXPECT_EQ(cells, (std::vector<Label>{2, 3, 4, 5, 6, 9, 10, 11, 12, 13}));
    EXPECT_EQ(back.mesh.cellZones[0].labels,
              (std::vector<Label>{0, 2, 4, 6, 8, 9, 10, 11, 12, 13}));
    EXPECT_EQ(std::ranges::count(back.cellFrom, 4), 6);
    EXPECT_EQ(back.mesh.faceZones[0].labels.size(), 8U);
    EXPECT_NEAR(test::volumeOf(back.mesh), test::volumeOf(whole.mesh), 1e-12);
}

TEST(MeshRegion, cellsMoveUpWhereOneIsJoined) {
    const EditedMesh whole = unedited(row(9));
    const MeshRegion region = regionRound(whole, std::vector<Label>{4});
    EditedMesh part = region.part;
    part.mesh = withJoinedCells(part.mesh, std::vector{std::pair<Label, Label>{2, 3}});
    part.cellFrom.erase(part.cellFrom.begin() + 3);
    const auto [back, cells] = withRegion(whole, region, part);
    EXPECT_TRUE(validate(back.mesh).empty());
    EXPECT_EQ(back.mesh.cellCount, 8);
    EXPECT_EQ(cells, (std::vector<Label>{2, 3, 4, 5}));
    EXPECT_EQ(back.cellFrom, (std::vector<Label>{0, 1, 2, 3, 4, 6, 7, 8}));
    EXPECT_EQ(back.mesh.faceZones[0].labels.size(), 7U);
}

} // namespace polymesh
