// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/disjointSets.h"
#include "libpolymesh/base/label.h"

#include <span>
#include <vector>

namespace polymesh {

/// Polygons of one cell, joined to shells across their common edges. Reusable from cell to cell.
class CellShells {
public:
    void clear();

    /// Adds a polygon of point labels; isTurned: its normal points into the cell.
    void add(std::span<const Label> polygon, bool isTurned);

    /// Joins the polygons across their edges; call once all have been added.
    void join();

    /// Whether every edge is used equally often in both directions. After join.
    bool isClosed() const { return openPoint_ < 0; }

    /// Whether moreover every edge is used only once in each direction. After join.
    bool isSimple() const { return isSimple_ && isClosed(); }

    /// A point of an edge that is not closed, or -1.
    Label openPoint() const { return openPoint_; }

    /// The lowest polygon of the shell to which a polygon belongs.
    Label shellOf(Label polygon) { return shells_.lowest(polygon); }

    /// Makes one shell of those of two polygons.
    void unite(Label a, Label b) { shells_.join(a, b); }

    Label polygonCount() const { return shells_.count(); }

private:
    struct EdgeUse {
        Label low;
        Label high;
        Label polygon;
        bool isForward;
    };

    std::vector<EdgeUse> uses_;
    DisjointSets shells_; // of polygons
    Label openPoint_ = -1;
    bool isSimple_ = true;
};

} // namespace polymesh
