// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapeSplit/rimCuts.h"

#include "libpolymesh/quality/cutCell.h"

#include <algorithm>
#include <map>
#include <set>

namespace polymesh {

namespace {

using PointSet = std::vector<Label>; // ascending

/// A way across a face, past the points that are cut off.
struct Link {
    Label to = -1;
    Label face = -1; // -1: along an edge of the cell
};

/// The corners of a face, anticlockwise seen from outside the cell.
Polygon outwardCorners(const MeshEditor& editor, Label cell, Label f) {
    Polygon corners = editor.face(f).points;
    if (editor.face(f).owner != cell) std::reverse(corners.begin(), corners.end());
    return corners;
}

/// The way past the points of the set on one face, from the corner before them to the one behind;
/// false when they are not in one row there.
bool addLink(const MeshEditor& editor,
             Label cell,
             Label f,
             const PointSet& cutOff,
             std::map<Label, Link>& links) {
    const Polygon corners = outwardCorners(editor, cell, f);
    const std::size_t n = corners.size();
    const auto isCutOff = [&](std::size_t i) {
        return std::ranges::binary_search(cutOff, corners[i % n]);
    };
    std::size_t rows = 0;
    std::size_t first = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < n; ++i) {
        if (isCutOff(i)) ++count;
        if (isCutOff(i) || !isCutOff(i + 1)) continue;
        ++rows;
        first = i;
    }
    if (count == 0 || count == n) return true; // nothing of it here, or the whole face
    const Label from = corners[first];
    const Label to = corners[(first + count + 1) % n];
    if (rows != 1 || from == to || links.contains(from)) return false;
    links[from] = {to, cellHasEdge(editor, cell, from, to) ? -1 : f};
    return true;
}

/// The loop round a set of points; empty when there is none.
CellLoop loopRound(const MeshEditor& editor, Label cell, const PointSet& cutOff) {
    std::map<Label, Link> links;
    for (const Label f : editor.cell(cell).faces)
        if (!addLink(editor, cell, f, cutOff, links)) return {};
    CellLoop loop;
    if (links.size() < 3) return loop;
    const Label start = links.begin()->first;
    for (Label p = start; loop.size() < links.size();) {
        const auto link = links.find(p);
        if (link == links.end()) return {};
        LoopCorner corner;
        corner.point = p;
        corner.position = editor.point(p);
        corner.faceToNext = link->second.face;
        loop.push_back(corner);
        p = link->second.to;
        if (p == start) break;
    }
    return loop.size() == links.size() ? loop : CellLoop{};
}

} // namespace

std::vector<CellLoop> rimCuts(const MeshEditor& editor, Label cell) {
    std::set<PointSet> sets;
    for (const Label f : editor.cell(cell).faces) {
        const Polygon& points = editor.face(f).points;
        PointSet whole(points.begin(), points.end());
        std::ranges::sort(whole);
        sets.insert(whole);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Label next = points[(i + 1) % points.size()];
            sets.insert({points[i]});
            sets.insert({std::min(points[i], next), std::max(points[i], next)});
        }
    }
    std::vector<CellLoop> loops;
    for (const PointSet& cutOff : sets)
        if (CellLoop loop = loopRound(editor, cell, cutOff); !loop.empty())
            loops.push_back(std::move(loop));
    return loops;
}

} // namespace polymesh
