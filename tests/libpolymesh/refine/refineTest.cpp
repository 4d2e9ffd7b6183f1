// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/refine/refine.h"

#include "libpolymesh/base/threadLimit.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/validate.h"
#include "tests/libpolymesh/refine/macroCells.h"
#include "tests/support/sameMesh.h"

#include <gtest/gtest.h>

#include <map>

namespace polymesh {
namespace {

/// Wants cells near a point to have this level.
Criterion nearPoint(const Vec3& p, int level) {
    return [=](const RefineCell& cell) {
        return cell.level < level && norm(cell.centre - p) <= cell.radius;
    };
}

void expectValid(const RefinedMesh& refined) {
    const std::vector<Defect> defects = validate(refined.mesh);
    EXPECT_TRUE(defects.empty()) << defects.front().message;
}

/// Cells that share a point differ by one level at most.
void expectGraded(const RefinedMesh& refined) {
    std::map<Label, std::pair<Label, Label>> atPoint; // least and most level
    const PolyMesh& mesh = refined.mesh;
    const auto add = [&](Label face, Label cell) {
        const Label level = refined.cellLevel[index(cell)];
        for (const Label p : mesh.faces[face]) {
            auto& [least, most] = atPoint.try_emplace(p, level, level).first->second;
            least = std::min(least, level);
            most = std::max(most, level);
        }
    };
    for (Label f = 0; f < mesh.faceCount(); ++f) {
        add(f, mesh.owner[index(f)]);
        if (mesh.isInternal(f)) add(f, mesh.neighbour[index(f)]);
    }
    for (const auto& [point, levels] : atPoint)
        EXPECT_LE(levels.second - levels.first, 1) << "point " << point;
}

} // namespace

TEST(Refine, leavesAMeshAsItIsWhenNothingIsWanted) {
    const CartesianBox box{{{0, 0, 0}, {1, 2, 3}}, {3, 4, 5}};
    const RefinedMesh refined = refine(hexCells(box), {});
    EXPECT_EQ(refined.mesh, cartesianMesh(box));
    EXPECT_EQ(refined.pointLevel, std::vector<Label>(refined.mesh.points.size(), 0));
}

TEST(Refine, halvesEveryCellWhenAllIsWanted) {
    const Criterion all = [](const RefineCell& cell) { return cell.level < 2; };
    const CartesianBox fine{{{0, 0, 0}, {1, 2, 3}}, {8, 12, 4}};
    const RefinedMesh refined = refine(hexCells({fine.box, {2, 3, 1}}), {{all}, 1});
    expectValid(refined);
    const PolyMesh expected = cartesianMesh(fine);
    EXPECT_EQ(refined.mesh.pointCount(), expected.pointCount());
    EXPECT_EQ(refined.mesh.faceCount(), expected.faceCount());
    std::vector<Vec3> a = refined.mesh.points;
    std::vector<Vec3> b = expected.points;
    const auto key = [](const Vec3& p) { return std::array<double, 3>{p.x, p.y, p.z}; };
    std::ranges::sort(a, {}, key);
    std::ranges::sort(b, {}, key);
    EXPECT_EQ(a, b) << "bit for bit";
}

TEST(Refine, makesPolyhedraBesideFinerCells) {
    const CartesianBox box{{{0, 0, 0}, {2, 1, 1}}, {2, 1, 1}};
    const Criterion first = [](const RefineCell& cell) {
        return cell.initialCell == 0 && cell.level == 0;
    };
    const RefinedMesh refined = refine(hexCells(box), {{first}, 1});
    expectValid(refined);
    EXPECT_EQ(refined.mesh.cellCount, 9);
    EXPECT_EQ(refined.cellLevel, (std::vector<Label>{1, 1, 1, 1, 1, 1, 1, 1, 0}));
    EXPECT_EQ(refined.mesh.pointCount(), 12 + 19);
    // Four faces to the fine cells, and those four of its sides that touch them have middles.
    EXPECT_EQ(std::ranges::count(refined.mesh.neighbour, 8), 4);
    std::map<Label, int> corners;
    for (Label f = refined.mesh.internalFaceCount(); f < refined.mesh.faceCount(); ++f)
        if (refined.mesh.owner[index(f)] == 8) ++corners[refined.mesh.faces.rowSize(f)];
    EXPECT_EQ(corners, (std::map<Label, int>{{4, 1}, {5, 4}}));
}

TEST(Refine, isValidAndGradedHoweverCellsAreTurned) {
    for (unsigned seed = 1; seed <= 8; ++seed) {
        const HexCells cells = test::turned(hexCells({{{0, 0, 0}, {3, 3, 3}}, {3, 3, 3}}), seed);
        const RefinedMesh refined =
            refine(cells, {{nearPoint({1.1, 1, 1.3}, 5), nearPoint({3, 3, 0}, 3)}, 1});
        expectValid(refined);
        expectGraded(refined);
    }
}

TEST(Refine, isValidWhereTreesHaveAsManyLeavesAsEvenOnes) {
    // 64 leaves, the first of level 2, but also coarser and finer ones.
    const RefinedMesh refined = refine(hexCells({{{0, 0, 0}, {2, 1, 1}}, {2, 1, 1}}),
                                       {{[](const RefineCell& cell) {
                                            const Vec3& c = cell.centre;
                                            if (cell.initialCell != 0 || c.z > 0.5) return false;
                                            if (cell.level < 2) return c.y < 0.5 || cell.level == 0;
                                            return cell.level == 2 && c.y < 0.25 && c.z < 0.25;
                                        }},
                                        1});
    expectValid(refined);
    expectGraded(refined);
}

TEST(Refine, isValidForManyRandomSelections) {
    for (unsigned seed = 0; seed < 60; ++seed) {
        std::mt19937 random(seed);
        std::vector<Criterion> criteria;
        const auto number = [&] { return 2 * static_cast<double>(random()) / 4294967296.0; };
        for (unsigned i = 0; i < 1 + seed % 5; ++i) {
            const Vec3 at{number(), number(), number()};
            criteria.push_back(nearPoint(at, static_cast<int>(1 + random() % 5)));
        }
        const RefinedMesh refined = refine(hexCells({{{0, 0, 0}, {2, 2, 2}}, {2, 2, 2}}),
                                           {criteria, static_cast<int>(1 + seed % 3)});
        expectValid(refined);
        expectGraded(refined);
    }
}

TEST(Refine, isValidRoundEdgesOfAnyNumberOfCells) {
    for (const Label sectors : {3, 5, 6}) {
        const RefinedMesh refined =
            refine(test::turned(test::star(sectors), 7), {{nearPoint({0.01, 0.02, 0.3}, 5)}, 1});
        expectValid(refined);
        expectGraded(refined);
    }
}

TEST(Refine, isTheSameWithAnyNumberOfThreads) {
    const HexCells cells = hexCells({{{0, 0, 0}, {20, 20, 20}}, {20, 20, 20}});
    const RefineOptions options{{nearPoint({7.1, 3, 4.3}, 6), nearPoint({13, 18, 10}, 5)}, 2};
    const ThreadLimit one(1);
    const RefinedMesh expected = refine(cells, options);
    for (const std::size_t threads : {2U, 8U}) {
        const ThreadLimit limit(threads);
        const RefinedMesh refined = refine(cells, options);
        EXPECT_EQ(refined.mesh, expected.mesh);
        EXPECT_EQ(refined.pointLevel, expected.pointLevel);
    }
}

} // namespace polymesh
