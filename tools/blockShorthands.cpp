// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/blockShorthands.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/initial/blockParts.h"
#include "libpolymesh/initial/roundBlocks.h"
#include "tools/blockDictReader.h"
#include "tools/blockExtrude.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <utility>

namespace polymesh::tools {

namespace {

const std::vector<std::string> shorthands{"cartesian", "cylinder", "sphere", "extrude"};

/// `parts ( shorthand {...} shorthand {...} )`
constexpr const char* partList = "parts";

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
    const GradedBox box{{dictionary.vector("min"), dictionary.vector("max")},
                        cellsOf<3>(dictionary, "three numbers of cells (nx ny nz)"),
                        gradingsOf<3>(dictionary, "three gradings (x y z)")};
    for (int axis = 0; axis < 3; ++axis)
        if (!(box.box.min[axis] < box.box.max[axis]))
            dictionary.entry("max").value().fail("max", "a corner above min in x, y and z");
    return boxBlocks(box);
}

BlockMeshDescription readCylinder(const foam::Dictionary& dictionary) {
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
    BallSpec ball;
    ball.centre = dictionary.vector("centre");
    ball.radius = positive(dictionary, "radius");
    ball.core = between(0, 1, dictionary, "core", ball.core);
    ball.cells = cellsOf<2>(dictionary, "two numbers of cells (outwards along-edges-of-the-core)");
    ball.grading = gradingsOf<1>(dictionary, "one grading (outwards)")[0];
    return ballBlocks(ball);
}

void requireKnownKeys(const std::string& shorthand, const foam::Dictionary& dictionary) {
    if (shorthand == "cartesian")
        foam::requireKnownKeys(dictionary, {"min", "max", "cells", "grading", "patches", "zone"});
    else if (shorthand == "cylinder")
        foam::requireKnownKeys(dictionary,
                               {"point1",
                                "point2",
                                "radius",
                                "holeRadius",
                                "core",
                                "angle",
                                "cells",
                                "grading",
                                "patches",
                                "zone"});
    else if (shorthand == "sphere")
        foam::requireKnownKeys(dictionary,
                               {"centre", "radius", "core", "cells", "grading", "patches", "zone"});
    else
        foam::requireKnownKeys(dictionary,
                               {"points",
                                "quads",
                                "surface",
                                "patch",
                                "vector",
                                "cells",
                                "layers",
                                "grading",
                                "patches",
                                "zone"});
}

BlockMeshDescription readBlocks(const std::string& shorthand,
                                const foam::Dictionary& dictionary,
                                const ShorthandFiles& files) {
    if (shorthand == "cartesian") return readCartesian(dictionary);
    if (shorthand == "cylinder") return readCylinder(dictionary);
    if (shorthand == "sphere") return readSphere(dictionary);
    return readExtrude(dictionary, files);
}

/// `patches { side pipe; bottom { name inlet; type patch; } }`: other names, and types.
void renamePatches(const foam::Dictionary& patches, BlockMeshDescription& mesh) {
    std::vector<std::string> known;
    for (const BlockPatch& patch : mesh.patches)
        known.push_back(patch.patch.name);
    for (const foam::Entry& entry : patches.entries()) {
        require(std::ranges::find(known, entry.key) != known.end(),
                "{}: patches: there is no patch {} here, expected one of: {}",
                entry.place.text(),
                entry.key,
                fmt::join(known, ", "));
        if (!entry.dictionary) continue;
        foam::requireKnownKeys(*entry.dictionary, {"name", "type"});
        const auto patch = std::ranges::find(
            mesh.patches, entry.key, [](const BlockPatch& p) -> auto& { return p.patch.name; });
        patch->patch.type = entry.dictionary->word("type", "patch");
        if (entry.dictionary->has("type"))
            refuseMisspeltType(entry.dictionary->entry("type").value());
    }
    // No new name may be taken for one of the old ones.
    for (const std::string& name : known)
        renamePatch(mesh, name, "/" + name);
    for (const std::string& name : known) {
        const foam::Entry* entry = patches.find(name);
        std::string newName = name;
        if (entry != nullptr)
            newName =
                entry->dictionary ? entry->dictionary->string("name", name) : patches.string(name);
        renamePatch(mesh, "/" + name, newName);
    }
}

BlockMeshDescription readPart(const std::string& shorthand,
                              const foam::Dictionary& dictionary,
                              const ShorthandFiles& files) {
    requireKnownKeys(shorthand, dictionary);
    BlockMeshDescription part = readBlocks(shorthand, dictionary, files);
    if (dictionary.has("patches")) renamePatches(dictionary.dictionary("patches"), part);
    const std::string zone = dictionary.word("zone", "");
    for (Block& block : part.blocks) {
        block.zone = zone;
        if (shorthand != "extrude") block.where = dictionary.place().text();
    }
    return part;
}

bool isKnown(const std::string& word) {
    return std::ranges::find(shorthands, word) != shorthands.end();
}

/// A dictionary that comes twice has become one.
void refuseMerged(const foam::Entry& entry) {
    if (entry.earlier.empty()) return;
    throw InputError(
        fmt::format("{}: there is another {} at line {}; several of a kind have to stand in a "
                    "list: {} ( {} {{...}} {} {{...}} );",
                    entry.place.text(),
                    entry.key,
                    entry.earlier.front().line,
                    partList,
                    entry.key,
                    entry.key));
}

using NamedDictionary = std::pair<std::string, const foam::Dictionary*>;

/// The shorthands of a dictionary in the order in which they stand there.
std::vector<NamedDictionary> findShorthands(const foam::Dictionary& dictionary) {
    std::vector<NamedDictionary> found;
    for (const foam::Entry& entry : dictionary.entries()) {
        if (isKnown(entry.key)) {
            refuseMerged(entry);
            found.emplace_back(entry.key, &dictionary.dictionary(entry.key));
        } else if (entry.key == partList) {
            for (const NamedDictionary& part : foam::namedDictionaries(entry)) {
                require(isKnown(part.first),
                        "{}: {}: found {}, expected one of: {}",
                        part.second->place().text(),
                        partList,
                        part.first,
                        fmt::join(shorthands, ", "));
                found.push_back(part);
            }
        }
    }
    require(!found.empty(),
            "{}: {}: the list is empty; give at least one part",
            dictionary.place().text(),
            partList);
    return found;
}

} // namespace

bool isShorthand(const foam::Dictionary& dictionary) {
    return dictionary.has(partList) || std::ranges::any_of(shorthands, [&](const std::string& key) {
               return dictionary.has(key);
           });
}

BlockMeshDescription readShorthands(const foam::Dictionary& dictionary,
                                    const ShorthandFiles& files) {
    std::vector<std::string> keys = shorthands;
    keys.insert(keys.end(), {partList, "refinement"}); // see refineDict.h
    refuseMisspelt(dictionary, keys);
    const std::vector<NamedDictionary> found = findShorthands(dictionary);
    if (found.size() == 1) return readPart(found[0].first, *found[0].second, files);
    BlockMeshDescription mesh;
    for (const auto& [shorthand, part] : found)
        addPart(mesh, readPart(shorthand, *part, files), part->place().text());
    return mesh;
}

} // namespace polymesh::tools
