// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/extrude.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/validate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace polymesh::test {
namespace {

/// Two quadrilaterals side by side, 2 by 1; the second goes round the other way.
ExtrusionSpec sheet() {
    ExtrusionSpec extrusion;
    extrusion.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}};
    extrusion.quads = {{{0, 1, 2, 3}, "first"}, {{4, 1, 2, 5}, "second"}};
    extrusion.vector = {0, 0, 3};
    return extrusion;
}

Label facesOf(const PolyMesh& mesh, const std::string& patch) {
    const auto found = std::ranges::find(mesh.patches, patch, &Patch::name);
    return found == mesh.patches.end() ? -1 : found->size;
}

double volumeOf(const PolyMesh& mesh) {
    EXPECT_TRUE(validate(mesh).empty());
    const std::vector<double> volumes = computeGeometry(mesh).cellVolumes;
    EXPECT_GT(*std::ranges::min_element(volumes), 0);
    return std::accumulate(volumes.begin(), volumes.end(), 0.0);
}

std::string refusal(const ExtrusionSpec& extrusion) {
    try {
        extrudedBlocks(extrusion);
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing was refused";
}

TEST(Extrude, drawsASheetOutInLayers) {
    ExtrusionSpec extrusion = sheet();
    extrusion.cells = {3, 4};
    extrusion.layers = 5;
    extrusion.grading = {{1, 1, 16}};
    const PolyMesh mesh = blockMesh(extrudedBlocks(extrusion));
    EXPECT_NEAR(volumeOf(mesh), 6, 1e-12);
    EXPECT_EQ(mesh.cellCount, 2 * 3 * 4 * 5);
    EXPECT_EQ(facesOf(mesh, "start"), 24);
    EXPECT_EQ(facesOf(mesh, "end"), 24);
    EXPECT_EQ(facesOf(mesh, "side"), (6 + 6 + 4 + 4) * 5);
    EXPECT_EQ(mesh.patches.size(), 3U);
    const auto isHigh = [](const Vec3& p) { return p.z > 0 && p.z < 3; };
    std::vector<Vec3> between;
    std::ranges::copy_if(mesh.points, std::back_inserter(between), isHigh);
    const double first = std::ranges::min_element(between, {}, &Vec3::z)->z;
    const double last = 3 - std::ranges::max_element(between, {}, &Vec3::z)->z;
    EXPECT_NEAR(last / first, 16, 1e-10);
}

TEST(Extrude, goesEitherWayAndAskew) {
    for (const Vec3 vector : {Vec3{0, 0, -3}, Vec3{1, 2, 3}, Vec3{0.5, -9, -3}}) {
        ExtrusionSpec extrusion = sheet();
        extrusion.vector = vector;
        EXPECT_NEAR(volumeOf(blockMesh(extrudedBlocks(extrusion))), 6, 1e-12);
    }
}

TEST(Extrude, takesABentSheetWithAHole) {
    ExtrusionSpec extrusion;
    extrusion.vector = {0, 0, 1};
    for (Label j = 0; j < 4; ++j)
        for (Label i = 0; i < 4; ++i) {
            const auto x = static_cast<double>(i);
            const auto y = static_cast<double>(j);
            extrusion.points.push_back({x, y, 0.1 * x * y});
        }
    for (Label j = 0; j < 3; ++j)
        for (Label i = 0; i < 3; ++i) {
            const Label p = i + 4 * j;
            if (p != 5) extrusion.quads.push_back({{p, p + 1, p + 5, p + 4}, "quad"});
        }
    const PolyMesh mesh = blockMesh(extrudedBlocks(extrusion));
    EXPECT_NEAR(volumeOf(mesh), 8, 1e-12);
    EXPECT_EQ(facesOf(mesh, "side"), 12 + 4);
}

TEST(Extrude, refusesWhatMakesNoBlocksAndSaysWhere) {
    ExtrusionSpec folded = sheet();
    folded.points[4] = {0.4, 0, 1};
    folded.points[5] = {0.4, 1, 1};
    EXPECT_NE(refusal(folded).find("second: as seen along (0 0 3)"), std::string::npos);
    ExtrusionSpec concave = sheet();
    concave.points[3] = {0.9, 0.1, 0};
    EXPECT_NE(refusal(concave).find("first: the quadrilateral (0 1 2 3) near"), std::string::npos);
    ExtrusionSpec standing = sheet();
    standing.vector = {1, 1, 0};
    EXPECT_NE(refusal(standing).find("stands along the vector"), std::string::npos);
    ExtrusionSpec twice = sheet();
    twice.quads[1].points[3] = 4;
    EXPECT_NE(refusal(twice).find("second: the quadrilateral (4 1 2 4) has a point twice"),
              std::string::npos);
    ExtrusionSpec third = sheet();
    third.points.push_back({2, 0, 1});
    third.points.push_back({2, 1, 1});
    third.quads.push_back({{1, 6, 7, 2}, "third"});
    EXPECT_NE(refusal(third).find("third: as seen along"), std::string::npos);
}

} // namespace
} // namespace polymesh::test
