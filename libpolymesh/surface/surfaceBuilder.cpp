// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/surfaceBuilder.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/surface/polygonTriangles.h"
#include "libpolymesh/surface/regions.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <utility>

namespace polymesh {

namespace {

std::size_t hash(const Vec3& p) {
    std::uint64_t h = 0;
    for (int axis = 0; axis < 3; ++axis) {
        h = (h ^ std::bit_cast<std::uint64_t>(p[axis])) * 0x9e3779b97f4a7c15U;
        h ^= h >> 32U;
    }
    return h;
}

/// The place of `point` in the table, or the free place where it belongs.
std::size_t
findSlot(const std::vector<Label>& table, const std::vector<Vec3>& points, const Vec3& point) {
    const std::size_t mask = table.size() - 1;
    std::size_t slot = hash(point) & mask;
    while (table[slot] >= 0 && points[index(table[slot])] != point)
        slot = (slot + 1) & mask;
    return slot;
}

/// Removes the entries that `used` does not mark and returns each entry's new label.
template<class T>
std::vector<Label> keepUsed(std::vector<T>& entries, const std::vector<bool>& used) {
    std::vector<Label> newLabel(entries.size());
    Label count = 0;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        newLabel[i] = count;
        if (!used[i]) continue;
        if (index(count) != i) entries[index(count)] = std::move(entries[i]);
        ++count;
    }
    entries.resize(index(count));
    return newLabel;
}

void dropUnusedPoints(TriSurface& surface) {
    std::vector<bool> used(surface.points.size(), false);
    for (const auto& triangle : surface.triangles)
        for (Label corner : triangle)
            used[index(corner)] = true;
    if (std::ranges::find(used, false) == used.end()) return;
    const auto newLabel = keepUsed(surface.points, used);
    for (auto& triangle : surface.triangles)
        for (Label& corner : triangle)
            corner = newLabel[index(corner)];
}

void dropEmptyRegions(TriSurface& surface) {
    std::vector<bool> used(surface.regionNames.size(), false);
    for (Label region : surface.region)
        used[index(region)] = true;
    const auto newLabel = keepUsed(surface.regionNames, used);
    for (Label& region : surface.region)
        region = newLabel[index(region)];
}

/// Gives the nameless region its name, which another region may already bear.
void nameRegion(TriSurface& surface, const std::string& name) {
    auto& names = surface.regionNames;
    const auto nameless = std::ranges::find(names, std::string{});
    if (nameless == names.end()) return;
    const auto namesake = std::ranges::find(names, name);
    if (namesake == names.end()) {
        *nameless = name;
        return;
    }
    std::ranges::replace(surface.region,
                         static_cast<Label>(nameless - names.begin()),
                         static_cast<Label>(namesake - names.begin()));
}

} // namespace

Label SurfaceBuilder::addPoint(const Vec3& point) {
    const Vec3 p{point.x + 0.0, point.y + 0.0, point.z + 0.0}; // -0 + 0 is 0
    if (2 * surface_.points.size() >= table_.size()) growTable();
    Label& entry = table_[findSlot(table_, surface_.points, p)];
    if (entry < 0) {
        require(surface_.points.size() < index(std::numeric_limits<Label>::max()),
                "more points than labels: configure with POLYMESH_LABEL64");
        entry = toLabel(surface_.points.size());
        surface_.points.push_back(p);
    }
    return entry;
}

void SurfaceBuilder::growTable() {
    table_.assign(std::bit_ceil(std::max<std::size_t>(64, 4 * surface_.points.size())), -1);
    for (Label label = 0; label < surface_.pointCount(); ++label)
        table_[findSlot(table_, surface_.points, surface_.points[index(label)])] = label;
}

Label SurfaceBuilder::addRegion(std::string_view name) {
    const auto label = toLabel(surface_.regionNames.size());
    const auto [entry, isNew] = regionLabels_.try_emplace(toWord(name), label);
    if (isNew) surface_.regionNames.push_back(entry->first);
    return entry->second;
}

void SurfaceBuilder::addPolygon(std::span<const Label> corners, Label region) {
    if (corners.size() == 3) return addTriangle(corners[0], corners[1], corners[2], region);
    std::vector<Vec3> polygon;
    for (Label corner : corners)
        polygon.push_back(surface_.points[index(corner)]);
    for (const auto& [a, b, c] : polygonTriangles(polygon))
        addTriangle(corners[a], corners[b], corners[c], region);
}

void SurfaceBuilder::addTriangle(Label a, Label b, Label c, Label region) {
    if (a == b || b == c || c == a) return;
    // Sides are counted with labels too: three a triangle, in two directions.
    require(surface_.triangles.size() < index(std::numeric_limits<Label>::max()) / 6,
            "more triangles than labels: configure with POLYMESH_LABEL64");
    surface_.triangles.push_back({a, b, c});
    surface_.region.push_back(region);
}

TriSurface SurfaceBuilder::finish(std::string_view defaultName) {
    TriSurface surface;
    std::swap(surface, surface_);
    table_.clear();
    regionLabels_.clear();
    dropUnusedPoints(surface);
    const std::string word = toWord(defaultName);
    nameRegion(surface, word.empty() ? "surface" : word);
    dropEmptyRegions(surface);
    return surface;
}

} // namespace polymesh
