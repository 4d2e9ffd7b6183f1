// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/cells3.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace polymesh::star {

namespace {

template<std::size_t Vertices, std::size_t Faces>
struct FormTable {
    std::array<std::uint8_t, Vertices> slots;
    std::array<std::uint8_t, Faces> faceNumbers;
};

constexpr FormTable<10, 7> trim1{{3, 2, 6, 7, 11, 9, 1, 5, 4, 12}, {2, 1, 4, 3, 6, 5, 7}};
constexpr FormTable<10, 7> trim2{{13, 5, 6, 2, 10, 12, 4, 7, 3, 11}, {4, 3, 6, 5, 2, 1, 7}};
constexpr FormTable<10, 7> trim3{{2, 3, 0, 1, 10, 11, 12, 4, 8, 9}, {3, 4, 1, 2, 5, 6, 7}};
constexpr FormTable<10, 7> trim4{{0, 1, 3, 4, 13, 8, 9, 10, 11, 12}, {1, 2, 5, 6, 3, 4, 7}};
constexpr FormTable<8, 6> trim5{{12, 7, 6, 5, 8, 11, 10, 9}, {6, 5, 2, 4, 3, 7}};
constexpr FormTable<12, 8> trim85{{11, 3, 15, 12, 4, 8, 10, 2, 14, 13, 5, 9},
                                  {5, 6, 1, 4, 7, 2, 3, 8}};

const std::array<TrimmedForm, 6> forms{{
    {BaseShape::sammTrim1, 1, trim1.slots, trim1.faceNumbers},
    {BaseShape::sammTrim2, 2, trim2.slots, trim2.faceNumbers},
    {BaseShape::sammTrim3, 7, trim3.slots, trim3.faceNumbers},
    {BaseShape::sammTrim4, 8, trim4.slots, trim4.faceNumbers},
    {BaseShape::sammTrim5, 7, trim5.slots, trim5.faceNumbers},
    {BaseShape::hexagonalPrism, 85, trim85.slots, trim85.faceNumbers},
}};

/// The faces in the order of their numbers for each rotation: the 24 of a cube.
constexpr std::array<std::string_view, rotationCount> rotatedFaces{
    "123456", "345612", "561234", "125643", "341265", "563421", "124365", "346521",
    "562143", "126534", "342156", "564312", "215634", "431256", "653412", "213465",
    "435621", "651243", "216543", "432165", "654321", "214356", "436512", "652134"};

using Order = std::vector<std::size_t>; // of vertices

Order followedBy(const Order& first, const Order& second) {
    Order order(first.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = first[second[i]];
    return order;
}

/// All products of the rotations `generators`.
std::vector<Order> generatedBy(const std::vector<Order>& generators) {
    std::vector<Order> group{Order(generators.front().size())};
    for (std::size_t i = 0; i < group.front().size(); ++i)
        group.front()[i] = i;
    for (std::size_t i = 0; i < group.size(); ++i)
        for (const Order& generator : generators) {
            Order next = followedBy(group[i], generator);
            if (std::ranges::find(group, next) == group.end()) group.push_back(std::move(next));
        }
    return group;
}

/// The vertices in another order, as a rotation of the shape gives it, such that the vertices at
/// the places `a` and `b` are equal; as they are when no rotation does that.
std::vector<Label> rotatedTo(std::span<const Label> vertices,
                             const std::vector<Order>& rotations,
                             std::size_t a,
                             std::size_t b) {
    const auto isWanted = [&](const Order& r) { return vertices[r[a]] == vertices[r[b]]; };
    const auto found = std::ranges::find_if(rotations, isWanted);
    const Order& rotation = found == rotations.end() ? rotations.front() : *found;
    std::vector<Label> rotated;
    for (const std::size_t v : rotation)
        rotated.push_back(vertices[v]);
    return rotated;
}

const std::vector<Order>& prismRotations() {
    static const std::vector<Order> rotations =
        generatedBy({{1, 2, 0, 4, 5, 3}, {3, 5, 4, 0, 2, 1}});
    return rotations;
}

const std::vector<Order>& hexahedronRotations() {
    static const std::vector<Order> rotations =
        generatedBy({{1, 2, 3, 0, 5, 6, 7, 4}, {3, 2, 6, 7, 0, 1, 5, 4}});
    return rotations;
}

} // namespace

const TrimmedForm* formOf(BaseShape base) {
    const auto found = std::ranges::find(forms, base, &TrimmedForm::base);
    return found == forms.end() ? nullptr : &*found;
}

const TrimmedForm* formOfType(Label type, bool hasFirstCorner) {
    const auto found = std::ranges::find(forms, type, &TrimmedForm::type);
    if (found == forms.end()) return nullptr;
    const bool isFifth = found->base == BaseShape::sammTrim3 && !hasFirstCorner;
    return isFifth ? formOf(BaseShape::sammTrim5) : &*found;
}

Label unrotatedFace(Label rotation, Label face) {
    return rotatedFaces[index(rotation)][index(face) - 1] - '0';
}

std::array<Label, 8> regularSlots(BaseShape base, std::span<const Label> v) {
    switch (base) {
    case BaseShape::tetrahedron:
        return {v[0], v[1], v[2], v[2], v[3], v[3], v[3], v[3]};
    case BaseShape::pyramid:
        return {v[0], v[1], v[2], v[3], v[4], v[4], v[4], v[4]};
    case BaseShape::prism: {
        const std::vector<Label> p = rotatedTo(v, prismRotations(), 3, 4); // a tetWedge's edge
        return {p[0], p[1], p[2], p[2], p[3], p[4], p[5], p[5]};
    }
    default: {
        const std::vector<Label> h = rotatedTo(v, hexahedronRotations(), 4, 7); // a wedge's edge
        return {h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7]};
    }
    }
}

} // namespace polymesh::star
