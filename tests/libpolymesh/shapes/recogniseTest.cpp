// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapes/recognise.h"

#include "libpolymesh/mesh/topology.h"
#include "tests/libpolymesh/shapes/polyhedra.h"

#include <gtest/gtest.h>

#include <iterator>

namespace polymesh::test {

namespace {

/// Law (1) of Recognition.
void expectFits(const Polyhedron& cell, const Recognition& found, const std::string& name) {
    EXPECT_EQ(loopSet(polyhedronOf(collapsedFaces(found.base, found.vertices()))), loopSet(cell))
        << name;
}

TEST(Recognise, findsEachShapeHoweverItIsNumberedAndMirrored) {
    std::mt19937 random(1);
    const Catalogue& catalogue = Catalogue::instance();
    for (std::size_t id = 0; id < catalogue.shapes().size(); ++id)
        for (int trial = 0; trial < 50; ++trial) {
            const CatalogueShape& shape = catalogue.shapes()[id];
            Polyhedron cell = renumbered(shapeCell(shape), random);
            if (trial % 2 == 1) cell = mirrorImage(std::move(cell));
            const auto found = recognise(rowsOf(cell));
            ASSERT_TRUE(found) << shape.name;
            EXPECT_EQ(found->shape, id) << shape.name;
            EXPECT_EQ(found->base, shape.base) << shape.name;
            expectFits(cell, *found, shape.name);
        }
}

/// The obvious slow way: maps points one by one, such that edges go to edges.
class Isomorphism {
public:
    Isomorphism(const Polyhedron& a, const Polyhedron& b) : a_(a), b_(b) {
        for (const Label p : pointsOf(a))
            from_.push_back(p);
        for (const Label p : pointsOf(b))
            to_.push_back(p);
    }

    bool exists() { return from_.size() == to_.size() && extend(); }

private:
    static std::set<std::pair<Label, Label>> edgesOf(const Polyhedron& cell) {
        std::set<std::pair<Label, Label>> edges;
        for (const Polygon& loop : cell)
            for (std::size_t i = 0; i < loop.size(); ++i)
                edges.insert({loop[i], loop[(i + 1) % loop.size()]});
        return edges;
    }

    bool fits(Label p, Label q) const {
        return std::ranges::all_of(image_, [&](const auto& pair) {
            return pair.second != q &&
                   edgesA_.contains({p, pair.first}) == edgesB_.contains({q, pair.second});
        });
    }

    bool extend() {
        if (image_.size() == from_.size()) return mapsFaces();
        const Label p = from_[image_.size()];
        for (const Label q : to_) {
            if (!fits(p, q)) continue;
            image_[p] = q;
            if (extend()) return true;
            image_.erase(p);
        }
        return false;
    }

    bool mapsFaces() const {
        Polyhedron mapped = a_;
        for (Polygon& loop : mapped)
            for (Label& p : loop)
                p = image_.at(p);
        return loopSet(mapped) == loopSet(b_) || loopSet(mirrorImage(mapped)) == loopSet(b_);
    }

    Polyhedron a_;
    Polyhedron b_;
    std::vector<Label> from_;
    std::vector<Label> to_;
    std::set<std::pair<Label, Label>> edgesA_ = edgesOf(a_);
    std::set<std::pair<Label, Label>> edgesB_ = edgesOf(b_);
    std::map<Label, Label> image_;
};

/// A tetrahedron or hexahedron after some random cuts.
Polyhedron randomPolyhedron(std::mt19937& random) {
    Polyhedron cell = random() % 3 == 0 ? Polyhedron{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}
                                        : hexahedron({0, 1, 2, 3, 4, 5, 6, 7});
    const auto cuts = 1 + random() % 4;
    for (unsigned cut = 0; cut < cuts; ++cut) {
        const std::set<Label> points = pointsOf(cell);
        const std::size_t face = random() % cell.size();
        if (random() % 2 == 0 && points.size() < 11) {
            const auto corner =
                std::next(points.begin(), static_cast<long>(random() % points.size()));
            cell = truncated(cell, *corner, *points.rbegin() + 1);
        } else if (cell[face].size() > 3) {
            const std::size_t size = cell[face].size();
            const std::size_t i = random() % size;
            cell = withFaceCut(cell, face, i, (i + 2 + random() % (size - 3)) % size);
        }
    }
    return cell;
}

std::vector<std::size_t> faceSizes(const Polyhedron& cell) {
    std::vector<std::size_t> sizes;
    for (const Polygon& loop : cell)
        sizes.push_back(loop.size());
    std::ranges::sort(sizes);
    return sizes;
}

TEST(Recognise, agreesWithComparingPointByPoint) {
    std::mt19937 random(2);
    int rejected = 0;
    int accepted = 0;
    std::set<ShapeId> seen;
    while (rejected < 10000) {
        const Polyhedron cell = renumbered(randomPolyhedron(random), random);
        const auto found = recognise(rowsOf(cell));
        if (found) {
            ++accepted;
            seen.insert(found->shape);
            expectFits(cell, *found, "random");
            continue;
        }
        ++rejected;
        for (const CatalogueShape& shape : Catalogue::instance().shapes())
            ASSERT_FALSE(shape.faceSizes == faceSizes(cell) &&
                         Isomorphism(cell, shapeCell(shape)).exists())
                << shape.name;
    }
    EXPECT_GT(accepted, 1000);
    EXPECT_GT(seen.size(), 20U);
}

TEST(Recognise, knowsNoOpenNorPinchedNorLargeCells) {
    Polyhedron cube = hexahedron({0, 1, 2, 3, 4, 5, 6, 7});
    EXPECT_TRUE(recognise(rowsOf(cube)));
    Polyhedron open = cube;
    open.pop_back();
    EXPECT_FALSE(recognise(rowsOf(open)));
    Polyhedron twisted = cube;
    std::ranges::reverse(twisted[0]);
    EXPECT_FALSE(recognise(rowsOf(twisted)));
    Polyhedron two{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    for (const Polygon& loop : Polyhedron{{5, 6, 3}, {4, 3, 6}, {4, 5, 3}, {4, 6, 5}})
        two.push_back(loop); // meets the first at point 3
    EXPECT_FALSE(recognise(rowsOf(two)));
    EXPECT_FALSE(recognise(Rows<Label>{}));
}

TEST(Recognise, seesPyramidsOnPentagonsAndHexagonsAsTrimmedCells) {
    for (const auto& [sides, name] :
         {std::pair{5, "sammTrim5:1-2,2-3"}, std::pair{6, "sammTrim4:0-1,0-2,0-3"}}) {
        Polyhedron pyramid{{}};
        for (Label i = 0; i < sides; ++i) {
            pyramid[0].insert(pyramid[0].begin(), i);
            pyramid.push_back({i, (i + 1) % sides, sides});
        }
        const auto found = recognise(rowsOf(pyramid));
        ASSERT_TRUE(found);
        EXPECT_EQ(Catalogue::instance()[found->shape].name, name);
    }
}

TEST(Recognise, findsTheFacesOfCellsInAMesh) {
    const PolyMesh mesh = box(2, 2, 2);
    const Rows<Label> faces = cellFaces(mesh);
    for (Label c = 0; c < mesh.cellCount; ++c) {
        const auto found = recognise(mesh, faces[c], c);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->base, BaseShape::hexahedron);
        const auto v = found->vertices();
        const auto at = [&](int i) { return mesh.points[index(v[static_cast<std::size_t>(i)])]; };
        EXPECT_GT(dot(cross(at(1) - at(0), at(3) - at(0)), at(4) - at(0)), 0);
    }
}

} // namespace

} // namespace polymesh::test
