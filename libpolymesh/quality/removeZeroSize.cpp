// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/removeZeroSize.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/collapsePoints.h"
#include "libpolymesh/quality/mergeCells.h"
#include "libpolymesh/quality/polygons.h"

#include <algorithm>
#include <optional>

namespace polymesh {

namespace {

constexpr double roundOff = 1e-10;       // of a cell's size
constexpr double roundOffVolume = 1e-12; // of the cube of a cell's size

/// Where a face runs back along itself: at `tip` the edges to `near` and `far` have one direction.
struct Spike {
    Label tip = -1;
    Label near = -1;
    Label far = -1; // -1: near and tip are one point
};

/// Two neighbours of a corner as seen from it: does the nearer lie on the edge to the farther?
std::optional<Spike>
spikeAt(const EditMesh& mesh, Label before, Label tip, Label after, double tolerance) {
    const Vec3& origin = mesh.points[index(tip)];
    const Vec3 u = mesh.points[index(before)] - origin;
    const Vec3 v = mesh.points[index(after)] - origin;
    const double uLength = norm(u);
    const double vLength = norm(v);
    if (vLength <= tolerance) return Spike{tip, after, -1};
    if (uLength <= tolerance) return Spike{tip, before, -1};
    if (dot(u, v) <= 0) return std::nullopt;
    const double longer = std::max(uLength, vLength);
    if (norm(cross(u, v)) > tolerance * longer) return std::nullopt;
    return uLength < vLength ? Spike{tip, before, after} : Spike{tip, after, before};
}

std::optional<Spike> findSpike(const EditMesh& mesh, Label f) {
    const EditFace& face = mesh.faces[index(f)];
    if (face.isRemoved()) return std::nullopt;
    const double tolerance = roundOff * mesh.cells[index(face.owner)].size;
    const std::size_t n = face.points.size();
    for (std::size_t i = 0; i < n; ++i) {
        const auto spike = spikeAt(mesh,
                                   face.points[(i + n - 1) % n],
                                   face.points[i],
                                   face.points[(i + 1) % n],
                                   tolerance);
        if (spike) return spike;
    }
    return std::nullopt;
}

/// Makes two points with the same place one: the one of the lower rank goes.
bool joinPoints(MeshEditor& editor, Label a, Label b) {
    const Label gone = editor.rank(a) <= editor.rank(b) ? a : b;
    if (editor.rank(gone) == PointRank::fixed) return false;
    const MeshEditor::Mark mark = editor.mark();
    if (replacePoint(editor, gone, gone == a ? b : a) == 0) return true;
    editor.undoTo(mark);
    return false;
}

/// Removes the spikes of a face one by one; the parts into which the face falls are added to
/// `queue`.
void removeSpikes(MeshEditor& editor, Label f, std::vector<Label>& queue, ZeroSizeCounts& counts) {
    const auto spike = findSpike(editor.mesh(), f);
    if (!spike) return;
    const Label before = editor.faceCount();
    bool done = false;
    if (spike->far < 0) {
        done = joinPoints(editor, spike->tip, spike->near);
        counts.points += done;
    } else if (norm(editor.point(spike->near) - editor.point(spike->far)) <=
               roundOff * editor.cell(editor.face(f).owner).size) {
        done = joinPoints(editor, spike->near, spike->far);
        counts.points += done;
    } else {
        done = insertPointInEdge(editor, spike->tip, spike->far, spike->near);
        counts.edges += done;
    }
    editor.commit();
    if (!done) return;
    queue.push_back(f);
    for (Label part = before; part < editor.faceCount(); ++part)
        queue.push_back(part);
}

void removeAllSpikes(MeshEditor& editor, ZeroSizeCounts& counts) {
    std::vector<std::uint8_t> flagged(index(editor.faceCount()), 0);
    parallelFor(editor.faceCount(),
                [&](Label f) { flagged[index(f)] = findSpike(editor.mesh(), f).has_value(); });
    std::vector<Label> queue;
    for (std::size_t f = 0; f < flagged.size(); ++f) {
        if (!flagged[f]) continue;
        queue.assign(1, toLabel(f));
        // Each step removes a point or a spike; the bound is for coordinates that make no sense.
        for (int step = 0; !queue.empty() && step < 1000; ++step) {
            const Label next = queue.back();
            queue.pop_back();
            removeSpikes(editor, next, queue, counts);
        }
    }
}

/// Merges a flat cell into the first partner that accepts it; a ball is wanted, closed will do.
bool mergeFlatCell(MeshEditor& editor, Label c) {
    for (const MergePartner& partner : mergePartners(editor, c)) {
        const MeshEditor::Mark mark = editor.mark();
        mergeCells(editor, c, partner.cell);
        std::vector<Label> touched{partner.cell};
        const CollapseCounts tidied = tidyCells(editor, touched);
        if (tidied.brokenCells == 0 && tidied.addedCells == 0 &&
            !editor.cell(partner.cell).isRemoved())
            return true;
        editor.undoTo(mark);
    }
    return false;
}

/// Removes a flat cell that only has boundary faces: it lies between the surface and the boundary
/// of the mesh, where they touch. False for a cell with neighbours.
bool removeLoneCell(MeshEditor& editor, Label c) {
    const auto faces = editor.cell(c).faces; // a copy: the list is emptied
    if (!std::all_of(
            faces.begin(), faces.end(), [&](Label f) { return editor.face(f).isBoundary(); }))
        return false;
    for (const Label f : faces)
        editor.removeFace(f);
    return true;
}

/// Without volume, or with so few faces that only their bend gives it one.
bool isFlat(MeshEditor& editor, Label c) {
    const EditCell& cell = editor.cell(c);
    return cell.faces.size() < 4 ||
           editor.cellGeometry(c).volume <= roundOffVolume * cell.size * cell.size * cell.size;
}

void mergeFlatCells(MeshEditor& editor, ZeroSizeCounts& counts) {
    editor.computeGeometry();
    for (Label c = 0; c < editor.cellCount(); ++c) {
        const EditCell& cell = editor.cell(c);
        if (cell.frozen || cell.isRemoved()) continue;
        if (!isFlat(editor, c)) continue;
        const bool merged = removeLoneCell(editor, c) || mergeFlatCell(editor, c);
        editor.commit();
        ++(merged ? counts.cells : counts.remainingCells);
    }
}

} // namespace

bool insertPointInEdge(MeshEditor& editor, Label a, Label b, Label p) {
    if (editor.rank(a) == PointRank::fixed && editor.rank(b) == PointRank::fixed) return false;
    std::vector<Label> faces;
    for (const Label f : editor.facesOfPoint(a))
        if (hasEdge(editor.face(f).points, a, b)) faces.push_back(f);
    std::vector<Label> cells;
    for (const Label f : faces) {
        if (editor.isFrozenFace(f)) return false;
        cells.push_back(editor.face(f).owner);
        if (editor.face(f).neighbour >= 0) cells.push_back(editor.face(f).neighbour);
        Polygon walk = editor.face(f).points;
        auto at = std::find(walk.begin(), walk.end(), a);
        const bool forward = cornerAfter(walk, a) == b;
        walk.insert(forward ? at + 1 : at, p);
        setFaceWalk(editor, f, walk);
    }
    tidyCells(editor, cells);
    return true;
}

Label replacePoint(MeshEditor& editor, Label from, Label to) {
    const std::vector<Label> faces(editor.facesOfPoint(from).begin(),
                                   editor.facesOfPoint(from).end());
    const std::vector<Label> cells = cellsOfPoint(editor, from);
    for (const Label f : faces) {
        Polygon walk = editor.face(f).points;
        std::replace(walk.begin(), walk.end(), from, to);
        setFaceWalk(editor, f, walk);
    }
    const CollapseCounts counts = tidyCells(editor, cells);
    return counts.addedCells + counts.brokenCells;
}

ZeroSizeCounts removeZeroSize(MeshEditor& editor) {
    ZeroSizeCounts counts;
    removeAllSpikes(editor, counts);
    mergeFlatCells(editor, counts);
    return counts;
}

} // namespace polymesh
