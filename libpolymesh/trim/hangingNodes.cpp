// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/hangingNodes.h"

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polymesh {

namespace {

/// A point in a face of the cell, with its neighbours there and the face's unit normal out of the
/// cell, at the point.
struct Corner {
    Label point;
    std::array<Label, 2> neighbours;
    Vec3 normal;
};

/// Whether three of the directions are independent, by 20 degrees or more.
bool isSolid(std::span<const Corner> corners) {
    const double straight = std::cos(std::numbers::pi / 9);
    boost::container::small_vector<Vec3, 6> directions;
    for (const Corner& corner : corners)
        if (std::ranges::none_of(directions,
                                 [&](const Vec3& d) { return dot(d, corner.normal) > straight; }))
            directions.push_back(corner.normal);
    return directions.size() >= 3;
}

/// The two neighbours between which the point is, most nearly.
HangingNode between(const PolyMesh& mesh, std::span<const Corner> corners) {
    boost::container::small_vector<Label, 8> neighbours;
    for (const Corner& corner : corners)
        neighbours.insert(neighbours.end(), corner.neighbours.begin(), corner.neighbours.end());
    std::ranges::sort(neighbours);
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    HangingNode node;
    node.node = corners.front().point;
    const Vec3& p = mesh.points[index(node.node)];
    double least = 2;
    for (std::size_t i = 0; i < neighbours.size(); ++i)
        for (std::size_t j = i + 1; j < neighbours.size(); ++j) {
            const Vec3 a = mesh.points[index(neighbours[i])] - p;
            const Vec3 b = mesh.points[index(neighbours[j])] - p;
            const double cosine = dot(a, b) / std::sqrt(squaredNorm(a) * squaredNorm(b));
            if (!(cosine < least - 1e-9)) continue;
            least = cosine;
            node.ends = {neighbours[i], neighbours[j]};
            node.weight = norm(a) / (norm(a) + norm(b));
        }
    node.offset = {};
    node.offset = p - node.place(mesh.points);
    return node;
}

} // namespace

void findHanging(const PolyMesh& mesh,
                 Label cell,
                 std::span<const Label> cellFaces,
                 std::vector<HangingNode>& found) {
    const bool isHexahedron = cellFaces.size() == 6 && std::ranges::all_of(cellFaces, [&](Label f) {
                                  return mesh.faces.rowSize(f) == 4;
                              });
    if (isHexahedron) return;
    boost::container::small_vector<Corner, 48> corners;
    for (const Label f : cellFaces) {
        const auto face = mesh.faces[f];
        const double out = mesh.owner[index(f)] == cell ? 1 : -1;
        Vec3 area;
        for (std::size_t i = 1; i + 1 < face.size(); ++i)
            area += cross(mesh.points[index(face[i])] - mesh.points[index(face[0])],
                          mesh.points[index(face[i + 1])] - mesh.points[index(face[0])]);
        const Vec3 normal = squaredNorm(area) > 0 ? (out / norm(area)) * area : Vec3{};
        for (std::size_t i = 0; i < face.size(); ++i)
            corners.push_back(
                {face[i],
                 {face[(i + face.size() - 1) % face.size()], face[(i + 1) % face.size()]},
                 normal});
    }
    std::ranges::stable_sort(corners, {}, &Corner::point);
    for (std::size_t i = 0; i < corners.size();) {
        std::size_t end = i + 1;
        while (end < corners.size() && corners[end].point == corners[i].point)
            ++end;
        const std::span<const Corner> group(&corners[i], end - i);
        if (!isSolid(group)) found.push_back(between(mesh, group));
        i = end;
    }
}

} // namespace polymesh
