// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/geometry/predicates.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace polymesh::test {
namespace {

using Triangle = std::array<Vec3, 3>;
using Rational = boost::multiprecision::cpp_rational;

/// Points of a 4 x 4 x 4 lattice: most sets of four are degenerate in one way or another.
class Lattice {
public:
    explicit Lattice(unsigned seed) : random_(seed) {}

    Vec3 point() { return {coordinate(), coordinate(), coordinate()}; }

    Triangle triangle() { return {point(), point(), point()}; }

private:
    double coordinate() { return static_cast<double>(random_() % 4); }

    std::mt19937 random_;
};

/// Exact arithmetic on lattice points after a real move: each component of it is so much smaller
/// than the one before that no integer determinant of these points can be turned by it.
struct Int3 {
    std::int64_t x, y, z;
};

Int3 operator-(const Int3& a, const Int3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

Int3 crossOf(const Int3& a, const Int3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

std::int64_t dotOf(const Int3& a, const Int3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

int signOf(std::int64_t v) {
    return v > 0 ? 1 : v < 0 ? -1 : 0;
}

/// Lattice coordinates in units of 2^-(3 bits); the move is (2^-bits, 2^-2bits, 2^-3bits).
Int3 scaled(const Vec3& p, int bits, bool isMoved) {
    const std::int64_t unit = std::int64_t{1} << (3 * bits);
    Int3 r{static_cast<std::int64_t>(p.x) * unit,
           static_cast<std::int64_t>(p.y) * unit,
           static_cast<std::int64_t>(p.z) * unit};
    if (isMoved) {
        r.x += std::int64_t{1} << (2 * bits);
        r.y += std::int64_t{1} << bits;
        r.z += 1;
    }
    return r;
}

// Components of normals of lattice triangles are at most 18 < 2^6.
Int3 still(const Vec3& p) {
    return scaled(p, 6, false);
}

Int3 moved(const Vec3& p) {
    return scaled(p, 6, true);
}

int orientOf(const Int3& a, const Int3& b, const Int3& c, const Int3& d) {
    return signOf(dotOf(crossOf(b - a, c - a), d - a));
}

bool hasArea(const Triangle& t) {
    return cross(t[1] - t[0], t[2] - t[0]) != Vec3{};
}

/// Whether the mesh edge crosses the moved triangle, by the predicates: 1 to the side away from the
/// normal, -1 to the other, 0 not at all.
int crossing(const Vec3& from, const Vec3& to, const Triangle& t) {
    const int start = sideOfTriangle(t, from).sign;
    if (start == sideOfTriangle(t, to).sign) return 0;
    const int side = passingSide(from, to, t[0], t[1]).sign;
    if (passingSide(from, to, t[1], t[2]).sign != side) return 0;
    return passingSide(from, to, t[2], t[0]).sign == side ? start : 0;
}

/// Whether the moved surface edge pierces the triangle of the mesh.
bool doesPierce(const Vec3& p, const Vec3& q, const Triangle& facet) {
    if (sideOfMeshPlane(facet, p).sign == sideOfMeshPlane(facet, q).sign) return false;
    const int side = passingSide(facet[0], facet[1], p, q).sign;
    return passingSide(facet[1], facet[2], p, q).sign == side &&
           passingSide(facet[2], facet[0], p, q).sign == side;
}

TEST(Predicates, signsAreThoseOfIntegerArithmetic) {
    Lattice lattice(1);
    int zeros = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 a = lattice.point();
        const Vec3 b = lattice.point();
        const Vec3 c = lattice.point();
        const Vec3 d = lattice.point();
        const int sign = orientOf(still(a), still(b), still(c), still(d));
        zeros += sign == 0 ? 1 : 0;
        ASSERT_EQ(orient3d(a, b, c, d), sign);
        const Int3 n = crossOf(still(b) - still(a), still(c) - still(a));
        const Int3 m = crossOf(still(b) - still(a), still(d) - still(c));
        ASSERT_EQ(normalSign(a, b, c, 0), signOf(n.x));
        ASSERT_EQ(normalSign(a, b, c, 1), signOf(n.y));
        ASSERT_EQ(normalSign(a, b, c, 2), signOf(n.z));
        ASSERT_EQ(crossSign(a, b, c, d, 0), signOf(m.x));
        ASSERT_EQ(crossSign(a, b, c, d, 1), signOf(m.y));
        ASSERT_EQ(crossSign(a, b, c, d, 2), signOf(m.z));
    }
    EXPECT_GT(zeros, 2000);
}

TEST(Predicates, signsOnTheMovedSurfaceAreThoseOfASurfaceThatWasMoved) {
    Lattice lattice(2);
    int zeros = 0;
    for (int i = 0; i < 20000; ++i) {
        const Triangle t = lattice.triangle();
        const Vec3 p = lattice.point();
        const Vec3 q = lattice.point();
        const bool wasZero = orientOf(still(t[0]), still(t[1]), still(t[2]), still(p)) == 0;
        zeros += wasZero ? 1 : 0;
        if (hasArea(t)) {
            const MovedSign surface = sideOfTriangle(t, p);
            ASSERT_EQ(surface.sign, orientOf(moved(t[0]), moved(t[1]), moved(t[2]), still(p)));
            ASSERT_EQ(surface.wasZero, wasZero);
            const MovedSign facet = sideOfMeshPlane(t, p);
            ASSERT_EQ(facet.sign, orientOf(still(t[0]), still(t[1]), still(t[2]), moved(p)));
            ASSERT_EQ(facet.wasZero, wasZero);
        }
        const MovedSign passing = passingSide(t[0], t[1], p, q);
        ASSERT_EQ(passing.sign, orientOf(still(t[0]), still(t[1]), moved(p), moved(q)));
        const bool isParallel = cross(t[1] - t[0], q - p) == Vec3{};
        ASSERT_EQ(passing.sign == 0, isParallel);
    }
    EXPECT_GT(zeros, 2000);
}

TEST(Predicates, exchangingTwoArgumentsOfOneKindTurnsTheSign) {
    Lattice lattice(3);
    for (int i = 0; i < 5000; ++i) {
        const Triangle t = lattice.triangle();
        const Vec3 p = lattice.point();
        const Vec3 q = lattice.point();
        EXPECT_EQ(passingSide(t[0], t[1], p, q).sign, -passingSide(t[1], t[0], p, q).sign);
        EXPECT_EQ(passingSide(t[0], t[1], p, q).sign, -passingSide(t[0], t[1], q, p).sign);
        if (!hasArea(t)) continue;
        const Triangle turned{t[0], t[2], t[1]};
        const Triangle rotated{t[1], t[2], t[0]};
        EXPECT_EQ(sideOfTriangle(t, p).sign, -sideOfTriangle(turned, p).sign);
        EXPECT_EQ(sideOfTriangle(t, p).sign, sideOfTriangle(rotated, p).sign);
        EXPECT_EQ(sideOfMeshPlane(t, p).sign, -sideOfMeshPlane(turned, p).sign);
        EXPECT_EQ(sideOfMeshPlane(t, p).sign, sideOfMeshPlane(rotated, p).sign);
    }
}

TEST(Predicates, trianglesWithoutAreaHaveEveryPointOnOneSide) {
    const Triangle line{Vec3{0, 0, 0}, Vec3{1, 1, 1}, Vec3{3, 3, 3}};
    Lattice lattice(4);
    for (int i = 0; i < 100; ++i) {
        const Vec3 p = lattice.point();
        EXPECT_EQ(sideOfTriangle(line, p).sign, 1);
        EXPECT_EQ(sideOfMeshPlane(line, p).sign, 1);
    }
}

TEST(Predicates, crossingsOfAClosedSurfaceSumToTheChangeOfSide) {
    Lattice lattice(5);
    int crossed = 0;
    for (int i = 0; i < 20000; ++i) {
        std::array<Vec3, 4> v{lattice.point(), lattice.point(), lattice.point(), lattice.point()};
        if (orient3d(v[0], v[1], v[2], v[3]) == 0) continue;
        if (orient3d(v[0], v[1], v[2], v[3]) < 0) std::swap(v[0], v[1]);
        const std::array<Triangle, 4> sides{Triangle{v[0], v[2], v[1]},
                                            Triangle{v[0], v[1], v[3]},
                                            Triangle{v[1], v[2], v[3]},
                                            Triangle{v[2], v[0], v[3]}};
        const Vec3 from = lattice.point();
        const Vec3 to = lattice.point();
        const auto isInside = [&](const Vec3& p) {
            return std::ranges::all_of(
                sides, [&](const Triangle& t) { return sideOfTriangle(t, p).sign < 0; });
        };
        int sum = 0;
        for (const Triangle& t : sides) {
            const int sign = crossing(from, to, t);
            sum += sign;
            crossed += sign == 0 ? 0 : 1;
        }
        ASSERT_EQ(sum, (isInside(to) ? 1 : 0) - (isInside(from) ? 1 : 0));
    }
    EXPECT_GT(crossed, 1000);
}

TEST(Predicates, twoTrianglesMeetInNoneOrTwoEnds) {
    Lattice lattice(6);
    std::array<int, 7> ends{};
    for (int i = 0; i < 30000; ++i) {
        const Triangle facet = lattice.triangle();
        const Triangle t = lattice.triangle();
        std::size_t count = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            count += crossing(facet[k], facet[(k + 1) % 3], t) != 0 ? 1U : 0U;
            count += doesPierce(t[k], t[(k + 1) % 3], facet) ? 1U : 0U;
        }
        ++ends[count];
    }
    EXPECT_GT(ends[2], 1000);
    EXPECT_EQ(ends[0] + ends[2], 30000);
}

Rational determinant(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const auto minus = [](const Vec3& u, const Vec3& v) {
        return std::array<Rational, 3>{Rational(u.x) - Rational(v.x),
                                       Rational(u.y) - Rational(v.y),
                                       Rational(u.z) - Rational(v.z)};
    };
    const auto u = minus(b, a);
    const auto v = minus(c, a);
    const auto w = minus(d, a);
    return (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] +
           (u[0] * v[1] - u[1] * v[0]) * w[2];
}

TEST(Predicates, signsAreExactWhereRoundingDecidesTheValue) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto point = [&] { return Vec3{unit(random), unit(random), unit(random)}; };
    for (int i = 0; i < 1000; ++i) {
        const double scale = std::ldexp(1.0, static_cast<int>(random() % 200) - 100);
        const Vec3 a = scale * point();
        const Vec3 b = scale * point();
        const Vec3 c = scale * point();
        const Vec3 onPlane = a + unit(random) * (b - a) + unit(random) * (c - a);
        ASSERT_EQ(orient3d(a, b, c, onPlane), determinant(a, b, c, onPlane).sign());
        const Vec3 almostParallel = c + unit(random) * (b - a);
        const Rational x =
            (Rational(b.y) - Rational(a.y)) * (Rational(almostParallel.z) - Rational(c.z)) -
            (Rational(b.z) - Rational(a.z)) * (Rational(almostParallel.y) - Rational(c.y));
        ASSERT_EQ(crossSign(a, b, c, almostParallel, 0), x.sign());
    }
}

/// Order of the parameters u[0] / u[1] and v[0] / v[1].
int compareRatios(const std::array<std::int64_t, 2>& u, const std::array<std::int64_t, 2>& v) {
    return signOf(u[0] * v[1] - v[0] * u[1]) * signOf(u[1]) * signOf(v[1]);
}

enum class Moves : std::uint8_t { nothing, plane, line };

/// Where the plane of `t` cuts the line a b. Cross products of two parameters of lattice points are
/// below 2^11, so that 12 bits keep the components of the move apart.
std::array<std::int64_t, 2>
parameterOf(const Vec3& a, const Vec3& b, const Triangle& t, Moves moves) {
    const auto whole = [](const Vec3& v) { return scaled(v, 0, false); };
    const Int3 n = crossOf(whole(t[1] - t[0]), whole(t[2] - t[0]));
    const Int3 start = scaled(a, 12, moves == Moves::line);
    return {dotOf(n, scaled(t[0], 12, moves == Moves::plane) - start), dotOf(n, whole(b - a))};
}

bool isCoplanar(const Triangle& s, const Triangle& t) {
    return std::ranges::all_of(t,
                               [&](const Vec3& p) { return orient3d(s[0], s[1], s[2], p) == 0; });
}

TEST(Predicates, orderAlongEdgesIsThatOnASurfaceThatWasMoved) {
    Lattice lattice(8);
    int ties = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 a = lattice.point();
        const Vec3 b = lattice.point();
        const Triangle s = lattice.triangle();
        const Triangle t = lattice.triangle();
        const auto u = parameterOf(a, b, s, Moves::plane);
        const auto v = parameterOf(a, b, t, Moves::plane);
        if (u[1] == 0 || v[1] == 0) continue; // parallel to the plane: never asked
        const int order = compareAlongMeshEdge(a, b, s, t);
        ASSERT_EQ(order, compareRatios(u, v));
        ASSERT_EQ(order, -compareAlongMeshEdge(a, b, t, s));
        ASSERT_EQ(order, -compareAlongMeshEdge(b, a, s, t));
        ASSERT_EQ(order == 0, isCoplanar(s, t));
        ASSERT_EQ(
            compareAlongSurfaceEdge(a, b, s, t),
            compareRatios(parameterOf(a, b, s, Moves::line), parameterOf(a, b, t, Moves::line)));
        const int atRest = compareRatios(parameterOf(a, b, s, Moves::nothing),
                                         parameterOf(a, b, t, Moves::nothing));
        ties += order != atRest ? 1 : 0;
    }
    EXPECT_GT(ties, 100);
}

TEST(Predicates, planarConvexPolygonsAreToldFromOthers) {
    const auto isConvex = [](const std::vector<Vec3>& polygon) { return isPlanarConvex(polygon); };
    EXPECT_TRUE(isConvex({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_TRUE(isConvex({{0, 0, 0}, {.5, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 1}}));
    EXPECT_TRUE(isConvex({{0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 0}}));
    EXPECT_FALSE(isConvex({{0, 0, 0}, {1, 0, 0}, {1, 1, 1e-300}, {0, 1, 0}}));
    EXPECT_FALSE(isConvex({{0, 0, 0}, {2, 0, 0}, {.5, .5, 0}, {0, 2, 0}}));
    EXPECT_FALSE(isConvex({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_FALSE(isConvex({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}}));
    EXPECT_FALSE(isConvex({{0, 0, 0}, {1, 0, 0}}));
    const std::vector<Vec3> star{{0, 3, 0}, {2, -3, 0}, {-3, 1, 0}, {3, 1, 0}, {-2, -3, 0}};
    EXPECT_FALSE(isConvex(star)); // every corner turns the same way, twice round
}

} // namespace
} // namespace polymesh::test
