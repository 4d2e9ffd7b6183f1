// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/measure.h"
#include "libpolymesh/trim/trim.h"
#include "tests/support/meshes.h"
#include "tests/support/surfaces.h"
#include "tests/support/trimOptions.h"

#include <gtest/gtest.h>

#include <random>

namespace polymesh::test {
namespace {

/// A part within one cell has no edge in a face of the mesh: rays tell which cell it is in, past
/// faces that are not plane; outside it is a void, whose cell has to be found.
TEST(WarpedCells, holdPartsThatTouchNoFace) {
    std::mt19937 random(1);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    for (unsigned i = 0; i < 500; ++i) {
        const PolyMesh mesh = jittered(box(2, 2, 2), between(0.02, 0.12), i);
        const double x = between(0.25, 0.75);
        const double y = between(0.25, 0.75);
        const TriSurface part = sphere(0, between(0.003, 0.02), {x, y, between(0.25, 0.75)});
        const double volume = measure(part).volume;
        const double inside = volumeOf(trim(mesh, part, exact()).mesh);
        const double outside = volumeOf(trim(mesh, part, exact(Keep::outside)).mesh);
        ASSERT_NEAR(inside / volume, 1, 1e-9) << "mesh " << i;
        ASSERT_NEAR((volumeOf(mesh) - outside) / volume, 1, 1e-5) << "mesh " << i;
    }
}

} // namespace
} // namespace polymesh::test
