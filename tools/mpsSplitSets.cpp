// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mpsSplitSets.h"

#include "formats/foam/sets.h"
#include "libpolymesh/base/error.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <string>

namespace polymesh::tools {

namespace {

/// What the header of a file says that it holds a set of.
std::optional<foam::SetKind> kindOf(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string head(2048, '\0');
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(stream.gcount()));
    const std::size_t at = head.find("class");
    if (at == std::string::npos) return std::nullopt;
    const std::string rest = head.substr(at, head.find(';', at) - at);
    if (rest.find("cellSet") != std::string::npos) return foam::SetKind::cell;
    if (rest.find("faceSet") != std::string::npos) return foam::SetKind::face;
    if (rest.find("pointSet") != std::string::npos) return foam::SetKind::point;
    return std::nullopt;
}

std::vector<std::filesystem::path> filesIn(const std::filesystem::path& directory) {
    std::vector<std::filesystem::path> files;
    if (std::filesystem::is_directory(directory))
        for (const auto& entry : std::filesystem::directory_iterator(directory))
            if (entry.is_regular_file()) files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

void moveTail(std::vector<Zone>& from, std::size_t first, std::vector<Zone>& to) {
    to.assign(from.begin() + static_cast<std::ptrdiff_t>(first), from.end());
    from.resize(first);
}

} // namespace

TravellingSets takeSets(const std::filesystem::path& meshDir, PolyMesh& mesh) {
    const TravellingSets own{mesh.pointZones.size(), mesh.faceZones.size(), mesh.cellZones.size()};
    for (const auto& file : filesIn(meshDir / "sets")) {
        const auto kind = kindOf(file);
        if (!kind) continue;
        const std::string name = file.filename().string();
        Zone zone{name, foam::readSet(meshDir, *kind, name), {}};
        const Label count = *kind == foam::SetKind::cell   ? mesh.cellCount
                            : *kind == foam::SetKind::face ? mesh.faceCount()
                                                           : mesh.pointCount();
        require(zone.labels.empty() || (zone.labels.front() >= 0 && zone.labels.back() < count),
                "{}: has a label beyond the {} of the mesh; remove the set, or the mesh that it "
                "belongs to is another",
                file.string(),
                count);
        if (*kind == foam::SetKind::face) zone.flip.assign(zone.labels.size(), false);
        (*kind == foam::SetKind::cell   ? mesh.cellZones
         : *kind == foam::SetKind::face ? mesh.faceZones
                                        : mesh.pointZones)
            .push_back(std::move(zone));
    }
    return own;
}

PolyMesh removeSets(const TravellingSets& sets, PolyMesh& mesh) {
    PolyMesh removed;
    moveTail(mesh.pointZones, sets.pointZones, removed.pointZones);
    moveTail(mesh.faceZones, sets.faceZones, removed.faceZones);
    moveTail(mesh.cellZones, sets.cellZones, removed.cellZones);
    return removed;
}

void writeSets(const std::filesystem::path& meshDir, const PolyMesh& sets) {
    for (const Zone& zone : sets.pointZones)
        foam::writeSet(meshDir, foam::SetKind::point, zone.name, zone.labels);
    for (const Zone& zone : sets.faceZones)
        foam::writeSet(meshDir, foam::SetKind::face, zone.name, zone.labels);
    for (const Zone& zone : sets.cellZones)
        foam::writeSet(meshDir, foam::SetKind::cell, zone.name, zone.labels);
}

} // namespace polymesh::tools
