// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/directions.h"

#include "libpolymesh/mesh/topology.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace polymesh {

namespace {

constexpr double component = 1e-6; // components of a unit vector below this are none
constexpr double parallel = 1e-3;  // how far cosines of wedges may differ
constexpr double planar = 3.16227766016837952e-08; // OpenFOAM's ROOTSMALL

Vec3 magnitudes(const Vec3& v) {
    return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}

Vec3 unit(const Vec3& v) {
    const double length = norm(v);
    return length < 1e-300 ? Vec3{} : v / length;
}

struct WedgePlane {
    const Patch* patch = nullptr;
    Vec3 normal;       // average of the faces'
    Vec3 centreNormal; // of the coordinate plane
    Vec3 axis;
    double cosine = 1; // of the angle between the two
};

/// The part of a normal's component that is above one half: all but one component vanish.
double dominant(double c) {
    return std::copysign(std::max(std::abs(c), 0.5) - 0.5, c);
}

WedgePlane wedgePlane(const Patch& patch, const MeshGeometry& geometry) {
    WedgePlane plane;
    plane.patch = &patch;
    for (Label face = patch.start; face < patch.start + patch.size; ++face)
        plane.normal += unit(geometry.faceAreas[index(face)]);
    plane.normal = plane.normal / static_cast<double>(patch.size);
    plane.centreNormal =
        unit({dominant(plane.normal.x), dominant(plane.normal.y), dominant(plane.normal.z)});
    plane.cosine = dot(plane.centreNormal, plane.normal);
    plane.axis = unit(cross(plane.centreNormal, plane.normal));
    return plane;
}

std::vector<WedgePlane> wedgePlanes(const PolyMesh& mesh, const MeshGeometry& geometry) {
    std::vector<WedgePlane> planes;
    for (const Patch& patch : mesh.patches)
        if (patch.type == "wedge" && patch.size > 0) planes.push_back(wedgePlane(patch, geometry));
    return planes;
}

void takeOut(Directions& directions, const Vec3& normalSum) {
    const Vec3 direction = normalSum / norm(normalSum);
    for (int axis = 0; axis < 3; ++axis)
        directions[static_cast<std::size_t>(axis)] = !(direction[axis] > component);
}

bool isOpposite(const WedgePlane& a, const WedgePlane& b) {
    return a.patch != b.patch && a.patch->size == b.patch->size &&
           std::abs(dot(a.axis, b.axis)) >= 1 - parallel &&
           std::abs(dot(a.centreNormal, b.normal) - a.cosine) >= parallel;
}

/// The first point of the patch that is not in its plane through the first point; else none.
std::string planarityFault(const PolyMesh& mesh, const WedgePlane& plane) {
    const std::span<const Label> first = mesh.faces[plane.patch->start];
    if (first.empty())
        return fmt::format("Wedge patch {} has a face without points", plane.patch->name);
    const Vec3& origin = mesh.points[index(first[0])];
    for (Label f = plane.patch->start; f < plane.patch->start + plane.patch->size; ++f)
        for (const Label point : mesh.faces[f]) {
            const Vec3& p = mesh.points[index(point)];
            const double distance = std::abs(dot(p - origin, plane.normal));
            if (distance > planar)
                return fmt::format(
                    "Wedge patch {} not planar. Point ({:.6g} {:.6g} {:.6g}) is not in patch "
                    "plane by {:.6g} metre.",
                    plane.patch->name,
                    p.x,
                    p.y,
                    p.z,
                    distance);
        }
    return {};
}

void checkWedges(const PolyMesh& mesh,
                 const std::vector<WedgePlane>& planes,
                 EdgeAlignment& result) {
    for (const WedgePlane& plane : planes) {
        result.wedges.push_back({plane.patch->name, std::acos(plane.cosine)});
        const bool hasOpposite = std::any_of(planes.begin(), planes.end(), [&](const auto& other) {
            return isOpposite(plane, other);
        });
        result.wedgeFault =
            hasOpposite ? planarityFault(mesh, plane)
                        : fmt::format("Cannot find opposite wedge for wedge {}", plane.patch->name);
        if (!result.wedgeFault.empty()) return;
    }
}

/// Calls use(a, b) for the edges of a face that run from a lower to a higher label.
template<class Use>
void forEachAscendingEdge(const PolyMesh& mesh, Label face, Use&& use) {
    const std::span<const Label> points = mesh.faces[face];
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Label next = points[i + 1 == points.size() ? 0 : i + 1];
        if (points[i] < next) use(points[i], next);
    }
}

bool isAligned(const Vec3& edge, const Directions& directions) {
    const double length = norm(edge);
    if (!(length > 1e-150)) return true;
    int missing = 0;
    int extant = 0;
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(edge[axis] / length) > component)
            ++(directions[static_cast<std::size_t>(axis)] ? extant : missing);
    return missing == 0 || (missing == 1 && extant == 0);
}

std::set<Edge> wedgeEdges(const PolyMesh& mesh, const std::vector<WedgePlane>& planes) {
    std::set<Edge> result;
    for (const WedgePlane& plane : planes)
        for (Label f = plane.patch->start; f < plane.patch->start + plane.patch->size; ++f) {
            const std::span<const Label> points = mesh.faces[f];
            for (std::size_t i = 0; i < points.size(); ++i) {
                const Label next = points[i + 1 == points.size() ? 0 : i + 1];
                result.insert({std::min(points[i], next), std::max(points[i], next)});
            }
        }
    return result;
}

} // namespace

MeshDirections meshDirections(const PolyMesh& mesh, const MeshGeometry& geometry) {
    MeshDirections result;
    Vec3 emptySum;
    bool hasEmpty = false;
    for (const Patch& patch : mesh.patches) {
        if (patch.type != "empty" || patch.size <= 0) continue;
        hasEmpty = true;
        Vec3 sum;
        for (Label face = patch.start; face < patch.start + patch.size; ++face)
            sum += magnitudes(geometry.faceAreas[index(face)]);
        emptySum += sum;
    }
    if (hasEmpty) takeOut(result.solution, emptySum);
    result.geometric = result.solution;
    Vec3 wedgeSum;
    const std::vector<WedgePlane> planes = wedgePlanes(mesh, geometry);
    for (const WedgePlane& plane : planes)
        wedgeSum += magnitudes(plane.centreNormal);
    if (!planes.empty()) takeOut(result.geometric, wedgeSum);
    return result;
}

EdgeAlignment edgeAlignment(const PolyMesh& mesh,
                            const MeshGeometry& geometry,
                            const MeshDirections& directions) {
    EdgeAlignment result;
    std::set<Edge> exempt;
    if (directions.geometric != directions.solution) {
        const std::vector<WedgePlane> planes = wedgePlanes(mesh, geometry);
        checkWedges(mesh, planes, result);
        if (!result.wedgeFault.empty()) return result;
        exempt = wedgeEdges(mesh, planes);
    }
    std::set<Edge> offenders;
    for (Label face = 0; face < mesh.faceCount(); ++face)
        forEachAscendingEdge(mesh, face, [&](Label a, Label b) {
            const Vec3 edge = mesh.points[index(b)] - mesh.points[index(a)];
            if (!isAligned(edge, directions.geometric) && !exempt.contains({a, b}))
                offenders.insert({a, b});
        });
    result.edgeCount = toLabel(offenders.size());
    for (const Edge& edge : offenders)
        result.points.insert(result.points.end(), edge.begin(), edge.end());
    std::sort(result.points.begin(), result.points.end());
    result.points.erase(std::unique(result.points.begin(), result.points.end()),
                        result.points.end());
    return result;
}

} // namespace polymesh
