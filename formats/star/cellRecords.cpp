// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/cellRecords.h"

#include "libpolymesh/base/error.h"

#include <algorithm>
#include <array>
#include <limits>

namespace polymesh::star {

namespace {

bool hasRepeats(std::span<const Label> labels) {
    constexpr std::size_t few = 16;
    if (labels.size() > few) {
        std::vector<Label> sorted(labels.begin(), labels.end());
        std::ranges::sort(sorted);
        return std::ranges::adjacent_find(sorted) != sorted.end();
    }
    for (std::size_t i = 1; i < labels.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (labels[i] == labels[j]) return true;
    return false;
}

} // namespace

void CellBuilder::fail(std::string_view message) const {
    file_.fail(head_.place, fmt::format("cell {}: {}", head_.number, message));
}

void CellBuilder::addFace(std::span<const Label> corners, Label faceNumber) {
    std::vector<Label>& values = records_.faces.values;
    const std::size_t first = values.size();
    for (const Label p : corners)
        if (values.size() == first || values.back() != p) values.push_back(p);
    while (values.size() > first + 1 && values.back() == values[first])
        values.pop_back();
    const std::size_t size = values.size() - first;
    if (size < 3) {
        values.resize(first);
        return;
    }
    if (hasRepeats({values.data() + first, size}))
        fail(fmt::format("face {} has a vertex twice", faceNumber));
    if (values.size() > index(std::numeric_limits<Label>::max()))
        fail("too many faces for 32-bit labels; configure with POLYMESH_LABEL64");
    records_.faces.offsets.push_back(toLabel(values.size()));
    records_.faceNumbers.push_back(faceNumber);
}

void CellBuilder::addShape(BaseShape shape,
                           std::span<const Label> vertices,
                           std::span<const std::uint8_t> faceNumbers) {
    std::array<Label, maxShapeFacePoints> corners{};
    const auto faces = tableOf(shape).faces;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        for (std::size_t i = 0; i < faces[f].size(); ++i)
            corners[i] = vertices[faces[f][i]];
        addFace(std::span(corners).first(faces[f].size()), faceNumbers[f]);
    }
}

void CellBuilder::end() {
    const Label faceCount = records_.faces.size() - records_.firstFaces.back();
    if (faceCount < 4)
        fail(fmt::format("only {} of its faces have three vertices; a cell has 4 or more",
                         faceCount));
    records_.firstFaces.push_back(records_.faces.size());
    records_.numbers.push_back(head_.number);
    records_.tables.push_back(head_.table);
    records_.places.push_back(head_.place);
}

void CellBuilder::endPolyhedron() {
    edges_.clear();
    const Rows<Label>& faces = records_.faces;
    for (Label f = records_.firstFaces.back(); f < faces.size(); ++f)
        for (std::size_t i = 0; i < faces[f].size(); ++i)
            edges_.emplace_back(faces[f][i], faces[f][i + 1 == faces[f].size() ? 0 : i + 1]);
    std::ranges::sort(edges_);
    const bool isOnce = std::ranges::adjacent_find(edges_) == edges_.end();
    const bool isClosed = std::ranges::all_of(edges_, [&](const auto& edge) {
        return std::ranges::binary_search(edges_, std::pair(edge.second, edge.first));
    });
    if (!isOnce || !isClosed)
        fail("it is not closed: an edge must be in two of its faces, once in each direction");
    end();
}

std::span<const std::uint8_t> regularFaceNumbers(BaseShape shape) {
    static constexpr std::array<std::uint8_t, 4> tetrahedron{6, 5, 3, 1};
    static constexpr std::array<std::uint8_t, 5> pyramid{1, 5, 4, 6, 3};
    static constexpr std::array<std::uint8_t, 5> prism{1, 2, 5, 6, 3};
    static constexpr std::array<std::uint8_t, 6> hexahedron{5, 6, 3, 4, 1, 2};
    switch (shape) {
    case BaseShape::tetrahedron:
        return tetrahedron;
    case BaseShape::pyramid:
        return pyramid;
    case BaseShape::prism:
        return prism;
    default:
        return hexahedron;
    }
}

} // namespace polymesh::star
