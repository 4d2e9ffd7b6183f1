// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/cartesian.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/threadLimit.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <utility>

namespace polymesh {

namespace {

const std::vector<std::array<Label, 3>> someCounts{{1, 1, 1},
                                                   {2, 1, 1},
                                                   {1, 2, 1},
                                                   {1, 1, 2},
                                                   {1, 2, 3},
                                                   {3, 1, 2},
                                                   {2, 3, 1},
                                                   {2, 2, 2},
                                                   {4, 3, 5}};

PolyMesh meshOf(const std::array<Label, 3>& cells) {
    return cartesianMesh({{{-1, 0, 0.5}, {2, 1, 4.5}}, cells});
}

/// Twice the area vector of a planar quadrangle.
Vec3 areaVector(const PolyMesh& mesh, Label face) {
    const auto p = mesh.faces[face];
    const auto at = [&](std::size_t i) { return mesh.points[index(p[i])]; };
    return cross(at(2) - at(0), at(3) - at(1));
}

Vec3 centreOf(const PolyMesh& mesh, Label face) {
    Vec3 sum;
    for (const Label p : mesh.faces[face])
        sum += mesh.points[index(p)];
    return 0.25 * sum;
}

} // namespace

TEST(CartesianMesh, isInUpperTriangularOrder) {
    for (const auto& cells : someCounts) {
        const PolyMesh mesh = meshOf(cells);
        std::pair<Label, Label> previous{-1, -1};
        for (Label f = 0; f < mesh.internalFaceCount(); ++f) {
            const std::pair<Label, Label> pair{mesh.owner[index(f)], mesh.neighbour[index(f)]};
            EXPECT_LT(pair.first, pair.second);
            EXPECT_LT(previous, pair);
            previous = pair;
        }
    }
}

TEST(CartesianMesh, everyCellIsClosedAndFacesPointOutOfTheirOwner) {
    for (const auto& cells : someCounts) {
        const PolyMesh mesh = meshOf(cells);
        std::map<std::array<Label, 3>, int> uses; // cell, edge from, edge to
        std::vector<Vec3> closure(index(mesh.cellCount));
        for (Label f = 0; f < mesh.faceCount(); ++f) {
            const auto points = mesh.faces[f];
            const Label own = mesh.owner[index(f)];
            closure[index(own)] += areaVector(mesh, f);
            for (std::size_t i = 0; i < 4; ++i)
                ++uses[{own, points[i], points[(i + 1) % 4]}];
            if (!mesh.isInternal(f)) continue;
            const Label other = mesh.neighbour[index(f)];
            closure[index(other)] -= areaVector(mesh, f);
            for (std::size_t i = 0; i < 4; ++i)
                ++uses[{other, points[(i + 1) % 4], points[i]}];
        }
        EXPECT_EQ(uses.size(), 24 * index(mesh.cellCount));
        for (const auto& [edge, count] : uses) {
            EXPECT_EQ(count, 1);
            EXPECT_TRUE(uses.contains({edge[0], edge[2], edge[1]}));
        }
        for (const Vec3& sum : closure)
            EXPECT_LT(norm(sum), 1e-14);
    }
}

TEST(CartesianMesh, fillsTheBox) {
    for (const auto& cells : someCounts) {
        const PolyMesh mesh = meshOf(cells);
        EXPECT_EQ(mesh.cellCount, cells[0] * cells[1] * cells[2]);
        double volume = 0;
        for (Label f = mesh.internalFaceCount(); f < mesh.faceCount(); ++f)
            volume += dot(areaVector(mesh, f), centreOf(mesh, f)) / 6;
        EXPECT_NEAR(volume, 12, 1e-13);
        EXPECT_EQ(boundingBox(mesh.points), (Box{{-1, 0, 0.5}, {2, 1, 4.5}}));
    }
}

TEST(CartesianMesh, patchesLieOnTheSidesThatTheyName) {
    const PolyMesh mesh = meshOf({4, 3, 5});
    const std::vector<std::pair<std::string, double>> sides{
        {"xMin", -1}, {"xMax", 2}, {"yMin", 0}, {"yMax", 1}, {"zMin", 0.5}, {"zMax", 4.5}};
    ASSERT_EQ(mesh.patches.size(), sides.size());
    Label start = mesh.internalFaceCount();
    for (std::size_t s = 0; s < sides.size(); ++s) {
        const Patch& patch = mesh.patches[s];
        const int axis = static_cast<int>(s / 2);
        EXPECT_EQ(patch.name, sides[s].first);
        EXPECT_EQ(patch.start, start);
        for (Label f = patch.start; f < patch.start + patch.size; ++f) {
            EXPECT_EQ(centreOf(mesh, f)[axis], sides[s].second);
            EXPECT_GT(areaVector(mesh, f)[axis] * (s % 2 == 0 ? -1 : 1), 0);
        }
        start += patch.size;
    }
    EXPECT_EQ(start, mesh.faceCount());
}

TEST(CartesianMesh, planesHaveOneCoordinateAndTenthsAreTenths) {
    const PolyMesh mesh = cartesianMesh({{{0, 0, 0}, {1, 1, 1}}, {10, 10, 10}});
    for (Label p = 0; p < mesh.pointCount(); ++p)
        EXPECT_EQ(mesh.points[index(p)].x, (p % 11) / 10.0);
}

TEST(CartesianMesh, piecesAreTheWhole) {
    const CartesianMesh source({{{0, 0, 0}, {1, 1, 1}}, {3, 4, 2}});
    const PolyMesh mesh = cartesianMesh({{{0, 0, 0}, {1, 1, 1}}, {3, 4, 2}});
    for (const Label piece : {1, 2, 7, 1000}) {
        Label expected = 0;
        for (Label first = 0; first < source.faceCount(); first += piece) {
            const Label last = std::min(source.faceCount(), first + piece);
            source.visitFaces(first, last, [&](Label f, const CartesianMesh::Face& face) {
                EXPECT_EQ(f, expected++);
                EXPECT_EQ(face.owner, mesh.owner[index(f)]);
                EXPECT_TRUE(std::ranges::equal(face.points, mesh.faces[f]));
            });
        }
        EXPECT_EQ(expected, mesh.faceCount());
    }
}

TEST(CartesianMesh, isTheSameWithOneThreadAndFour) {
    const CartesianBox box{{{0, 0, 0}, {1, 2, 3}}, {40, 50, 60}};
    PolyMesh one;
    {
        const ThreadLimit limit(1);
        one = cartesianMesh(box);
    }
    const ThreadLimit limit(4);
    EXPECT_EQ(one, cartesianMesh(box));
}

TEST(CartesianMesh, refusesNonsense) {
    const Box unit{{0, 0, 0}, {1, 1, 1}};
    EXPECT_THROW(CartesianMesh({unit, {0, 1, 1}}), InputError);
    EXPECT_THROW(CartesianMesh({unit, {-1, -1, 1}}), InputError);
    EXPECT_THROW(CartesianMesh({{{0, 0, 0}, {1, 0, 1}}, {1, 1, 1}}), InputError);
    EXPECT_THROW(CartesianMesh({{{0, 0, 0}, {1, std::nan(""), 1}}, {1, 1, 1}}), InputError);
    EXPECT_THROW(CartesianMesh({{{1e16, 0, 0}, {1e16 + 4, 1, 1}}, {100, 1, 1}}), InputError);
    const Label most = std::numeric_limits<Label>::max();
    EXPECT_THROW(CartesianMesh({unit, {most, most, most}}), InputError);
    EXPECT_THROW(CartesianMesh({unit, {most, 1, 1}}), InputError);
}

TEST(BoxAround, keepsTheSurfaceAQuarterCellFromEveryPlane) {
    for (const double size : {0.95, 0.9999, 1.0, 1.0001, 1.05, 1.09, 1.1, 7.3}) {
        const CartesianBox box = boxAround({{3, 3, 3}, {3 + size, 4, 5}}, 0.1, defaultMargin(0.1));
        const double outside = (3 - box.box.min.x) / 0.1; // [cells]
        EXPECT_GE(outside, 0.25 - 1e-9) << size;
        EXPECT_LE(outside, 0.75 + 1e-9) << size;
        EXPECT_NEAR(box.box.centre().x, 3 + size / 2, 1e-12);
        EXPECT_NEAR(box.box.size().x, 0.1 * box.cells[0], 1e-12);
    }
}

TEST(BoxAround, marginIsTakenAsGiven) {
    const CartesianBox box = boxAround({{0, 0, 0}, {1, 1, 1}}, 0.1, 0.2);
    EXPECT_EQ(box.cells, (std::array<Label, 3>{14, 14, 14}));
    EXPECT_NEAR(box.box.min.x, -0.2, 1e-15);
}

TEST(BoxAround, refusesNonsense) {
    const Box unit{{0, 0, 0}, {1, 1, 1}};
    EXPECT_THROW(boxAround(unit, 0, 0), InputError);
    EXPECT_THROW(boxAround(unit, -1, 0), InputError);
    EXPECT_THROW(boxAround(unit, std::nan(""), 0), InputError);
    EXPECT_THROW(boxAround(unit, 0.1, -1), InputError);
    EXPECT_THROW(boxAround(unit, 1e-30, 0), InputError);
    EXPECT_THROW(boxAround({}, 0.1, 0), InputError);
}

} // namespace polymesh
