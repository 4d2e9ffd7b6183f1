// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapeSplit/fillWithTetrahedra.h"

#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/reference/tetgen.h"
#include "libpolymesh/shapeSplit/faceTriangles.h"
#include "tests/support/editedMesh.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace polymesh::test {

namespace {

PolyMesh octahedron() {
    return meshOf(
        {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
        {{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}});
}

Label labelAt(const TriSurface& surface, const Vec3& position) {
    return static_cast<Label>(std::ranges::find(surface.points, position) - surface.points.begin());
}

/// The four tetrahedra of an octahedron round its axis.
TetMesh roundAxis(const TriSurface& surface) {
    std::vector<Label> p;
    for (const Vec3& position : octahedron().points)
        p.push_back(labelAt(surface, position));
    TetMesh tets;
    for (std::size_t i = 0; i < 4; ++i)
        tets.tetrahedra.push_back({p[i], p[(i + 1) % 4], p[4], p[5]});
    return tets;
}

TEST(FillWithTetrahedra, putsInWhatTheFunctionMakes) {
    EditedMesh cell(octahedron());
    const Filled filled = fillWithTetrahedra(cell.editor, 0, roundAxis);
    EXPECT_EQ(filled.pieces.size(), 4U);
    const PolyMesh mesh = cell.result();
    EXPECT_TRUE(validate(mesh).empty());
    EXPECT_NEAR(volumeOf(mesh), volumeOf(cell.mesh), 1e-15);
    for (const double volume : computeGeometry(mesh).cellVolumes)
        EXPECT_NEAR(volume, 1.0 / 3, 1e-15);
}

TEST(FillWithTetrahedra, changesNothingWhenTheTetrahedraDoNotFit) {
    const auto oneIsMissing = [](const TriSurface& surface) {
        TetMesh tets = roundAxis(surface);
        tets.tetrahedra.pop_back();
        return tets;
    };
    const auto oneComesTwice = [](const TriSurface& surface) {
        TetMesh tets = roundAxis(surface);
        tets.tetrahedra.push_back(tets.tetrahedra[0]);
        return tets;
    };
    const auto oneIsFlat = [](const TriSurface& surface) {
        TetMesh tets = roundAxis(surface);
        const auto [a, b, c, d] = tets.tetrahedra[0];
        tets.newPoints.push_back(0.5 * (surface.points[index(a)] + surface.points[index(b)]));
        const Label p = surface.pointCount();
        tets.tetrahedra[0] = {a, p, c, d};
        tets.tetrahedra.push_back({p, b, c, d});
        tets.tetrahedra.push_back({a, b, p, c});
        tets.tetrahedra.push_back({a, b, p, d});
        return tets;
    };
    const auto oneHasNoSuchPoint = [](const TriSurface& surface) {
        TetMesh tets = roundAxis(surface);
        tets.tetrahedra[2][1] = surface.pointCount();
        return tets;
    };
    const auto none = [](const TriSurface&) { return std::optional<TetMesh>(); };
    for (const Tetrahedraliser& bad : {Tetrahedraliser(oneIsMissing),
                                       Tetrahedraliser(oneComesTwice),
                                       Tetrahedraliser(oneIsFlat),
                                       Tetrahedraliser(oneHasNoSuchPoint),
                                       Tetrahedraliser(none)}) {
        EditedMesh cell(octahedron());
        EXPECT_TRUE(fillWithTetrahedra(cell.editor, 0, bad).pieces.empty());
        EXPECT_EQ(cell.result(), cell.mesh);
    }
}

TEST(FillWithTetrahedra, fillsConcaveCellsBesideOthersWithoutTouchingSharedFaces) {
    if (!hasTetgen()) GTEST_SKIP() << "built without TetGen";
    EditedMesh cell(jittered(hangingNodes(), 0.1));
    const Label big = 4;
    const Label shared = cell.mesh.internalFaceCount();
    const Filled filled = fillWithTetrahedra(cell.editor, big, tetgenTetrahedraliser());
    EXPECT_GT(filled.pieces.size(), 9U);
    const PolyMesh mesh = cell.result();
    EXPECT_TRUE(validate(mesh).empty());
    EXPECT_NEAR(volumeOf(mesh), volumeOf(cell.mesh), 1e-13 * volumeOf(mesh));
    EXPECT_GT(std::ranges::min(computeGeometry(mesh).cellVolumes), 0);
    std::set<std::set<Label>> faces;
    for (Label f = 0; f < mesh.internalFaceCount(); ++f)
        faces.emplace(mesh.faces[f].begin(), mesh.faces[f].end());
    for (Label f = 0; f < shared; ++f)
        EXPECT_TRUE(faces.contains({cell.mesh.faces[f].begin(), cell.mesh.faces[f].end()}));
}

TEST(FillWithTetrahedra, saysWhichFacesCross) {
    PolyMesh crossed = octahedron();
    crossed.points[5] = {0, 0, 2}; // beyond the point opposite
    EditedMesh cell(crossed);
    const Filled filled = fillWithTetrahedra(cell.editor, 0, roundAxis);
    EXPECT_TRUE(filled.pieces.empty());
    EXPECT_EQ(facesInTheWay(cell.editor, 0).empty(), filled.inTheWay.empty());
}

TEST(FaceTriangles, boundTheVolumeThatTheFaceBounded) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const PolyMesh whole = jittered(unitCube(), 0.2, seed);
        for (Label f = 0; f < whole.faceCount(); ++f) {
            const auto ways = trianglesKeepingVolume(EditedMesh(whole).editor, f);
            EXPECT_GE(ways.size(), 1U); // of two chords, two triangles each, spikes left out
            EXPECT_LE(ways.size(), 6U); // both triangles at once
            for (const FaceTriangles& way : ways) {
                EditedMesh cell(whole);
                replaceByTriangles(cell.editor, f, way);
                const PolyMesh mesh = cell.result();
                EXPECT_TRUE(validate(mesh).empty());
                EXPECT_EQ(mesh.faceCount(), whole.faceCount() + toLabel(way.triangles.size()) - 1);
                EXPECT_EQ(way.triangles.size(), 2 + 2 * way.positions.size());
                EXPECT_NEAR(volumeOf(mesh), volumeOf(whole), 1e-14);
            }
        }
    }
}

TEST(FaceTriangles, bestComeFirst) {
    const PolyMesh whole = jittered(lShapedCell(), 0.05);
    const auto ways = trianglesKeepingVolume(EditedMesh(whole).editor, 0);
    ASSERT_GT(ways.size(), 10U);
    EXPECT_FALSE(ways.front().isTurned);
    EXPECT_TRUE(ways.back().isTurned); // with a chord outside the concave face
    EXPECT_TRUE(std::ranges::is_sorted(ways, {}, [](const FaceTriangles& way) {
        return std::pair(way.isTurned, -way.roundness);
    }));
}

TEST(FaceTriangles, ofLargeFacesAreThoseOfLeastArea) {
    std::vector<Vec3> points;
    Polyhedron cell(2);
    constexpr Label n = 9;
    for (const double z : {0.0, 1.0})
        for (Label i = 0; i < n; ++i) {
            const double angle = 2 * std::numbers::pi * i / n;
            points.push_back(
                {std::cos(angle), std::sin(angle), z + (z > 0 && i % 2 == 0 ? 0.1 : 0)});
        }
    for (Label i = 0; i < n; ++i) {
        cell[0].push_back(n - 1 - i);
        cell[1].push_back(n + i);
        cell.push_back({i, (i + 1) % n, (i + 1) % n + n, i + n});
    }
    const PolyMesh whole = meshOf(points, {cell});
    for (Label f = 0; f < whole.faceCount(); ++f) {
        if (whole.faces[f].size() != n) continue;
        const auto ways = trianglesKeepingVolume(EditedMesh(whole).editor, f);
        ASSERT_FALSE(ways.empty());
        EditedMesh edited(whole);
        replaceByTriangles(edited.editor, f, ways.front());
        EXPECT_NEAR(volumeOf(edited.result()), volumeOf(whole), 1e-13);
    }
}

} // namespace

} // namespace polymesh::test
