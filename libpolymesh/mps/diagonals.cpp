// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/mps/loopCuts.h"
#include "libpolymesh/mps/loopCutter.h"

#include <map>

namespace polymesh {

namespace {

Label otherCell(const PolyMesh& mesh, Label face, Label cell) {
    const Label owner = mesh.owner[index(face)];
    return owner == cell ? mesh.neighbour[index(face)] : owner;
}

/// The faces of a cell, or their pieces where there are.
CellPart wholeCell(const PolyMesh& mesh,
                   const SubdivisionPlan& plan,
                   Label cell,
                   const std::map<Label, std::vector<Polygon>>& pieces) {
    CellPart whole;
    int place = 0;
    for (Polygon& loop : outwardLoops(mesh, plan.cellFaces, cell)) {
        const Label face = plan.cellFaces[cell][static_cast<std::size_t>(place)];
        const auto split = pieces.find(face);
        if (split == pieces.end()) {
            whole.loops.push_back(std::move(loop));
            whole.sources.push_back(place);
        } else {
            for (Polygon piece : split->second) {
                if (mesh.owner[index(face)] != cell) std::ranges::reverse(piece);
                whole.loops.push_back(std::move(piece));
                whole.sources.push_back(place);
            }
        }
        ++place;
    }
    return whole;
}

/// The faces of a cell that a cutter has split, by their places in the cell's row.
std::map<int, std::vector<Polygon>> splitFacesOf(const LoopCutter& cutter,
                                                 std::span<const int> sourcesBefore) {
    std::map<int, std::vector<Polygon>> split;
    for (const CellPart& part : cutter.parts())
        for (std::size_t f = 0; f < part.loops.size(); ++f)
            if (part.sources[f] >= 0) split[part.sources[f]].push_back(part.loops[f]);
    std::erase_if(split, [&](const auto& entry) {
        return std::ranges::count(sourcesBefore, entry.first) == std::ssize(entry.second);
    });
    return split;
}

/// The pieces of faces, by face.
using SplitFaces = std::map<Label, std::vector<Polygon>>;

/// Groups of cells that are connected over faces between them; cells as given, ascending, groups
/// by their first cells.
Rows<Label> groupsOfNeighbours(const PolyMesh& mesh,
                               const SubdivisionPlan& plan,
                               std::span<const Label> cells) {
    std::vector<char> isDone(cells.size(), 0);
    Rows<Label> groups;
    std::vector<Label> group;
    for (std::size_t first = 0; first < cells.size(); ++first) {
        if (isDone[first] != 0) continue;
        isDone[first] = 1;
        group.assign(1, cells[first]);
        for (std::size_t i = 0; i < group.size(); ++i)
            for (const Label face : plan.cellFaces[group[i]]) {
                if (!mesh.isInternal(face)) continue;
                const Label other = otherCell(mesh, face, group[i]);
                const auto at = std::ranges::lower_bound(cells, other);
                if (at == cells.end() || *at != other) continue;
                char& done = isDone[static_cast<std::size_t>(at - cells.begin())];
                if (done == 0) group.push_back(other);
                done = 1;
            }
        std::ranges::sort(group);
        groups.add(group);
    }
    return groups;
}

/// Finds the diagonals for a group of cells, from cell to cell.
class DiagonalSearch {
public:
    DiagonalSearch(const PolyMesh& mesh,
                   const Bends& bends,
                   const SubdivisionPlan& plan,
                   std::span<const Label> cells)
        : mesh_(mesh), bends_(bends), plan_(plan), cells_(cells) {}

    SplitFaces find() {
        pending_.assign(cells_.rbegin(), cells_.rend());
        std::set<Label> done;
        while (!pending_.empty()) {
            const Label cell = pending_.back();
            pending_.pop_back();
            if (done.insert(cell).second) split(cell);
        }
        return std::move(pieces_);
    }

private:
    /// Splits faces of a cell as its cuts need, and turns to its neighbours there.
    void split(Label cell) {
        CellPart whole = wholeCell(mesh_, plan_, cell, pieces_);
        const std::vector<int> sources = whole.sources;
        LoopCutter cutter(mesh_, bends_, cell, std::move(whole));
        cutter.allowDiagonals(plan_.edges.points, added_);
        if (!cutter.find()) return;
        for (auto& [place, loops] : splitFacesOf(cutter, sources)) {
            const Label face = plan_.cellFaces[cell][static_cast<std::size_t>(place)];
            if (mesh_.owner[index(face)] != cell)
                for (Polygon& loop : loops)
                    std::ranges::reverse(loop);
            for (const Polygon& loop : loops)
                addEdges(loop);
            pieces_[face] = std::move(loops);
            if (!mesh_.isInternal(face)) continue;
            const Label other = otherCell(mesh_, face, cell);
            if (std::ranges::binary_search(cells_, other)) pending_.push_back(other);
        }
    }

    void addEdges(const Polygon& loop) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const auto [low, high] = std::minmax(loop[i], loop[(i + 1) % loop.size()]);
            added_.insert({low, high});
        }
    }

    const PolyMesh& mesh_;
    const Bends& bends_;
    const SubdivisionPlan& plan_;
    std::span<const Label> cells_;
    std::vector<Label> pending_;
    SplitFaces pieces_;
    std::set<Edge> added_;
};

/// The edges between the pieces of a face.
std::vector<Edge> diagonalsBetween(std::span<const Polygon> pieces) {
    std::vector<Edge> edges;
    for (const Polygon& loop : pieces)
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const auto [low, high] = std::minmax(loop[i], loop[(i + 1) % loop.size()]);
            edges.push_back({low, high});
        }
    std::ranges::sort(edges);
    std::vector<Edge> inner;
    for (std::size_t i = 1; i < edges.size(); ++i)
        if (edges[i] == edges[i - 1]) inner.push_back(edges[i]);
    return inner;
}

/// All faces, but for those of later groups that would join the same points as earlier ones.
std::vector<FacePieces> withoutCommonDiagonals(std::vector<SplitFaces>& found) {
    std::set<Edge> taken;
    SplitFaces all;
    for (SplitFaces& faces : found) {
        std::vector<Edge> own;
        for (auto& [face, pieces] : faces) {
            const std::vector<Edge> inner = diagonalsBetween(pieces);
            if (std::ranges::any_of(inner, [&](const Edge& e) { return taken.contains(e); }))
                continue;
            own.insert(own.end(), inner.begin(), inner.end());
            all.emplace(face, std::move(pieces));
        }
        taken.insert(own.begin(), own.end());
    }
    std::vector<FacePieces> result;
    result.reserve(all.size());
    for (auto& [face, pieces] : all)
        result.push_back({face, std::move(pieces)});
    return result;
}

} // namespace

std::vector<FacePieces> diagonalsOf(const PolyMesh& mesh,
                                    const Bends& bends,
                                    const SubdivisionPlan& plan,
                                    std::span<const Label> cells) {
    const Rows<Label> groups = groupsOfNeighbours(mesh, plan, cells);
    std::vector<SplitFaces> found(index(groups.size()));
    parallelBlocks(groups.size(), 1, [&](Label, Label group, Label) {
        DiagonalSearch search(mesh, bends, plan, groups[group]);
        found[index(group)] = search.find();
    });
    return withoutCommonDiagonals(found);
}

} // namespace polymesh
