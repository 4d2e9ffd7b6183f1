// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/cuttingLoop.h"
#include "libpolymesh/quality/editQuality.h"
#include "libpolymesh/quality/meshEditor.h"
#include "libpolymesh/quality/workBudget.h"

#include <optional>
#include <vector>

namespace polymesh {

/// Kinds of local changes that may mend a cell.
enum class Remedy : std::uint8_t {
    cut,         // the cell `from` along `loops`
    merge,       // the cell `from` into the cell `to`
    collapse,    // the point `from` onto the point `to`
    collapseAll, // the edges of the cell `from` below the limit number `to`
    splitFace,   // the face `face` of the cell `cell` from the point `from` to the point `to`
    detach,      // the same where the cell has that edge already, so that a part comes off
    slide,       // the point `from` to `position`
    unite,       // faces of the cell `from` that turn by less than the limit number `to`
    pinch        // the point `from`, at `position` then, into the edge from `to` to `end`
};

constexpr std::size_t remedyCount = 9;

/// A change that might be made, and what it does to the badness round it.
struct RepairMove {
    Remedy remedy = Remedy::cut;
    Label from = -1;
    Label to = -1;
    Label end = -1;
    Label face = -1;
    Label cell = -1;
    Vec3 position = {};  // [m]
    CellCut loops = {};  // for cut
    Badness change = {}; // after - before: negative is good
};

/// True for a change for the better.
bool isGood(const Badness& change);

/// True when the change a is clearly better than b.
bool isBetterChange(const Badness& a, const Badness& b);

/// The moves that come first: the best cut at a reflex edge, merges with each neighbour, collapses
/// of each edge up to half a cell and of all short edges at once. All can be made; they are tried
/// and taken back to fill in `change`.
std::vector<RepairMove> plainMoves(MeshEditor& editor, Label cell, WorkBudget& budget);

/// The ones for cells that those do not mend: the best cut between any faces, chords of faces.
std::vector<RepairMove> furtherMoves(MeshEditor& editor, Label cell, WorkBudget& budget);

/// Those that move points or unite faces, and every cut: they may help together with another move.
std::vector<RepairMove> moreMoves(MeshEditor& editor, Label cell, WorkBudget& budget);

/// Makes a move. Returns the cells that are changed or new; nothing when the move cannot be made,
/// and the caller then undoes.
std::optional<std::vector<Label>> makeMove(MeshEditor& editor, const RepairMove& move);

} // namespace polymesh
