// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/editPart.h"

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
        addPolygons();
        addWholeFaces();
        rankPoints();
        return std::move(part_);
    }

private:
    Label cellOf(Label meshCell) const { return editCell_[index(meshCell)]; }

    /// Marks the mesh points that a crossing may be collapsed with.
    std::vector<std::uint8_t> nearPoints() const {
        std::vector<std::uint8_t> isNear(trim_.mesh.points.size(), 0);
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
        part_.states.assign(index(mesh.cellCount), CellState::outside);
        parallelFor(mesh.cellCount, [&](Label c) {
            if (trim_.probe.localCell[index(c)] < 0 && isInside(trim_.cellWinding[index(c)]))
                part_.states[index(c)] = CellState::inside;
        });
        for (const Label local : trim_.cells.localCell)
            part_.states[index(trim_.probe.cells[index(local)])] = CellState::edited;
        isRing_.assign(index(mesh.cellCount), 0);
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
        editCell_.assign(index(trim_.mesh.cellCount), -1);
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

    Label addCell(Label meshCell, bool isFrozen) {
        EditCell cell;
        cell.origin = meshCell;
        cell.frozen = isFrozen;
        editCell_[index(meshCell)] = toLabel(part_.mesh.cells.size());
        part_.mesh.cells.push_back(cell);
        return editCell_[index(meshCell)];
    }

    Label pointOf(Label point) {
        Label& known = editPoint_[index(point)];
        if (known < 0) {
            known = toLabel(part_.mesh.points.size());
            part_.mesh.points.push_back(trim_.positions[index(point)]);
            part_.mesh.ranks.push_back(PointRank::interior);
            arrangementPoint_.push_back(point);
            const bool isMeshNode = point < trim_.probe.meshNodeCount();
            part_.meshPoint.push_back(isMeshNode ? trim_.probe.nodes[index(point)] : -1);
            if (isMeshNode) editPointOfMesh_[index(part_.meshPoint.back())] = known;
        }
        return known;
    }

    Label pointOfMesh(Label meshPoint) {
        Label& known = editPointOfMesh_[index(meshPoint)];
        if (known < 0) {
            known = toLabel(part_.mesh.points.size());
            part_.mesh.points.push_back(trim_.mesh.points[index(meshPoint)]);
            part_.mesh.ranks.push_back(PointRank::interior);
            arrangementPoint_.push_back(-1);
            part_.meshPoint.push_back(meshPoint);
        }
        return known;
    }

    void addFace(EditFace face) {
        const Label f = toLabel(part_.mesh.faces.size());
        for (const Label c : {face.owner, face.neighbour})
            if (c >= 0) part_.mesh.cells[index(c)].faces.push_back(f);
        part_.mesh.faces.push_back(std::move(face));
    }

    /// The cell on a side of a polygon of a probed face: a piece, or a cell that nothing touches.
    Label sideOf(Label polygon, Label localFace, std::size_t side) {
        if (const Label piece = trim_.cells.polygonCells[index(polygon)][side]; piece >= 0)
            return piece;
        const Label f = trim_.probe.faces[index(localFace)];
        if (side == 1 && !trim_.mesh.isInternal(f)) return -1;
        const Label c = side == 0 ? trim_.mesh.owner[index(f)] : trim_.mesh.neighbour[index(f)];
        return cellOf(c) >= 0 ? cellOf(c) : addCell(c, true);
    }

    Label patchOf(Label meshFace) const {
        const auto& patches = trim_.mesh.patches;
        for (std::size_t p = 0; p < patches.size(); ++p)
            if (meshFace < patches[p].start + patches[p].size) return toLabel(p);
        return toLabel(patches.size()) - 1;
    }

    void addPolygons() {
        const Probe& probe = trim_.probe;
        editPoint_.assign(trim_.positions.size(), -1);
        editPointOfMesh_.assign(trim_.mesh.points.size(), -1);
        const Label firstRegion = toLabel(trim_.mesh.patches.size());
        part_.mesh.faces.reserve(
            index(trim_.loops.polygons.size() + trim_.boundary.polygons.size()) +
            2 * part_.mesh.cells.size());
        for (Label f = 0; f < probe.faceCount(); ++f) {
            const Label meshFace = probe.faces[index(f)];
            for (Label k = trim_.loops.offsets[index(f)]; k < trim_.loops.offsets[index(f) + 1];
                 ++k) {
                EditFace face;
                for (const Label p : trim_.loops.polygons[k])
                    face.points.push_back(pointOf(p));
                face.owner = sideOf(k, f, 0);
                face.neighbour = sideOf(k, f, 1);
                const Label region = trim_.touchedRegions[index(k)];
                if (face.neighbour < 0)
                    face.patch = region >= 0 ? firstRegion + region : patchOf(meshFace);
                addFace(std::move(face));
            }
        }
        for (Label k = 0; k < trim_.boundary.polygons.size(); ++k) {
            EditFace face;
            for (const Label p : trim_.boundary.polygons[k])
                face.points.push_back(pointOf(p));
            face.owner = trim_.cells.boundaryCells[index(k)];
            face.patch = firstRegion + trim_.boundary.region[index(k)];
            addFace(std::move(face));
        }
    }

    /// The faces of ring cells that no probed cell shares.
    void addWholeFaces() {
        const PolyMesh& mesh = trim_.mesh;
        const auto otherOf = [&](Label f) {
            return mesh.isInternal(f) ? mesh.neighbour[index(f)] : -1;
        };
        const auto isRing = [&](Label c) { return c >= 0 && isRing_[index(c)] != 0; };
        const auto isProbed = [&](Label c) {
            return c >= 0 && trim_.probe.localCell[index(c)] >= 0;
        };
        const Kept wanted(mesh.faceCount(), [&](Label f) {
            const Label own = mesh.owner[index(f)];
            const Label other = otherOf(f);
            return (isRing(own) || isRing(other)) && !isProbed(own) && !isProbed(other);
        });
        std::vector<Label> faces(index(wanted.count()));
        wanted.forEach([&](Label f, Label to) { faces[index(to)] = f; });
        const auto sideOfCell = [&](Label c) {
            return cellOf(c) >= 0 ? cellOf(c) : addCell(c, true);
        };
        for (const Label f : faces) {
            EditFace face;
            for (const Label p : mesh.faces[f])
                face.points.push_back(pointOfMesh(p));
            face.owner = sideOfCell(mesh.owner[index(f)]);
            if (mesh.isInternal(f))
                face.neighbour = sideOfCell(mesh.neighbour[index(f)]);
            else
                face.patch = patchOf(f);
            addFace(std::move(face));
        }
        for (EditCell& cell : part_.mesh.cells)
            if (!cell.frozen && cell.size == 0) cell.size = sizeOf(cell);
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

    /// A point of two patches is on a border between them, one of three is a corner.
    void rankByPatches() {
        std::vector<std::array<Label, 2>> patches(part_.mesh.points.size(), {-1, -1});
        for (const EditFace& face : part_.mesh.faces) {
            const bool isOfFrozen =
                part_.mesh.cells[index(face.owner)].frozen ||
                (face.neighbour >= 0 && part_.mesh.cells[index(face.neighbour)].frozen);
            for (const Label p : face.points) {
                if (isOfFrozen) raise(p, PointRank::fixed);
                if (!face.isBoundary()) continue;
                auto& seen = patches[index(p)];
                const bool isNew = seen[0] != face.patch && seen[1] != face.patch;
                if (!isNew) continue;
                if (seen[0] < 0)
                    raise(p, PointRank::surface);
                else
                    raise(p, seen[1] < 0 ? PointRank::feature : PointRank::corner);
                (seen[0] < 0 ? seen[0] : seen[1]) = face.patch;
            }
        }
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
