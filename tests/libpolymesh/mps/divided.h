// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Laws that every divided mesh keeps, and an independent look at its corners.

#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/mps/midPointSubdivision.h"
#include "libpolymesh/quality/standardShape.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace polymesh::test {

/// The sum of the area vectors and that of their magnitudes.
inline std::pair<Vec3, double> patchArea(const PolyMesh& mesh, const Patch& patch) {
    std::pair<Vec3, double> area;
    for (Label face = patch.start; face < patch.start + patch.size; ++face) {
        const Vec3 own = faceGeometry(mesh.points, mesh.faces[face]).area;
        area.first += own;
        area.second += norm(own);
    }
    return area;
}

/// The least scaled Jacobian of a hexahedron or pyramid from nothing but its faces: at each corner
/// of a quadrilateral face with each further edge of the cell from that corner.
inline double leastJacobianOfFaces(const PolyMesh& mesh, const Rows<Label>& faces, Label cell) {
    std::map<Label, std::vector<Label>> neighbours;
    std::vector<std::vector<Label>> outward;
    for (const Label face : faces[cell]) {
        std::vector<Label> loop(mesh.faces[face].begin(), mesh.faces[face].end());
        if (mesh.owner[index(face)] != cell) std::ranges::reverse(loop);
        for (std::size_t i = 0; i < loop.size(); ++i)
            neighbours[loop[i]].push_back(loop[(i + 1) % loop.size()]);
        outward.push_back(loop);
    }
    double least = 1;
    for (const auto& loop : outward)
        for (std::size_t i = 0; i < loop.size() && loop.size() == 4; ++i) {
            const Vec3& at = mesh.points[index(loop[i])];
            const Label before = loop[(i + 3) % 4];
            const Label after = loop[(i + 1) % 4];
            for (const Label third : neighbours[loop[i]]) {
                if (third == before || third == after) continue;
                const Vec3 a = mesh.points[index(before)] - at;
                const Vec3 b = mesh.points[index(after)] - at;
                const Vec3 c = mesh.points[index(third)] - at;
                least = std::min(least, dot(cross(a, b), c) / (norm(a) * norm(b) * norm(c)));
            }
        }
    return least;
}

/// The least over all cells.
inline double leastJacobianOfFaces(const PolyMesh& mesh) {
    const Rows<Label> faces = cellFaces(mesh);
    double least = 1;
    for (Label cell = 0; cell < mesh.cellCount; ++cell)
        least = std::min(least, leastJacobianOfFaces(mesh, faces, cell));
    return least;
}

struct Divided {
    PolyMesh mesh;
    std::vector<Label> inverted;
    Label hexahedra = 0;
    Label pyramids = 0;
};

/// Divides a mesh and holds what is always true: the result is valid, has hexahedra and pyramids
/// only, as many as theory demands, and the same volume, cell by cell, and areas.
inline Divided dividedByLaw(const PolyMesh& mesh) {
    EXPECT_TRUE(validate(mesh).empty());
    SubdivisionPlan plan = planSubdivision(mesh);
    const std::vector<Label> firstPart = plan.firstPart;
    Divided result{{}, plan.inverted};
    const SubdivisionCounts planned{plan.hexahedra, plan.pyramids};
    result.mesh = divide(mesh, std::move(plan));
    const auto defects = validate(result.mesh);
    EXPECT_TRUE(defects.empty()) << defects.front().message;
    const ShapeCounts shapes = countShapes(result.mesh, cellFaces(result.mesh));
    result.hexahedra = shapes[StandardShape::hexahedron];
    result.pyramids = shapes[StandardShape::pyramid];
    EXPECT_EQ(result.hexahedra + result.pyramids, result.mesh.cellCount);
    EXPECT_EQ(result.hexahedra, planned.hexahedra);
    EXPECT_EQ(result.pyramids, planned.pyramids);
    const SubdivisionCounts demanded = demandedCounts(mesh);
    EXPECT_EQ(result.hexahedra, demanded.hexahedra);
    EXPECT_EQ(result.pyramids, demanded.pyramids);
    EXPECT_EQ(result.inverted.empty(), leastJacobianOfFaces(result.mesh) > leastJacobian);
    const double volume = volumeOf(mesh);
    EXPECT_NEAR(volumeOf(result.mesh), volume, 1e-12 * volume);
    for (std::size_t p = 0; p < mesh.patches.size(); ++p) {
        const auto [area, magnitude] = patchArea(mesh, mesh.patches[p]);
        const Vec3 divided = patchArea(result.mesh, result.mesh.patches[p]).first;
        EXPECT_EQ(result.mesh.patches[p].name, mesh.patches[p].name);
        EXPECT_LE(norm(divided - area), 1e-12 * magnitude);
    }
    return result;
}

} // namespace polymesh::test
