// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/editPart.h"

#include "libpolymesh/base/freshList.h"
#include "libpolymesh/base/kept.h"
#include "libpolymesh/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace polymesh {

namespace {

bool isInside(int winding) {
    return winding >= 1;
}

class Builder {
public:
    Builder(const TrimResult& trim,
            const SurfaceFeatures& features,
            const std::vector<Label>& representative)
        : trim_(trim),
          features_(features),
          representative_(representative),
          isOnFeature_(trim.cutter.surface->points.size(), 0) {
        const auto& edges = trim.cutter.edges.edges;
        for (std::size_t e = 0; e < edges.size(); ++e)
            if (features.isFeature[e] != 0)
                isOnFeature_[index(edges[e].start)] = isOnFeature_[index(edges[e].end)] = 1;
    }

    EditPart run() {
        findStates();
        addCells();
        listWholeFaces();
        addFrozenCells();
        numberPoints();
        addFaces();
        rankPoints();
        return std::move(part_);
    }

private:
    Label cellOf(Label meshCell) const { return editCell_[index(meshCell)]; }

    /// Marks the mesh points that a crossing may be collapsed with.
    std::vector<std::uint8_t> nearPoints() const {
        std::vector<std::uint8_t> isNear = freshList<std::uint8_t>(trim_.mesh.points.size());
        const Probe& probe = trim_.probe;
        for (Label e = 0; e < probe.edgeCount(); ++e)
            for (Label x = trim_.arrangement.crossings.offsets[index(e)];
                 x < trim_.arrangement.crossings.offsets[index(e) + 1];
                 ++x)
                for (const Label n : probe.edges[index(e)]) {
                    if (n >= probe.meshNodeCount() || probe.nodes[index(n)] < 0) continue;
                    const Vec3& p = trim_.positions[index(trim_.arrangement.firstCrossing() + x)];
                    const double reach =
                        trim_.minEdge * trim_.cellSizes[index(probe.edgeCell[index(e)])];
                    if (norm(p - probe.nodePoints[index(n)]) <= 2 * reach)
                        isNear[index(probe.nodes[index(n)])] = 1;
                }
        return isNear;
    }

    void findStates() {
        const PolyMesh& mesh = trim_.mesh;
        part_.states = freshList<CellState>(index(mesh.cellCount), CellState::outside);
        parallelFor(mesh.cellCount, [&](Label c) {
            if (trim_.probe.localCell[index(c)] < 0 && isInside(trim_.cellWinding[index(c)]))
                part_.states[index(c)] = CellState::inside;
        });
        for (const Label local : trim_.cells.localCell)
            part_.states[index(trim_.probe.cells[index(local)])] = CellState::edited;
        isRing_ = freshList<std::uint8_t>(index(mesh.cellCount));
        parallelFor(trim_.probe.faceCount(), [&](Label f) {
            const Label meshFace = trim_.probe.faces[index(f)];
            if (meshFace < 0 || trim_.loops.offsets[index(f)] == trim_.loops.offsets[index(f) + 1])
                return;
            markRing(mesh.owner[index(meshFace)]);
            if (mesh.isInternal(meshFace)) markRing(mesh.neighbour[index(meshFace)]);
        });
        const std::vector<std::uint8_t> isNear = nearPoints();
        parallelFor(mesh.faceCount(), [&](Label f) {
            const bool touches =
                std::ranges::any_of(mesh.faces[f], [&](Label p) { return isNear[index(p)] != 0; });
            if (!touches) return;
            markRing(mesh.owner[index(f)]);
            if (mesh.isInternal(f)) markRing(mesh.neighbour[index(f)]);
        });
    }

    void markRing(Label c) {
        if (part_.states[index(c)] == CellState::inside)
            std::atomic_ref<std::uint8_t>(isRing_[index(c)]).store(1, std::memory_order_relaxed);
    }

    void addCells() {
        editCell_ = freshList<Label>(index(trim_.mesh.cellCount), -1);
        const auto ring = std::ranges::count(isRing_, std::uint8_t{1});
        // About as many frozen cells as there are in the ring follow.
        part_.mesh.cells.reserve(trim_.cells.localCell.size() + 2 * static_cast<std::size_t>(ring));
        for (const Label local : trim_.cells.localCell) {
            EditCell cell;
            cell.size = trim_.cellSizes[index(local)];
            cell.origin = trim_.probe.cells[index(local)];
            part_.mesh.cells.push_back(cell);
        }
        part_.cutCellCount = trim_.cells.cellCount();
        for (Label c = 0; c < trim_.mesh.cellCount; ++c)
            if (isRing_[index(c)] != 0) {
                part_.states[index(c)] = CellState::edited;
                addCell(c, false);
            }
    }

    void addCell(Label meshCell, bool isFrozen) {
        EditCell cell;
        cell.origin = meshCell;
        cell.frozen = isFrozen;
        editCell_[index(meshCell)] = toLabel(part_.mesh.cells.size());
        part_.mesh.cells.push_back(cell);
    }

    Label otherCell(Label meshFace) const {
        return trim_.mesh.isInternal(meshFace) ? trim_.mesh.neighbour[index(meshFace)] : -1;
    }

    /// Lists the faces of ring cells that no probed cell shares.
    void listWholeFaces() {
        const PolyMesh& mesh = trim_.mesh;
        const auto isRing = [&](Label c) { return c >= 0 && isRing_[index(c)] != 0; };
        const auto isProbed = [&](Label c) {
            return c >= 0 && trim_.probe.localCell[index(c)] >= 0;
        };
        const Kept wanted(mesh.faceCount(), [&](Label f) {
            const Label own = mesh.owner[index(f)];
            const Label other = otherCell(f);
            return (isRing(own) || isRing(other)) && !isProbed(own) && !isProbed(other);
        });
        wholeFaces_.resize(index(wanted.count()));
        wanted.forEach([&](Label f, Label to) { wholeFaces_[index(to)] = f; });
    }

    /// Calls body(polygon, probed face) for the polygons of probed faces, in parallel.
    template<class Body>
    void forPolygons(Body&& body) const {
        parallelFor(trim_.probe.faceCount(), [&](Label f) {
            for (Label k = trim_.loops.offsets[index(f)]; k < trim_.loops.offsets[index(f) + 1];
                 ++k)
                body(k, f);
        });
    }

    static void mark(std::vector<std::uint8_t>& flags, Label i) {
        std::atomic_ref<std::uint8_t>(flags[index(i)]).store(1, std::memory_order_relaxed);
    }

    /// The cells that are not edited but share a face of the part.
    void addFrozenCells() {
        std::vector<std::uint8_t> isFrozen(index(trim_.mesh.cellCount), 0);
        const auto see = [&](Label meshCell) {
            if (meshCell >= 0 && cellOf(meshCell) < 0) mark(isFrozen, meshCell);
        };
        forPolygons([&](Label k, Label f) {
            const auto& pieces = trim_.cells.polygonCells[index(k)];
            const Label meshFace = trim_.probe.faces[index(f)];
            if (pieces[0] < 0) see(trim_.mesh.owner[index(meshFace)]);
            if (pieces[1] < 0 && meshFace >= 0) see(otherCell(meshFace));
        });
        parallelFor(toLabel(wholeFaces_.size()), [&](Label i) {
            see(trim_.mesh.owner[index(wholeFaces_[index(i)])]);
            see(otherCell(wholeFaces_[index(i)]));
        });
        for (Label c = 0; c < trim_.mesh.cellCount; ++c)
            if (isFrozen[index(c)] != 0) addCell(c, true);
    }

    /// Points of polygons first, then those that only whole faces use.
    void numberPoints() {
        std::vector<std::uint8_t> isUsed(trim_.positions.size(), 0);
        const auto use = [&](std::span<const Label> polygon) {
            for (const Label p : polygon)
                mark(isUsed, p);
        };
        forPolygons([&](Label k, Label) { use(trim_.loops.polygons[k]); });
        parallelFor(trim_.boundary.polygons.size(),
                    [&](Label k) { use(trim_.boundary.polygons[k]); });
        const Kept cut(toLabel(isUsed.size()), [&](Label p) { return isUsed[index(p)] != 0; });
        editPoint_ = freshList<Label>(isUsed.size(), -1);
        editPointOfMesh_ = freshList<Label>(trim_.mesh.points.size(), -1);
        cut.forEach([&](Label p, Label to) {
            editPoint_[index(p)] = to;
            if (p < trim_.probe.meshNodeCount())
                editPointOfMesh_[index(trim_.probe.nodes[index(p)])] = to;
        });
        const Kept whole = pointsOfWholeFaces();
        whole.forEach([&](Label p, Label to) { editPointOfMesh_[index(p)] = cut.count() + to; });
        placePoints(cut, whole);
    }

    Kept pointsOfWholeFaces() const {
        std::vector<std::uint8_t> isUsed(trim_.mesh.points.size(), 0);
        parallelFor(toLabel(wholeFaces_.size()), [&](Label i) {
            for (const Label p : trim_.mesh.faces[wholeFaces_[index(i)]])
                if (editPointOfMesh_[index(p)] < 0) mark(isUsed, p);
        });
        return {toLabel(isUsed.size()), [&](Label p) { return isUsed[index(p)] != 0; }};
    }

    void placePoints(const Kept& cut, const Kept& whole) {
        const std::size_t count = index(cut.count() + whole.count());
        part_.mesh.points = freshList<Vec3>(count);
        part_.mesh.ranks.assign(count, PointRank::interior);
        part_.meshPoint = freshList<Label>(count, -1);
        arrangementPoint_ = freshList<Label>(count, -1);
        cut.forEach([&](Label p, Label to) {
            part_.mesh.points[index(to)] = trim_.positions[index(p)];
            arrangementPoint_[index(to)] = p;
            if (p < trim_.probe.meshNodeCount())
                part_.meshPoint[index(to)] = trim_.probe.nodes[index(p)];
        });
        whole.forEach([&](Label p, Label to) {
            part_.mesh.points[index(cut.count() + to)] = trim_.mesh.points[index(p)];
            part_.meshPoint[index(cut.count() + to)] = p;
        });
    }

    Label patchOf(Label meshFace) const {
        const auto& patches = trim_.mesh.patches;
        for (std::size_t p = 0; p < patches.size(); ++p)
            if (meshFace < patches[p].start + patches[p].size) return toLabel(p);
        return toLabel(patches.size()) - 1;
    }

    /// A polygon of a probed face: between pieces, or cells that nothing touches.
    void fillPolygon(EditFace& face, Label k, Label f) const {
        const Label meshFace = trim_.probe.faces[index(f)];
        const auto& pieces = trim_.cells.polygonCells[index(k)];
        for (const Label p : trim_.loops.polygons[k])
            face.points.push_back(editPoint_[index(p)]);
        face.owner = pieces[0] >= 0 ? pieces[0] : cellOf(trim_.mesh.owner[index(meshFace)]);
        face.neighbour = pieces[1];
        if (face.neighbour < 0 && meshFace >= 0 && trim_.mesh.isInternal(meshFace))
            face.neighbour = cellOf(trim_.mesh.neighbour[index(meshFace)]);
        if (face.neighbour >= 0) return;
        const Label region = trim_.touchedRegions[index(k)];
        const Label firstRegion = toLabel(trim_.mesh.patches.size());
        face.patch = region >= 0 ? firstRegion + region : patchOf(meshFace);
    }

    void fillBoundary(EditFace& face, Label k) const {
        for (const Label p : trim_.boundary.polygons[k])
            face.points.push_back(editPoint_[index(p)]);
        face.owner = trim_.cells.boundaryCells[index(k)];
        face.patch = toLabel(trim_.mesh.patches.size()) + trim_.boundary.region[index(k)];
    }

    void fillWholeFace(EditFace& face, Label f) const {
        for (const Label p : trim_.mesh.faces[f])
            face.points.push_back(editPointOfMesh_[index(p)]);
        face.owner = cellOf(trim_.mesh.owner[index(f)]);
        if (trim_.mesh.isInternal(f))
            face.neighbour = cellOf(trim_.mesh.neighbour[index(f)]);
        else
            face.patch = patchOf(f);
    }

    void addFaces() {
        const Label cut = trim_.loops.polygons.size();
        const Label boundary = trim_.boundary.polygons.size();
        auto& faces = part_.mesh.faces;
        // Clean-up makes more faces: without room for them all would be moved.
        const std::size_t count = index(cut + boundary) + wholeFaces_.size();
        faces.reserve(count + count / 8);
        backPages(faces.data(), count * sizeof(EditFace));
        faces.resize(count);
        forPolygons([&](Label k, Label f) { fillPolygon(faces[index(k)], k, f); });
        parallelFor(boundary, [&](Label k) { fillBoundary(faces[index(cut + k)], k); });
        parallelFor(toLabel(wholeFaces_.size()), [&](Label i) {
            fillWholeFace(faces[index(cut + boundary + i)], wholeFaces_[index(i)]);
        });
        listFacesOfCells(part_.mesh);
        parallelFor(toLabel(part_.mesh.cells.size()), [&](Label c) {
            EditCell& cell = part_.mesh.cells[index(c)];
            if (!cell.frozen && cell.size == 0) cell.size = sizeOf(cell);
        });
    }

    double sizeOf(const EditCell& cell) const {
        Box box;
        for (const Label f : cell.faces)
            for (const Label p : part_.mesh.faces[index(f)].points)
                box.add(part_.mesh.points[index(p)]);
        const Vec3 size = box.size();
        return std::cbrt(size.x * size.y * size.z);
    }

    void raise(Label point, PointRank rank) {
        PointRank& known = part_.mesh.ranks[index(point)];
        known = std::max(known, rank);
    }

    void rankPoints() {
        part_.representative.resize(part_.mesh.points.size());
        for (std::size_t p = 0; p < part_.mesh.points.size(); ++p) {
            part_.representative[p] = toLabel(p);
            const Label point = arrangementPoint_[p];
            if (point < 0) continue;
            const Label stands = representative_[index(point)];
            if (stands != point) part_.representative[p] = editPoint_[index(stands)];
            rankFeaturePoint(toLabel(p), point);
        }
        for (const SettledNode& node : trim_.settled)
            if (const Label p = editPoint_[index(node.node)]; p >= 0) raise(p, rankOf(node.target));
        keepOneOfEach();
        rankByPatches();
    }

    static PointRank rankOf(AdjustTarget target) {
        if (target == AdjustTarget::corner) return PointRank::corner;
        return target == AdjustTarget::edge ? PointRank::feature : PointRank::surface;
    }

    /// Points of feature edges of the surface.
    void rankFeaturePoint(Label p, Label point) {
        const Arrangement& a = trim_.arrangement;
        if (a.isPierce(point) && features_.isFeature[index(a.pierce(point).edge)] != 0)
            raise(p, PointRank::feature);
        if (point < a.firstVertex()) return;
        const Label v = point - a.firstVertex();
        if (isOnFeature_[index(v)] != 0) raise(p, PointRank::feature);
        if (features_.isCorner[index(v)] != 0) raise(p, PointRank::corner);
    }

    /// `seen` are two patches of the point so far, -1 for none.
    void rankByPatch(Label p, Label patch, std::array<Label, 2>& seen) {
        if (seen[0] == patch || seen[1] == patch) return;
        if (seen[0] < 0)
            raise(p, PointRank::surface);
        else
            raise(p, seen[1] < 0 ? PointRank::feature : PointRank::corner);
        (seen[0] < 0 ? seen[0] : seen[1]) = patch;
    }

    bool isOfFrozen(const EditFace& face) const {
        const auto isFrozen = [&](Label c) { return c >= 0 && part_.mesh.cells[index(c)].frozen; };
        return isFrozen(face.owner) || isFrozen(face.neighbour);
    }

    /// A point of two patches is on a border between them, one of three is a corner; those of
    /// frozen cells stay where they are.
    void rankByPatches() {
        const auto& faces = part_.mesh.faces;
        const Kept boundary(toLabel(faces.size()), [&](Label f) {
            const EditFace& face = faces[index(f)];
            if (isOfFrozen(face))
                for (const Label p : face.points)
                    std::atomic_ref<PointRank>(part_.mesh.ranks[index(p)])
                        .store(PointRank::fixed, std::memory_order_relaxed);
            return face.isBoundary();
        });
        std::vector<Label> listed(index(boundary.count()));
        boundary.forEach([&](Label f, Label to) { listed[index(to)] = f; });
        std::vector<std::array<Label, 2>> patches(part_.mesh.points.size(), {-1, -1});
        for (const Label f : listed)
            for (const Label p : faces[index(f)].points)
                rankByPatch(p, faces[index(f)].patch, patches[index(p)]);
    }

    /// Where the point that should stand for others is not used itself, the first that is does.
    void keepOneOfEach() {
        std::vector<std::pair<Label, Label>> orphans; // standing point, edit point
        for (std::size_t p = 0; p < part_.representative.size(); ++p)
            if (part_.representative[p] < 0)
                orphans.emplace_back(representative_[index(arrangementPoint_[p])], toLabel(p));
        std::ranges::sort(orphans);
        for (std::size_t i = 0; i < orphans.size(); ++i) {
            const bool isFirst = i == 0 || orphans[i].first != orphans[i - 1].first;
            const Label p = orphans[i].second;
            part_.representative[index(p)] =
                isFirst ? p : part_.representative[index(orphans[i - 1].second)];
            // It stands where the others should be.
            part_.mesh.points[index(p)] = trim_.positions[index(orphans[i].first)];
        }
    }

    const TrimResult& trim_;
    const SurfaceFeatures& features_;
    const std::vector<Label>& representative_;
    std::vector<std::uint8_t> isOnFeature_; // per surface point
    EditPart part_;
    std::vector<std::uint8_t> isRing_;
    std::vector<Label> wholeFaces_;       // mesh faces
    std::vector<Label> editCell_;         // mesh cell -> edit cell, for whole and frozen cells
    std::vector<Label> editPoint_;        // arrangement point -> edit point
    std::vector<Label> editPointOfMesh_;  // mesh point -> edit point
    std::vector<Label> arrangementPoint_; // edit point -> arrangement point, or -1
};

} // namespace

EditPart buildEditPart(const TrimResult& trim,
                       const SurfaceFeatures& features,
                       const std::vector<Label>& representative) {
    return Builder(trim, features, representative).run();
}

} // namespace polymesh
