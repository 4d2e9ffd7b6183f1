// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/blockMeshDict.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/nearestWord.h"
#include "tools/blockDictReader.h"

#include <algorithm>
#include <array>

namespace polymesh::tools {
namespace {

const std::vector<std::string> knownKeys{"blocks",
                                         "boundary",
                                         "convertToMeters",
                                         "defaultPatch",
                                         "edges",
                                         "faces",
                                         "geometry",
                                         "mergePatchPairs",
                                         "patches",
                                         "scale",
                                         "vertices"};

const std::vector<std::string> patchTypes{"cyclic",
                                          "cyclicACMI",
                                          "cyclicAMI",
                                          "cyclicPeriodicAMI",
                                          "cyclicSlip",
                                          "directMappedPatch",
                                          "directMappedWall",
                                          "empty",
                                          "generic",
                                          "mappedPatch",
                                          "mappedWall",
                                          "overset",
                                          "patch",
                                          "processor",
                                          "processorCyclic",
                                          "regionCoupled",
                                          "regionCoupledWall",
                                          "symmetry",
                                          "symmetryPlane",
                                          "wall",
                                          "wedge"};

/// Whether two words differ in no more than two neighbouring letters.
bool areSimilar(const std::string& a, const std::string& b) {
    const std::size_t shorter = std::min(a.size(), b.size());
    std::size_t prefix = 0;
    while (prefix < shorter && a[prefix] == b[prefix])
        ++prefix;
    std::size_t suffix = 0;
    while (suffix < shorter - prefix && a[a.size() - 1 - suffix] == b[b.size() - 1 - suffix])
        ++suffix;
    return shorter >= 4 && prefix + suffix + 2 >= std::max(a.size(), b.size());
}

bool isEmptyList(const foam::Entry& entry) {
    return entry.values.size() == 1 && entry.values[0].kind == foam::Value::Kind::list &&
           entry.values[0].items.empty();
}

double scaleOf(const foam::Dictionary& dictionary) {
    for (const char* key : {"scale", "convertToMeters"}) {
        if (!dictionary.has(key)) continue;
        const double scale = dictionary.scalar(key);
        if (!(scale > 0)) dictionary.entry(key).value().fail(key, "a positive number");
        return scale;
    }
    return 1;
}

void readDefaultPatch(BlockDictReader& reader) {
    const foam::Entry* entry = reader.dictionary.find("defaultPatch");
    if (entry == nullptr) return;
    const foam::Dictionary& patch = reader.dictionary.dictionary("defaultPatch");
    foam::requireKnownKeys(patch, {"name", "type"});
    reader.mesh.defaultPatch.name = patch.word("name", "defaultFaces");
    reader.mesh.defaultPatch.type = patch.word("type", "empty");
    if (patch.has("type")) refuseMisspeltType(patch.entry("type").value());
}

void readMergePairs(BlockDictReader& reader) {
    const std::string key = "mergePatchPairs";
    if (!reader.dictionary.has(key)) return;
    for (const foam::Value& pair : listOf(reader.dictionary, key).list(key)) {
        if (pair.list(key).size() != 2) pair.fail(key, "two patches (master slave)");
        reader.mesh.mergePairs.push_back(
            {pair.items[0].string(key), pair.items[1].string(key), pair.place.text()});
    }
}

} // namespace

void refuseMisspeltType(const foam::Value& type) {
    if (std::ranges::find(patchTypes, type.text) != patchTypes.end()) return;
    const std::string nearest = nearestWord(type.text, patchTypes);
    if (areSimilar(type.text, nearest))
        type.fail("type", fmt::format("a type of patch; did you mean {}?", nearest));
}

void refuseMisspelt(const foam::Dictionary& dictionary, const std::vector<std::string>& known) {
    for (const foam::Entry& entry : dictionary.entries()) {
        const bool isKnown = std::ranges::find(known, entry.key) != known.end();
        if (isKnown || isEmptyList(entry)) continue;
        const std::string nearest = nearestWord(entry.key, known);
        require(dictionary.has(nearest) || !areSimilar(entry.key, nearest),
                "{}: unknown entry {}; did you mean {}? (A macro needs a less similar name.)",
                entry.place.text(),
                entry.key,
                nearest);
    }
}

const foam::Value& Items::next(const std::string& expected) {
    require(!atEnd(),
            "{}: {}: the list ends where {} is expected",
            items_.empty() ? end_.text() : items_.back().place.text(),
            key_,
            expected);
    return items_[at_++];
}

const foam::Value& listOf(const foam::Dictionary& dictionary, const std::string& key) {
    const foam::Entry& entry = dictionary.entry(key);
    const std::vector<foam::Value>& values = entry.values;
    require(!values.empty(), "{}: {}: expected a list ( ... )", entry.place.text(), key);
    if (values.size() == 1) return values.front();
    // blockMesh reads the first list only. What follows when a ; is missing must not get lost.
    const bool nothingLost =
        values.size() == 3 && values[2].kind == foam::Value::Kind::list && values[2].items.empty();
    require(nothingLost,
            "{}: {}: '{}' is not expected after the list; is a ; missing before it?",
            values[1].place.text(),
            key,
            written({values[1]}));
    return values.front();
}

std::string written(const std::vector<foam::Value>& values) {
    std::string text;
    for (const foam::Value& value : values) {
        if (!text.empty()) text += ' ';
        if (value.kind == foam::Value::Kind::list)
            text += '(' + written(value.items) + ')';
        else if (value.kind == foam::Value::Kind::string)
            text += '"' + value.text + '"';
        else
            text += value.text;
    }
    return text;
}

bool isBlockMeshDict(const foam::Dictionary& dictionary) {
    return dictionary.has("blocks") || dictionary.has("vertices");
}

BlockMeshDescription readBlockMeshDict(const foam::Dictionary& dictionary,
                                       const FindSurface& findSurface) {
    refuseMisspelt(dictionary, knownKeys);
    BlockDictReader reader{dictionary, findSurface};
    reader.mesh.scale = scaleOf(dictionary);
    reader.readVertices();
    reader.readEdges();
    reader.readBlocks();
    reader.readProjectedSides();
    reader.readPatches();
    readDefaultPatch(reader);
    readMergePairs(reader);
    return std::move(reader.mesh);
}

} // namespace polymesh::tools
