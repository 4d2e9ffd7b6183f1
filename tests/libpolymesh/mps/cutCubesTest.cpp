// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Convex polyhedra: cubes cut by planes.

#include "libpolymesh/reference/tetgen.h"
#include "tests/libpolymesh/mps/divided.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>
#include <set>
#include <utility>

namespace polymesh {

namespace {

using test::Polygon;
using test::Polyhedron;

/// The points x with dot(normal, x) <= offset are kept.
struct Plane {
    Vec3 normal;
    double offset = 0;
};

/// A convex polyhedron that planes cut. No plane goes through a point.
struct Cut {
    std::vector<Vec3> points;
    Polyhedron faces;

    double side(const Plane& plane, Label p) const {
        return dot(plane.normal, points[index(p)]) - plane.offset;
    }

    void by(const Plane& plane) {
        std::map<std::pair<Label, Label>, Label> crossings;
        std::map<Label, Label> rim; // of the new face: from where a face is left to where entered
        Polyhedron kept;
        for (const Polygon& face : faces) {
            Polygon rest;
            Label left = -1;
            Label entered = -1;
            for (std::size_t i = 0; i < face.size(); ++i) {
                const Label a = face[i];
                const Label b = face[(i + 1) % face.size()];
                const bool isIn = side(plane, a) < 0;
                if (isIn) rest.push_back(a);
                if (isIn == (side(plane, b) < 0)) continue;
                (isIn ? left : entered) = crossing(plane, a, b, crossings);
                rest.push_back(isIn ? left : entered);
            }
            if (left >= 0) rim[entered] = left;
            if (!rest.empty()) kept.push_back(rest);
        }
        faces = kept;
        if (rim.empty()) return;
        Polygon cap{rim.begin()->first};
        while (rim.at(cap.back()) != cap.front())
            cap.push_back(rim.at(cap.back()));
        faces.push_back(cap);
    }

    PolyMesh mesh() const {
        std::map<Label, Label> used;
        std::vector<Vec3> usedPoints;
        Polyhedron loops = faces;
        for (Polygon& loop : loops)
            for (Label& p : loop) {
                const auto [at, isNew] = used.try_emplace(p, toLabel(usedPoints.size()));
                if (isNew) usedPoints.push_back(points[index(p)]);
                p = at->second;
            }
        return test::meshOf(usedPoints, {loops});
    }

private:
    Label crossing(const Plane& plane,
                   Label a,
                   Label b,
                   std::map<std::pair<Label, Label>, Label>& crossings) {
        const auto [low, high] = std::minmax(a, b);
        const auto [at, isNew] = crossings.try_emplace({low, high}, toLabel(points.size()));
        if (isNew) {
            const double s = side(plane, low);
            const double t = s / (s - side(plane, high));
            const Vec3 from = points[index(low)];
            points.push_back(from + t * (points[index(high)] - from));
        }
        return at->second;
    }
};

Cut cube() {
    const PolyMesh mesh = test::unitCube();
    Cut cut{mesh.points, {}};
    for (Label face = 0; face < mesh.faceCount(); ++face)
        cut.faces.emplace_back(mesh.faces[face].begin(), mesh.faces[face].end());
    return cut;
}

/// Bit p: whether corner p of the cube is below the plane.
unsigned cornersBelow(const Cut& cut, const Plane& plane) {
    unsigned mask = 0;
    for (Label p = 0; p < 8; ++p)
        mask |= cut.side(plane, p) < 0 ? 1U << static_cast<unsigned>(p) : 0U;
    return mask;
}

} // namespace

TEST(MidPointSubdivision, everyPlaneCutCubeDividesIntoHexahedra) {
    // Planes of small whole normals between lattice levels separate the corners in all ways.
    std::set<unsigned> masks;
    const auto divideBy = [&](const Plane& plane) {
        Cut cut = cube();
        const unsigned mask = cornersBelow(cut, plane);
        if (mask == 0 || mask == 255 || !masks.insert(mask).second) return;
        cut.by(plane);
        const test::Divided divided = test::dividedByLaw(cut.mesh());
        EXPECT_TRUE(divided.inverted.empty()) << mask;
        EXPECT_EQ(divided.pyramids, 0) << mask; // a cut in general position
    };
    for (int x = -3; x <= 3; ++x)
        for (int y = -3; y <= 3; ++y)
            for (int z = -3; z <= 3; ++z)
                for (int level = -9; level <= 9; ++level)
                    divideBy({{1.0 * x, 1.0 * y, 1.0 * z}, level + 0.5});
    EXPECT_EQ(masks.size(), 102U);
}

TEST(MidPointSubdivision, randomConvexPolyhedraKeepTheirVolumes) {
    std::mt19937 random(7);
    const auto coordinate = [&] { return static_cast<double>(random()) / 2147483648.0 - 1; };
    for (int trial = 0; trial < 40; ++trial) {
        Cut cut = cube();
        for (int k = 0; k < 8; ++k) {
            const Vec3 normal{coordinate(), coordinate(), coordinate()};
            cut.by({normal, dot(normal, {0.5, 0.5, 0.5}) + 0.3 * norm(normal)});
        }
        const PolyMesh mesh = cut.mesh();
        const test::Divided divided = test::dividedByLaw(mesh);
        EXPECT_TRUE(divided.inverted.empty()) << trial;
        if (!hasTetgen()) continue;
        const auto volumes = tetgenVolumes(mesh, cellFaces(mesh), std::array<Label, 1>{0});
        ASSERT_TRUE(volumes[0].has_value());
        EXPECT_NEAR(test::volumeOf(divided.mesh), *volumes[0], 1e-12);
    }
}

} // namespace polymesh
