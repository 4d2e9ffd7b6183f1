// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// sameMesh CASE CASE TOLERANCE: says in which way the meshes of two cases differ, but for names;
// status 1 when they do. The tolerance of points is relative to the largest coordinate.

#include "tests/support/sameMesh.h"

#include "formats/foam/polyMeshIo.h"

#include <cmath>
#include <cstdlib>
#include <exception>

int main(int argc, char** argv) {
    using namespace polymesh;
    if (argc != 4) return 2;
    try {
        const auto read = [](const char* name) {
            return foam::readPolyMesh(std::filesystem::path(name) / "constant/polyMesh");
        };
        const PolyMesh a = read(argv[1]);
        double largest = 0;
        for (const Vec3& p : a.points)
            largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        const std::string difference =
            test::differenceOf(a, read(argv[2]), std::atof(argv[3]) * largest);
        if (!difference.empty()) fmt::print("{} and {} differ: {}\n", argv[1], argv[2], difference);
        return difference.empty() ? 0 : 1;
    } catch (const std::exception& error) {
        fmt::print(stderr, "sameMesh: {}\n", error.what());
        return 2;
    }
}
