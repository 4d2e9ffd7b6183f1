// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapes/catalogue.h"

#include "tests/libpolymesh/shapes/polyhedra.h"

#include <gtest/gtest.h>

#include <map>

namespace polymesh::test {

namespace {

TEST(Catalogue, hasTheKnownNumbersOfVariants) {
    const Catalogue& catalogue = Catalogue::instance();
    const std::map<std::string_view, std::size_t> known{{"tetrahedron", 1},
                                                        {"pyramid", 1},
                                                        {"prism", 2},
                                                        {"hexahedron", 5},
                                                        {"sammTrim1", 27},
                                                        {"sammTrim2", 21},
                                                        {"sammTrim3", 27},
                                                        {"sammTrim4", 14},
                                                        {"sammTrim5", 8},
                                                        {"hexagonalPrism", 72}};
    for (const BaseShape base : allBaseShapes())
        EXPECT_EQ(catalogue.variantCount(base), known.at(tableOf(base).name)) << tableOf(base).name;
    EXPECT_EQ(catalogue.shapes().size(), 118U);
}

TEST(Catalogue, hasTheSameVariantsOfSammTrim1AndSammTrim3) {
    for (const CatalogueShape& shape : Catalogue::instance().shapes())
        EXPECT_EQ(std::ranges::count(shape.bases, BaseShape::sammTrim1),
                  std::ranges::count(shape.bases, BaseShape::sammTrim3))
            << shape.name;
}

TEST(Catalogue, hasA114VariantsOfTheTrimmedBases) {
    const auto isTrimmed = [](BaseShape base) { return base > BaseShape::hexahedron; };
    const auto count =
        std::ranges::count_if(Catalogue::instance().shapes(), [&](const CatalogueShape& shape) {
            return std::ranges::any_of(shape.bases, isTrimmed);
        });
    EXPECT_EQ(count, 114);
}

TEST(Catalogue, namesShapesByBaseAndCollapsedEdges) {
    std::set<std::string> names;
    for (const CatalogueShape& shape : Catalogue::instance().shapes())
        names.insert(shape.name);
    EXPECT_EQ(names.size(), 118U);
    for (const char* name : {"hexahedron", "sammTrim1", "sammTrim5:1-2,2-3", "hexahedron:0-1"})
        EXPECT_TRUE(names.contains(name)) << name;
}

TEST(Catalogue, holdsClosedPolyhedraOnly) {
    for (const CatalogueShape& shape : Catalogue::instance().shapes()) {
        const Polyhedron cell = shapeCell(shape);
        std::map<std::pair<Label, Label>, int> uses;
        for (const Polygon& loop : cell) {
            EXPECT_GE(loop.size(), 3U) << shape.name;
            for (std::size_t i = 0; i < loop.size(); ++i)
                ++uses[{loop[i], loop[(i + 1) % loop.size()]}];
        }
        for (const auto& [dart, count] : uses) {
            EXPECT_EQ(count, 1) << shape.name;
            EXPECT_TRUE(uses.contains({dart.second, dart.first})) << shape.name;
        }
        EXPECT_EQ(pointsOf(cell).size() + cell.size(), uses.size() / 2 + 2) << shape.name;
        EXPECT_EQ(pointsOf(cell).size(), shape.pointCount) << shape.name;
    }
}

} // namespace

} // namespace polymesh::test
