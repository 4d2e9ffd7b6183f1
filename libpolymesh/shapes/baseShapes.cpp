// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapes/baseShapes.h"

#include <vector>

namespace polymesh {

namespace {

using Face = std::vector<ShapeVertex>;

/// A table that owns what BaseShapeTable points into.
struct OwnedTable {
    OwnedTable(std::string_view name,
               std::size_t pointCount,
               std::vector<Face> faces,
               std::vector<std::array<std::uint8_t, 2>> oppositeFaces,
               std::vector<std::uint8_t> cutFaces)
        : faces_(std::move(faces)),
          spans_(faces_.begin(), faces_.end()),
          oppositeFaces_(std::move(oppositeFaces)),
          cutFaces_(std::move(cutFaces)),
          table{name, pointCount, spans_, oppositeFaces_, cutFaces_} {}

    OwnedTable(const OwnedTable&) = delete;

private:
    std::vector<Face> faces_;
    std::vector<ShapeFace> spans_;
    std::vector<std::array<std::uint8_t, 2>> oppositeFaces_;
    std::vector<std::uint8_t> cutFaces_;

public:
    BaseShapeTable table;
};

const std::array<OwnedTable, baseShapeCount>& tables() {
    using Pairs = std::vector<std::array<std::uint8_t, 2>>;
    static const std::array<OwnedTable, baseShapeCount> all{{
        {"tetrahedron",
         4,
         {Face{1, 2, 3}, Face{0, 3, 2}, Face{0, 1, 3}, Face{0, 2, 1}},
         Pairs{},
         {}},
        {"pyramid",
         5,
         {Face{0, 3, 2, 1}, Face{0, 4, 3}, Face{3, 4, 2}, Face{1, 2, 4}, Face{0, 1, 4}},
         Pairs{},
         {}},
        {"prism",
         6,
         {Face{0, 2, 1}, Face{3, 4, 5}, Face{0, 3, 5, 2}, Face{1, 2, 5, 4}, Face{0, 1, 4, 3}},
         Pairs{},
         {}},
        {"hexahedron",
         8,
         {Face{0, 4, 7, 3},
          Face{1, 2, 6, 5},
          Face{0, 1, 5, 4},
          Face{3, 7, 6, 2},
          Face{0, 3, 2, 1},
          Face{4, 5, 6, 7}},
         Pairs{{0, 1}, {2, 3}, {4, 5}},
         {}},
        {"sammTrim5",
         8,
         {Face{2, 3, 7, 6},
          Face{1, 5, 0},
          Face{2, 1, 0, 4, 3},
          Face{2, 6, 5, 1},
          Face{3, 4, 7},
          Face{0, 5, 6, 7, 4}},
         Pairs{{0, 1}, {3, 4}},
         {5}},
        {"sammTrim1",
         10,
         {Face{2, 3, 8, 7},
          Face{0, 1, 6, 5, 4},
          Face{2, 1, 0, 3},
          Face{7, 8, 9, 5, 6},
          Face{2, 7, 6, 1},
          Face{3, 0, 4, 9, 8},
          Face{4, 5, 9}},
         Pairs{{0, 1}, {2, 3}, {4, 5}},
         {6}},
        {"sammTrim2",
         10,
         {Face{2, 3, 8, 7},
          Face{1, 6, 5, 0},
          Face{2, 1, 0, 4, 3},
          Face{7, 8, 9, 5, 6},
          Face{2, 7, 6, 1},
          Face{3, 4, 9, 8},
          Face{0, 5, 9, 4}},
         Pairs{{0, 1}, {2, 3}, {4, 5}},
         {6}},
        {"sammTrim3",
         10,
         {Face{2, 3, 9, 8, 7},
          Face{1, 5, 4, 0},
          Face{2, 1, 0, 3},
          Face{7, 8, 6},
          Face{2, 7, 6, 5, 1},
          Face{3, 0, 4, 9},
          Face{4, 5, 6, 8, 9}},
         Pairs{{0, 1}, {2, 3}, {4, 5}},
         {6}},
        {"sammTrim4",
         10,
         {Face{0, 2, 6, 5, 1},
          Face{3, 9, 8},
          Face{0, 3, 8, 7, 2},
          Face{1, 5, 4},
          Face{0, 1, 4, 9, 3},
          Face{2, 7, 6},
          Face{4, 5, 6, 7, 8, 9}},
         Pairs{{0, 1}, {2, 3}, {4, 5}},
         {6}},
        {"hexagonalPrism",
         12,
         {Face{0, 5, 4, 3, 2, 1},
          Face{6, 7, 8, 9, 10, 11},
          Face{0, 1, 7, 6},
          Face{1, 2, 8, 7},
          Face{2, 3, 9, 8},
          Face{3, 4, 10, 9},
          Face{4, 5, 11, 10},
          Face{5, 0, 6, 11}},
         Pairs{{0, 1}, {2, 5}, {3, 6}},
         {4, 7}},
    }};
    return all;
}

} // namespace

const BaseShapeTable& tableOf(BaseShape shape) {
    return tables()[static_cast<std::size_t>(shape)].table;
}

std::array<BaseShape, baseShapeCount> allBaseShapes() {
    std::array<BaseShape, baseShapeCount> shapes{};
    for (std::size_t i = 0; i < baseShapeCount; ++i)
        shapes[i] = static_cast<BaseShape>(i);
    return shapes;
}

std::optional<BaseShape> baseShapeNamed(std::string_view name) {
    for (const BaseShape shape : allBaseShapes())
        if (tableOf(shape).name == name) return shape;
    return std::nullopt;
}

Rows<Label> collapsedFaces(BaseShape shape, std::span<const Label> points) {
    Rows<Label> faces;
    std::vector<Label> loop;
    for (const ShapeFace face : tableOf(shape).faces) {
        loop.clear();
        for (const ShapeVertex v : face)
            if (loop.empty() || loop.back() != points[v]) loop.push_back(points[v]);
        while (loop.size() > 1 && loop.front() == loop.back())
            loop.pop_back();
        if (loop.size() >= 3) faces.add(loop);
    }
    return faces;
}

} // namespace polymesh
