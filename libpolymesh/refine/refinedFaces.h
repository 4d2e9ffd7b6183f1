// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/refine/leaves.h"
#include "libpolymesh/refine/pointTable.h"

#include <span>

namespace polymesh {

/// Some faces of a refined mesh, in order.
struct FaceList {
    Rows<Label> points;           // outlines, outward from the owner
    std::vector<Label> owner;     // one per face
    std::vector<Label> neighbour; // one per face; boundary faces: none
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
        : mesh_(mesh), octants_(octants), leaves_(leaves), points_(points) {}

    /// Adds the faces of the cells of a tree towards higher cells, by cell and neighbour.
    void addInternal(Label tree, FaceList& faces) const;

    /// Adds the faces on a side of a tree that is on the boundary, by cell.
    void addBoundary(const TreeSide& at, FaceList& faces) const;

private:
    struct Contact;
    class Contacts;

    void addContacts(Label tree, const Octant& leaf, std::size_t side, Contacts& contacts) const;
    void addWhole(Label tree, const Octant& leaf, std::size_t side, FaceList& faces) const;
    void addQuarter(Label tree, const Octant& leaf, const Contact& contact, FaceList& faces) const;

    const MacroMesh& mesh_;
    const TreeOctants& octants_;
    const Leaves& leaves_;
    const PointTable& points_;
};

} // namespace polymesh
