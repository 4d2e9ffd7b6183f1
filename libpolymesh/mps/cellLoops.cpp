// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/cellLoops.h"

#include <algorithm>
#include <tuple>

namespace polymesh {

std::vector<Polygon> outwardLoops(const PolyMesh& mesh, const Rows<Label>& faces, Label cell) {
    std::vector<Polygon> loops;
    for (const Label face : faces[cell]) {
        loops.emplace_back(mesh.faces[face].begin(), mesh.faces[face].end());
        if (mesh.owner[index(face)] != cell) std::ranges::reverse(loops.back());
    }
    return loops;
}

std::vector<CellEdge> edgesOf(std::span<const Polygon> loops) {
    std::vector<CellEdge> uses;
    for (std::size_t f = 0; f < loops.size(); ++f)
        for (std::size_t i = 0; i < loops[f].size(); ++i)
            uses.push_back(
                {loops[f][i], loops[f][(i + 1) % loops[f].size()], static_cast<int>(f), -1});
    std::ranges::sort(uses, {}, [](const CellEdge& e) {
        return std::tuple(std::min(e.a, e.b), std::max(e.a, e.b), e.a);
    });
    std::vector<CellEdge> edges;
    for (std::size_t i = 0; i + 1 < uses.size(); i += 2)
        edges.push_back({uses[i].a, uses[i].b, uses[i].left, uses[i + 1].left});
    return edges;
}

bool isClosed(std::span<const Polygon> loops) {
    std::vector<std::pair<Label, Label>> steps;
    for (const Polygon& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i)
            steps.emplace_back(loop[i], loop[(i + 1) % loop.size()]);
    std::ranges::sort(steps);
    return std::ranges::adjacent_find(steps) == steps.end() &&
           std::ranges::all_of(steps, [&](const auto& step) {
               return std::ranges::binary_search(steps, std::pair(step.second, step.first));
           });
}

LoneCell loneCell(const PolyMesh& mesh,
                  const Bends& bends,
                  std::span<const Polygon> loops,
                  const Vec3& further) {
    LoneCell lone;
    std::vector<Label> points;
    for (const Polygon& loop : loops)
        points.insert(points.end(), loop.begin(), loop.end());
    std::ranges::sort(points);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    const auto localOf = [&](Label p) {
        return static_cast<Label>(std::ranges::lower_bound(points, p) - points.begin());
    };
    for (const Label p : points)
        lone.mesh.points.push_back(p < 0 ? further : mesh.points[index(p)]);
    Polygon local;
    for (const Polygon& loop : loops) {
        local.clear();
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Label next = loop[(i + 1) % loop.size()];
            local.push_back(localOf(loop[i]));
            if (loop[i] > next) continue; // each edge is met once in either sense
            const Bend* bend = findBend(bends, loop[i], next);
            if (bend != nullptr)
                lone.bends.push_back({{localOf(loop[i]), localOf(next)}, bend->at});
        }
        lone.mesh.faces.add(local);
    }
    std::ranges::sort(lone.bends, {}, &Bend::ends);
    lone.mesh.owner.assign(loops.size(), 0);
    lone.mesh.cellCount = 1;
    return lone;
}

} // namespace polymesh
