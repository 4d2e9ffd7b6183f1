// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/trim.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/freedMemory.h"
#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/cleanUp.h"
#include "libpolymesh/quality/collapsePoints.h"
#include "libpolymesh/quality/editQuality.h"
#include "libpolymesh/quality/meshEditor.h"
#include "libpolymesh/quality/removeZeroSize.h"
#include "libpolymesh/quality/separatePinches.h"
#include "libpolymesh/surface/boxTree.h"
#include "libpolymesh/surface/features.h"
#include "libpolymesh/surface/triangleBoxes.h"
#include "libpolymesh/trim/adjustNodes.h"
#include "libpolymesh/trim/assemble.h"
#include "libpolymesh/trim/cutCells.h"
#include "libpolymesh/trim/flatFlaps.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace polymesh {

namespace {

void turnInsideOut(TriSurface& surface) {
    for (auto& triangle : surface.triangles)
        std::swap(triangle[1], triangle[2]);
}

void refuseBroken(Label cells) {
    if (cells == 0) return;
    throw WorkError(
        fmt::format("clean-up left {} cells open; please report this surface and mesh", cells));
}

/// Takes away what has no thickness between the surface and faces of the mesh on which it lies.
void tidyTouchingFaces(EditPart& part, TrimSummary& summary) {
    MeshEditor editor(part.mesh);
    const CollapseCounts collapsed = collapsePoints(editor, part.representative);
    const ZeroSizeCounts zero = removeZeroSize(editor);
    removeFlatFlaps(editor);
    // Points that fall together but for rounding can leave a cell open until they are joined.
    if (collapsed.brokenCells > 0) refuseBroken(separatePinches(editor));
    for (Label p = toLabel(part.representative.size()); p < toLabel(part.mesh.points.size()); ++p)
        part.representative.push_back(p);
    summary.mergedCells += collapsed.removedCells + zero.cells;
}

/// Collapses what coincides, then what the user wants cleaned up. Returns the work on repairs.
std::int64_t tidy(EditPart& part,
                  const TrimOptions& options,
                  std::int64_t thoroughWork,
                  bool mayPinch,
                  TrimSummary& summary) {
    const CleanUpCounts counts = cleanUp(part.mesh,
                                         part.representative,
                                         {.minEdge = options.minEdge,
                                          .minVolume = options.minVolume,
                                          .mendsCells = options.mendsCells,
                                          .thoroughWork = thoroughWork,
                                          .mayPinch = mayPinch});
    refuseBroken(counts.brokenCells);
    summary.mergedCells += counts.zeroCells + counts.mergedCells;
    summary.collapsedEdges = counts.collapsedEdges;
    summary.splitCells = counts.cutCells;
    summary.repairs = counts.repairs;
    summary.badCells = counts.badCells;
    return counts.work;
}

void count(const EditPart& part, const PolyMesh& result, TrimSummary& summary) {
    Label cut = 0;
    for (Label c = 0; c < part.cutCellCount; ++c)
        if (!part.mesh.cells[index(c)].isRemoved()) ++cut;
    summary.trimmedCells = cut;
    summary.untouchedCells = result.cellCount - cut;
}

/// A cell that came out small, and a box round it, wider by half a cell [m].
struct SmallCell {
    double share = 0; // of the volume of a cell of the mesh there
    Vec3 middle;
    Box box;
};

/// A trimmed mesh, and boxes round the cells that came out bad, wider by half a cell [m].
struct Cut {
    Trimmed trimmed;
    std::vector<Box> badPlaces;
    bool isOpen = false;                 // there is no mesh: those cells do not close
    std::vector<SmallCell> smallCells{}; // when nodes were projected
};

/// Whether a cell has fewer faces than a cell may have; it may close all the same, when they are
/// bent.
bool isStump(const EditCell& cell) {
    return !cell.frozen && !cell.isRemoved() && cell.faces.size() < 4;
}

Box placeOf(MeshEditor& editor, Label c) {
    const EditCell& cell = editor.cell(c);
    Box box;
    for (const Label f : cell.faces)
        for (const Label p : editor.face(f).points)
            box.add(editor.point(p));
    const Vec3 half = 0.5 * cell.size * Vec3{1, 1, 1};
    return {box.min - half, box.max + half};
}

/// The places of the cells that are open, or else of those that checkMesh fails.
std::vector<Box> findBadPlaces(EditPart& part, bool isOpen) {
    std::vector<Box> places;
    MeshEditor editor(part.mesh);
    for (Label c = 0; c < editor.cellCount(); ++c) {
        const EditCell& cell = editor.cell(c);
        if (cell.frozen || cell.isRemoved()) continue;
        const bool isBad = isOpen ? isStump(cell) || cellShape(part.mesh, c) == CellShape::broken
                                  : isFailing(editor, c);
        if (isBad) places.push_back(placeOf(editor, c));
    }
    return places;
}

/// Smaller cells, as a share of a cell of the mesh, are worth another try with other nodes. Far
/// above what chance leaves and far below minVolume.
constexpr double smallShare = 5e-4;

std::vector<SmallCell> findSmallCells(EditPart& part) {
    std::vector<SmallCell> found;
    MeshEditor editor(part.mesh);
    for (Label c = 0; c < editor.cellCount(); ++c) {
        const EditCell& cell = editor.cell(c);
        if (cell.frozen || cell.isRemoved()) continue;
        const CellGeometry& geometry = editor.cellGeometry(c);
        const double share = geometry.volume / (cell.size * cell.size * cell.size);
        if (share < smallShare) found.push_back({share, geometry.centre, placeOf(editor, c)});
    }
    return found;
}

/// The pieces of the cells after clean-up.
struct CleanPieces {
    EditPart part;
    TrimSummary summary;
    std::int64_t work = 0; // on repairs, see WorkBudget
};

/// Makes clean pieces of the cells of one mesh in several ways and keeps the best.
class PieceMaker {
public:
    PieceMaker(PolyMesh& mesh,
               MeshCut& cut,
               const FeaturedSurface& surface,
               const TrimOptions& options)
        : mesh_(mesh), cut_(cut), surface_(surface), options_(options) {}

    /// Makes pieces. Where repairs leave bad cells, these are made again with more and less of the
    /// surface round them, also without its features: they come out otherwise, and the rest as
    /// before. At last repairs get more time. Requires: no node is settled.
    CleanPieces best() {
        if (options_.deviation <= 0 || !options_.mendsCells) return make({}, workOfOnlyTry);
        CleanPieces best = make({}, workOfEachTry);
        if (best.summary.badCells == 0) return best;
        options_.onStage("try again");
        options_.onStage = [](const std::string&) {};
        tryOtherFidelities(best);
        if (isFew(best.summary.badCells))
            takeIfBetter(best.summary.remadePlaces, workOfLastTry, best);
        return best;
    }

    /// Makes pieces once. Where they cannot be cleaned up (WorkError), `openPart` is them.
    CleanPieces only(EditPart& openPart) { return make({}, workOfOnlyTry, &openPart); }

private:
    // On repairs, in units of WorkBudget.
    static constexpr std::int64_t workOfOnlyTry = 80000;
    static constexpr std::int64_t workOfEachTry = 20000;
    static constexpr std::int64_t workOfLastTry = 60000;
    static constexpr std::int64_t workOfAllTries = 160000;

    /// What is tried in a bad place.
    struct OtherFidelity {
        double factor = 1;
        bool isBlunt = false;
    };

    static constexpr std::array<OtherFidelity, 8> otherFidelities{{{0.3, false},
                                                                   {2, false},
                                                                   {4, true},
                                                                   {40, true},
                                                                   {0.1, false},
                                                                   {4, false},
                                                                   {0.6, false},
                                                                   {1.4, false}}};

    CleanPieces make(std::span<const FidelityPlace> places,
                     std::int64_t thoroughWork,
                     EditPart* openPart = nullptr) {
        Pieces pieces = makePieces(mesh_, cut_, surface_, options_, places);
        CleanPieces clean{std::move(pieces.part), {}, 0};
        clean.summary.holedFaces = pieces.holedFaces;
        clean.summary.remadeCells = pieces.remadeCells;
        clean.summary.remadePlaces.assign(places.begin(), places.end());
        try {
            if (pieces.mayTouch) tidyTouchingFaces(clean.part, clean.summary);
            clean.work = tidy(clean.part, options_, thoroughWork, pieces.mayPinch, clean.summary);
        } catch (const WorkError&) {
            if (openPart) *openPart = std::move(clean.part);
            throw;
        }
        return clean;
    }

    /// Makes pieces with these places and keeps them where fewer cells are bad. False where it is
    /// all the same: the surface has no more and no less to give there.
    bool
    takeIfBetter(std::vector<FidelityPlace> places, std::int64_t thoroughWork, CleanPieces& best) {
        try {
            CleanPieces other = make(places, thoroughWork);
            work_ += other.work;
            if (other.summary.badCells >= best.summary.badCells) return other.work != best.work;
            best = std::move(other);
        } catch (const WorkError&) {
            // What there is has no such fault.
        }
        return true;
    }

    /// More: features are finer than the cells there, so that no deviation helps that keeps them.
    static bool isFew(Label badCells) {
        constexpr Label few = 20;
        return badCells > 0 && badCells <= few;
    }

    void tryOtherFidelities(CleanPieces& best) {
        int sames = 0;
        for (const auto& [factor, isBlunt] : otherFidelities) {
            if (best.summary.badCells == 0 || work_ > workOfAllTries) return;
            if (!isBlunt && (sames == 2 || !isFew(best.summary.badCells))) continue;
            std::vector<FidelityPlace> places = best.summary.remadePlaces;
            for (const Box& box : findBadPlaces(best.part, false))
                places.push_back({box, factor, isBlunt});
            if (!takeIfBetter(std::move(places), workOfEachTry, best)) ++sames;
        }
    }

    PolyMesh& mesh_;
    MeshCut& cut_;
    const FeaturedSurface& surface_;
    TrimOptions options_;
    std::int64_t work_ = 0; // on all tries
};

/// Trims a mesh whose nodes have been adjusted.
Cut cutMesh(PolyMesh mesh,
            const FeaturedSurface& surface,
            const AdjustedNodes& adjusted,
            const TrimOptions& options) {
    const CutFinder find = options.findCut ? options.findCut : findCut;
    MeshCut meshCut = find(mesh, surface, adjusted, options);
    PieceMaker maker(mesh, meshCut, surface, options);
    EditPart openPart;
    CleanPieces clean;
    try {
        // With nodes moved other nodes are tried instead: see trimAdjusted.
        clean = adjusted.moved.empty() ? maker.best() : maker.only(openPart);
    } catch (const WorkError&) {
        if (adjusted.moved.empty()) throw;
        return {{}, findBadPlaces(openPart, true), true};
    }
    meshCut = {};
    if (!adjusted.moved.empty() && std::ranges::any_of(clean.part.mesh.cells, isStump))
        return {{}, findBadPlaces(clean.part, true), true};

    Cut cut;
    Trimmed& result = cut.trimmed;
    EditPart& part = clean.part;
    result.summary = clean.summary;
    result.summary.adjusted = adjusted.counts;
    if (!adjusted.moved.empty() && result.summary.badCells > 0)
        cut.badPlaces = findBadPlaces(part, false);
    if (options.adjust.how == Adjust::project) cut.smallCells = findSmallCells(part);

    options.onStage("assemble");
    giveBackFreedMemory(); // old mesh, edited part and result are there at the same time
    std::vector<std::string> types = options.regionTypes;
    const std::vector<std::string>& regions = surface.cutter.surface->regionNames;
    types.resize(regions.size(), "wall");
    result.mesh = assemble(mesh, part, regions, types);
    require(result.mesh.cellCount > 0,
            "nothing is left: the surface and the mesh have no volume in common on the side to "
            "keep; check the surface's unit and place, and -keep");
    count(part, result.mesh, result.summary);
    result.summary.featureEdges =
        toLabel(static_cast<std::size_t>(std::ranges::count(surface.features.isFeature, char{1})));
    result.summary.featureCorners =
        toLabel(static_cast<std::size_t>(std::ranges::count(surface.features.isCorner, char{1})));
    return cut;
}

/// Adds the moved nodes that are in one of the boxes to a list; false when there are none.
bool addNodes(const AdjustedNodes& adjusted,
              const std::vector<Box>& boxes,
              std::vector<Label>& nodes) {
    const std::size_t before = nodes.size();
    const BoxTree tree(boxes);
    for (const MovedNode& node : adjusted.moved) {
        bool isIn = false;
        tree.forEachNear({node.place, node.place},
                         [&](Label i) { isIn = isIn || boxes[index(i)].contains(node.place); });
        if (isIn) nodes.push_back(node.node);
    }
    std::ranges::sort(nodes);
    return nodes.size() > before;
}

/// Has the nodes round small cells repelled, and edges and faces of the mesh keep away from these.
void avoidCells(const AdjustedNodes& adjusted,
                const std::vector<SmallCell>& cells,
                AdjustOptions& options) {
    std::vector<Box> boxes;
    for (const SmallCell& cell : cells) {
        boxes.push_back(cell.box);
        options.avoided.push_back(cell.middle);
    }
    addNodes(adjusted, boxes, options.repelled);
}

double smallestShare(const std::vector<SmallCell>& cells) {
    double least = smallShare;
    for (const SmallCell& cell : cells)
        least = std::min(least, cell.share);
    return least;
}

/// Adjusts nodes and trims. Where that leaves bad cells it is done again without the nodes round
/// these, where projected nodes leave small ones with these nodes repelled; the best result
/// counts. If there is none, no node is moved.
Trimmed trimAdjusted(const PolyMesh& mesh, const FeaturedSurface& surface, TrimOptions options) {
    constexpr int mostTries = 4;
    std::optional<Trimmed> best;
    double bestShare = 0;
    for (int i = 0; i < mostTries; ++i) {
        PolyMesh moved = mesh;
        const AdjustedNodes adjusted =
            adjustNodes(moved, surface.cutter, surface.features, options.adjust);
        Cut cut = cutMesh(std::move(moved), surface, adjusted, options);
        const double share = smallestShare(cut.smallCells);
        const Label bad = cut.trimmed.summary.badCells;
        const bool isBest = !cut.isOpen && (!best || bad < best->summary.badCells ||
                                            (bad == best->summary.badCells && share > bestShare));
        if (isBest) {
            best = std::move(cut.trimmed);
            bestShare = share;
        }
        const bool hasKept = addNodes(adjusted, cut.badPlaces, options.adjust.kept);
        if (!hasKept && cut.smallCells.empty()) break;
        avoidCells(adjusted, cut.smallCells, options.adjust);
        if (i == 0) options.onStage("try again");
        options.onStage = [](const std::string&) {};
    }
    return best ? std::move(*best) : cutMesh(mesh, surface, {}, options).trimmed;
}

} // namespace

Trimmed trim(PolyMesh mesh, TriSurface surface, const TrimOptions& options) {
    options.onStage("features");
    if (options.keep == Keep::outside) turnInsideOut(surface);
    const CuttingSurface cutter{&surface, pairEdges(surface), triangleBoxes(surface)};
    const SurfaceFeatures features = findFeatures(surface, cutter.edges, options.featureAngle);
    if (options.adjust.how == Adjust::none)
        return cutMesh(std::move(mesh), {cutter, features}, {}, options).trimmed;
    options.onStage("adjust");
    return trimAdjusted(mesh, {cutter, features}, options);
}

} // namespace polymesh
