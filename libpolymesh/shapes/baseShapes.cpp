// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapes/baseShapes.h"

#include <algorithm>
#include <deque>
#include <vector>

namespace polymesh {

namespace {

/// A base shape as text: faces between spaces, a digit of base 12 for each vertex or face.
struct ShapeText {
    std::string_view name;
    std::string_view faces;
    std::string_view oppositeFaces;
    std::string_view cutFaces;
};

constexpr std::array<ShapeText, baseShapeCount> texts{{
    {"tetrahedron", "123 032 013 021", "", ""},
    {"pyramid", "0321 043 342 124 014", "", ""},
    {"prism", "021 345 0352 1254 0143", "", ""},
    {"hexahedron", "0473 1265 0154 3762 0321 4567", "01 23 45", ""},
    {"sammTrim5", "2376 150 21043 2651 347 05674", "01 34", "5"},
    {"sammTrim1", "2387 01654 2103 78956 2761 30498 459", "01 23 45", "6"},
    {"sammTrim2", "2387 1650 21043 78956 2761 3498 0594", "01 23 45", "6"},
    {"sammTrim3", "23987 1540 2103 786 27651 3049 45689", "01 23 45", "6"},
    {"sammTrim4", "02651 398 03872 154 01493 276 456789", "01 23 45", "6"},
    {"hexagonalPrism", "054321 6789ab 0176 1287 2398 34a9 45ba 506b", "01 25 36", "47"},
}};

using Digits = std::vector<std::uint8_t>;

std::vector<Digits> wordsOf(std::string_view text) {
    std::vector<Digits> words;
    bool isInWord = false;
    for (const char c : text) {
        if (c != ' ') {
            if (!isInWord) words.emplace_back();
            words.back().push_back(static_cast<std::uint8_t>(c <= '9' ? c - '0' : c - 'a' + 10));
        }
        isInWord = c != ' ';
    }
    return words;
}

/// A table that owns what BaseShapeTable points into.
class OwnedTable {
public:
    explicit OwnedTable(const ShapeText& text)
        : faces_(wordsOf(text.faces)), spans_(faces_.begin(), faces_.end()) {
        for (const Digits& pair : wordsOf(text.oppositeFaces))
            oppositeFaces_.push_back({pair[0], pair[1]});
        for (const Digits& cuts : wordsOf(text.cutFaces))
            cutFaces_ = cuts;
        std::size_t points = 0;
        for (const Digits& face : faces_)
            points = std::max(points, std::size_t{*std::ranges::max_element(face)} + 1);
        table_ = {text.name, points, spans_, oppositeFaces_, cutFaces_};
    }

    OwnedTable(const OwnedTable&) = delete;
    OwnedTable& operator=(const OwnedTable&) = delete;

    const BaseShapeTable& table() const { return table_; }

private:
    std::vector<Digits> faces_;
    std::vector<ShapeFace> spans_;
    std::vector<std::array<std::uint8_t, 2>> oppositeFaces_;
    Digits cutFaces_;
    BaseShapeTable table_;
};

const std::array<BaseShapeTable, baseShapeCount>& tables() {
    static const std::deque<OwnedTable> owned(texts.begin(), texts.end());
    static const std::array<BaseShapeTable, baseShapeCount> all = [] {
        std::array<BaseShapeTable, baseShapeCount> found;
        std::ranges::transform(owned, found.begin(), &OwnedTable::table);
        return found;
    }();
    return all;
}

} // namespace

const BaseShapeTable& tableOf(BaseShape shape) {
    return tables()[static_cast<std::size_t>(shape)];
}

std::array<BaseShape, baseShapeCount> allBaseShapes() {
    std::array<BaseShape, baseShapeCount> shapes{};
    for (std::size_t i = 0; i < baseShapeCount; ++i)
        shapes[i] = static_cast<BaseShape>(i);
    return shapes;
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
