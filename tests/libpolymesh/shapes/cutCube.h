// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The unit cube cut by planes.

#include "tests/libpolymesh/shapes/polyhedra.h"

namespace polymesh::test {

/// What a plane leaves of the unit cube.
struct CutCube {
    std::vector<Vec3> points;
    Polyhedron faces;
    Polygon cutFace; // empty: nothing was cut off
};

inline Vec3 cubeCorner(Label corner) {
    constexpr std::array<std::array<int, 3>, 8> corners{
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
    const auto& c = corners[index(corner)];
    return {double(c[0]), double(c[1]), double(c[2])};
}

/// True when the four corners of the set are those of one face.
inline bool isCubeFace(unsigned mask) {
    for (const Polygon& face : hexahedron({0, 1, 2, 3, 4, 5, 6, 7})) {
        unsigned corners = 0;
        for (const Label p : face)
            corners |= 1U << static_cast<unsigned>(p);
        if (corners == mask) return true;
    }
    return false;
}

/// What is left where dot(normal, x) <= offset, which no corner meets with equality.
inline CutCube cutCube(const Vec3& normal, double offset) {
    CutCube cut;
    std::array<double, 8> beyond{};
    std::map<std::pair<Label, Label>, Label> label; // of a corner (twice) or an edge's cut
    for (Label c = 0; c < 8; ++c)
        beyond[index(c)] = dot(normal, cubeCorner(c)) - offset;
    const auto pointOn = [&](Label a, Label b) {
        const auto [at, isNew] = label.try_emplace(std::minmax(a, b), toLabel(cut.points.size()));
        if (isNew) {
            const double t = a == b ? 0 : beyond[index(a)] / (beyond[index(a)] - beyond[index(b)]);
            cut.points.push_back(cubeCorner(a) + t * (cubeCorner(b) - cubeCorner(a)));
        }
        return at->second;
    };
    std::map<Label, Label> rim; // of the cut, against the faces beside it
    for (const Polygon& face : hexahedron({0, 1, 2, 3, 4, 5, 6, 7})) {
        Polygon left;
        Label out = -1;
        Label in = -1;
        for (std::size_t i = 0; i < face.size(); ++i) {
            const Label a = face[i];
            const Label b = face[(i + 1) % face.size()];
            if (beyond[index(a)] < 0) left.push_back(pointOn(a, a));
            if ((beyond[index(a)] < 0) == (beyond[index(b)] < 0)) continue;
            left.push_back(pointOn(a, b));
            (beyond[index(a)] < 0 ? out : in) = left.back();
        }
        if (!left.empty()) cut.faces.push_back(left);
        if (out >= 0) rim[in] = out;
    }
    if (rim.empty()) return cut;
    cut.cutFace.push_back(rim.begin()->first);
    for (Label p = rim.begin()->second; p != cut.cutFace[0]; p = rim.at(p))
        cut.cutFace.push_back(p);
    cut.faces.push_back(cut.cutFace);
    return cut;
}

/// Bit i: whether dot(normal, x) > offset at corner i.
inline unsigned cornersBeyond(const Vec3& normal, double offset) {
    unsigned mask = 0;
    for (Label c = 0; c < 8; ++c)
        if (dot(normal, cubeCorner(c)) > offset) mask |= 1U << static_cast<unsigned>(c);
    return mask;
}

/// One plane for each set of corners (bit i: corner i) that a plane cuts off, the empty one
/// included, the full one not.
inline std::map<unsigned, CutCube> cubesCutByPlanes() {
    std::map<unsigned, CutCube> cuts;
    for (int x = -3; x <= 3; ++x)
        for (int y = -3; y <= 3; ++y)
            for (int z = -3; z <= 3; ++z)
                for (int offset = -10; offset <= 10; ++offset) {
                    const Vec3 normal{double(x), double(y), double(z)};
                    const double limit = offset + 0.5;
                    const unsigned mask = cornersBeyond(normal, limit);
                    if (mask != 255) cuts.try_emplace(mask, cutCube(normal, limit));
                }
    return cuts;
}

} // namespace polymesh::test
