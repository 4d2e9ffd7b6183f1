// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/check.h"
#include "libpolymesh/surface/distance.h"
#include "libpolymesh/surface/edges.h"
#include "libpolymesh/surface/features.h"
#include "libpolymesh/surface/measure.h"
#include "libpolymesh/surface/orient.h"
#include "libpolymesh/surface/surfaceBuilder.h"
#include "tests/fuzz/surfaceFuzz.h"

#include <array>

namespace {

using namespace polymesh;

/// A point of a coarse grid, so that coincidence of every kind is common.
Vec3 gridPoint(std::uint8_t byte) {
    return {static_cast<double>(byte & 3U),
            static_cast<double>((byte >> 2U) & 3U),
            static_cast<double>((byte >> 4U) & 3U)};
}

/// Tetrahedra, which are closed, where the first byte is odd, else triangles.
TriSurface build(const std::uint8_t* data, std::size_t size) {
    constexpr std::array<std::array<std::size_t, 3>, 4> faces{
        {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    SurfaceBuilder builder;
    const bool isClosed = size > 0 && (data[0] & 1U) != 0;
    const std::size_t step = isClosed ? 4 : 3;
    for (std::size_t i = 1; i + step <= size; i += step) {
        std::array<Label, 4> p{};
        for (std::size_t j = 0; j < step; ++j)
            p[j] = builder.addPoint(gridPoint(data[i + j]));
        const Label region = builder.addRegion((data[i] & 64U) != 0 ? "a" : "");
        if (!isClosed) builder.addPolygon(std::span(p).first(3), region);
        const bool isWhole = std::set<Label>(p.begin(), p.end()).size() == 4;
        for (const auto& face : faces)
            if (isClosed && isWhole)
                builder.addPolygon(std::array{p[face[0]], p[face[1]], p[face[2]]}, region);
    }
    return builder.finish("part");
}

void testClosed(const TriSurface& surface) {
    const SurfaceEdges edges = pairEdges(surface);
    fuzz::demand(2 * edges.edges.size() == 3 * surface.triangles.size(), "all sides are paired");
    std::vector<int> uses(edges.edges.size(), 0);
    for (const auto& sides : edges.ofTriangle)
        for (Label side : sides)
            ++uses[index(side)];
    fuzz::demand(std::ranges::count(uses, 2) == toLabel(uses.size()), "each edge has two sides");
    const SurfaceFeatures features = findFeatures(surface, edges, 0.5);
    fuzz::demand(features.isFeature.size() == edges.edges.size(), "a flag an edge");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const TriSurface given = build(data, std::min<std::size_t>(size, 200));
    fuzz::demandLaws(given);
    const bool isClosed = checkSurface(given).isClosed();
    fuzz::demand(isClosed == openEdges(given).empty(), "the two checks for closure agree");
    TriSurface surface = given;
    orientSurface(surface);
    fuzz::demandLaws(surface);
    fuzz::demand(!isClosed || openEdges(surface).empty(), "what was closed stays closed");
    TriSurface again = surface;
    fuzz::demand(orientSurface(again).turnedTriangles == 0, "there is nothing to turn twice");
    findSelfIntersections(surface, 3);
    if (openEdges(surface).empty()) testClosed(surface);
    if (!surface.triangles.empty())
        fuzz::demand(SurfaceTree(surface).closest(surface.points[0]).distance == 0,
                     "points of the surface are on it");
    return 0;
}
