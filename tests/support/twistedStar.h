// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/surfaces.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace polymesh::test {

/// A star with `points` points, drawn up along a tilted axis while it turns: a thread.
struct TwistedStar {
    Label points = 3;
    double turn = 0; // [rad] in all
    double tilt = 0; // [rad] of the axis against z

    Vec3 corner(Label slice, Label i, double radius) const {
        constexpr double height = 2;
        const double part = static_cast<double>(slice) / slices;
        const double angle = std::numbers::pi * i / points + turn * part;
        const double y = radius * std::sin(angle);
        const double z = height * part;
        return {radius * std::cos(angle),
                y * std::cos(tilt) - z * std::sin(tilt),
                y * std::sin(tilt) + z * std::cos(tilt)};
    }

    TriSurface surface() const {
        const Label corners = 2 * points;
        std::vector<Vec3> all;
        for (Label s = 0; s <= slices; ++s)
            for (Label i = 0; i < corners; ++i)
                all.push_back(corner(s, i, i % 2 == 0 ? 1 : 0.8));
        all.push_back(corner(0, 0, 0));
        all.push_back(corner(slices, 0, 0));
        const Label top = slices * corners;
        const Label floor = top + corners;
        std::vector<std::vector<Label>> triangles;
        for (Label i = 0; i < corners; ++i) {
            const Label j = (i + 1) % corners;
            for (Label s = 0; s < top; s += corners) {
                triangles.push_back({s + i, s + j, s + corners + j});
                triangles.push_back({s + i, s + corners + j, s + corners + i});
            }
            triangles.push_back({floor, j, i});
            triangles.push_back({floor + 1, top + i, top + j});
        }
        return surfaceOf(all, triangles);
    }

    static constexpr Label slices = 24;
};

} // namespace polymesh::test
