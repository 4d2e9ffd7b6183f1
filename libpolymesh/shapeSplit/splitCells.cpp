// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapeSplit/splitCells.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/quality/meshPart.h"
#include "libpolymesh/quality/starPoint.h"
#include "libpolymesh/shapeSplit/editedShape.h"
#include "libpolymesh/shapeSplit/faceCuts.h"
#include "libpolymesh/shapeSplit/innerPoint.h"
#include "libpolymesh/shapeSplit/makeStarShaped.h"
#include "libpolymesh/shapeSplit/splitTogether.h"
#include "libpolymesh/shapes/recognise.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <tuple>

namespace polymesh {

namespace {

/// What may be done in one pass over the cells.
struct Effort {
    CutEffort cut;
    bool mayFold = false; // take a point behind all faces where none sees them all
};

/// What of a mesh has to stay where it is.
struct Bounds {
    std::vector<Label> cellGroup;           // [cell] equal for cells that are in the same zones
    std::vector<std::uint8_t> isFaceInZone; // [face]
};

/// Splits cells of a mesh that is being edited.
class Splitter {
public:
    Splitter(MeshEditor& editor,
             const Bounds& bounds,
             const Effort& effort,
             ShapeSplitCounts& counts)
        : editor_(editor), bounds_(bounds), effort_(effort), counts_(counts) {}

    void split(const std::vector<Label>& cells) {
        waiting_ = cells;
        for (std::size_t i = 0; i < waiting_.size(); ++i)
            cutLargeFaces(waiting_[i]);
        // A cut may lead to cuts of neighbours, but not for ever.
        Label cutsLeft = 100 + toLabel(waiting_.size());
        for (std::size_t i = 0; i < waiting_.size() && cutsLeft > 0; ++i)
            if (cutUnlessStarShaped(waiting_[i])) --cutsLeft;
        waiting_.insert(waiting_.end(), parts_.begin(), parts_.end());
        std::ranges::sort(waiting_);
        waiting_.erase(std::unique(waiting_.begin(), waiting_.end()), waiting_.end());
        for (const Label cell : waiting_)
            makePyramidsOf(cell);
    }

private:
    void cutLargeFaces(Label cell) {
        const MeshEditor::Mark mark = editor_.mark();
        const auto faces = editor_.cell(cell).faces; // a copy: cutting changes the list
        for (const Label f : faces) {
            const std::size_t size = editor_.face(f).points.size();
            if (size <= maxShapeFacePoints) continue;
            const bool cut = cutLargeFace(f, size);
            counts_.splitFaces += cut ? 1 : 0;
        }
        if (!arePositive(editor_, mark)) editor_.undoTo(mark);
        for (const Label c : editor_.reshapedSince(mark))
            if (c != cell) wait(c);
        editor_.commit();
    }

    bool cutLargeFace(Label f, std::size_t size) {
        if (!editor_.face(f).isBoundary() || isPlane(editor_, f))
            return cutByChords(editor_, f, maxShapeFacePoints);
        const std::size_t parts = (size + 3) / 4; // each has two points more than edges
        return cutFromMiddle(editor_, f, parts) ||
               cutByChordsKeepingVolume(editor_, f, maxShapeFacePoints) ||
               cutFromMiddle(editor_, f, size) || cutFromMiddle(editor_, f, parts, Parts::any) ||
               cutFromMiddle(editor_, f, size, Parts::any);
    }

    bool cutUnlessStarShaped(Label cell) {
        if (isAcceptable(editor_, cell) || innerPoint(editor_, cell)) return false;
        if (splitWithNeighbour(cell, false)) return false;
        const MeshEditor::Mark mark = editor_.mark();
        const std::vector<Label> parts = makeStarShaped(editor_, cell, effort_.cut);
        if (parts.empty()) return false;
        ++counts_.cutCells;
        parts_.insert(parts_.end(), parts.begin(), parts.end());
        for (const Label c : editor_.reshapedSince(mark))
            if (std::ranges::find(parts, c) == parts.end()) wait(c);
        editor_.commit();
        return true;
    }

    /// Cells of different zones stay apart, and so do those with a face of a zone between them.
    bool mayUnite(Label cell, Label other) const {
        const auto groupOf = [&](Label c) {
            return bounds_.cellGroup[index(editor_.cell(c).origin)];
        };
        if (editor_.isFrozen(other) || groupOf(cell) != groupOf(other)) return false;
        return std::ranges::none_of(editor_.cell(cell).faces, [&](Label f) {
            const Label source = editor_.face(f).patch;
            return editor_.otherCell(f, cell) == other && source >= 0 &&
                   bounds_.isFaceInZone[index(source)];
        });
    }

    /// Neighbours that have to be split anyway come first, then those with fewer faces.
    bool splitWithNeighbour(Label cell, bool mayFold) {
        std::vector<std::tuple<bool, std::size_t, Label>> neighbours;
        for (const Label f : editor_.cell(cell).faces) {
            const Label other = editor_.otherCell(f, cell);
            if (other >= 0 && mayUnite(cell, other))
                neighbours.emplace_back(
                    isAcceptable(editor_, other), editor_.cell(other).faces.size(), other);
        }
        std::ranges::sort(neighbours);
        neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
        for (const auto& neighbour : neighbours)
            if (splitTogether(editor_, cell, std::get<Label>(neighbour), mayFold)) {
                ++counts_.unitedCells;
                editor_.commit();
                return true;
            }
        return false;
    }

    /// A cell whose faces have changed may need to be split now.
    void wait(Label cell) {
        if (!editor_.isFrozen(cell)) waiting_.push_back(cell);
    }

    void makePyramidsOf(Label cell) {
        if (isAcceptable(editor_, cell) || hasLargeFace(editor_, cell)) return;
        auto apex = innerPoint(editor_, cell);
        if (!apex && effort_.mayFold) {
            apex = pointBehindFaces(editor_, cell);
            counts_.foldedCells += apex ? 1 : 0;
        }
        if (apex)
            makePyramids(editor_, cell, *apex);
        else if (effort_.mayFold && splitWithNeighbour(cell, true))
            ++counts_.foldedCells;
        editor_.commit();
    }

    MeshEditor& editor_;
    const Bounds& bounds_;
    Effort effort_;
    ShapeSplitCounts& counts_;
    std::vector<Label> waiting_;
    std::vector<Label> parts_; // of cells that have been cut
};

Bounds boundsOf(const PolyMesh& mesh) {
    Bounds bounds{std::vector<Label>(index(mesh.cellCount), 0),
                  std::vector<std::uint8_t>(index(mesh.faceCount()), 0)};
    for (const Zone& zone : mesh.faceZones)
        for (const Label f : zone.labels)
            bounds.isFaceInZone[index(f)] = 1;
    Label groups = 1;
    for (const Zone& zone : mesh.cellZones) {
        std::map<Label, Label> inZone; // by the group without it
        for (const Label c : zone.labels) {
            Label& group = bounds.cellGroup[index(c)];
            const auto [at, isNew] = inZone.try_emplace(group, groups);
            groups += isNew ? 1 : 0;
            group = at->second;
        }
    }
    return bounds;
}

std::vector<Label> unacceptableCells(const PolyMesh& mesh) {
    const Rows<Label> faces = cellFaces(mesh);
    std::vector<std::uint8_t> bad(index(mesh.cellCount), 0);
    parallelFor(mesh.cellCount, [&](Label c) { bad[index(c)] = !recognise(mesh, faces[c], c); });
    std::vector<Label> cells;
    for (std::size_t c = 0; c < bad.size(); ++c)
        if (bad[c]) cells.push_back(toLabel(c));
    return cells;
}

std::vector<Label> withFaceNeighbours(const PolyMesh& mesh, const std::vector<Label>& cells) {
    std::vector<std::uint8_t> centre(index(mesh.cellCount), 0);
    for (const Label c : cells)
        centre[index(c)] = 1;
    std::vector<std::uint8_t> chosen = centre;
    for (Label f = 0; f < mesh.internalFaceCount(); ++f) {
        const std::size_t a = index(mesh.owner[index(f)]);
        const std::size_t b = index(mesh.neighbour[index(f)]);
        if (centre[a]) chosen[b] = 1;
        if (centre[b]) chosen[a] = 1;
    }
    std::vector<Label> all;
    for (std::size_t c = 0; c < chosen.size(); ++c)
        if (chosen[c]) all.push_back(toLabel(c));
    return all;
}

/// Splits the cells once; what a cut has made unacceptable at the rim of the part is left.
void splitPass(PolyMesh& mesh,
               const std::vector<Label>& cells,
               const Effort& effort,
               ShapeSplitCounts& counts,
               std::vector<Label>& origins) {
    MeshPart part = partRound(mesh, withFaceNeighbours(mesh, cells));
    std::vector<Label> inPart;
    for (const Label c : cells)
        inPart.push_back(
            static_cast<Label>(std::ranges::lower_bound(part.cells, c) - part.cells.begin()));
    MeshEditor editor(part.mesh);
    editor.computeGeometry();
    const Bounds bounds = boundsOf(mesh);
    Splitter(editor, bounds, effort, counts).split(inPart);
    JoinedPart joined = withPart(mesh, part);
    for (Label& origin : joined.origins)
        origin = origins[index(origin)];
    origins = std::move(joined.origins);
    mesh = std::move(joined.mesh);
}

} // namespace

ShapeSplitCounts splitUnacceptableCells(PolyMesh& mesh, std::vector<Label>* origins) {
    ShapeSplitCounts counts;
    const Label oldCells = mesh.cellCount;
    const Label oldPoints = mesh.pointCount();
    std::vector<Label> cells = unacceptableCells(mesh);
    counts.splitCells = toLabel(cells.size());
    std::vector<Label> from(index(mesh.cellCount));
    for (std::size_t c = 0; c < from.size(); ++c)
        from[c] = toLabel(c);
    // Few cells are left after the first pass; they are worth more.
    for (const Effort& effort : {Effort{},
                                 Effort{{12, 20, 400, true}, false},
                                 Effort{{}, true},
                                 Effort{{}, true},
                                 Effort{{}, true}}) {
        if (cells.empty()) break;
        splitPass(mesh, cells, effort, counts, from);
        cells = unacceptableCells(mesh);
    }
    counts.newCells = mesh.cellCount - oldCells;
    counts.newPoints = mesh.pointCount() - oldPoints;
    counts.remaining = std::move(cells);
    if (origins) *origins = std::move(from);
    return counts;
}

} // namespace polymesh
