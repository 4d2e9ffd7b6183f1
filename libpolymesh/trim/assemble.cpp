// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/assemble.h"

#include "libpolymesh/base/parallel.h"

#include <algorithm>

namespace polymesh {

namespace {

/// A face of the result: of the old mesh, or (from the face count of the old mesh on) edited.
struct FaceRecord {
    Label owner;
    Label neighbour; // -1: boundary
    Label patch;     // -1: internal
    Label source;
    bool isTurned;
};

class Assembly {
public:
    Assembly(const PolyMesh& mesh, const EditPart& part) : mesh_(mesh), part_(part) {}

    PolyMesh run(const std::vector<std::string>& regionNames,
                 const std::vector<std::string>& regionTypes) {
        numberCells();
        listFaces();
        numberPoints();
        addPatches(regionNames, regionTypes);
        fillFaces();
        addCellZones();
        return std::move(result_);
    }

private:
    bool isUntouched(Label meshCell) const {
        return part_.states[index(meshCell)] == CellState::inside;
    }

    void numberCells() {
        const auto& cells = part_.mesh.cells;
        std::vector<Label> order;
        for (std::size_t c = 0; c < cells.size(); ++c)
            if (!cells[c].frozen && !cells[c].isRemoved()) order.push_back(toLabel(c));
        std::ranges::stable_sort(order, {}, [&](Label c) { return cells[index(c)].origin; });
        meshCell_.assign(index(mesh_.cellCount), -1);
        editCell_.assign(cells.size(), -1);
        std::size_t next = 0;
        Label count = 0;
        for (Label c = 0; c < mesh_.cellCount; ++c) {
            if (isUntouched(c)) meshCell_[index(c)] = count++;
            for (; next < order.size() && cells[index(order[next])].origin == c; ++next)
                editCell_[index(order[next])] = count++;
        }
        for (std::size_t c = 0; c < cells.size(); ++c)
            if (cells[c].frozen) editCell_[c] = meshCell_[index(cells[c].origin)];
        result_.cellCount = count;
    }

    /// Internal records by (owner, neighbour), then the boundary's by patch.
    void listFaces() {
        listOldFaces();
        std::vector<FaceRecord> edited;
        for (std::size_t f = 0; f < part_.mesh.faces.size(); ++f) {
            const EditFace& face = part_.mesh.faces[f];
            if (face.isRemoved()) continue;
            FaceRecord record{editCell_[index(face.owner)],
                              -1,
                              face.patch,
                              mesh_.faceCount() + toLabel(f),
                              false};
            if (!face.isBoundary()) {
                record.neighbour = editCell_[index(face.neighbour)];
                record.patch = -1;
                record.isTurned = record.owner > record.neighbour;
                if (record.isTurned) std::swap(record.owner, record.neighbour);
            }
            edited.push_back(record);
        }
        const auto before = [](const FaceRecord& a, const FaceRecord& b) {
            if (a.patch != b.patch) return a.patch < b.patch; // internal ones first
            if (a.owner != b.owner) return a.owner < b.owner;
            if (a.neighbour != b.neighbour) return a.neighbour < b.neighbour;
            return a.source < b.source;
        };
        std::ranges::sort(edited, before);
        if (!std::ranges::is_sorted(records_, before)) std::ranges::sort(records_, before);
        std::vector<FaceRecord> merged(records_.size() + edited.size());
        std::ranges::merge(records_, edited, merged.begin(), before);
        records_ = std::move(merged);
    }

    /// Faces of the old mesh that stay as they are: in order already where that was in order.
    void listOldFaces() {
        Label patch = 0;
        for (Label f = 0; f < mesh_.faceCount(); ++f) {
            const Label own = meshCell_[index(mesh_.owner[index(f)])];
            if (!mesh_.isInternal(f)) {
                while (f >= mesh_.patches[index(patch)].start + mesh_.patches[index(patch)].size)
                    ++patch;
                if (own >= 0) records_.push_back({own, -1, patch, f, false});
                continue;
            }
            const Label other = meshCell_[index(mesh_.neighbour[index(f)])];
            if (own >= 0 && other >= 0) records_.push_back({own, other, -1, f, false});
        }
    }

    std::span<const Label> pointsOf(const FaceRecord& record) const {
        if (record.source < mesh_.faceCount()) return mesh_.faces[record.source];
        const auto& points = part_.mesh.faces[index(record.source - mesh_.faceCount())].points;
        return {points.data(), points.size()};
    }

    void numberPoints() {
        oldPoint_.assign(mesh_.points.size(), -1);
        newPoint_.assign(part_.mesh.points.size(), -1);
        for (const FaceRecord& record : records_) {
            const bool isOld = record.source < mesh_.faceCount();
            for (const Label p : pointsOf(record)) {
                if (isOld)
                    oldPoint_[index(p)] = 0;
                else if (p < toLabel(part_.meshPoint.size()) && part_.meshPoint[index(p)] >= 0)
                    oldPoint_[index(part_.meshPoint[index(p)])] = 0;
                else
                    newPoint_[index(p)] = 0;
            }
        }
        for (std::size_t p = 0; p < oldPoint_.size(); ++p)
            if (oldPoint_[p] == 0) {
                oldPoint_[p] = result_.pointCount();
                result_.points.push_back(mesh_.points[p]);
            }
        for (std::size_t p = 0; p < newPoint_.size(); ++p) {
            const Label meshPoint = p < part_.meshPoint.size() ? part_.meshPoint[p] : -1;
            if (meshPoint >= 0) {
                newPoint_[p] = oldPoint_[index(meshPoint)];
            } else if (newPoint_[p] == 0) {
                newPoint_[p] = result_.pointCount();
                result_.points.push_back(part_.mesh.points[p]);
            }
        }
    }

    void addPatches(const std::vector<std::string>& names, const std::vector<std::string>& types) {
        const Label oldCount = toLabel(mesh_.patches.size());
        std::vector<Label> sizes(index(oldCount) + names.size(), 0);
        Label internal = 0;
        for (const FaceRecord& record : records_) {
            if (record.patch < 0)
                ++internal;
            else
                ++sizes[index(record.patch)];
        }
        Label start = internal;
        for (std::size_t p = 0; p < sizes.size(); ++p) {
            Patch patch;
            if (toLabel(p) < oldCount) {
                patch = mesh_.patches[p];
                if (sizes[p] == 0) continue;
            } else {
                patch.name = freeName(names[p - index(oldCount)]);
                patch.type = types[p - index(oldCount)];
            }
            patch.start = start;
            patch.size = sizes[p];
            start += sizes[p];
            result_.patches.push_back(std::move(patch));
        }
        result_.neighbour.reserve(index(internal));
    }

    std::string freeName(std::string name) const {
        const auto isTaken = [&] {
            return std::ranges::any_of(result_.patches,
                                       [&](const Patch& p) { return p.name == name; });
        };
        while (isTaken())
            name += "_surface";
        return name;
    }

    void fillFaces() {
        result_.owner.reserve(records_.size());
        result_.faces.offsets.reserve(records_.size() + 1);
        for (const FaceRecord& record : records_) {
            result_.owner.push_back(record.owner);
            if (record.neighbour >= 0) result_.neighbour.push_back(record.neighbour);
            const Label size = toLabel(pointsOf(record).size());
            result_.faces.offsets.push_back(result_.faces.offsets.back() + size);
        }
        result_.faces.values.resize(index(result_.faces.offsets.back()));
        parallelFor(toLabel(records_.size()), [&](Label f) {
            const FaceRecord& record = records_[index(f)];
            const auto& numbers = record.source < mesh_.faceCount() ? oldPoint_ : newPoint_;
            const auto from = pointsOf(record);
            const auto to = result_.faces[f];
            for (std::size_t i = 0; i < from.size(); ++i)
                to[i] = numbers[index(from[record.isTurned && i > 0 ? from.size() - i : i])];
        });
    }

    void addCellZones() {
        if (mesh_.cellZones.empty()) return;
        std::vector<Label> zoneOf(index(mesh_.cellCount), -1);
        for (std::size_t z = 0; z < mesh_.cellZones.size(); ++z) {
            result_.cellZones.push_back({mesh_.cellZones[z].name, {}, {}});
            for (const Label c : mesh_.cellZones[z].labels)
                zoneOf[index(c)] = toLabel(z);
        }
        const auto add = [&](Label meshCell, Label cell) {
            if (const Label z = zoneOf[index(meshCell)]; z >= 0 && cell >= 0)
                result_.cellZones[index(z)].labels.push_back(cell);
        };
        for (Label c = 0; c < mesh_.cellCount; ++c)
            add(c, meshCell_[index(c)]);
        for (std::size_t c = 0; c < editCell_.size(); ++c)
            if (!part_.mesh.cells[c].frozen) add(part_.mesh.cells[c].origin, editCell_[c]);
        for (Zone& zone : result_.cellZones)
            std::ranges::sort(zone.labels);
    }

    const PolyMesh& mesh_;
    const EditPart& part_;
    PolyMesh result_;
    std::vector<Label> meshCell_; // old cell -> new cell, for untouched ones
    std::vector<Label> editCell_; // edit cell -> new cell
    std::vector<Label> oldPoint_;
    std::vector<Label> newPoint_;
    std::vector<FaceRecord> records_;
};

} // namespace

PolyMesh assemble(const PolyMesh& mesh,
                  const EditPart& part,
                  const std::vector<std::string>& regionNames,
                  const std::vector<std::string>& regionTypes) {
    return Assembly(mesh, part).run(regionNames, regionTypes);
}

} // namespace polymesh
