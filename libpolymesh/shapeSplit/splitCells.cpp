// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapeSplit/splitCells.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/quality/editQuality.h"
#include "libpolymesh/quality/meshPart.h"
#include "libpolymesh/quality/starPoint.h"
#include "libpolymesh/shapeSplit/editedShape.h"
#include "libpolymesh/shapeSplit/faceCuts.h"
#include "libpolymesh/shapeSplit/goodPieces.h"
#include "libpolymesh/shapeSplit/innerPoint.h"
#include "libpolymesh/shapeSplit/makeStarShaped.h"
#include "libpolymesh/shapeSplit/mendPieces.h"
#include "libpolymesh/shapeSplit/splitTogether.h"
#include "libpolymesh/shapeSplit/unsuitableFaces.h"
#include "libpolymesh/shapes/recognise.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <span>
#include <tuple>

namespace polymesh {

namespace {

/// What may be done in one pass over the cells.
struct Effort {
    CutEffort cut;
    bool mayFold = false; // take a point behind all faces where none sees them all
    const Tetrahedraliser* tetrahedralise = nullptr;
};

/// What of a mesh has to stay where it is.
struct Bounds {
    std::vector<Label> cellGroup;           // [cell] equal for cells that are in the same zones
    std::vector<std::uint8_t> isFaceInZone; // [face]
    std::vector<std::uint8_t> isFragile;    // [cell] not to be cut
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
        firstNewCell_ = editor_.cellCount();
        firstNewPoint_ = toLabel(editor_.mesh().points.size());
        for (const Label c : failingCells(editor_))
            if (isAcceptable(editor_, c)) tolerated_.push_back(c);
        forAllWaiting([&](Label cell) { cutFacesThatAreTooLarge(cell); });
        forAllWaiting([&](Label cell) {
            counts_.splitFaces += cutConcaveFaces(editor_, cell);
            editor_.commit();
        });
        // A cut may lead to cuts of neighbours, but not for ever.
        Label cutsLeft = 100 + toLabel(waiting_.size());
        forAllWaiting([&](Label cell) {
            if (cutsLeft > 0 && cutUnlessStarShaped(cell)) --cutsLeft;
        });
        waiting_.insert(waiting_.end(), parts_.begin(), parts_.end());
        std::ranges::sort(waiting_);
        waiting_.erase(std::unique(waiting_.begin(), waiting_.end()), waiting_.end());
        for (const Label cell : waiting_)
            makePyramidsOf(cell);
        mend();
    }

private:
    /// What checkMesh would fail of what this pass has made.
    void mend() {
        static const Tetrahedraliser noTetrahedra;
        MendMeans means;
        means.firstNewCell = firstNewCell_;
        means.firstNewPoint = firstNewPoint_;
        means.mayUnite = [&](Label a, Label b) { return mayUnite(a, b); };
        means.tetrahedralise = effort_.tetrahedralise ? effort_.tetrahedralise : &noTetrahedra;
        means.tolerated = tolerated_;
        counts_.mends += mendPieces(editor_, means);
    }

    /// Works on the waiting cells in turn, and then on those that the work has made wait.
    template<class Work>
    void forAllWaiting(const Work& work) {
        std::size_t done = 0;
        while (done < waiting_.size())
            work(Label{waiting_[done++]}); // a copy: the list may grow, and move
    }

    void cutFacesThatAreTooLarge(Label cell) {
        const MeshEditor::Mark mark = editor_.mark();
        counts_.splitFaces += cutLargeFaces(editor_, cell);
        for (const Label c : editor_.reshapedSince(mark))
            if (c != cell) wait(c);
        editor_.commit();
    }

    bool cutUnlessStarShaped(Label cell) {
        if (isAcceptable(editor_, cell) || innerPoint(editor_, cell)) return false;
        if (bounds_.isFragile[index(editor_.cell(cell).origin)]) {
            foldPyramids(cell);
            return false;
        }
        if (fill(cell) || splitWithNeighbour(cell)) return false;
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

    /// Tetrahedra in the cell, or in the cell united with those beyond the faces that are in the
    /// way, or with these faces cut into triangles.
    bool fill(Label cell) {
        if (!effort_.tetrahedralise || !*effort_.tetrahedralise) return false;
        constexpr int tries = 6;
        std::vector<Label> others;
        std::vector<Label> refused; // cannot be united with the cell
        std::vector<Label> inTheWay;
        for (int i = 0; i < tries; ++i) {
            if (const auto filled = fillTogether(editor_, cell, others, *effort_.tetrahedralise)) {
                if (!filled->pieces.empty()) {
                    ++counts_.filledCells;
                    editor_.commit();
                    return true;
                }
                inTheWay = filled->inTheWay;
            } else {
                if (others.empty()) return false; // the cell itself is not a ball
                refused.push_back(others.back());
                others.pop_back();
            }
            const Label next = cellBeyond(inTheWay, cell, others, refused);
            if (next < 0) break;
            others.push_back(next);
        }
        return fillWithFacesCut(cell);
    }

    /// The first cell beyond some faces of a cell that is united with others with which these may
    /// be united too and have not been refused; -1: there is none.
    Label cellBeyond(const std::vector<Label>& faces,
                     Label cell,
                     const std::vector<Label>& others,
                     const std::vector<Label>& refused) const {
        const auto has = [](const std::vector<Label>& list, Label c) {
            return std::ranges::find(list, c) != list.end();
        };
        const auto isInside = [&](Label c) { return c == cell || has(others, c); };
        for (const Label f : faces) {
            const EditFace& face = editor_.face(f);
            if (face.isRemoved() || face.isBoundary()) continue;
            for (const auto& [inner, outer] :
                 {std::pair{face.owner, face.neighbour}, std::pair{face.neighbour, face.owner}})
                if (isInside(inner) && !isInside(outer) && !has(refused, outer) &&
                    mayUnite(inner, outer))
                    return outer;
        }
        return -1;
    }

    /// Tetrahedra where shared faces are cut into triangles, so that neighbours have to be split.
    bool fillWithFacesCut(Label cell) {
        const MeshEditor::Mark mark = editor_.mark();
        const auto faces = editor_.cell(cell).faces; // a copy: cutting changes the list
        for (const Label f : faces)
            if (!editor_.face(f).isBoundary()) cutByChords(editor_, f, 3);
        if (!areSound(editor_, mark) ||
            fillWithTetrahedra(editor_, cell, *effort_.tetrahedralise).pieces.empty()) {
            editor_.undoTo(mark);
            return false;
        }
        ++counts_.filledCells;
        for (const Label c : editor_.reshapedSince(mark))
            wait(c);
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

    /// The neighbours of some cells with which they may be united: those that have to be split
    /// anyway first, then those with fewer faces.
    std::vector<Label> partnersOf(const std::vector<Label>& cells) const {
        std::vector<std::tuple<bool, std::size_t, Label>> partners;
        for (const Label cell : cells)
            for (const Label f : editor_.cell(cell).faces) {
                const Label other = editor_.otherCell(f, cell);
                if (other < 0 || !mayUnite(cell, other) ||
                    std::ranges::find(cells, other) != cells.end())
                    continue;
                partners.emplace_back(
                    isAcceptable(editor_, other), editor_.cell(other).faces.size(), other);
            }
        std::ranges::sort(partners);
        partners.erase(std::unique(partners.begin(), partners.end()), partners.end());
        std::vector<Label> labels;
        labels.reserve(partners.size());
        for (const auto& partner : partners)
            labels.push_back(std::get<Label>(partner));
        return labels;
    }

    bool splitWith(Label cell, const std::vector<Label>& others, bool mayFold) {
        if (!splitTogether(editor_, cell, others, mayFold)) return false;
        ++counts_.unitedCells;
        editor_.commit();
        return true;
    }

    bool splitWithNeighbour(Label cell) {
        return std::ranges::any_of(partnersOf({cell}),
                                   [&](Label other) { return splitWith(cell, {other}, false); });
    }

    /// The last resort: more and more cells round this one, until a point is behind all faces.
    bool splitWithSeveral(Label cell) {
        constexpr std::size_t branches = 5;
        std::vector<Label> first = partnersOf({cell});
        if (first.size() > branches) first.resize(branches);
        return std::ranges::any_of(first, [&](Label start) {
            return splitWithGroup({cell, start});
        });
    }

    bool splitWithGroup(std::vector<Label> group) {
        constexpr std::size_t most = 7;
        const Label cell = group.front();
        while (group.size() <= most) {
            const std::vector<Label> partners = partnersOf(group);
            const std::vector<Label> sure(group.begin() + 1, group.end());
            for (const bool mayFold : {false, true})
                if (splitWithOneMore(cell, sure, partners, mayFold)) return true;
            if (partners.empty()) return false;
            group.push_back(partners.front());
        }
        return false;
    }

    bool splitWithOneMore(Label cell,
                          const std::vector<Label>& sure,
                          const std::vector<Label>& partners,
                          bool mayFold) {
        const auto fits = [&](std::vector<Label> others, Label one) {
            if (one >= 0) others.push_back(one);
            if (!splitWith(cell, others, mayFold)) return false;
            counts_.foldedCells += mayFold ? 1 : 0;
            return true;
        };
        return fits(sure, -1) ||
               std::ranges::any_of(partners, [&](Label one) { return fits(sure, one); });
    }

    /// A cell whose faces have changed may need to be split now.
    void wait(Label cell) {
        if (!editor_.isFrozen(cell)) waiting_.push_back(cell);
    }

    void makePyramidsOf(Label cell) {
        if (isAcceptable(editor_, cell)) return;
        if (!hasLargeFace(editor_, cell) && makeGoodPieces(cell)) {
            editor_.commit();
            return;
        }
        if (effort_.mayFold) foldPyramids(cell);
    }

    /// Pyramids though no point sees all faces: round one that is behind them at least.
    void foldPyramids(Label cell) {
        const bool mayBe = !hasLargeFace(editor_, cell);
        if (const auto apex = mayBe ? pointBehindFaces(editor_, cell) : std::nullopt) {
            makePyramids(editor_, cell, *apex);
            ++counts_.foldedCells;
            editor_.commit();
        } else {
            splitWithSeveral(cell);
        }
    }

    bool makeGoodPieces(Label cell) {
        static const Tetrahedraliser noTetrahedra;
        const Pieces pieces = polymesh::makeGoodPieces(
            editor_, cell, effort_.tetrahedralise ? *effort_.tetrahedralise : noTetrahedra);
        counts_.filledCells += pieces == Pieces::tetrahedra ? 1 : 0;
        return pieces != Pieces::none;
    }

    MeshEditor& editor_;
    const Bounds& bounds_;
    Effort effort_;
    ShapeSplitCounts& counts_;
    std::vector<Label> waiting_;
    std::vector<Label> parts_; // of cells that have been cut
    Label firstNewCell_ = 0;
    Label firstNewPoint_ = 0;
    std::vector<Label> tolerated_; // acceptable cells that failed before
};

std::span<const Zone> firstOf(const std::vector<Zone>& zones, std::size_t count) {
    return std::span(zones).first(std::min(count, zones.size()));
}

Bounds boundsOf(const PolyMesh& mesh, const BindingZones& binding) {
    Bounds bounds{std::vector<Label>(index(mesh.cellCount), 0),
                  std::vector<std::uint8_t>(index(mesh.faceCount()), 0),
                  {}};
    for (const Zone& zone : firstOf(mesh.faceZones, binding.faceZones))
        for (const Label f : zone.labels)
            bounds.isFaceInZone[index(f)] = 1;
    Label groups = 1;
    for (const Zone& zone : firstOf(mesh.cellZones, binding.cellZones)) {
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

/// A mesh that is being split.
struct SplitMesh {
    PolyMesh mesh;
    std::vector<Label> origins; // [cell] the cell before the first pass
    ShapeSplitCounts counts;
};

/// What holds for all passes.
struct Limits {
    const ShapeSplitMeans& means;
    std::vector<std::uint8_t> isFragile; // [cell before the first pass] not to be cut
};

/// Splits the cells once; what a cut has made unacceptable at the rim of the part is left.
void splitPass(SplitMesh& split,
               const std::vector<Label>& cells,
               const Effort& effort,
               const Limits& limits) {
    MeshPart part = partRound(split.mesh, withFaceNeighbours(split.mesh, cells));
    std::vector<Label> inPart;
    inPart.reserve(cells.size());
    for (const Label c : cells)
        inPart.push_back(
            static_cast<Label>(std::ranges::lower_bound(part.cells, c) - part.cells.begin()));
    MeshEditor editor(part.mesh);
    editor.computeGeometry();
    Bounds bounds = boundsOf(split.mesh, limits.means.binding);
    for (const Label origin : split.origins)
        bounds.isFragile.push_back(limits.isFragile[index(origin)]);
    Splitter(editor, bounds, effort, split.counts).split(inPart);
    JoinedPart joined = withPart(split.mesh, part);
    for (Label& origin : joined.origins)
        origin = split.origins[index(origin)];
    split.origins = std::move(joined.origins);
    split.mesh = std::move(joined.mesh);
}

SplitMesh splitInPasses(const PolyMesh& mesh, std::vector<Label> cells, const Limits& limits) {
    SplitMesh split{mesh, std::vector<Label>(index(mesh.cellCount)), {}};
    std::iota(split.origins.begin(), split.origins.end(), 0);
    split.counts.splitCells = toLabel(cells.size());
    // Few cells are left after the first pass; they are worth more.
    const CutEffort thorough{12, 12, 300, true, true};
    const Tetrahedraliser* tets = &limits.means.tetrahedralise;
    for (const Effort& effort :
         {Effort{{}, false, tets}, Effort{thorough, true, tets}, Effort{thorough, true, tets}}) {
        if (cells.empty()) break;
        splitPass(split, cells, effort, limits);
        cells = unacceptableCells(split.mesh);
    }
    split.counts.newCells = split.mesh.cellCount - mesh.cellCount;
    split.counts.newPoints = split.mesh.pointCount() - mesh.pointCount();
    split.counts.remaining = std::move(cells);
    return split;
}

} // namespace

ShapeSplitCounts
splitUnacceptableCells(PolyMesh& mesh, const ShapeSplitMeans& means, std::vector<Label>* origins) {
    const std::vector<Label> cells = unacceptableCells(mesh);
    Limits limits{means, std::vector<std::uint8_t>(index(mesh.cellCount), 0)};
    SplitMesh best = splitInPasses(mesh, cells, limits);
    // Where cuts have led to cells that nothing can be done about, another time without cuts there.
    constexpr int furtherTries = 2;
    std::vector<Label> hopeless;
    for (const Label c : best.counts.remaining)
        hopeless.push_back(best.origins[index(c)]);
    for (int i = 0; i < furtherTries && !best.counts.remaining.empty(); ++i) {
        for (const Label c : withFaceNeighbours(mesh, hopeless))
            limits.isFragile[index(c)] = 1;
        SplitMesh next = splitInPasses(mesh, cells, limits);
        for (const Label c : next.counts.remaining)
            hopeless.push_back(next.origins[index(c)]);
        if (next.counts.remaining.size() < best.counts.remaining.size()) best = std::move(next);
    }
    mesh = std::move(best.mesh);
    if (origins) *origins = std::move(best.origins);
    return std::move(best.counts);
}

} // namespace polymesh
