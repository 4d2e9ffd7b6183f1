// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/geometry/vec3.h"

#include <algorithm>
#include <array>

namespace polymesh {

using StraightEdge = std::array<Vec3, 2>;

/// The closest points of two segments, as parameters from 0 at the first end to 1 at the second.
struct SegmentPair {
    double onFirst = 0;
    double onSecond = 0;
};

inline Vec3 pointOn(const StraightEdge& segment, double parameter) {
    return segment[0] + parameter * (segment[1] - segment[0]);
}

/// Of parallel segments the middle of where they run beside each other; of one without length its
/// first end. Source: C. Ericson, Real-Time Collision Detection, 5.1.9.
inline SegmentPair closestOnSegments(const StraightEdge& first, const StraightEdge& second) {
    const Vec3 a = first[1] - first[0];
    const Vec3 b = second[1] - second[0];
    const Vec3 r = first[0] - second[0];
    const double aa = squaredNorm(a);
    const double bb = squaredNorm(b);
    const double ab = dot(a, b);
    const auto within = [](double x) { return std::clamp(x, 0.0, 1.0); };
    if (!(aa > 0) && !(bb > 0)) return {};
    if (!(aa > 0)) return {0, within(dot(b, r) / bb)};
    if (!(bb > 0)) return {within(-dot(a, r) / aa), 0};
    const double area = aa * bb - ab * ab;
    double s = 0;
    if (area > 1e-12 * aa * bb) {
        s = within((ab * dot(b, r) - dot(a, r) * bb) / area);
    } else {
        const double from = -dot(a, r) / aa; // of the second segment's ends on the first
        const double to = from + ab / aa;
        s = 0.5 * (within(std::min(from, to)) + within(std::max(from, to)));
    }
    double t = within((ab * s + dot(b, r)) / bb);
    s = within((ab * t - dot(a, r)) / aa);
    t = within((ab * s + dot(b, r)) / bb);
    return {s, t};
}

} // namespace polymesh
