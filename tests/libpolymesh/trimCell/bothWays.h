// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The mesh-based way and the cell-based one side by side.

#include "libpolymesh/trim/trim.h"
#include "libpolymesh/trimCell/cutByCells.h"
#include "tests/libpolymesh/trim/arranged.h"
#include "tests/support/meshes.h"
#include "tests/support/surfaces.h"
#include "tests/support/trimOptions.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <utility>

namespace polymesh::test {

inline bool areSame(const EdgeCrossing& a, const EdgeCrossing& b) {
    return a.triangle == b.triangle && a.sign == b.sign && a.zeros == b.zeros;
}

inline bool areSame(const FacePierce& a, const FacePierce& b) {
    return a.edge == b.edge && a.facet == b.facet && a.sign == b.sign && a.zeros == b.zeros;
}

inline bool areSame(const Segment& a, const Segment& b) {
    return a.triangle == b.triangle && a.from == b.from && a.to == b.to;
}

template<class T>
bool areSame(const Rows<T>& a, const Rows<T>& b) {
    return a.offsets == b.offsets &&
           std::ranges::equal(
               a.values, b.values, [](const T& x, const T& y) { return areSame(x, y); });
}

/// What the first difference between two cuts is about; empty when there is none.
inline std::string differenceOf(const Arrangement& a, const Arrangement& b) {
    if (!areSame(a.crossings, b.crossings)) return "crossings";
    if (a.winding != b.winding) return "nodes";
    if (!areSame(a.pierces, b.pierces)) return "pierces";
    if (!areSame(a.segments, b.segments)) return "segments";
    if (a.surfacePierces != b.surfacePierces || a.pierceRank != b.pierceRank)
        return "order of pierces";
    return a.vertexCell == b.vertexCell ? "" : "surface points";
}

inline std::string differenceOf(const FaceLoops& a, const FaceLoops& b) {
    if (a.offsets != b.offsets || a.polygons != b.polygons) return "faces";
    return a.isNeeded == b.isNeeded && a.holeCount == b.holeCount ? "" : "holes";
}

inline std::string differenceOf(const CellPieces& a, const CellPieces& b) {
    const bool isSame = a.offsets == b.offsets && a.polygons == b.polygons &&
                        a.intervals == b.intervals && a.triangle == b.triangle;
    return isSame ? "" : "pieces";
}

/// How the exact cuts of both ways differ, compared to the last label; empty when they do not.
inline std::string
differenceOfWays(const PolyMesh& mesh, const TriSurface& surface, Keep keep = Keep::inside) {
    const Arranged byMesh(mesh, surface, keep == Keep::outside);
    const CellPieces pieces = cutTriangles(byMesh.probe, byMesh.cutter, byMesh.arrangement);
    TrimOptions options;
    options.keep = keep;
    PolyMesh initial = mesh;
    const SurfaceFeatures features = findFeatures(byMesh.surface, byMesh.cutter.edges, 0.5);
    const MeshCut byCells = findCutByCells(initial, {byMesh.cutter, features}, {}, options);
    if (byMesh.cellWinding != byCells.cellWinding) return "far cells";
    for (const std::string& difference : {differenceOf(byMesh.arrangement, byCells.arrangement),
                                          differenceOf(byMesh.loops, byCells.faces->loops),
                                          differenceOf(pieces, byCells.faces->pieces)})
        if (!difference.empty()) return difference;
    return byMesh.positions == byCells.positions ? "" : "positions";
}

/// Fails unless both ways give the same cut, inside and outside.
inline void
expectSameCut(const PolyMesh& mesh, const TriSurface& surface, const std::string& name) {
    EXPECT_EQ(differenceOfWays(mesh, surface), "") << name << ", inside";
    EXPECT_EQ(differenceOfWays(mesh, surface, Keep::outside), "") << name << ", outside";
}

inline PolyMesh trimByCells(const PolyMesh& mesh, const TriSurface& surface, TrimOptions options) {
    options.findCut = findCutByCells;
    return trim(mesh, surface, options).mesh;
}

/// A part with dents and bumps: a sphere whose points go in and out by up to `roughness`.
inline TriSurface
dentedSphere(int divisions, const Vec3& centre, double radius, double roughness, unsigned seed) {
    std::mt19937 random(seed);
    TriSurface surface = sphere(divisions);
    for (Vec3& p : surface.points) {
        const double in = roughness * static_cast<double>(random()) / 4294967296.0;
        p = centre + radius * (1 - in) * p;
    }
    return surface;
}

} // namespace polymesh::test
