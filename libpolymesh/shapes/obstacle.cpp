// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapes/obstacle.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/shapes/recognise.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace polymesh {

namespace {

using Loop = std::vector<Label>;

/// The faces of a cell, outward, and what is beyond each.
struct Shell {
    std::vector<Loop> loops;
    std::vector<Label> beyond; // cell; below 0: patch
    std::vector<Vec3> areas;   // [m^2] outward
};

Label patchOf(const PolyMesh& mesh, Label face) {
    Label patch = 0;
    while (face >= mesh.patches[index(patch)].start + mesh.patches[index(patch)].size)
        ++patch;
    return patch;
}

Shell shellOf(const PolyMesh& mesh, std::span<const Label> cellFaces, Label cell) {
    Shell shell;
    for (const Label f : cellFaces) {
        shell.loops.emplace_back(mesh.faces[f].begin(), mesh.faces[f].end());
        const bool isOwner = mesh.owner[index(f)] == cell;
        if (!isOwner) std::ranges::reverse(shell.loops.back());
        shell.areas.push_back(faceGeometry(mesh.points, shell.loops.back()).area);
        if (!mesh.isInternal(f))
            shell.beyond.push_back(-1 - patchOf(mesh, f));
        else
            shell.beyond.push_back(isOwner ? mesh.neighbour[index(f)] : mesh.owner[index(f)]);
    }
    return shell;
}

bool isAcceptable(const std::vector<Loop>& loops) {
    Rows<Label> faces;
    for (const Loop& loop : loops)
        faces.add(loop);
    return recognise(faces).has_value();
}

/// Takes out the points at which only two edges of the cell meet, and faces of which less than a
/// triangle is left.
void dropPointsOnEdges(std::vector<Loop>& loops) {
    std::map<Label, std::set<Label>> nextTo;
    for (const Loop& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Label a = loop[i];
            const Label b = loop[(i + 1) % loop.size()];
            nextTo[a].insert(b);
            nextTo[b].insert(a);
        }
    for (Loop& loop : loops)
        std::erase_if(loop, [&](Label p) { return nextTo[p].size() < 3; });
    std::erase_if(loops, [](const Loop& loop) { return loop.size() < 3; });
}

/// The one loop round some loops that touch; none when there are several, or one with a point
/// twice.
std::optional<Loop> roundAll(const std::vector<Loop>& loops) {
    std::set<std::pair<Label, Label>> darts;
    for (const Loop& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i)
            darts.emplace(loop[i], loop[(i + 1) % loop.size()]);
    std::map<Label, Label> next;
    for (const auto& [a, b] : darts)
        if (!darts.contains({b, a}) && !next.emplace(a, b).second) return std::nullopt;
    if (next.empty()) return std::nullopt;
    Loop round;
    for (Label p = next.begin()->first; round.size() < next.size(); p = next[p])
        round.push_back(p);
    Loop points = round;
    std::ranges::sort(points);
    if (std::ranges::adjacent_find(points) != points.end()) return std::nullopt;
    return round;
}

/// True when all of the faces look about the same way: a bend, not the corner of a box.
bool lookOneWay(const Shell& shell, const std::vector<std::size_t>& faces) {
    constexpr double leastCosine = 0.5;
    Vec3 sum;
    for (const std::size_t i : faces)
        sum += shell.areas[i];
    return std::ranges::all_of(faces, [&](std::size_t i) {
        return dot(shell.areas[i], sum) > leastCosine * norm(shell.areas[i]) * norm(sum);
    });
}

/// One loop for the faces with the same beyond them, where they touch and look about one way.
std::vector<Loop> withoutCreases(const Shell& shell) {
    std::map<Label, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < shell.loops.size(); ++i)
        groups[shell.beyond[i]].push_back(i);
    std::vector<Loop> loops;
    for (const auto& [beyond, group] : groups) {
        std::vector<Loop> parts;
        for (const std::size_t i : group)
            parts.push_back(shell.loops[i]);
        auto round = lookOneWay(shell, group) ? roundAll(parts) : std::nullopt;
        if (round)
            loops.push_back(std::move(*round));
        else
            loops.insert(loops.end(), parts.begin(), parts.end());
    }
    return loops;
}

} // namespace

std::string_view nameOf(Obstacle obstacle) {
    constexpr std::array<std::string_view, obstacleCount> names{
        "pointsOnEdges", "creases", "manyFaces", "manyPoints", "largeFace", "otherGraph"};
    return names[static_cast<std::size_t>(obstacle)];
}

Obstacle obstacleOf(const PolyMesh& mesh, std::span<const Label> cellFaces, Label cell) {
    const Shell shell = shellOf(mesh, cellFaces, cell);
    std::vector<Loop> straight = shell.loops;
    dropPointsOnEdges(straight);
    if (isAcceptable(straight)) return Obstacle::pointsOnEdges;
    std::vector<Loop> smooth = withoutCreases(shell);
    dropPointsOnEdges(smooth);
    if (isAcceptable(smooth)) return Obstacle::creases;
    std::set<Label> points;
    for (const Loop& loop : shell.loops)
        points.insert(loop.begin(), loop.end());
    if (shell.loops.size() > maxShapeFaces) return Obstacle::manyFaces;
    if (points.size() > maxShapePoints) return Obstacle::manyPoints;
    const bool hasLargeFace = std::ranges::any_of(
        shell.loops, [](const Loop& loop) { return loop.size() > maxShapeFacePoints; });
    return hasLargeFace ? Obstacle::largeFace : Obstacle::otherGraph;
}

std::array<Label, obstacleCount>
countObstacles(const PolyMesh& mesh, const Rows<Label>& cellFaces, std::span<const Label> cells) {
    std::vector<Obstacle> obstacles(cells.size());
    parallelFor(toLabel(cells.size()), [&](Label i) {
        const Label c = cells[index(i)];
        obstacles[index(i)] = obstacleOf(mesh, cellFaces[c], c);
    });
    std::array<Label, obstacleCount> counts{};
    for (const Obstacle obstacle : obstacles)
        ++counts[static_cast<std::size_t>(obstacle)];
    return counts;
}

} // namespace polymesh
