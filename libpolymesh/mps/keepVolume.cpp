// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/keepVolume.h"

#include "libpolymesh/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace polymesh {

namespace {

/// Consecutive boundary faces of the mesh that take the place of faces of the undivided mesh.
struct Group {
    Label first;          // face
    Label last;           // behind the last
    Vec3 area;            // [m^2]
    Vec3 apex;            // [m] any point near
    double target = 0;    // [m^3] three times the volume over the apex that the faces should hold
    bool isFixed = false; // of a cell that is not divided
    bool isMoved = false;
    bool wentBack = false;
};

Vec3 areaOf(const PolyMesh& mesh, const SubdivisionPlan& plan, Label face) {
    const Vec3& middle = plan.points[index(plan.layout.firstFace + face)];
    const Label first = mesh.faces.offsets[index(face)];
    const Label size = mesh.faces.rowSize(face);
    Vec3 sum;
    for (Label i = 0; i < size; ++i) {
        const Label next = i + 1 < size ? i + 1 : 0;
        const Vec3 a = mesh.points[index(mesh.faces.values[index(first + i)])] - middle;
        const Vec3 b =
            plan.points[index(plan.layout.firstEdge + plan.edges.ofCorner[index(first + i)])] -
            middle;
        const Vec3 c = mesh.points[index(mesh.faces.values[index(first + next)])] - middle;
        sum += 0.5 * (cross(a, b) + cross(b, c));
    }
    return sum;
}

/// Three times the volume [m^3] over a point under the quadrilaterals of a face.
double heldBy(const PolyMesh& mesh, const SubdivisionPlan& plan, Label face, const Vec3& apex) {
    const Label first = mesh.faces.offsets[index(face)];
    const Label size = mesh.faces.rowSize(face);
    double sum = 0;
    for (Label i = 0; i < size; ++i) {
        const Label before = i > 0 ? i - 1 : size - 1;
        const std::array<Label, 4> quad{
            mesh.faces.values[index(first + i)],
            plan.layout.firstEdge + plan.edges.ofCorner[index(first + i)],
            plan.layout.firstFace + face,
            plan.layout.firstEdge + plan.edges.ofCorner[index(first + before)]};
        const FaceGeometry own = faceGeometry(plan.points, quad);
        sum += dot(own.area, own.centre - apex);
    }
    return sum;
}

double excess(const PolyMesh& mesh, const SubdivisionPlan& plan, const Group& group) {
    double held = 0;
    for (Label face = group.first; face < group.last; ++face)
        held += heldBy(mesh, plan, face, group.apex);
    return held - group.target;
}

/// A group for each undivided face.
std::vector<Group> groupsOf(const PolyMesh& mesh,
                            const SubdivisionPlan& plan,
                            std::span<const Label> from,
                            std::span<const FaceGeometry> undivided) {
    std::vector<Group> groups;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const Label face = mesh.internalFaceCount() + toLabel(i);
        if (i == 0 || from[i] != from[i - 1])
            groups.push_back({face, face, {}, undivided[index(from[i])].centre});
        groups.back().last = face + 1;
        groups.back().area += areaOf(mesh, plan, face);
    }
    return groups;
}

void shift(const Group& group, const Vec3& by, SubdivisionPlan& plan) {
    for (Label face = group.first; face < group.last; ++face)
        plan.points[index(plan.layout.firstFace + face)] += by;
}

/// Moves the points of a group until it holds its target; false when it holds it already.
bool fit(const PolyMesh& mesh, const Group& group, SubdivisionPlan& plan) {
    constexpr int steps = 6;
    const double area = norm(group.area);
    const double rounding = 1e-15 * area * std::sqrt(area);
    double now = excess(mesh, plan, group);
    if (!(area > 0) || std::abs(now) <= rounding) return false;
    const Vec3 normal = group.area / area;
    double slope = area;
    for (int i = 0; i < steps && std::abs(now) > rounding; ++i) {
        const double by = -now / slope;
        shift(group, by * normal, plan);
        const double then = excess(mesh, plan, group);
        const double measured = by != 0 ? (then - now) / by : slope;
        if (measured > 0.1 * area) slope = measured;
        now = then;
    }
    return true;
}

/// The cells at the groups that have moved, ascending.
std::vector<Label> movedCells(const PolyMesh& mesh, std::span<const Group> groups) {
    std::vector<Label> cells;
    for (const Group& group : groups)
        for (Label face = group.first; group.isMoved && face < group.last; ++face)
            cells.push_back(mesh.owner[index(face)]);
    std::ranges::sort(cells);
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return cells;
}

/// Fits all groups and takes back those that invert a part of a cell that was right. Returns what
/// is missing then [m^3, three times].
double fitAll(const PolyMesh& mesh, std::vector<Group>& groups, SubdivisionPlan& plan) {
    const std::vector<Vec3> before(plan.points.begin() + plan.layout.firstFace,
                                   plan.points.begin() + plan.layout.firstCell);
    parallelFor(toLabel(groups.size()), [&](Label g) {
        Group& group = groups[index(g)];
        group.isMoved = !group.isFixed && fit(mesh, group, plan);
    });
    std::vector<Label> bad = invertedCells(mesh, plan, movedCells(mesh, groups));
    std::erase_if(bad, [&](Label c) { return std::ranges::binary_search(plan.inverted, c); });
    double missing = 0;
    for (Group& group : groups) {
        const auto isBad = [&](Label face) {
            return std::ranges::binary_search(bad, mesh.owner[index(face)]);
        };
        bool goesBack = false;
        for (Label face = group.first; group.isMoved && face < group.last; ++face)
            goesBack = goesBack || isBad(face);
        if (!goesBack) continue;
        for (Label face = group.first; face < group.last; ++face)
            plan.points[index(plan.layout.firstFace + face)] = before[index(face)];
        group.isMoved = false;
        group.wentBack = true;
        const double left = excess(mesh, plan, group);
        missing += left;
        group.target += left;
    }
    return missing;
}

/// Fixes the groups with a face of a cell that is not divided. Returns what these hold too much.
double fixUndivided(const PolyMesh& mesh,
                    const SubdivisionPlan& plan,
                    std::span<const Fate> fates,
                    std::vector<Group>& groups) {
    double missing = 0;
    for (Group& group : groups) {
        double held = 0;
        for (Label face = group.first; face < group.last; ++face) {
            const bool isDivided = fates[index(mesh.owner[index(face)])] == Fate::divided;
            const FaceGeometry whole = faceGeometry(mesh.points, mesh.faces[face]);
            held += isDivided ? heldBy(mesh, plan, face, group.apex)
                              : dot(whole.area, whole.centre - group.apex);
            group.isFixed = group.isFixed || !isDivided;
        }
        if (group.isFixed) missing += held - group.target;
    }
    return missing;
}

} // namespace

std::vector<FaceGeometry> boundaryGeometry(const PolyMesh& mesh) {
    const Label internal = mesh.internalFaceCount();
    std::vector<FaceGeometry> faces(index(mesh.faceCount() - internal));
    parallelFor(toLabel(faces.size()), [&](Label i) {
        faces[index(i)] = faceGeometry(mesh.points, mesh.faces[internal + i]);
    });
    return faces;
}

KeptVolume keepVolume(const PolyMesh& mesh,
                      std::span<const Label> from,
                      std::span<const FaceGeometry> undivided,
                      std::span<const Fate> fates,
                      SubdivisionPlan& plan) {
    constexpr int rounds = 4;
    std::vector<Group> groups = groupsOf(mesh, plan, from, undivided);
    double missing = fates.empty() ? 0 : fixUndivided(mesh, plan, fates, groups);
    missing += fitAll(mesh, groups, plan);
    for (int round = 1; round < rounds && missing != 0; ++round) {
        double area = 0;
        for (const Group& group : groups)
            area += group.isMoved ? norm(group.area) : 0;
        if (!(area > 0)) break;
        for (Group& group : groups)
            if (group.isMoved) group.target -= missing * norm(group.area) / area;
        missing = fitAll(mesh, groups, plan);
    }
    KeptVolume kept{
        static_cast<Label>(std::ranges::count(groups, true, &Group::isMoved)), missing / 3, {}};
    for (const Group& group : groups)
        if (group.wentBack)
            kept.notKept.push_back(from[index(group.first - mesh.internalFaceCount())]);
    return kept;
}

} // namespace polymesh
