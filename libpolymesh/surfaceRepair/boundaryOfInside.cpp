// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surfaceRepair/boundaryOfInside.h"

#include "libpolymesh/base/disjointSets.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/surface/boxTree.h"
#include "libpolymesh/surface/coplanar.h"
#include "libpolymesh/surface/triangleBoxes.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace polymesh {

namespace {

using Corners = std::array<Label, 3>;

/// All triangles with the same corners as one.
struct Sheet {
    Label triangle = -1; // the first that has the higher winding number behind it
    int step = 0;        // by how much it is higher, > 0
};

/// +1 when the corners are an even permutation of ascending ones, else -1.
int orientationOf(const Corners& corners) {
    const auto lowest =
        static_cast<std::size_t>(std::ranges::min_element(corners) - corners.begin());
    return corners[(lowest + 1) % 3] < corners[(lowest + 2) % 3] ? 1 : -1;
}

/// The sheets of a soup, without those whose triangles cancel; by their first triangles.
std::vector<Sheet> findSheets(const ExactSoup& soup) {
    const auto sorted = [&](Label t) {
        Corners corners = soup.triangles[index(t)];
        std::ranges::sort(corners);
        return corners;
    };
    std::vector<std::pair<Corners, Label>> keys;
    keys.reserve(soup.triangles.size());
    for (Label t = 0; t < toLabel(soup.triangles.size()); ++t)
        keys.emplace_back(sorted(t), t);
    std::ranges::sort(keys);
    std::vector<Sheet> sheets;
    for (std::size_t first = 0, last = 0; first < keys.size(); first = last) {
        int step = 0;
        for (last = first; last < keys.size() && keys[last].first == keys[first].first; ++last)
            step += orientationOf(soup.triangles[index(keys[last].second)]);
        if (step == 0) continue;
        std::size_t i = first;
        while (orientationOf(soup.triangles[index(keys[i].second)]) * step < 0)
            ++i;
        sheets.push_back({keys[i].second, std::abs(step)});
    }
    std::ranges::sort(sheets, {}, &Sheet::triangle);
    return sheets;
}

/// Patches of sheets: those reached across sides of just two sheets. As the surface is closed, the
/// sheets of a patch have the same step and orientation.
DisjointSets findPatches(const ExactSoup& soup, const std::vector<Sheet>& sheets) {
    std::vector<std::pair<std::array<Label, 2>, Label>> sides; // ends ascending, sheet
    sides.reserve(3 * sheets.size());
    for (std::size_t s = 0; s < sheets.size(); ++s) {
        const Corners& corners = soup.triangles[index(sheets[s].triangle)];
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [a, b] = std::minmax({corners[i], corners[(i + 1) % 3]});
            sides.emplace_back(std::array{a, b}, toLabel(s));
        }
    }
    std::ranges::sort(sides);
    DisjointSets patches(toLabel(sheets.size()));
    for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
        for (last = first; last < sides.size() && sides[last].first == sides[first].first;)
            ++last;
        if (last - first == 2) patches.join(sides[first].second, sides[first + 1].second);
    }
    return patches;
}

/// Winding numbers of a closed surface by rays along an axis.
class WindingNumbers {
public:
    explicit WindingNumbers(const TriSurface& surface)
        : surface_(surface), box_(boundingBox(surface.points)), tree_(triangleBoxes(surface)) {}

    /// Just in front of triangle `t` of the soup.
    int inFrontOf(const ExactSoup& soup, Label t) const {
        const ExactPoint& a = soup.corner(t, 0);
        const ExactPoint& b = soup.corner(t, 1);
        const ExactPoint& c = soup.corner(t, 2);
        const ExactKernel::Vector_3 normal = CGAL::normal(a, b, c);
        int axis = 0;
        for (int other = 1; other < 3; ++other)
            if (CGAL::abs(normal[other]) > CGAL::abs(normal[axis])) axis = other;
        const int side = CGAL::sign(normal[axis]) == CGAL::POSITIVE ? 1 : -1;
        // A ray through a side tells nothing: the next one starts elsewhere in the triangle.
        for (int weight = 1; weight < 100; ++weight) {
            const ExactPoint start = CGAL::barycenter(a, 1, b, weight, c, weight * weight + 1);
            if (const auto number = alongRay(start, axis, side)) return *number;
        }
        throw WorkError("no ray tells the winding number beside a triangle of the surface");
    }

private:
    std::optional<int> alongRay(const ExactPoint& start, int axis, int side) const {
        Box ray;
        for (int i = 0; i < 3; ++i)
            std::tie(ray.min[i], ray.max[i]) = CGAL::to_interval(start[i]);
        (side > 0 ? ray.max : ray.min)[axis] = side > 0 ? box_.max[axis] : box_.min[axis];
        std::optional<int> sum = 0;
        tree_.forEachNear(ray, [&](Label t) {
            if (!sum || !overlaps(triangleBox(surface_, t), ray)) return;
            const auto crossing = crossingOf(start, axis, side, t);
            sum = crossing ? std::optional(*sum + *crossing) : std::nullopt;
        });
        return sum;
    }

    /// +1 where the ray leaves through triangle t, -1 where it enters, 0 where it passes; nothing
    /// when it meets a side.
    std::optional<int> crossingOf(const ExactPoint& start, int axis, int side, Label t) const {
        const ExactKernel::Triangle_3 triangle = exactTriangle(surface_, t);
        const auto turn = [&](const ExactPoint& p, const ExactPoint& q, const ExactPoint& r) {
            const int i = (axis + 1) % 3;
            const int j = (axis + 2) % 3;
            return static_cast<int>(
                CGAL::sign((q[i] - p[i]) * (r[j] - p[j]) - (q[j] - p[j]) * (r[i] - p[i])));
        };
        std::array<int, 3> turns{};
        for (int i = 0; i < 3; ++i)
            turns[static_cast<std::size_t>(i)] = turn(triangle[i], triangle[i + 1], start);
        const auto [least, most] = std::ranges::minmax(turns);
        if (least < 0 && most > 0) return 0;
        if (least == 0 || most == 0) return std::nullopt;
        const int facing = turn(triangle[0], triangle[1], triangle[2]);
        const int above =
            facing *
            static_cast<int>(CGAL::orientation(triangle[0], triangle[1], triangle[2], start));
        return above * side < 0 ? facing * side : 0;
    }

    const TriSurface& surface_;
    Box box_;
    BoxTree tree_;
};

} // namespace

std::vector<Label> boundaryOfInside(const TriSurface& surface, const ExactSoup& soup) {
    const std::vector<Sheet> sheets = findSheets(soup);
    DisjointSets patches = findPatches(soup, sheets);
    const WindingNumbers windings(surface);
    std::vector<char> isBoundary(sheets.size(), 0);
    std::vector<Label> boundary;
    for (std::size_t s = 0; s < sheets.size(); ++s) {
        const Sheet& sheet = sheets[s];
        const std::size_t first = index(patches.lowest(toLabel(s)));
        if (first == s) {
            const int inFront = windings.inFrontOf(soup, sheet.triangle);
            isBoundary[s] = inFront < 1 && inFront + sheet.step >= 1 ? 1 : 0;
        }
        if (isBoundary[first] != 0) boundary.push_back(sheet.triangle);
    }
    return boundary;
}

} // namespace polymesh
