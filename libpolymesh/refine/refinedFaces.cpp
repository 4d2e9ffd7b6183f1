// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/refine/refinedFaces.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/refine/treePoints.h"

#include <algorithm>
#include <optional>

namespace polymesh {
namespace {

LatticePoint middle(const LatticePoint& a, const LatticePoint& b) {
    return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

/// The octant of the same size across a side, its place in the tree there; empty on the boundary.
struct Across {
    Label tree = -1;
    std::optional<Passage> passage; // when it is another tree

    Octant placed(const Octant& moved) const { return passage ? passage->octant(moved) : moved; }
};

Across across(const MacroMesh& mesh, Label tree, const Octant& moved, std::size_t side) {
    const std::int32_t at = moved.anchor[side / 2];
    if (at >= 0 && at < latticeSize) return {tree, std::nullopt};
    const Label other = mesh.neighbour(tree, side);
    if (other < 0) return {};
    return {other, Passage(mesh, tree, side)};
}

Octant shifted(Octant octant, std::size_t side) {
    octant.anchor[side / 2] += side % 2 == 1 ? octant.size() : -octant.size();
    return octant;
}

/// Ends a face of which the points were added, so that it begins with the lowest one: then it does
/// not matter from which side it was seen. Throws WorkError when a corner has no point: by the
/// construction all have.
void endFace(Rows<Label>& points) {
    const auto begin = points.values.begin() + points.offsets.back();
    const auto lowest = std::min_element(begin, points.values.end());
    if (*lowest < 0) throw WorkError("a face of the refined mesh has a corner without a point");
    std::rotate(begin, lowest, points.values.end());
    points.offsets.push_back(toLabel(points.values.size()));
}

/// The quarter of an octant's side at the k-th corner of its loop, as the octant half as large that
/// lies there inside.
Octant quarter(const Octant& octant, std::size_t side, std::size_t k) {
    return octant.child(sideLoops[side][k]);
}

} // namespace

/// What a cell touches across a side, or a quarter of it.
struct RefinedFaces::Contact {
    static constexpr std::size_t whole = 4;
    Label neighbour = -1;
    std::size_t side = 0;
    std::size_t part = whole; // or the corner of the side's loop at which the quarter is
};

/// In the order of the neighbours.
class RefinedFaces::Contacts {
public:
    void add(const Contact& contact) {
        std::size_t at = count_++;
        for (; at > 0 && contacts_[at - 1].neighbour > contact.neighbour; --at)
            contacts_[at] = contacts_[at - 1];
        contacts_[at] = contact;
    }

    std::span<const Contact> all() const { return {contacts_.data(), count_}; }

private:
    std::array<Contact, 24> contacts_;
    std::size_t count_ = 0;
};

void RefinedFaces::addContacts(Label tree,
                               const Octant& leaf,
                               std::size_t side,
                               Contacts& contacts) const {
    const Octant moved = shifted(leaf, side);
    const Across there = across(mesh_, tree, moved, side);
    if (there.tree < 0) return;
    const Label neighbour = leaves_.cellAt(there.tree, there.placed(moved).anchor);
    if (leaves_.levelAt(there.tree, neighbour) <= leaf.level) {
        contacts.add({neighbour, side, Contact::whole});
        return;
    }
    for (std::size_t k = 0; k < 4; ++k) {
        const Octant outside = shifted(quarter(leaf, side, k), side);
        const Label fine = leaves_.cellAt(there.tree, there.placed(outside).anchor);
        contacts.add({fine, side, k});
    }
}

void RefinedFaces::addWhole(const TreePoints& points,
                            const Octant& leaf,
                            std::size_t side,
                            FaceList& faces) const {
    const bool mayBeHalved = octants_.highest[index(points.tree())] > leaf.level;
    const std::array<std::size_t, 4>& loop = sideLoops[side];
    for (std::size_t k = 0; k < 4; ++k) {
        const LatticePoint corner = leaf.corner(loop[k]);
        faces.points.values.push_back(points.find(corner));
        if (!mayBeHalved) continue;
        const Label between = points.find(middle(corner, leaf.corner(loop[(k + 1) % 4])));
        if (between >= 0) faces.points.values.push_back(between);
    }
    endFace(faces.points);
}

void RefinedFaces::addQuarter(const TreePoints& points,
                              const Octant& leaf,
                              const Contact& contact,
                              FaceList& faces) const {
    const std::array<std::size_t, 4>& loop = sideLoops[contact.side];
    const Octant part = quarter(leaf, contact.side, contact.part);
    for (const std::size_t corner : loop)
        faces.points.values.push_back(points.find(part.corner(corner)));
    endFace(faces.points);
}

void RefinedFaces::addFace(const TreePoints& points,
                           const Octant& leaf,
                           const Contact& contact,
                           FaceList& faces) const {
    if (contact.part == Contact::whole)
        addWhole(points, leaf, contact.side, faces);
    else
        addQuarter(points, leaf, contact, faces);
}

void RefinedFaces::addInternal(Label tree, InternalFaces& faces) const {
    const TreePoints points(points_, tree, octants_.highest[index(tree)], leaves_.of(tree).size());
    Label cell = leaves_.first[index(tree)];
    for (const OctantCode code : leaves_.of(tree)) {
        const Octant leaf = octantOf(code);
        Contacts contacts;
        for (std::size_t side = 0; side < 6; ++side)
            // Inside the tree, what is below comes before on the curve and has the face.
            if (side % 2 == 1 || leaf.anchor[side / 2] == 0)
                addContacts(tree, leaf, side, contacts);
        for (const Contact& contact : contacts.all()) {
            const bool isLower = contact.neighbour < cells_.first;
            if (contact.neighbour < cell && !isLower) continue;
            FaceList& list = isLower                              ? faces.toLower
                             : contact.neighbour >= cells_.second ? faces.toHigher
                                                                  : faces.inner;
            list.owner.push_back(cell);
            list.neighbour.push_back(contact.neighbour);
            if (hasOthers_ && !isLower) list.place.push_back(faces.count++);
            addFace(points, leaf, contact, list);
        }
        ++cell;
    }
}

void RefinedFaces::addBoundary(const TreeSide& at, FaceList& faces) const {
    Label cell = leaves_.first[index(at.tree)];
    const TreePoints points(points_, at.tree, octants_.highest[index(at.tree)], 0);
    const std::size_t normal = at.side / 2;
    for (const OctantCode code : leaves_.of(at.tree)) {
        const Octant leaf = octantOf(code);
        const std::int32_t outer = leaf.anchor[normal] + (at.side % 2 == 1 ? leaf.size() : 0);
        if (outer == (at.side % 2 == 1 ? latticeSize : 0)) {
            faces.owner.push_back(cell);
            addWhole(points, leaf, at.side, faces);
        }
        ++cell;
    }
}

} // namespace polymesh
