// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/adjustGuard.h"

#include "libpolymesh/geometry/box.h"

#include <boost/container/small_vector.hpp>

#include <algorithm>

namespace polymesh {

namespace {

/// A point of a cell in one of its faces, seen from outside: the edges to before and after.
struct Corner {
    Label point;
    Label before;
    Label after;
};

using Corners = boost::container::small_vector<Corner, 32>;

Vec3 meanOf(const PolyMesh& mesh, std::span<const Label> face) {
    Vec3 sum;
    for (const Label p : face)
        sum += mesh.points[index(p)];
    return sum / static_cast<double>(face.size());
}

Corners cornersOf(const PolyMesh& mesh, Label cell, std::span<const Label> cellFaces) {
    Corners corners;
    for (const Label f : cellFaces) {
        const auto face = mesh.faces[f];
        const bool isOutward = mesh.owner[index(f)] == cell;
        for (std::size_t i = 0; i < face.size(); ++i) {
            Label before = face[i == 0 ? face.size() - 1 : i - 1];
            Label after = face[i + 1 == face.size() ? 0 : i + 1];
            if (!isOutward) std::swap(before, after);
            corners.push_back({face[i], before, after});
        }
    }
    return corners;
}

/// The smallest parallelepiped of three edges that meet.
double smallestCorner(const PolyMesh& mesh, Corners& corners) {
    std::ranges::sort(corners, {}, &Corner::point);
    double smallest = Box::inf;
    const auto at = [&](Label p) -> const Vec3& { return mesh.points[index(p)]; };
    for (std::size_t i = 0; i < corners.size();) {
        std::size_t end = i + 1;
        while (end < corners.size() && corners[end].point == corners[i].point)
            ++end;
        if (end - i == 3) {
            const Corner& c = corners[i];
            const Label third =
                corners[i + 1].before == c.after || corners[i + 1].before == c.before
                    ? corners[i + 1].after
                    : corners[i + 1].before;
            const Vec3& p = at(c.point);
            smallest =
                std::min(smallest, dot(cross(at(c.before) - p, at(c.after) - p), at(third) - p));
        }
        i = end;
    }
    return smallest;
}

} // namespace

PartMeasure
smallestPart(const PolyMesh& mesh, Label cell, std::span<const Label> cellFaces, double volume) {
    boost::container::small_vector<Vec3, 8> means;
    Vec3 centre;
    for (const Label f : cellFaces) {
        means.push_back(meanOf(mesh, mesh.faces[f]));
        centre += means.back();
    }
    centre = centre / static_cast<double>(means.size());
    const Corners outward = cornersOf(mesh, cell, cellFaces);
    PartMeasure parts;
    double smallest = Box::inf;
    std::size_t next = 0;
    for (std::size_t i = 0; i < means.size(); ++i) {
        const Vec3 up = means[i] - centre;
        for (std::size_t k = 0; k < mesh.faces[cellFaces[i]].size(); ++k, ++next) {
            const Vec3 a = mesh.points[index(outward[next].point)] - means[i];
            const Vec3 b = mesh.points[index(outward[next].after)] - means[i];
            const double part = dot(up, cross(a, b));
            smallest = std::min(smallest, part);
            parts.volume += part;
        }
    }
    parts.volume /= 6;
    smallest *= static_cast<double>(next) / 6;
    Corners sorted = outward;
    smallest = std::min(smallest, smallestCorner(mesh, sorted));
    const double reference = volume != 0 ? volume : parts.volume;
    parts.smallest = reference > 0 ? smallest / reference : -1;
    return parts;
}

} // namespace polymesh
