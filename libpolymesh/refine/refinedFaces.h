// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/refine/leaves.h"
#include "libpolymesh/refine/pointTable.h"

#include <utility>
#include <vector>

namespace polymesh {

class TreePoints;

/// Some faces of a refined mesh, in order. Each begins with its lowest point.
struct FaceList {
    Rows<Label> points;           // outlines, outward from the owner
    std::vector<Label> owner;     // one per face
    std::vector<Label> neighbour; // one per face; boundary faces: none
    std::vector<Label> place;     // see InternalFaces
};

/// The faces between cells of which some belong to other processes. The faces that cells share
/// with higher cells are counted through, which is their `place` (only kept when there are others).
struct InternalFaces {
    FaceList inner;    // between own cells
    FaceList toHigher; // to higher cells of others
    FaceList toLower;  // to lower cells of others; these have no place
    Label count = 0;
};

/// A side of a tree.
struct TreeSide {
    Label tree = 0;
    std::size_t side = 0;
};

/// Makes the faces between leaves. A leaf beside four finer ones has four faces there, and an edge
/// that some leaf has halved has its middle in the outlines of all faces at it.
class RefinedFaces {
public:
    RefinedFaces(const MacroMesh& mesh,
                 const TreeOctants& octants,
                 const Leaves& leaves,
                 const PointTable& points)
        : mesh_(mesh),
          octants_(octants),
          leaves_(leaves),
          points_(points),
          cells_(0, leaves.cellCount()) {}

    /// Says that only the cells from `first` up to `end` are own ones.
    void setOwnCells(Label first, Label end) {
        cells_ = {first, end};
        hasOthers_ = true;
    }

    /// Adds the faces of the cells of a tree towards higher cells, and cells of others, by cell and
    /// neighbour.
    void addInternal(Label tree, InternalFaces& faces) const;

    /// Adds the faces on a side of a tree that is on the boundary, by cell.
    void addBoundary(const TreeSide& at, FaceList& faces) const;

private:
    struct Contact;
    class Contacts;

    void addContacts(Label tree, const Octant& leaf, std::size_t side, Contacts& contacts) const;
    void addFace(const TreePoints& points,
                 const Octant& leaf,
                 const Contact& contact,
                 FaceList& faces) const;
    void
    addWhole(const TreePoints& points, const Octant& leaf, std::size_t side, FaceList& faces) const;
    void addQuarter(const TreePoints& points,
                    const Octant& leaf,
                    const Contact& contact,
                    FaceList& faces) const;

    const MacroMesh& mesh_;
    const TreeOctants& octants_;
    const Leaves& leaves_;
    const PointTable& points_;
    std::pair<Label, Label> cells_;
    bool hasOthers_ = false;
};

} // namespace polymesh
