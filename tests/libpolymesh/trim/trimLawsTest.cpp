// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Laws of the whole trim, on real surfaces.

#include "formats/surfaceIo.h"
#include "libpolymesh/initial/cartesian.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/quality/checks.h"
#include "libpolymesh/surface/edges.h"
#include "libpolymesh/surface/measure.h"
#include "libpolymesh/surface/orient.h"
#include "libpolymesh/trim/trim.h"
#include "tests/formats/surfaceFilesTest.h"
#include "tests/support/meshes.h"
#include "tests/support/surfaces.h"
#include "tests/support/trimmed.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <utility>

namespace polymesh::test {
namespace {

namespace fs = std::filesystem;

const fs::path examples = "/usr/share/doc/openfoam-examples/examples/resources/geometry";
const fs::path cgalData = "/usr/share/doc/libcgal-dev/data.tar.gz";

/// A surface of the package libcgal-demo; nothing where that is not installed.
std::optional<TriSurface> cgalSurface(const std::string& name) {
    const TemporaryDirectory folder;
    const std::string file = "data/meshes/" + name + ".off";
    const std::string command =
        "tar xzf " + cgalData.string() + " -C " + folder.path().string() + " " + file;
    if (!fs::exists(cgalData) || std::system(command.c_str()) != 0) return std::nullopt;
    TriSurface surface = readSurface(folder.path() / file);
    orientSurface(surface);
    return surface;
}

/// Surfaces by name, of the packages openfoam-examples and libcgal-demo; none where they are not
/// installed.
std::map<std::string, TriSurface> realSurfaces() {
    std::map<std::string, TriSurface> surfaces;
    if (fs::exists(examples / "flange.stl.gz")) {
        surfaces["flange"] = readSurface(examples / "flange.stl.gz");
        orientSurface(surfaces["flange"]);
    }
    for (const char* name : {"elephant", "couplingdown", "joint"})
        if (auto surface = cgalSurface(name)) surfaces[name] = std::move(*surface);
    return surfaces;
}

/// A box of about `cells` cells round the surface.
PolyMesh boxOf(const TriSurface& surface, double cells) {
    const Box bounds = boundingBox(surface.points);
    const Vec3 size = bounds.size();
    const double cellSize = std::cbrt(size.x * size.y * size.z / cells);
    return cartesianMesh(boxAround(bounds, cellSize, defaultMargin(cellSize)));
}

void expectExact(const PolyMesh& mesh, const TriSurface& surface, const std::string& name) {
    const double part = measure(surface).volume;
    const double whole = volumeOf(mesh);
    const double inside = volumeOf(trimmed(mesh, surface, exact()));
    const double outside = volumeOf(trimmed(mesh, surface, exact(Keep::outside)));
    EXPECT_NEAR(inside / part, 1, 1e-11) << name;
    EXPECT_NEAR((inside + outside) / whole, 1, 1e-11) << name;
}

/// A turn about a skew axis that maps no coordinate plane to another.
Vec3 turned(const Vec3& p) {
    const Vec3 axis = Vec3{1, 2, 3} / std::sqrt(14.0);
    const double angle = 0.7;
    return std::cos(angle) * p + std::sin(angle) * cross(axis, p) +
           (1 - std::cos(angle)) * dot(axis, p) * axis;
}

template<class Body>
void turnAll(Body& body) {
    for (Vec3& p : body.points)
        p = turned(p);
}

TEST(TrimLaws, insideIsThePartAndOutsideTheRestOfTheBox) {
    const auto surfaces = realSurfaces();
    if (surfaces.empty()) GTEST_SKIP() << "openfoam-examples and libcgal-demo are not installed";
    for (const auto& [name, surface] : surfaces)
        expectExact(boxOf(surface, 3000), surface, name);
}

TEST(TrimLaws, alsoForTurnedSurfaces) {
    auto surfaces = realSurfaces();
    if (surfaces.empty()) GTEST_SKIP() << "openfoam-examples and libcgal-demo are not installed";
    surfaces.erase("elephant"); // lies in no special direction as it is
    for (auto& [name, surface] : surfaces) {
        turnAll(surface);
        expectExact(boxOf(surface, 1000), surface, name);
    }
}

TEST(TrimLaws, defaultOptionsGiveValidMeshesNearThePart) {
    const auto surfaces = realSurfaces();
    if (surfaces.empty()) GTEST_SKIP() << "openfoam-examples and libcgal-demo are not installed";
    for (const auto& [name, surface] : surfaces)
        for (const Keep keep : {Keep::inside, Keep::outside}) {
            TrimOptions options;
            options.keep = keep;
            const PolyMesh mesh = boxOf(surface, 1500);
            const double part = measure(surface).volume;
            const double wanted = keep == Keep::inside ? part : volumeOf(mesh) - part;
            EXPECT_NEAR(volumeOf(trimmed(mesh, surface, options)), wanted, 0.04 * part) << name;
        }
}

TEST(TrimLaws, badCellsAreThoseThatCheckMeshFails) {
    const auto surface = cgalSurface("pinion");
    if (!surface) GTEST_SKIP() << "libcgal-demo is not installed";
    // A repair here once made a cell bad that is no neighbour of the cells repaired.
    const Trimmed result = trim(boxOf(*surface, 60000), *surface, {});
    EXPECT_EQ(result.summary.badCells == 0, checkMesh(result.mesh, {}).isOk());
}

/// Turning mesh and surface together changes nothing: all their points are in general position.
void expectTurningChangesNothing(PolyMesh mesh, TriSurface surface) {
    const PolyMesh before = trimmed(mesh, surface, exact());
    turnAll(mesh);
    turnAll(surface);
    const PolyMesh after = trimmed(mesh, surface, exact());
    EXPECT_EQ(after.cellCount, before.cellCount);
    EXPECT_NEAR(volumeOf(after) / volumeOf(before), 1, 1e-12);
}

TEST(TrimLaws, turningMeshAndSurfaceTogetherChangesNothing) {
    // Faces that are fans before must be fans after: only then is the geometry the same.
    const PolyMesh mesh = jittered(box(6, 6, 6), .02);
    expectTurningChangesNothing(mesh, sphere(3, .37, {.51, .47, .5}));
    expectTurningChangesNothing(mesh, cuboid({.13, .23, .18}, {.71, .77, .83}));
}

/// The surface with its points numbered otherwise and its triangles in another order.
TriSurface renumbered(TriSurface surface, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<Label> number(surface.points.size());
    std::iota(number.begin(), number.end(), 0);
    for (std::size_t i = number.size(); i > 1; --i)
        std::swap(number[i - 1], number[random() % i]);
    const std::vector<Vec3> points = surface.points;
    for (std::size_t i = 0; i < number.size(); ++i)
        surface.points[index(number[i])] = points[i];
    for (auto& triangle : surface.triangles)
        for (Label& p : triangle)
            p = number[index(p)];
    return shuffled(surface, seed);
}

void expectRenumberingChangesNothing(const PolyMesh& mesh, const TriSurface& surface) {
    const PolyMesh before = trimmed(mesh, surface, exact());
    for (const unsigned seed : {1U, 2U}) {
        const PolyMesh after = trimmed(mesh, renumbered(surface, seed), exact());
        EXPECT_EQ(after.cellCount, before.cellCount);
        EXPECT_NEAR(volumeOf(after) / volumeOf(before), 1, 1e-13);
    }
}

TEST(TrimLaws, renumberingTheSurfaceChangesNothing) {
    expectRenumberingChangesNothing(box(7, 7, 7), sphere(3, .37, {.51, .47, .5}));
    expectRenumberingChangesNothing(box(4, 4, 4), cuboid({.25, .25, .25}, {.75, .75, .625}));
    expectRenumberingChangesNothing(box(4, 4, 4, {4, 4, 4}), sphere(0, 1.5, {1.5, 2, 2}));
    for (const auto& [name, surface] : realSurfaces())
        if (name != "elephant") expectRenumberingChangesNothing(boxOf(surface, 500), surface);
}

/// Cells that are put side by side; points with the same coordinates are one.
class Cells {
public:
    void addHex(const Vec3& low, double h) {
        std::array<Label, 8> v{};
        const std::array<int, 8> order{0, 1, 3, 2, 4, 5, 7, 6};
        for (std::size_t i = 0; i < 8; ++i)
            v[i] = label(corner(low, h, order[i]));
        cells_.push_back(hexahedron(v));
    }

    void addEighths(const Vec3& low, double h) {
        for (int part = 0; part < 8; ++part)
            addHex(corner(low, h / 2, part), h / 2);
    }

    /// A coarse cell on the fine half: four faces below, and a middle on each lower edge.
    void addTransition(const Vec3& low, double h) {
        const auto at = [&](double x, double y, double z) {
            return label(low + Vec3{x * h, y * h, z * h});
        };
        Polyhedron cell{{at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)},
                        {at(0, 0, 0), at(.5, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)},
                        {at(1, 0, 0), at(1, .5, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)},
                        {at(1, 1, 0), at(.5, 1, 0), at(0, 1, 0), at(0, 1, 1), at(1, 1, 1)},
                        {at(0, 1, 0), at(0, .5, 0), at(0, 0, 0), at(0, 0, 1), at(0, 1, 1)}};
        for (const double x : {0.0, .5})
            for (const double y : {0.0, .5})
                cell.push_back(
                    {at(x, y, 0), at(x, y + .5, 0), at(x + .5, y + .5, 0), at(x + .5, y, 0)});
        cells_.push_back(cell);
    }

    PolyMesh mesh() const { return meshOf(points_, cells_); }

private:
    static Vec3 corner(const Vec3& low, double h, int i) {
        return low + Vec3{(i & 1) != 0 ? h : 0, (i & 2) != 0 ? h : 0, (i & 4) != 0 ? h : 0};
    }

    Label label(const Vec3& p) {
        const auto [at, isNew] = labels_.try_emplace(p, toLabel(points_.size()));
        if (isNew) points_.push_back(p);
        return at->second;
    }

    std::map<Vec3, Label> labels_;
    std::vector<Vec3> points_;
    std::vector<Polyhedron> cells_;
};

/// A box in which every cell of the lower half is one of eight: faces and edges hang.
PolyMesh refinedBelow(Label n) {
    const double coarse = 1.0 / n;
    Cells cells;
    for (Label k = 0; k < n; ++k)
        for (Label j = 0; j < n; ++j)
            for (Label i = 0; i < n; ++i) {
                const Vec3 low{coarse * i, coarse * j, coarse * k};
                if (2 * k > n)
                    cells.addHex(low, coarse);
                else if (2 * k == n)
                    cells.addTransition(low, coarse);
                else
                    cells.addEighths(low, coarse);
            }
    return cells.mesh();
}

TEST(TrimLaws, meshesWithHangingNodesAreTrimmedExactly) {
    const PolyMesh mesh = refinedBelow(8);
    ASSERT_TRUE(validate(mesh).empty());
    expectExact(mesh, sphere(3, .37, {.51, .47, .5}), "sphere");
    expectExact(mesh, cuboid({.25, .25, .25}, {.75, .75, .75}), "cuboid on grid planes");
    expectExact(mesh, sphere(0, .25, {.5, .5, .5}), "octahedron on nodes");
    trimmed(mesh, sphere(3, .37, {.51, .47, .5}), TrimOptions{});
}

TEST(TrimLaws, jitteredMeshesAreTrimmedExactly) {
    for (const unsigned seed : {1U, 2U}) {
        const PolyMesh mesh = jittered(refinedBelow(4), .02, seed);
        expectExact(mesh, sphere(3, .37, {.51, .47, .5}), "sphere");
        expectExact(mesh, cuboid({.25, .25, .25}, {.75, .75, .75}), "cuboid");
        trimmed(mesh, cuboid({.21, .22, .23}, {.71, .72, .77}), TrimOptions{});
    }
}

TEST(TrimLaws, aVoidBelongsToThePieceOfTheCellThatHoldsIt) {
    // A wall divides the cell into a thin piece and a thick one; a ball hollows out the thick one.
    const TriSurface wall = cuboid({.1, -1, -1}, {.2, 2, 2});
    const TriSurface ball = sphere(2, .35, {.6, .5, .5});
    for (const bool isMirrored : {false, true}) {
        TriSurface surface = join(wall, ball);
        if (isMirrored) {
            for (Vec3& p : surface.points)
                p.x = 1 - p.x;
            surface = inverted(surface);
        }
        const PolyMesh mesh = trimmed(unitCube(), surface, exact(Keep::outside));
        ASSERT_EQ(mesh.cellCount, 2);
        std::vector<double> volumes = computeGeometry(mesh).cellVolumes;
        std::ranges::sort(volumes);
        EXPECT_NEAR(volumes[0], .1, 1e-14);
        EXPECT_NEAR(volumes[1], .8 - measure(ball).volume, 1e-14);
    }
}

TEST(TrimLaws, aVoidThatTouchesAFaceOfTheCellStaysAVoid) {
    // The tip of an octahedron lies on the face towards the next cell.
    const TriSurface surface = sphere(0, .0625, {.125, .4375, .625});
    const PolyMesh mesh = trimmed(box(2, 2, 2), surface, exact(Keep::outside));
    EXPECT_EQ(mesh.cellCount, 8);
    EXPECT_NEAR(volumeOf(mesh), 1 - measure(surface).volume, 1e-14);
}

TEST(TrimLaws, aVoidOnAFaceOfTheCellStaysAVoid) {
    const TriSurface surface = cuboid({.75, .5, .625}, {.8125, .8125, .6875});
    const PolyMesh mesh = trimmed(box(2, 2, 2), surface, exact(Keep::outside));
    EXPECT_NEAR(volumeOf(mesh), 1 - measure(surface).volume, 1e-14);
}

TEST(TrimLaws, aPartOnTheBoundaryOfTheMeshLeavesNoFlatCellsThere) {
    const TriSurface surface = cuboid({.0625, 0, .6875}, {.5625, .0625, 1.125});
    const PolyMesh mesh = trimmed(box(5, 5, 5), surface, exact(Keep::outside));
    EXPECT_NEAR(volumeOf(mesh), 1 - .5 * .0625 * .3125, 1e-14);
}

TEST(TrimLaws, aBarThatEndsInsideACellOnGridPlanesLeavesClosedCells) {
    const TriSurface surface = cuboid({.5, .25, .25}, {.5625, .5625, .3125});
    const PolyMesh mesh = trimmed(box(4, 4, 4), surface, exact(Keep::outside));
    EXPECT_NEAR(volumeOf(mesh), 1 - measure(surface).volume, 1e-14);
}

/// Three cubes in each direction, two of five of them.
TriSurface someCubes(unsigned seed) {
    std::mt19937 random(seed);
    std::set<std::array<int, 3>> places{{0, 0, 0}, {2, 2, 2}};
    for (int i = 0; i < 27; ++i)
        if (random() % 5 < 2) places.insert({i % 3, i / 3 % 3, i / 9});
    return cubes(places);
}

TEST(TrimLaws, surfacesMayTouchThemselvesAlongEdges) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        TriSurface surface = someCubes(seed);
        turnAll(surface);
        ASSERT_TRUE(isPinched(pairEdges(surface))) << seed;
        expectExact(boxOf(surface, 200), surface, std::to_string(seed));
        trimmed(boxOf(surface, 200), surface, {});
    }
}

TEST(TrimLaws, surfacesOnGridPlanesMayTouchThemselvesAlongEdges) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        const TriSurface surface = someCubes(seed);
        for (const Label n : {2, 5, 10}) // their planes lie on some, all, none of the cubes' sides
            expectExact(cartesianMesh({{{-1, -1, -1}, {4, 4, 4}}, {n, n, n}}),
                        surface,
                        std::to_string(seed));
    }
}

TEST(TrimLaws, cleanUpEnds) {
    TrimOptions options;
    options.keep = Keep::outside;
    trimmed(box(2, 2, 2), cuboid({.6875, .75, 0}, {1.125, .8125, .125}), options);
}

TEST(TrimLaws, finerMeshesComeNearerToThePart) {
    const TriSurface surface = sphere(5, .41, {.5, .5, .5});
    double last = 1;
    for (const Label n : {5, 10, 20}) {
        TrimOptions options;
        options.deviation = 0.2;
        const double error = std::abs(
            volumeOf(trimmed(box(n, n, n), surface, options)) / measure(surface).volume - 1);
        EXPECT_LT(error, 0.5 * last) << n;
        last = error;
    }
}

} // namespace
} // namespace polymesh::test
