// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/disjointSets.h"
#include "libpolymesh/trim/bridges.h"
#include "libpolymesh/trim/cellShells.h"
#include "libpolymesh/trim/loops.h"
#include "libpolymesh/trim/pieces.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

namespace polymesh {

/// How much of the surface is joined in one place.
struct JoinLevel {
    double sharpest = 0; // [rad] sharper edges are kept
    /// No piece of a group may turn from the group's mean normal by more than this [rad]; pi and
    /// more: no limit.
    double cone = 4;
};

/// The points of the arrangement that faces keep.
class KeptPoints {
public:
    KeptPoints(const Arrangement& arrangement, std::vector<std::uint8_t>& isNeeded)
        : nodeCount_(arrangement.nodeCount), isNeeded_(isNeeded) {}

    /// Nodes and surface points are kept, crossings and pierces when a face needs them.
    bool operator()(Label point) const {
        const std::size_t k = index(point - nodeCount_);
        if (point < nodeCount_ || k >= isNeeded_.size()) return true;
        return std::atomic_ref<std::uint8_t>(isNeeded_[k]).load(std::memory_order_relaxed) != 0;
    }

    /// Several cells may keep the same point at the same time.
    void keep(Label point) {
        std::atomic_ref<std::uint8_t>(isNeeded_[index(point - nodeCount_)])
            .store(1, std::memory_order_relaxed);
    }

private:
    Label nodeCount_;
    std::vector<std::uint8_t>& isNeeded_;
};

/// What the groups of a cell are made from.
struct CellInput {
    static constexpr std::uint8_t bluntLevel = 0; // all is joined, also across features
    static constexpr std::uint8_t firstLevel = 1; // features are kept: where most cells begin
    static constexpr std::uint8_t lastLevel = 5;  // nothing is joined

    const Probe& probe;
    const CuttingSurface& cutter;
    const Arrangement& arrangement;
    const PointPositions& positions;
    const CellPieces& pieces;
    const std::vector<double>& sharpness; // per surface edge, see Fidelity
    const std::vector<char>& isCorner;    // per surface point
    std::array<JoinLevel, lastLevel + 1> levels;
    std::vector<Label> edgeOfInterval; // see edgeOfIntervals
};

/// The pieces of one cell, joined to groups across the surface edges that are not kept; each group
/// will be one boundary face. Pieces with different levels are not joined. Reusable from cell to
/// cell.
class CellGroups {
public:
    struct Face { // NOLINT(bugprone-exception-escape): boost's move may allocate
        LoopPolygon points;
        Label region = -1;
        Label group = -1;
    };

    /// Joins the cell's pieces as far as their levels allow, the flattest edges first, and takes
    /// groups apart where a feature edge has the same group on both sides.
    /// `levels`: one per piece of all cells.
    void build(const CellInput& input, Label cell, std::vector<std::uint8_t>& levels);

    /// Raises the levels of the pieces of bad groups: those with several outlines, none, or one
    /// that touches itself, and those that checkFaces found bad. False when there was nothing to
    /// raise.
    bool raiseBad();

    /// The points at the ends of the intervals that lie between two groups.
    const std::vector<Label>& endsOfBorders() const { return borderEnds_; }

    /// Makes the faces: outlines without the points that are not kept, and without the surface
    /// points inside a border between two groups that lie within `tolerance` [m] of it.
    void reduce(const CellInput& input, double tolerance, const KeptPoints& kept);

    const std::vector<Face>& faces() const { return faces_; }

    /// Marks groups as bad whose face is farther than `tolerance` [m] from a point that it dropped,
    /// or whose shell of the cell (with the polygons of the mesh faces) has fewer than four faces,
    /// two with the same points, or no volume; all groups where a face has fewer than three points
    /// or an edge is used more than twice. Call after reduce.
    void checkFaces(const CellInput& input,
                    const FaceLoops& loops,
                    double tolerance,
                    const KeptPoints& kept);

private:
    /// A side of a piece.
    struct Entry {
        Label interval;
        Label piece;
        Label side; // see sideOf
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
        Label interval;
    };

    /// A polygon of the cell as it would be.
    struct CellPolygon { // NOLINT(bugprone-exception-escape): boost's move may allocate
        LoopPolygon points;
        bool isTurned;
        Label group; // -1: of a mesh face
    };

    /// A point that the face of a group has dropped.
    struct DroppedPoint {
        Label group;
        Label point;

        // NOLINTNEXTLINE(modernize-use-nullptr): what the compiler makes of it compares with 0
        auto operator<=>(const DroppedPoint&) const = default;
    };

    struct OutlineEdge {
        Label group;
        Label from;
        Label to;
        bool isUsed;
    };

    /// The lowest piece of the group of one.
    Label groupOf(Label piece) { return groups_.lowest(piece); }

    std::uint8_t& levelOf(Label piece) { return (*levels_)[index(firstPiece_ + piece)]; }

    bool isBlunt(Label piece) { return levelOf(piece) == CellInput::bluntLevel; }

    void listJoins(const CellInput& input);
    void joinPieces(const CellInput& input);
    bool fits(Label a, Label b, double cone);
    bool cutAlongFeatures(const CellInput& input);
    void cutGroup(const CellInput& input, Label group);
    void listPolygons(const CellInput& input, const FaceLoops& loops, const KeptPoints& kept);
    void checkShells(const CellInput& input);
    void checkDeviation(const CellInput& input, double tolerance);
    Label sideOf(const CellInput& input, Label piece, std::size_t side) const;
    void pairSides();
    void listOutlines(const CellInput& input);
    void walkOutlines(const CellInput& input);
    std::size_t next(std::size_t at) const;
    void keepVertices(const CellInput& input, double tolerance);

    Label cell_ = -1;
    Label firstPiece_ = 0;
    Label pieceCount_ = 0;
    std::vector<std::uint8_t>* levels_ = nullptr;
    DisjointSets groups_;             // of pieces
    std::vector<std::uint8_t> isBad_; // of the groups' lowest pieces
    std::vector<Cone> cones_;         // of the groups' lowest pieces
    std::vector<Join> joins_;
    std::vector<Join> features_; // edges that must not have one group on both sides
    std::vector<Label> cuts_;    // sorted intervals that are borders to make features borders
    std::vector<Entry> entries_; // sorted
    std::vector<Label> across_;  // per side: the piece on the other side of its interval, or -1
    std::vector<OutlineEdge> edges_;
    std::vector<Label> borderEnds_;
    std::vector<DroppedPoint> dropped_;
    std::vector<Face> faces_;
    std::vector<Label> faceOfPiece_;
    std::vector<Label> keptVertices_; // sorted
    std::vector<CellPolygon> polygons_;
    CellShells shells_;
};

} // namespace polymesh
