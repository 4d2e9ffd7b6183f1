// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/rows.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/quality/editMesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace polymesh {

/// Changes an EditMesh face by face: keeps the faces of each cell and of each point and a cache of
/// OpenFOAM's geometry up to date, and can take changes back. Cells have no life of their own: a
/// cell is what its faces say, and it is removed when the last of them goes.
/// Laws: (1) a face is listed by its owner, its neighbour and each of its points, once each;
/// (2) points never move; (3) undoTo brings back every face, cell and point as it was at the mark,
/// up to the order of the faces in a cell.
/// Cost: construction linear in the face corners, a change in what it touches. Serial.
class MeshEditor {
public:
    explicit MeshEditor(EditMesh& mesh);

    const EditMesh& mesh() const { return mesh_; }

    const EditFace& face(Label f) const { return mesh_.faces[index(f)]; }

    const EditCell& cell(Label c) const { return mesh_.cells[index(c)]; }

    const Vec3& point(Label p) const { return mesh_.points[index(p)]; }

    PointRank rank(Label p) const { return mesh_.ranks[index(p)]; }

    Label faceCount() const { return toLabel(mesh_.faces.size()); }

    Label cellCount() const { return toLabel(mesh_.cells.size()); }

    bool isFrozen(Label c) const { return c >= 0 && cell(c).frozen; }

    /// True when the face borders a cell outside the edited part, so that it must stay as it is.
    bool isFrozenFace(Label f) const {
        return isFrozen(face(f).owner) || isFrozen(face(f).neighbour);
    }

    /// The faces that use a point, in no order; valid until the next change.
    std::span<const Label> facesOfPoint(Label p) const;

    /// The cell on the other side of a face of `c`; -1 on the boundary.
    Label otherCell(Label f, Label c) const {
        return face(f).owner == c ? face(f).neighbour : face(f).owner;
    }

    Label addPoint(const Vec3& position, PointRank rank);
    /// Adds a cell without faces that is a part of another: of the same size and origin.
    Label addPartOf(Label cell);
    Label addFace(const EditFace& value);

    /// Gives a face new corners, sides or patch; a value without owner removes the face.
    void replaceFace(Label f, const EditFace& value);

    void removeFace(Label f) { replaceFace(f, EditFace{}); }

    void setFacePoints(Label f, const Polygon& corners);

    /// Makes a face that has the cell `from` on one side have the cell `to` there.
    void giveFace(Label f, Label from, Label to);

    /// A state to which undoTo can return; it stays good until commit or an undo past it.
    struct Mark {
        std::size_t changes = 0;
        std::size_t points = 0;
        std::size_t faces = 0;
        std::size_t cells = 0;
    };

    Mark mark() const;
    void undoTo(const Mark& mark);

    /// The cells of which a face has come, gone or got other corners since the mark, ascending; a
    /// face that only has another cell on its far side does not count. Removed cells are left out.
    std::vector<Label> reshapedSince(const Mark& mark) const;

    /// Forgets how to undo.
    void commit() { changes_.clear(); }

    /// Geometry from the cache, computed when needed. A frozen cell has none: do not ask.
    const FaceGeometry& faceGeometry(Label f);
    const CellGeometry& cellGeometry(Label c);

    /// Fills the cache of geometry where it has gaps, in parallel.
    void computeGeometry();

private:
    struct Change { // NOLINT(bugprone-exception-escape): boost's move may allocate
        Label face = -1;
        EditFace before;
    };

    using PointFaces = boost::container::small_vector<Label, 12>;

    PointFaces& ownList(Label p);
    void setFace(Label f, const EditFace& value);
    void setPoints(Label f, const EditFace& value);
    void leaveCell(Label c, Label f);
    void enterCell(Label c, Label f);
    void forgetGeometry(Label f);
    CellGeometry computeCell(Label c);

    EditMesh& mesh_;
    Rows<Label> pointFaces_;           // as constructed
    std::vector<Label> ownListOf_;     // per point: row of ownLists_, or -1: as constructed
    std::vector<PointFaces> ownLists_; // of points whose faces have changed
    std::vector<Change> changes_;
    std::vector<FaceGeometry> faceGeometry_;
    std::vector<CellGeometry> cellGeometry_;
    std::vector<std::uint8_t> faceKnown_; // 1: faceGeometry_ is valid
    std::vector<std::uint8_t> cellKnown_;
};

} // namespace polymesh
