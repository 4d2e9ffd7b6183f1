// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/keptZones.h"

#include <algorithm>
#include <span>

namespace polymesh {

namespace {

std::span<const Zone> firstZones(const std::vector<Zone>& zones, std::size_t count) {
    return std::span(zones).first(std::min(count, zones.size()));
}

} // namespace

bool areInSameZones(const PolyMesh& mesh, const KeptZones& zones, Label cell, Label other) {
    return std::ranges::all_of(firstZones(mesh.cellZones, zones.cellZones), [&](const Zone& zone) {
        return std::ranges::binary_search(zone.labels, cell) ==
               std::ranges::binary_search(zone.labels, other);
    });
}

bool isInZone(const PolyMesh& mesh, const KeptZones& zones, Label face) {
    return std::ranges::any_of(firstZones(mesh.faceZones, zones.faceZones), [&](const Zone& zone) {
        return std::ranges::binary_search(zone.labels, face);
    });
}

} // namespace polymesh
