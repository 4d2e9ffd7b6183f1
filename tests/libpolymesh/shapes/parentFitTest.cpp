// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapes/parentFit.h"

#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/shapes/classify.h"
#include "tests/libpolymesh/shapes/cutCube.h"

#include <gtest/gtest.h>

namespace polymesh::test {

namespace {

int cornersIn(unsigned mask) {
    int count = 0;
    for (; mask != 0; mask &= mask - 1)
        ++count;
    return count;
}

/// What is left of a cube when a plane cuts these corners away: shapes.md.
std::string expectedShape(unsigned mask) {
    switch (cornersIn(mask)) {
    case 0:
        return "hexahedron";
    case 1:
        return "sammTrim1";
    case 2:
        return "sammTrim2";
    case 3:
        return "sammTrim3";
    case 4:
        return isCubeFace(mask) ? "hexahedron" : "sammTrim4";
    case 5:
        return "sammTrim5";
    case 6:
        return "prism";
    default:
        return "tetrahedron";
    }
}

Vec3 turned(const Vec3& p) {
    // by 30 degrees about z, then by 50 about x; stretched, so that the parent is no cube
    const Vec3 a{0.8660254 * p.x - 0.5 * p.y, 0.5 * p.x + 0.8660254 * p.y, 1.7 * p.z};
    return {a.x, 0.6427876 * a.y - 0.7660444 * a.z, 0.7660444 * a.y + 0.6427876 * a.z};
}

TEST(FitToParent, recognisesEveryCornerSetThatAPlaneCutsOffACube) {
    const std::map<unsigned, CutCube> cuts = cubesCutByPlanes();
    EXPECT_EQ(cuts.size(), 103U); // 104 with the full set, which leaves nothing
    for (const auto& [mask, cell] : cuts) {
        PolyMesh mesh = meshOf(cell.points, {cell.faces});
        for (Vec3& p : mesh.points)
            p = turned(p);
        const std::vector<CellShape> shapes = classifyCells(mesh, cellFaces(mesh));
        ASSERT_TRUE(shapes[0].isRecognised()) << mask;
        EXPECT_EQ(nameOf(shapes[0]), expectedShape(mask)) << mask;
    }
}

TEST(FitToParent, findsTheCutFace) {
    for (const auto& [mask, cell] : cubesCutByPlanes()) {
        const auto found = recognise(rowsOf(cell.faces));
        ASSERT_TRUE(found);
        const Recognition fit = fitToParent(*found, cell.points);
        const BaseShapeTable& table = tableOf(fit.base);
        EXPECT_EQ(loopSet(polyhedronOf(collapsedFaces(fit.base, fit.vertices()))),
                  loopSet(cell.faces))
            << mask;
        if (table.cutFaces.empty()) continue;
        std::set<Label> cut;
        for (const ShapeVertex v : table.faces[table.cutFaces[0]])
            cut.insert(fit.points[v]);
        const std::set<Label> known(cell.cutFace.begin(), cell.cutFace.end());
        EXPECT_EQ(cut, known) << mask;
    }
}

TEST(FitToParent, takesTheCutFaceThatIsKnown) {
    // One corner cut off: geometry says sammTrim1, but a pentagon is said to be the cut.
    const CutCube cell = cubesCutByPlanes().at(1);
    const auto found = recognise(rowsOf(cell.faces));
    ASSERT_TRUE(found);
    EXPECT_EQ(fitToParent(*found, cell.points).base, BaseShape::sammTrim1);
    const auto pentagon =
        std::ranges::find_if(cell.faces, [](const Polygon& face) { return face.size() == 5; });
    const Recognition fit = fitToParent(*found, cell.points, *pentagon);
    EXPECT_EQ(fit.base, BaseShape::sammTrim3);
    EXPECT_EQ(loopSet(polyhedronOf(collapsedFaces(fit.base, fit.vertices()))), loopSet(cell.faces));
}

} // namespace

} // namespace polymesh::test
