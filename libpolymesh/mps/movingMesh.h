// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/rows.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/polyMesh.h"

#include <span>
#include <vector>

namespace polymesh {

/// A mesh of which points move, with the geometry of the cells that are looked at and OpenFOAM's
/// measures of them, each by its limit: above 1 its checkMesh fails.
/// Requires: cells of six faces at most, as parts are.
/// Law: the geometry of measured cells and their faces is that of the points as they are.
class MovingMesh {
public:
    /// `cellFaces` as topology.h has them. Cost: memory for all faces and cells.
    MovingMesh(PolyMesh& mesh, const Rows<Label>& cellFaces);

    const PolyMesh& mesh() const { return mesh_; }

    std::span<const Label> facesOf(Label cell) const { return cellFaces_[cell]; }

    const FaceGeometry& face(Label face) const { return faces_[index(face)]; }

    /// Measures the cells that are marked, and those across their faces; in parallel.
    void measure(std::span<const char> isMarked);

    /// Measures a cell and those across its faces, where they are not yet.
    void measure(Label cell);

    /// Moves a point. `faces`, `cells`: all that have it, measured.
    void
    move(Label point, const Vec3& to, std::span<const Label> faces, std::span<const Label> cells);

    /// OpenFOAM's aspect ratio of a cell, by its limit.
    double stretch(Label cell) const;

    /// The same, or 0 where it is clear, for less, that it is not half the limit.
    double largeStretch(Label cell) const { return isCompact(cell) ? 0 : stretch(cell); }

    /// The skewness of a face, by its limit.
    double skewness(Label face) const;

    /// The same, or 0 where it is clear, for less, that it is not half the limit and that the face
    /// does not lean by 1 or more.
    double largeSkewness(Label face) const { return isStraight(face) ? 0 : skewness(face); }

    /// Whether a cell or face is beyond a limit.
    bool isStretched(Label cell) const { return largeStretch(cell) > 1; }

    bool isSkewOrTurned(Label face) const {
        return !isStraight(face) && (skewness(face) > 1 || lean(face) >= 1);
    }

    /// How far a face leans: one less the cosine between its normal and the lines from cell centre
    /// to cell centre and from these to the face's, the largest. At 1 a pyramid from a centre to
    /// the face has no volume, or the faces's normal is at right angles to the line of the centres.
    double lean(Label face) const;

private:
    bool isCompact(Label cell) const;
    bool isStraight(Label face) const;
    void updateFace(Label face);
    void updateCell(Label cell);
    void measureOne(Label cell);

    PolyMesh& mesh_;
    const Rows<Label>& cellFaces_;
    std::vector<FaceGeometry> faces_;
    std::vector<CellGeometry> cells_;
    std::vector<char> isMeasured_; // one a cell
};

} // namespace polymesh
