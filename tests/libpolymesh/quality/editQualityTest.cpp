// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/editQuality.h"

#include "editMeshes.h"

#include <gtest/gtest.h>

#include <array>

namespace polymesh {

namespace {

/// Of one cube with its height changed to that.
Badness badnessOfHeight(double height) {
    EditMesh mesh = test::boxOfHexes({1, 1, 1}, 1.0);
    for (Vec3& p : mesh.points)
        p.z *= height;
    MeshEditor editor(mesh);
    const std::array<Label, 1> cells{0};
    return badnessOf(editor, cells);
}

TEST(Badness, growsAsACellGetsFlatter) {
    EXPECT_EQ(badnessOfHeight(1), Badness());
    EXPECT_EQ(badnessOfHeight(1e-2), Badness());
    const Badness thin = badnessOfHeight(2e-3); // an aspect ratio of 500
    EXPECT_EQ(thin.failures, 0);
    EXPECT_GT(thin.severity, 0);
    const Badness flat = badnessOfHeight(1e-8);
    EXPECT_GT(flat.failures, 0);
    EXPECT_EQ(flat.invalid, 0);
    EXPECT_TRUE(isBetter(thin, flat));
    EXPECT_FALSE(isNoWorse(flat, thin));
}

TEST(Badness, aCellWithoutHeightOrInsideOutIsInvalid) {
    for (const double height : {1e-12, 0.0, -1.0})
        EXPECT_GT(badnessOfHeight(height).invalid, 0) << height;
}

} // namespace

} // namespace polymesh
