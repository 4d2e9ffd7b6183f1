// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Polyhedra as loops of points, and changes that leave them polyhedra; shared by the tests of
// shapes.

#include "libpolymesh/shapes/catalogue.h"
#include "tests/support/meshes.h"

#include <algorithm>
#include <random>
#include <set>
#include <vector>

namespace polymesh::test {

inline Rows<Label> rowsOf(const Polyhedron& cell) {
    Rows<Label> rows;
    for (const Polygon& loop : cell)
        rows.add(loop);
    return rows;
}

inline Polyhedron polyhedronOf(const Rows<Label>& rows) {
    Polyhedron cell;
    for (Label f = 0; f < rows.size(); ++f)
        cell.emplace_back(rows[f].begin(), rows[f].end());
    return cell;
}

/// A shape of the catalogue; its points have the numbers of the vertices of its base.
inline Polyhedron shapeCell(const CatalogueShape& shape) {
    std::vector<Label> points(tableOf(shape.base).pointCount);
    for (std::size_t v = 0; v < points.size(); ++v)
        points[v] = toLabel(v);
    for (const ShapeEdge& edge : shape.collapsed)
        std::ranges::replace(points, points[edge[1]], Label{points[edge[0]]});
    return polyhedronOf(collapsedFaces(shape.base, points));
}

/// Other labels, faces in another order, each begun at another point; the same polyhedron.
inline Polyhedron renumbered(Polyhedron cell, std::mt19937& random) {
    std::vector<Label> label(100);
    for (std::size_t i = 0; i < label.size(); ++i)
        label[i] = toLabel(1000 + 7 * i);
    std::ranges::shuffle(label, random);
    for (Polygon& loop : cell) {
        for (Label& p : loop)
            p = label[index(p)];
        std::rotate(
            loop.begin(), loop.begin() + static_cast<long>(random() % loop.size()), loop.end());
    }
    std::ranges::shuffle(cell, random);
    return cell;
}

inline Polyhedron mirrorImage(Polyhedron cell) {
    for (Polygon& loop : cell)
        std::ranges::reverse(loop);
    return cell;
}

/// The loops of a polyhedron, each begun at its lowest point: equal for equal polyhedra.
inline std::set<Polygon> loopSet(const Polyhedron& cell) {
    std::set<Polygon> loops;
    for (Polygon loop : cell) {
        std::rotate(loop.begin(), std::ranges::min_element(loop), loop.end());
        loops.insert(loop);
    }
    return loops;
}

inline std::set<Label> pointsOf(const Polyhedron& cell) {
    std::set<Label> points;
    for (const Polygon& loop : cell)
        points.insert(loop.begin(), loop.end());
    return points;
}

/// Cuts one corner away, near it: the corner becomes a face.
inline Polyhedron truncated(const Polyhedron& cell, Label corner, Label firstNew) {
    std::map<Label, Label> newPoint; // by the neighbour of the corner
    std::map<Label, Label> after;    // the walk round the corner
    Polyhedron cut;
    for (const Polygon& loop : cell) {
        Polygon next;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            if (loop[i] != corner) {
                next.push_back(loop[i]);
                continue;
            }
            const Label before = loop[(i + loop.size() - 1) % loop.size()];
            const Label behind = loop[(i + 1) % loop.size()];
            for (const Label p : {before, behind}) {
                const auto [at, isNew] =
                    newPoint.try_emplace(p, firstNew + toLabel(newPoint.size()));
                next.push_back(at->second);
            }
            after[newPoint.at(behind)] = newPoint.at(before);
        }
        cut.push_back(next);
    }
    Polygon lid{after.begin()->first};
    for (Label p = after.at(lid[0]); p != lid[0]; p = after.at(p))
        lid.push_back(p);
    cut.push_back(lid);
    return cut;
}

/// Cuts a face of at least four points from corner i to corner j.
inline Polyhedron withFaceCut(Polyhedron cell, std::size_t face, std::size_t i, std::size_t j) {
    const Polygon loop = cell[face];
    Polygon one;
    Polygon other;
    for (std::size_t k = i; k != (j + 1) % loop.size(); k = (k + 1) % loop.size())
        one.push_back(loop[k]);
    for (std::size_t k = j; k != (i + 1) % loop.size(); k = (k + 1) % loop.size())
        other.push_back(loop[k]);
    cell[face] = one;
    cell.push_back(other);
    return cell;
}

} // namespace polymesh::test
