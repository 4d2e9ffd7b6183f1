// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/mps/midPointSubdivision.h"
#include "libpolymesh/mps/triangleHull.h"
#include "libpolymesh/mps/triangulate.h"

#include <set>
#include <span>
#include <vector>

namespace polymesh {

/// How faces of a mesh may become triangles, by diagonals or with their middles, which the plan
/// has; for both their cells. Diagonals join no points that are joined already, nor twice.
class TriangulatedFaces {
public:
    /// A face and whether its loop runs as seen from outside.
    struct SeenFace {
        Label face;
        bool isOutward;
    };

    /// For each of `faces` (ascending) the triangles that both its cells see best.
    /// Cost: about 5 us a face; parallel.
    TriangulatedFaces(const PolyMesh& mesh, const SubdivisionPlan& plan, std::vector<Label> faces);

    /// Puts other triangles in place of those that cross others of the same cell, for `cells`,
    /// where that helps; cells on both sides count. Cost: some ms for a cell with such.
    void avoidCrossings(std::span<const Label> cells);

    /// Triangles with -1 for the face's middle; of a face that is not among `faces` those from its
    /// middle.
    std::vector<Triangle> of(Label face) const;

    /// The triangles of some faces. Their middles are the points behind those of the mesh.
    TriangleHull hullOf(std::span<const SeenFace> faces) const;

    TriangleHull hullOf(Label cell) const;

private:
    using Triangles = std::vector<Triangle>;

    struct Choice {
        Triangles triangles;
        std::vector<Edge> diagonals;
    };

    void findViewPoints();
    void findTriangles();
    Vec3 viewPoint(Label cell) const;
    const Vec3& viewOf(Label cell) const;
    const Vec3& middleOf(Label face) const;
    bool areJoined(Label a, Label b) const;
    double qualityOf(Label face, const Vec3& a, const Vec3& b, const Vec3& c) const;
    double worstOf(Label face, const Triangles& triangles) const;
    Triangles fanOf(Label face) const;
    Triangles bestTriangles(Label face, const MayJoin& isFree) const;
    std::vector<Edge> newEdges(const Triangles& triangles) const;
    std::vector<Choice> choicesFor(Label face) const;
    Label crossingsBeside(Label face) const;
    std::vector<Label> crossingFaces(Label cell) const;
    Triangles released(Label face);
    void give(Label face, Triangles triangles);
    void chooseOneByOne(Label cell);
    void choosePairs(Label cell);
    void choosePair(Label cell, Label one, Label other);
    void addTriangles(const SeenFace& seen, TriangleHull& hull) const;
    Triangles* find(Label face);

    const PolyMesh& mesh_;
    const SubdivisionPlan& plan_;
    std::vector<Label> faces_;         // ascending
    std::vector<Triangles> triangles_; // beside faces_
    std::set<Edge> added_;             // their diagonals
    std::vector<Label> viewCells_;     // ascending
    std::vector<Vec3> views_;          // [m] beside viewCells_
};

} // namespace polymesh
