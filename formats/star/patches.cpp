// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/patches.h"

#include "formats/star/regionTypes.h"
#include "libpolymesh/surface/regions.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace polymesh::star {

namespace {

constexpr const char* defaultPatch = "Default_Boundary_Region";

/// Words that are names of zones or patches, none of which may come twice.
class UniqueNames {
public:
    std::string add(const std::string& wanted) {
        std::string word = toWord(wanted);
        if (word.empty()) word = "unnamed";
        std::string name = word;
        for (int& i = uses_[word]; !used_.insert(name).second;)
            name = fmt::format("{}_{}", word, ++i + 1);
        return name;
    }

private:
    std::set<std::string> used_;
    std::map<std::string, int> uses_; // how often each word had to be changed
};

std::string
usualName(Label region, std::string_view type, std::string_view foamType, Version version) {
    const std::string_view word = type.empty() ? foamType : type;
    return version == Version::v3 ? fmt::format("{}{}", toUpper(word), region)
                                  : fmt::format("{}_{}", toLower(word), region);
}

Patch patchOf(Label number, const std::string& recordType, const Names& names, Version version) {
    const auto named = names.regions.find(number);
    const Names::Region given = named == names.regions.end() ? Names::Region{} : named->second;
    const std::string& type = recordType.empty() ? given.type : recordType;
    Patch patch = patchOfType(type);
    if (!given.foamType.empty()) patch.type = given.foamType;
    if (!given.entries.empty()) patch.entries = given.entries;
    patch.name = given.name.empty() ? usualName(number, type, patch.type, version) : given.name;
    return patch;
}

/// Makes the patches one after the other.
class PatchMaker {
public:
    PatchMaker(const CellMesh& mesh, const BoundaryRecords& records)
        : mesh_(mesh), records_(records), isListed_(mesh.cells.faceTotal(), 0) {}

    void addRegions(const Names& names, Version version) {
        std::map<Label, Label> patchOfRegion;
        std::map<Label, std::string> types = records_.types;
        for (const auto& [number, region] : names.regions)
            if (!region.name.empty() && number > 0) types.try_emplace(number);
        for (const auto& [number, type] : types) {
            patchOfRegion[number] = toLabel(result_.patches.size());
            addPatch(patchOf(number, type, names, version));
        }
        for (std::size_t i = 0; i < records_.faces.size(); ++i)
            addFace(records_.faces[i], patchOfRegion[records_.regions[i]]);
    }

    void addBaffles(const Names& names) {
        std::map<Label, Label> patchOfTable;
        for (std::size_t b = 0; b < mesh_.baffles.size(); ++b)
            for (const Label face : mesh_.baffles[b]) {
                if (isListed_[index(face)] != 0) continue;
                const Label table = mesh_.cells.baffleTables[b];
                const auto [patch, isNew] =
                    patchOfTable.try_emplace(table, toLabel(result_.patches.size()));
                if (isNew) addPatch(bafflePatch(table, names));
                addFace(face, patch->second);
            }
    }

    void addDefault() {
        const Label patch = toLabel(result_.patches.size());
        for (Label f = 0; f < mesh_.cells.faces.size(); ++f)
            if (mesh_.pairs.partner[index(f)] < 0 && isListed_[index(f)] == 0) addFace(f, patch);
        if (!result_.patchOf.empty() && result_.patchOf.back() == patch) {
            Patch rest;
            rest.name = defaultPatch;
            addPatch(std::move(rest));
        }
    }

    PatchFaces take() { return std::move(result_); }

private:
    static Patch bafflePatch(Label table, const Names& names) {
        const auto named = names.tables.find(table);
        Patch patch;
        patch.type = "wall";
        patch.name = named != names.tables.end() && !named->second.name.empty()
                         ? named->second.name
                         : fmt::format("baffle_{}", table);
        return patch;
    }

    void addPatch(Patch patch) {
        patch.name = names_.add(patch.name);
        result_.patches.push_back(std::move(patch));
    }

    void addFace(Label face, Label patch) {
        isListed_[index(face)] = 1;
        result_.faces.push_back(face);
        result_.patchOf.push_back(patch);
    }

    const CellMesh& mesh_;
    const BoundaryRecords& records_;
    std::vector<char> isListed_;
    UniqueNames names_;
    PatchFaces result_;
};

} // namespace

PatchFaces patchesOf(const CellMesh& mesh,
                     const BoundaryRecords& records,
                     const Names& names,
                     Version version) {
    PatchMaker maker(mesh, records);
    maker.addRegions(names, version);
    maker.addBaffles(names);
    maker.addDefault();
    return maker.take();
}

std::vector<Zone> zonesOf(const CellRecords& cells, const Names& names) {
    std::map<Label, std::vector<Label>> cellsOf;
    std::vector<Label>* zone = nullptr;
    for (Label c = 0; c < cells.count(); ++c) {
        const Label table = cells.tables[index(c)];
        if (c == 0 || table != cells.tables[index(c) - 1]) zone = &cellsOf[table];
        zone->push_back(c);
    }
    UniqueNames unique;
    std::vector<Zone> zones;
    for (auto& [table, labels] : cellsOf) {
        const auto named = names.tables.find(table);
        const std::string name = named == names.tables.end() ? "" : named->second.name;
        if (name == unzonedCells || (name.empty() && cellsOf.size() == 1)) continue;
        zones.push_back({unique.add(name.empty() ? fmt::format("cellTable_{}", table) : name),
                         std::move(labels),
                         {}});
    }
    return zones;
}

} // namespace polymesh::star
