// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/trim/bridges.h"
#include "libpolymesh/trim/loops.h"
#include "libpolymesh/trim/pieces.h"

#include <functional>
#include <vector>

namespace polymesh {

/// What the pieces of a cell are made from.
struct CellInput {
    const Probe& probe;
    const CuttingSurface& cutter;
    const Arrangement& arrangement;
    const PointPositions& positions;
    const CellPieces& pieces;
    std::vector<Label> edgeOfInterval; // see edgeOfIntervals
};

/// The pieces of one cell, joined to groups across the surface edges that are not kept; each group
/// will be one boundary face. Reusable from cell to cell.
class CellGroups {
public:
    struct Face {
        LoopPolygon points;
        Label region = -1;
    };

    using PointTest = std::function<bool(Label)>; // of points of the arrangement

    /// Which pieces of a cell may belong together.
    struct Limit {
        /// Edges sharper than this [rad] stay; one value per surface edge.
        const std::vector<double>& sharpness;
        double sharpest = 0;
        /// No piece of a group may turn from the group's mean normal by more than this [rad]; pi
        /// and more: no limit.
        double cone = 4;
    };

    /// Joins the cell's pieces as far as the limit allows, the flattest edges first.
    void build(const CellInput& input, Label cell, const Limit& limit);

    /// Whether every group has one outline that does not touch itself.
    bool areDiscs() const { return areDiscs_; }

    /// The points at the ends of the intervals that lie between two groups.
    const std::vector<Label>& endsOfBorders() const { return borderEnds_; }

    /// Makes the faces: outlines without the points for which isKept is false, and without the
    /// surface points inside a border between two groups that lie within `tolerance` [m] of it.
    void reduce(const CellInput& input, double tolerance, const PointTest& isKept);

    const std::vector<Face>& faces() const { return faces_; }

    /// Whether the cell of these faces and the polygons of the mesh faces has four faces or more,
    /// with three points or more each, no two with the same points, and a volume. Call after
    /// reduce.
    bool isValid(const CellInput& input, const FaceLoops& loops, const PointTest& isKept) const;

    /// Largest distance of a dropped point from its face [m]. Call after reduce.
    double deviation(const CellInput& input) const;

private:
    struct Entry {
        Label interval;
        Label piece;
    };

    /// Normals of a group: their sum, weighted with the area, and how far one turns from it.
    struct Cone {
        Vec3 sum;
        double angle = 0;
    };

    /// An edge across which two pieces may be joined.
    struct Join {
        double sharpness;
        Label a;
        Label b;
    };

    struct OutlineEdge {
        Label group;
        Label from;
        Label to;
        bool isUsed;
    };

    Label root(Label piece);
    void joinPieces(const CellInput& input, const Limit& limit);
    bool fits(Label a, Label b, double cone);
    void listOutlines(const CellInput& input);
    void walkOutlines(const CellInput& input);
    void keepVertices(const CellInput& input, double tolerance);

    Label cell_ = -1;
    Label firstPiece_ = 0;
    Label pieceCount_ = 0;
    bool areDiscs_ = true;
    std::vector<Label> parent_; // of pieces, for joining
    std::vector<Cone> cones_;   // of the groups' roots
    std::vector<Join> joins_;
    std::vector<Entry> entries_;
    std::vector<OutlineEdge> edges_;
    std::vector<Label> borderEnds_;
    std::vector<Face> faces_;
    std::vector<Label> faceOfPiece_;
    std::vector<Label> keptVertices_; // sorted
};

} // namespace polymesh
