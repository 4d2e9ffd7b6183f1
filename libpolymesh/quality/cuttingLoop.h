// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/meshEditor.h"

#include <optional>
#include <vector>

namespace polymesh {

/// A corner of a loop on the surface of a cell: a point, or the place where a plane crosses an
/// edge.
struct LoopCorner {
    Label point = -1; // -1: on the edge low-high, at `position`
    Label low = -1;
    Label high = -1;
    Vec3 position;         // [m]
    double offPlane = 0;   // [m] distance from the plane: of points that were taken though near it
    Label faceToNext = -1; // the face to cut from here to the next corner; -1: they share an edge
};

/// A closed walk on the surface of a cell, along edges and across faces, that cuts it in two.
using CellLoop = std::vector<LoopCorner>;

/// Loops without common points that together cut a cell in two: one for a ball; two for a cell with
/// a hole through it that is cut open.
using CellCut = std::vector<CellLoop>;

/// A plane through an edge of a cell.
struct EdgePlane {
    Label a = -1; // the edge's points
    Label b = -1;
    Vec3 normal; // unit
};

/// What a loop may not use: the edges at which the surface does not need to be cut.
using EdgeList = std::vector<std::pair<Label, Label>>;

/// Finds loops on the surface of one cell along planes; what all planes need is gathered once.
class LoopFinder {
public:
    LoopFinder(MeshEditor& editor, Label cell);

    /// The shortest loop through the edge of the plane along which the plane cuts the surface of
    /// the cell; points nearer to the plane than `snap` times the length of a crossed edge are
    /// taken instead of a crossing. Weights: 1 a step, and more the farther a corner is from the
    /// plane. No loop where the plane does not close one or where it would cut a frozen face.
    /// Requires: the cell is as it was at construction (changes taken back do not matter).
    /// Cost: linear in the corners of the cell but for the search, which is quadratic in those of
    /// the loop's plane.
    std::optional<CellLoop> find(const EdgePlane& plane, double snap, const EdgeList& forbidden);

    /// Further loops in the plane of the loop that was found last, which have no point in common
    /// with it nor with each other.
    std::vector<CellLoop> loopsBeside(const CellLoop& found) const;

    /// True when a closed curve on the cell always cuts it in two: no holes through it.
    bool isBall() const { return isBall_; }

private:
    struct CellPoint {
        Label point = -1;
        double offPlane = 0;
        bool onPlane = false;
        std::size_t corner = 0; // its place in corners_ if it is on the plane
    };

    struct CellEdge {
        std::size_t low = 0; // places in points_
        std::size_t high = 0;
        bool isCrossed = false;
        std::size_t corner = 0; // its place in corners_ if it is crossed
    };

    /// A step between two corners, by position in the list of corners.
    struct Step {
        std::size_t from = 0;
        std::size_t to = 0;
        Label face = -1; // to be cut; -1: along an edge
    };

    std::size_t placeOf(Label p) const;
    const CellEdge& edgeOf(Label p, Label q) const;
    double crossingWeight(const CellEdge& edge) const;
    void placePlane(double snap);
    void addCorners();
    void addEdgeSteps(const EdgeList& forbidden);
    void addFaceSteps(Label f);
    double weightOf(std::size_t corner) const;
    std::optional<CellLoop>
    shortestWay(std::size_t start, std::size_t goal, const std::vector<bool>& taken) const;
    CellLoop
    walkBack(std::size_t start, std::size_t goal, const std::vector<std::size_t>& stepTo) const;

    MeshEditor& editor_;
    Label cell_;
    double size_;
    bool isBall_ = false;
    EdgePlane plane_;
    std::vector<CellPoint> points_; // by label
    std::vector<CellEdge> edges_;   // by labels
    std::vector<LoopCorner> corners_;
    std::vector<Step> steps_;
};

/// True when p, in the plane of the polygon or near it, is inside, seen along the normal's largest
/// component.
bool isInsidePolygon(const MeshEditor& editor,
                     const Polygon& polygon,
                     const Vec3& normal,
                     const Vec3& p);

/// The loop of one plane.
std::optional<CellLoop> findCuttingLoop(
    MeshEditor& editor, Label cell, const EdgePlane& plane, double snap, const EdgeList& forbidden);

} // namespace polymesh
