// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/blockShorthands.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/initial/roundBlocks.h"
#include "tools/blockDictReader.h"

#include <algorithm>
#include <numbers>

namespace polymesh::tools {

namespace {

constexpr std::array<const char*, 3> shorthands{"cartesian", "cylinder", "sphere"};

double positive(const foam::Dictionary& dictionary, const std::string& key) {
    const double value = dictionary.scalar(key);
    if (!(value > 0)) dictionary.entry(key).value().fail(key, "a positive number");
    return value;
}

/// A number between two others, or `standard` when the entry is missing.
double between(double least,
               double most,
               const foam::Dictionary& dictionary,
               const std::string& key,
               double standard) {
    const double value = dictionary.scalar(key, standard);
    if (!(value > least && value < most) && dictionary.has(key))
        dictionary.entry(key).value().fail(
            key, fmt::format("a number between {:g} and {:g}", least, most));
    return value;
}

/// `cells (...)`, as many as the array has.
template<std::size_t n>
std::array<Label, n> cellsOf(const foam::Dictionary& dictionary, const std::string& meaning) {
    const foam::Value& list = dictionary.entry("cells").value();
    if (list.list("cells").size() != n) list.fail("cells", meaning);
    std::array<Label, n> cells{};
    for (std::size_t i = 0; i < n; ++i)
        cells[i] = cellCount(list.items[i], "cells");
    return cells;
}

/// `grading (...)`, even when the entry is missing.
template<std::size_t n>
std::array<Grading, n> gradingsOf(const foam::Dictionary& dictionary, const std::string& meaning) {
    std::array<Grading, n> gradings;
    if (!dictionary.has("grading")) return gradings;
    const foam::Value& list = dictionary.entry("grading").value();
    if (list.list("grading").size() != n) list.fail("grading", meaning);
    for (std::size_t i = 0; i < n; ++i)
        gradings[i] = gradingOf(list.items[i], "grading");
    return gradings;
}

BlockMeshDescription readCartesian(const foam::Dictionary& dictionary) {
    foam::requireKnownKeys(dictionary, {"min", "max", "cells", "grading"});
    const GradedBox box{{dictionary.vector("min"), dictionary.vector("max")},
                        cellsOf<3>(dictionary, "three numbers of cells (nx ny nz)"),
                        gradingsOf<3>(dictionary, "three gradings (x y z)")};
    for (int axis = 0; axis < 3; ++axis)
        if (!(box.box.min[axis] < box.box.max[axis]))
            dictionary.entry("max").value().fail("max", "a corner above min in x, y and z");
    return boxBlocks(box);
}

BlockMeshDescription readCylinder(const foam::Dictionary& dictionary) {
    foam::requireKnownKeys(
        dictionary,
        {"point1", "point2", "radius", "holeRadius", "core", "angle", "cells", "grading"});
    CylinderSpec cylinder;
    cylinder.end1 = dictionary.vector("point1");
    cylinder.end2 = dictionary.vector("point2");
    if (cylinder.end1 == cylinder.end2)
        dictionary.entry("point2").value().fail("point2", "a point other than point1");
    cylinder.radius = positive(dictionary, "radius");
    cylinder.holeRadius = between(0, cylinder.radius, dictionary, "holeRadius", 0);
    cylinder.core = between(0, 1, dictionary, "core", cylinder.core);
    cylinder.angle = between(0, 360, dictionary, "angle", 0) * std::numbers::pi / 180;
    cylinder.cells = cellsOf<3>(dictionary, "three numbers of cells (outwards around along)");
    cylinder.grading = gradingsOf<2>(dictionary, "two gradings (outwards along)");
    const Label arcs = arcCount(cylinder);
    require(cylinder.cells[1] % arcs == 0,
            "{}: cells: found {} around, expected a multiple of {}, the number of blocks",
            dictionary.entry("cells").place.text(),
            cylinder.cells[1],
            arcs);
    return cylinderBlocks(cylinder);
}

BlockMeshDescription readSphere(const foam::Dictionary& dictionary) {
    foam::requireKnownKeys(dictionary, {"centre", "radius", "core", "cells", "grading"});
    BallSpec ball;
    ball.centre = dictionary.vector("centre");
    ball.radius = positive(dictionary, "radius");
    ball.core = between(0, 1, dictionary, "core", ball.core);
    ball.cells = cellsOf<2>(dictionary, "two numbers of cells (outwards along-edges-of-the-core)");
    ball.grading = gradingsOf<1>(dictionary, "one grading (outwards)")[0];
    return ballBlocks(ball);
}

} // namespace

bool isShorthand(const foam::Dictionary& dictionary) {
    return std::ranges::any_of(shorthands, [&](const char* key) { return dictionary.has(key); });
}

BlockMeshDescription readShorthand(const foam::Dictionary& dictionary) {
    std::string found;
    for (const char* key : shorthands) {
        if (!dictionary.has(key)) continue;
        require(found.empty(),
                "{}: {} and {} together are not supported; write their blocks in "
                "system/blockMeshDict",
                dictionary.entry(key).place.text(),
                found,
                key);
        found = key;
    }
    const foam::Dictionary& shorthand = dictionary.dictionary(found);
    if (found == "cartesian") return readCartesian(shorthand);
    if (found == "cylinder") return readCylinder(shorthand);
    return readSphere(shorthand);
}

} // namespace polymesh::tools
