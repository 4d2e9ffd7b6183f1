// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/pointWithin.h"

#include <algorithm>
#include <limits>

namespace polymesh {

void addHalfSpace(const Vec3& a, const Vec3& b, const Vec3& at, std::vector<HalfSpace>& list) {
    const Vec3 normal = cross(a, b);
    const double length = norm(normal);
    if (length > 0) list.push_back({normal / length, at});
}

std::optional<Vec3> pointWithin(std::span<const HalfSpace> halfSpaces,
                                const Vec3& start,
                                double reach,
                                const Search& search) {
    Vec3 x = start;
    double margin = 0.2 * reach;
    for (int m = 0; m < search.margins; ++m, margin /= 3)
        for (int step = 0; step < search.moves; ++step) {
            double worst = std::numeric_limits<double>::max();
            const HalfSpace* missed = nullptr;
            for (const HalfSpace& h : halfSpaces) {
                const double distance = dot(h.normal, x - h.at);
                if (distance < worst) missed = &h;
                worst = std::min(worst, distance);
            }
            if (missed == nullptr || worst >= margin) return x;
            x += (1.2 * margin - worst) * missed->normal;
        }
    return std::nullopt;
}

} // namespace polymesh
