// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/boundaryFile.h"

#include "formats/foam/listReader.h"

#include <algorithm>
#include <charconv>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>

namespace polymesh::foam {
namespace {

/// Calls readItem(name) for each `name { ... }` of `n ( ... )`; readItem stands before the brace.
template<class ReadItem>
void readNamedItems(FoamReader& reader, std::string_view what, ReadItem&& readItem) {
    std::optional<std::int64_t> count;
    if (reader.peek() != '(') count = reader.integer(fmt::format("number of {}", what));
    if (count == 0 && reader.peek() != '(') return;
    reader.expect('(', what);
    std::set<std::string> names;
    while (!reader.accept(')')) {
        const std::string name = reader.word(what);
        if (!names.insert(name).second) reader.fail("{}: the name '{}' is there twice", what, name);
        readItem(name);
    }
    if (count && *count != static_cast<std::int64_t>(names.size()))
        reader.fail("{} {} announced, {} found", *count, what, names.size());
}

Label countFromText(FoamReader& reader, std::string_view key, const std::string& text) {
    Label value = -1;
    const char* end = text.data() + text.size();
    const auto [stop, problem] = std::from_chars(text.data(), end, value);
    if (problem != std::errc{} || stop != end || value < 0)
        reader.fail("{} '{}': expected a number of faces, 0 or more", key, text);
    return value;
}

Patch readPatch(FoamReader& reader, const std::string& name) {
    Patch patch;
    patch.name = name;
    std::set<std::string, std::less<>> seen;
    reader.expect('{', "patch " + name);
    while (!reader.accept('}')) {
        const std::string key = reader.word("patch " + name);
        if (key.front() == '#')
            reader.fail("patch {}: {} is not supported in a boundary file", name, key);
        const std::string text = reader.entryText();
        if (!seen.insert(key).second) reader.fail("patch {}: {} is there twice", name, key);
        if (key == "type") {
            patch.type = text;
        } else if (key == "nFaces") {
            patch.size = countFromText(reader, key, text);
        } else if (key == "startFace") {
            patch.start = countFromText(reader, key, text);
        } else {
            patch.entries.emplace_back(key, text);
        }
    }
    for (const std::string_view key : {"type", "nFaces", "startFace"})
        if (!seen.contains(key)) reader.fail("patch {}: there is no {}", name, key);
    return patch;
}

std::string_view labelsKey(ZoneKind kind) {
    switch (kind) {
    case ZoneKind::point:
        return "pointLabels";
    case ZoneKind::face:
        return "faceLabels";
    case ZoneKind::cell:
        break;
    }
    return "cellLabels";
}

/// Moves over the type that may stand before a list.
void skipListType(FoamReader& reader) {
    const char first = reader.peek();
    if (first == 'L') reader.word("list type");
}

void checkZone(FoamReader& reader, const Zone& zone, Label elementCount) {
    for (const Label label : zone.labels)
        if (label < 0 || label >= elementCount)
            reader.failInFile("zone {}: label {} is out of range; the mesh has {}",
                              zone.name,
                              label,
                              elementCount);
    if (!zone.flip.empty() && zone.flip.size() != zone.labels.size())
        reader.failInFile("zone {}: flipMap has {} entries, expected {}, one a face",
                          zone.name,
                          zone.flip.size(),
                          zone.labels.size());
}

/// Makes the labels ascending, each once, and takes the flips along.
void sortZone(Zone& zone) {
    if (std::ranges::is_sorted(zone.labels, std::less_equal<>{})) return;
    std::vector<std::size_t> order(zone.labels.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return zone.labels[i]; });
    Zone sorted;
    for (const std::size_t i : order) {
        if (!sorted.labels.empty() && sorted.labels.back() == zone.labels[i]) continue;
        sorted.labels.push_back(zone.labels[i]);
        if (!zone.flip.empty()) sorted.flip.push_back(zone.flip[i]);
    }
    zone.labels = std::move(sorted.labels);
    zone.flip = std::move(sorted.flip);
}

Zone readZone(FoamReader& reader, const std::string& name, ZoneKind kind, Label elementCount) {
    Zone zone;
    zone.name = name;
    reader.expect('{', "zone " + name);
    while (!reader.accept('}')) {
        const std::string key = reader.word("zone " + name);
        if (key == labelsKey(kind)) {
            skipListType(reader);
            zone.labels = readLabels(reader, elementCount);
            reader.expect(';', key);
        } else if (key == "flipMap" && kind == ZoneKind::face) {
            skipListType(reader);
            zone.flip = readFlags(reader, elementCount);
            reader.expect(';', key);
        } else {
            reader.entryText();
        }
    }
    checkZone(reader, zone, elementCount);
    if (kind == ZoneKind::face) zone.flip.resize(zone.labels.size(), false);
    sortZone(zone);
    return zone;
}

} // namespace

std::vector<Patch> readPatches(FoamReader& reader) {
    std::vector<Patch> patches;
    readNamedItems(reader, "patches", [&](const std::string& name) {
        patches.push_back(readPatch(reader, name));
    });
    return patches;
}

std::vector<Zone> readZones(FoamReader& reader, ZoneKind kind, Label elementCount) {
    std::vector<Zone> zones;
    readNamedItems(reader, "zones", [&](const std::string& name) {
        zones.push_back(readZone(reader, name, kind, elementCount));
    });
    return zones;
}

} // namespace polymesh::foam
