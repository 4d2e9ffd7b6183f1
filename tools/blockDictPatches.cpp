// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Edges, projected sides and patches of a blockMeshDict.

#include "libpolymesh/base/error.h"
#include "libpolymesh/initial/blockGrid.h"
#include "tools/blockDictReader.h"

#include <algorithm>

namespace polymesh::tools {
namespace {

using Kind = foam::Value::Kind;

std::vector<Vec3> knots(Items& items) {
    std::vector<Vec3> points;
    for (const foam::Value& point : items.next("a list of points").list(items.key()))
        points.push_back(pointOf(point, items.key()));
    return points;
}

/// The tangents that may follow the knots of a spline are ignored, as by blockMesh.
void skipTangents(Items& items) {
    while (items.nextIs(Kind::list))
        items.next("a tangent").vector(items.key());
}

/// (x y z) on the arc, or: origin (x y z).
Curve readArc(Items& items, const std::string& where) {
    if (!items.nextIs(Kind::word))
        return arcThrough(pointOf(items.next("a point"), items.key()), where);
    const foam::Value& word = items.next("origin");
    if (word.text != "origin") word.fail(items.key(), "a point of the arc, or origin");
    if (items.nextIs(Kind::number)) {
        if (items.look()->number != 1)
            items.look()->fail(items.key(), "1: another factor of the radius is not supported");
        items.next("a factor");
    }
    return arcAbout(pointOf(items.next("the centre"), items.key()), where);
}

} // namespace

BlockEdge BlockDictReader::readEdge(Items& items) {
    const std::string& key = items.key();
    const foam::Value& type = items.next("the type of an edge");
    const std::string name = type.word(key);
    BlockEdge edge;
    for (Label& v : edge.vertices)
        v = vertex(items.next("a vertex"), key);
    if (name == "arc") {
        edge.curve = readArc(items, type.place.text());
    } else if (name == "line") {
        edge.curve = lineCurve();
    } else if (name == "polyLine") {
        edge.curve = polyLineCurve(knots(items));
    } else if (name == "spline" || name == "simpleSpline") {
        edge.curve = splineCurve(knots(items));
        skipTangents(items);
    } else if (name == "BSpline") {
        edge.curve = bSplineCurve(knots(items));
        skipTangents(items);
    } else if (name == "project") {
        edge.curve = projectedCurve(shape(items.next("(surface)")));
    } else {
        type.fail(key,
                  "arc, line, polyLine, spline, BSpline or project; another type of edge is not "
                  "supported");
    }
    return edge;
}

void BlockDictReader::readEdges() {
    if (!dictionary.has("edges")) return;
    Items items(listOf(dictionary, "edges"), "edges");
    while (!items.atEnd())
        mesh.edges.push_back(readEdge(items));
}

BlockSide BlockDictReader::side(const foam::Value& value, const std::string& key) const {
    const std::vector<foam::Value>& items = value.list(key);
    BlockSide side{{}, value.place.text()};
    if (items.size() == 2) {
        const auto named = blockNames.find(items[0].text);
        const Label block = named != blockNames.end() ? named->second : items[0].label(key);
        const Label number = items[1].label(key);
        if (block < 0 || block >= toLabel(mesh.blocks.size()) || number < 0 || number > 5)
            value.fail(key, "the number of a block and that of its side, from 0 to 5");
        for (std::size_t c = 0; c < 4; ++c)
            side.vertices[c] = mesh.blocks[index(block)].vertices[hexSides[index(number)][c]];
        return side;
    }
    if (items.size() != 3 && items.size() != 4) value.fail(key, "four vertices");
    for (std::size_t c = 0; c < 4; ++c)
        side.vertices[c] = vertex(items[std::min(c, items.size() - 1)], key);
    return side;
}

void BlockDictReader::readProjectedSides() {
    if (!dictionary.has("faces")) return;
    Items items(listOf(dictionary, "faces"), "faces");
    while (!items.atEnd()) {
        const foam::Value& type = items.next("project");
        if (type.kind != Kind::word || type.text != "project") type.fail("faces", "project");
        const BlockSide projected = side(items.next("four vertices"), "faces");
        mesh.projectedSides.push_back({projected, shape(items.next("a surface"))});
    }
}

void BlockDictReader::readBoundary() {
    foam::Entry boundary = dictionary.entry("boundary");
    boundary.values = {listOf(dictionary, "boundary")};
    for (const auto& [name, patch] : foam::namedDictionaries(boundary)) {
        BlockPatch result{{name, patch->word("type"), 0, 0, {}}, {}};
        refuseMisspeltType(patch->entry("type").value());
        for (const foam::Value& value : patch->list("faces"))
            result.sides.push_back(side(value, "faces"));
        for (const foam::Entry& entry : patch->entries())
            if (entry.key != "type" && entry.key != "faces" && !entry.dictionary)
                result.patch.entries.emplace_back(entry.key, written(entry.values));
        mesh.patches.push_back(std::move(result));
    }
}

/// type name (sides) type name (sides) ...
void BlockDictReader::readOldPatches() {
    Items items(listOf(dictionary, "patches"), "patches");
    while (!items.atEnd()) {
        const foam::Value& type = items.next("the type of a patch");
        const std::string name = items.next("the name of a patch").string("patches");
        if (type.word("patches") == "cyclic")
            type.fail("patches", "another type; cyclic without neighbourPatch is not supported");
        refuseMisspeltType(type);
        BlockPatch result{{name, type.text, 0, 0, {}}, {}};
        for (const foam::Value& value : items.next("the sides of a patch").list("patches"))
            result.sides.push_back(side(value, "patches"));
        mesh.patches.push_back(std::move(result));
    }
}

void BlockDictReader::readPatches() {
    if (dictionary.has("patches"))
        readOldPatches();
    else if (dictionary.has("boundary"))
        readBoundary();
    for (std::size_t p = 0; p < mesh.patches.size(); ++p)
        for (std::size_t q = 0; q < p; ++q)
            require(mesh.patches[p].patch.name != mesh.patches[q].patch.name,
                    "{}: there are two patches {}; give each a name of its own",
                    dictionary.place().text(),
                    mesh.patches[p].patch.name);
}

} // namespace polymesh::tools
