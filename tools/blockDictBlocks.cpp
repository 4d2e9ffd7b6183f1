// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices and blocks of a blockMeshDict.

#include "libpolymesh/base/error.h"
#include "tools/blockDictReader.h"

#include <cmath>

namespace polymesh::tools {
namespace {

using Kind = foam::Value::Kind;

/// A ratio of sizes; a negative one is turned over.
double expansion(const foam::Value& value, const std::string& key) {
    const double ratio = value.scalar(key);
    if (ratio == 0) value.fail(key, "an expansion ratio other than 0");
    constexpr double most = 1e100; // its powers must not overflow
    if (std::abs(ratio) > most || std::abs(ratio) < 1 / most)
        value.fail(key, "an expansion ratio between 1e-100 and 1e100");
    return ratio > 0 ? ratio : -1 / ratio;
}

double share(const foam::Value& value, const std::string& key) {
    if (!(value.scalar(key) > 0)) value.fail(key, "a positive share");
    return value.number;
}

std::array<Grading, 12> gradings(const foam::Value& value, const std::string& key) {
    const std::vector<foam::Value>& items = value.list(key);
    const std::size_t count = items.size();
    if (count > 1 && count != 3 && count != 12)
        value.fail(key, "3 ratios (simpleGrading) or 12 (edgeGrading)");
    std::array<Grading, 12> result;
    for (std::size_t e = 0; e < 12 && count > 0; ++e)
        result[e] = gradingOf(items[count == 12 ? e : count == 3 ? e / 4 : 0], key);
    return result;
}

/// (nx ny nz), or in old files nx ny nz.
std::array<Label, 3> cellCounts(Items& items) {
    const std::string& key = items.key();
    std::array<Label, 3> cells{};
    if (!items.nextIs(Kind::list)) {
        for (Label& n : cells)
            n = cellCount(items.next("a number of cells"), key);
        return cells;
    }
    const foam::Value& list = items.next("(nx ny nz)");
    if (list.items.size() != 3) list.fail(key, "three numbers of cells (nx ny nz)");
    for (std::size_t d = 0; d < 3; ++d)
        cells[d] = cellCount(list.items[d], key);
    return cells;
}

} // namespace

Grading gradingOf(const foam::Value& value, const std::string& key) {
    if (value.kind == Kind::number) return {{1, 1, expansion(value, key)}};
    Grading grading;
    for (const foam::Value& section : value.list(key)) {
        if (section.kind == Kind::number) {
            grading.push_back({1, 1, expansion(section, key)});
            continue;
        }
        const std::vector<foam::Value>& parts = section.list(key);
        if (parts.size() != 3) section.fail(key, "(length cells expansion)");
        grading.push_back({share(parts[0], key), share(parts[1], key), expansion(parts[2], key)});
    }
    if (grading.empty()) value.fail(key, "a number or a list of sections");
    return grading;
}

Label cellCount(const foam::Value& value, const std::string& key) {
    const Label count = value.label(key);
    if (count < 1) value.fail(key, "a number of cells, at least 1");
    return count;
}

Label BlockDictReader::vertex(const foam::Value& value, const std::string& key) const {
    const auto count = toLabel(mesh.vertices.size());
    if (value.kind == Kind::word) {
        const auto found = vertexNames.find(value.text);
        if (found == vertexNames.end()) value.fail(key, "a vertex: its number or its name");
        return found->second;
    }
    const Label label = value.label(key);
    if (label < 0 || label >= count)
        value.fail(key, fmt::format("a vertex, from 0 to {}", count - 1));
    return label;
}

/// Coordinates whose fourth powers are numbers, too.
Vec3 pointOf(const foam::Value& value, const std::string& key) {
    constexpr double most = 1e50;
    const Vec3 point = value.vector(key);
    if (norm(point) > most) value.fail(key, "coordinates up to 1e50");
    return point;
}

Vec3 BlockDictReader::readVertex(Items& items) {
    const foam::Value& value = items.next("a vertex (x y z)");
    if (value.kind != Kind::word) return pointOf(value, items.key());
    if (value.text != "project") value.fail(items.key(), "a vertex (x y z), name or project");
    const Vec3 point = pointOf(items.next("a vertex (x y z)"), items.key());
    return projectedVertex(point, shape(items.next("(surface)")));
}

void BlockDictReader::readVertices() {
    Items items(listOf(dictionary, "vertices"), "vertices");
    while (!items.atEnd()) {
        std::string name;
        if (items.look()->kind == Kind::word && items.look()->text == "name") {
            items.next("name");
            name = items.next("the name of a vertex").word("vertices");
        }
        const Vec3 point = readVertex(items);
        if (!name.empty()) vertexNames[name] = toLabel(mesh.vertices.size());
        mesh.vertices.push_back(point);
    }
}

Block BlockDictReader::readBlock(Items& items) {
    const std::string& key = items.key();
    const foam::Value& shape = items.next("hex");
    if (shape.kind != Kind::word || shape.text != "hex") shape.fail(key, "hex");
    Block block;
    block.where = shape.place.text();
    const foam::Value& vertices = items.next("eight vertices");
    if (vertices.list(key).size() != 8)
        vertices.fail(key, "eight vertices (ignoring further ones is not supported)");
    for (std::size_t v = 0; v < 8; ++v)
        block.vertices[v] = vertex(vertices.items[v], key);
    if (items.nextIs(Kind::word)) block.zone = items.next("a zone").text;
    block.cells = cellCounts(items);
    if (items.nextIs(Kind::word)) {
        const foam::Value& word = items.next("simpleGrading");
        if (word.text != "simpleGrading" && word.text != "edgeGrading" && word.text != "grading")
            word.fail(key, "simpleGrading or edgeGrading");
    }
    block.grading = gradings(items.next("expansion ratios"), key);
    return block;
}

void BlockDictReader::readBlocks() {
    Items items(listOf(dictionary, "blocks"), "blocks");
    while (!items.atEnd()) {
        if (items.look()->kind == Kind::word && items.look()->text == "name") {
            items.next("name");
            blockNames[items.next("the name of a block").word("blocks")] =
                toLabel(mesh.blocks.size());
        }
        mesh.blocks.push_back(readBlock(items));
    }
    require(!mesh.blocks.empty(),
            "{}: blocks: the list is empty, expected at least one block",
            dictionary.entry("blocks").place.text());
}

} // namespace polymesh::tools
