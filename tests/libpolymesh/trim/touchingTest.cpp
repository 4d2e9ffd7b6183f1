// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/touching.h"

#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/surface/measure.h"
#include "libpolymesh/trim/trim.h"
#include "tests/support/meshes.h"
#include "tests/support/surfaces.h"
#include "tests/support/trimmed.h"

#include <gtest/gtest.h>

namespace polymesh::test {
namespace {

/// Area of the patches whose names are (not) "part".
double patchArea(const PolyMesh& mesh, bool ofPart) {
    double area = 0;
    for (const Patch& patch : mesh.patches)
        for (Label f = patch.start; f < patch.start + patch.size; ++f)
            if ((patch.name == "part") == ofPart)
                area += norm(faceGeometry(mesh.points, mesh.faces[f]).area);
    return area;
}

/// Trims the unit cube with a cuboid in it; areas tell whether the faces that the two share are
/// there once and on the right patch.
void expectTouchingIsClean(const PolyMesh& mesh, const Vec3& min, const Vec3& max) {
    const TriSurface surface = cuboid(min, max, "part");
    const Vec3 size = max - min;
    double touching = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double area = size.x * size.y * size.z / size[axis];
        touching += (min[axis] == 0 ? area : 0) + (max[axis] == 1 ? area : 0);
    }
    const SurfaceMeasure part = measure(surface);
    for (TrimOptions options : {exact(), TrimOptions{}}) {
        const PolyMesh inside = trimmed(mesh, surface, options);
        EXPECT_NEAR(volumeOf(inside), part.volume, 1e-12);
        EXPECT_NEAR(patchArea(inside, true), part.area, 1e-12);
        EXPECT_NEAR(patchArea(inside, false), 0, 1e-12);
        options.keep = Keep::outside;
        const PolyMesh outside = trimmed(mesh, surface, options);
        EXPECT_NEAR(volumeOf(outside), 1 - part.volume, 1e-12);
        EXPECT_NEAR(patchArea(outside, true), part.area - touching, 1e-12);
        EXPECT_NEAR(patchArea(outside, false), 6 - touching, 1e-12);
    }
}

TEST(TouchingParts, theSideOfAnotherPartThatTouchesFromOutsideTheMeshIsNoPatch) {
    const TriSurface beyond = cuboid({1, 0.1, 0.1}, {1.5, 0.9, 0.9}, "beyond");
    const TriSurface part = cuboid({0.3, 0.3, 0.3}, {1, 0.7, 0.7}, "part");
    const PolyMesh inside = trimmed(box(4, 4, 4), join(beyond, part), exact());
    EXPECT_NEAR(volumeOf(inside), measure(part).volume, 1e-12);
    EXPECT_NEAR(patchArea(inside, true), measure(part).area, 1e-12);
    EXPECT_NEAR(patchArea(inside, false), 0, 1e-12);
}

TEST(TouchingParts, whereAPartTouchesTheBoundaryOfTheMeshNothingFlatIsLeft) {
    for (int sides = 0; sides < 63; ++sides) {
        SCOPED_TRACE(sides);
        Vec3 min{0.3, 0.35, 0.4};
        Vec3 max{0.72, 0.64, 0.61};
        for (int axis = 0; axis < 3; ++axis) {
            if ((sides >> (2 * axis) & 1) != 0) min[axis] = 0;
            if ((sides >> (2 * axis) & 2) != 0) max[axis] = 1;
        }
        expectTouchingIsClean(box(5, 5, 5), min, max);
    }
}

TEST(TouchingParts, aThinRodOnTheBoundaryOfTheMeshLeavesAHole) {
    for (int axis = 0; axis < 3; ++axis)
        for (const bool atMax : {false, true}) {
            Vec3 min{0.45, 0.42, 0.44};
            Vec3 max{0.55, 0.53, 0.51};
            min[axis] = atMax ? 0.4 : 0;
            max[axis] = atMax ? 1 : 0.6;
            expectTouchingIsClean(box(3, 3, 3), min, max);
        }
}

} // namespace
} // namespace polymesh::test
