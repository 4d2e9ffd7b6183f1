// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/meshRegion.h"

#include "libpolymesh/base/parallelSort.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace polymesh {

namespace {

using Flags = std::vector<char>;

template<class Use>
void forCellsOf(const PolyMesh& mesh, Label face, Use&& use) {
    use(mesh.owner[index(face)]);
    if (mesh.isInternal(face)) use(mesh.neighbour[index(face)]);
}

/// Adds all cells that share a point with one of the flagged cells.
void addRing(const PolyMesh& mesh, Flags& isIn) {
    Flags isPoint(mesh.points.size(), 0);
    for (Label face = 0; face < mesh.faceCount(); ++face) {
        bool isHere = false;
        forCellsOf(mesh, face, [&](Label c) { isHere = isHere || isIn[index(c)] != 0; });
        if (!isHere) continue;
        for (const Label p : mesh.faces[face])
            isPoint[index(p)] = 1;
    }
    for (Label face = 0; face < mesh.faceCount(); ++face)
        if (std::ranges::any_of(mesh.faces[face], [&](Label p) { return isPoint[index(p)] != 0; }))
            forCellsOf(mesh, face, [&](Label c) { isIn[index(c)] = 1; });
}

Flags cellsRound(const PolyMesh& mesh, std::span<const Label> cells) {
    Flags isIn(index(mesh.cellCount), 0);
    for (const Label cell : cells)
        isIn[index(cell)] = 1;
    addRing(mesh, isIn);
    addRing(mesh, isIn);
    return isIn;
}

/// Numbers what is flagged; the others get -1.
std::vector<Label> numbered(const Flags& flags, std::vector<Label>& chosen) {
    std::vector<Label> numbers(flags.size(), -1);
    for (std::size_t i = 0; i < flags.size(); ++i) {
        if (flags[i] == 0) continue;
        numbers[i] = toLabel(chosen.size());
        chosen.push_back(toLabel(i));
    }
    return numbers;
}

/// Cuts a region out.
class RegionCutter {
public:
    RegionCutter(const EditedMesh& whole, std::span<const Label> cells)
        : whole_(whole), mesh_(whole.mesh), isIn_(cellsRound(mesh_, cells)) {
        cellNumber_ = numbered(isIn_, region_.part.cellFrom);
        numberPoints();
        part().cellCount = toLabel(region_.part.cellFrom.size());
        for (const Label p : region_.points)
            part().points.push_back(mesh_.points[index(p)]);
        faceNumber_.assign(index(mesh_.faceCount()), -1);
    }

    MeshRegion cut() {
        addInternalFaces();
        addPatches();
        addRim();
        addBends();
        for (const Zone& zone : mesh_.cellZones)
            part().cellZones.push_back(zoneWith(zone, cellNumber_));
        for (const Zone& zone : mesh_.faceZones)
            part().faceZones.push_back(zoneWith(zone, faceNumber_));
        return std::move(region_);
    }

private:
    PolyMesh& part() { return region_.part.mesh; }

    bool hasCell(Label cell) const { return isIn_[index(cell)] != 0; }

    void numberPoints() {
        Flags isUsed(mesh_.points.size(), 0);
        for (Label face = 0; face < mesh_.faceCount(); ++face) {
            bool isHere = false;
            forCellsOf(mesh_, face, [&](Label c) { isHere = isHere || hasCell(c); });
            if (!isHere) continue;
            for (const Label p : mesh_.faces[face])
                isUsed[index(p)] = 1;
        }
        pointNumber_ = numbered(isUsed, region_.points);
    }

    void addFace(Label face, Label owner, bool isTurned) {
        loop_.clear();
        for (const Label p : mesh_.faces[face])
            loop_.push_back(pointNumber_[index(p)]);
        if (isTurned) std::ranges::reverse(loop_);
        part().faces.add(loop_);
        part().owner.push_back(cellNumber_[index(owner)]);
    }

    void addInternalFaces() {
        for (Label face = 0; face < mesh_.internalFaceCount(); ++face) {
            const Label owner = mesh_.owner[index(face)];
            const Label neighbour = mesh_.neighbour[index(face)];
            if (!hasCell(owner) || !hasCell(neighbour)) continue;
            faceNumber_[index(face)] = part().faceCount();
            addFace(face, owner, false);
            part().neighbour.push_back(cellNumber_[index(neighbour)]);
        }
    }

    void addPatches() {
        for (const Patch& patch : mesh_.patches) {
            Patch own = patch;
            own.start = part().faceCount();
            for (Label face = patch.start; face < patch.start + patch.size; ++face) {
                if (!hasCell(mesh_.owner[index(face)])) continue;
                faceNumber_[index(face)] = part().faceCount();
                addFace(face, mesh_.owner[index(face)], false);
                region_.part.boundaryFrom.push_back(face);
                region_.part.boundaryOrigin.push_back(
                    whole_.boundaryOrigin[index(face - mesh_.internalFaceCount())]);
            }
            own.size = part().faceCount() - own.start;
            part().patches.push_back(own);
        }
        const Label firstRim = mesh_.faceCount() - whole_.rimFaces;
        region_.part.rimFaces = static_cast<Label>(std::ranges::count_if(
            region_.part.boundaryFrom, [&](Label face) { return face >= firstRim; }));
    }

    void addRim() {
        Patch rim{"rim", "patch", part().faceCount(), 0, {}};
        for (Label face = 0; face < mesh_.internalFaceCount(); ++face) {
            const Label owner = mesh_.owner[index(face)];
            const Label neighbour = mesh_.neighbour[index(face)];
            if (hasCell(owner) == hasCell(neighbour)) continue;
            addFace(face, hasCell(owner) ? owner : neighbour, !hasCell(owner));
            region_.part.boundaryFrom.push_back(face);
            region_.part.boundaryOrigin.push_back(-1);
            ++rim.size;
        }
        region_.part.rimFaces += rim.size;
        part().patches.push_back(rim);
    }

    void addBends() {
        for (const Bend& bend : whole_.bends) {
            const Label a = pointNumber_[index(bend.ends[0])];
            const Label b = pointNumber_[index(bend.ends[1])];
            if (a < 0 || b < 0) continue;
            region_.bends.push_back(bend);
            region_.part.bends.push_back({{a, b}, bend.at});
        }
    }

    static Zone zoneWith(const Zone& zone, const std::vector<Label>& numbers) {
        Zone own{zone.name, {}, {}};
        for (std::size_t i = 0; i < zone.labels.size(); ++i) {
            const Label number = numbers[index(zone.labels[i])];
            if (number < 0) continue;
            own.labels.push_back(number);
            if (i < zone.flip.size()) own.flip.push_back(zone.flip[i]);
        }
        return own;
    }

    const EditedMesh& whole_;
    const PolyMesh& mesh_;
    Flags isIn_;
    MeshRegion region_;
    std::vector<Label> cellNumber_;
    std::vector<Label> pointNumber_;
    std::vector<Label> faceNumber_;
    std::vector<Label> loop_;
};

/// A face of the mesh into which the region is put back.
struct JoinedFace {
    Label owner;
    Label neighbour; // -1 on the boundary
    Label wholeFace; // that it is, or -1
    Label partFace;  // that it is, or -1
    bool isTurned = false;

    bool operator<(const JoinedFace& other) const {
        return std::tuple(owner, neighbour, wholeFace, partFace) <
               std::tuple(other.owner, other.neighbour, other.wholeFace, other.partFace);
    }
};

/// Puts a region back.
class RegionJoiner {
public:
    RegionJoiner(const EditedMesh& whole, const MeshRegion& region, const EditedMesh& part)
        : whole_(whole), mesh_(whole.mesh), region_(region), part_(part) {
        numberCells();
    }

    JoinedRegion join() {
        addInternal();
        for (std::size_t p = 0; p < mesh_.patches.size(); ++p)
            addPatch(p);
        addPoints();
        addFaces();
        joined_.mesh.cellCount = toLabel(joined_.cellFrom.size());
        joined_.mesh.pointZones = mesh_.pointZones;
        addCellZones();
        addFaceZones();
        joinBends();
        joined_.rimFaces = 0;
        const Label firstRim = mesh_.faceCount() - whole_.rimFaces;
        for (const JoinedFace& f : list_)
            joined_.rimFaces += f.neighbour < 0 && f.wholeFace >= firstRim ? 1 : 0;
        return {std::move(joined_), std::move(partCellNumber_)};
    }

private:
    /// Where a face of the whole, or a piece of it, is.
    struct WholePlace {
        Label face;
        Label place;
        bool isTurned;
    };

    bool isInPart(Label cell) const { return isInPart_[index(cell)] != 0; }

    /// Cells that are left keep their order, new ones follow.
    void numberCells() {
        const Rows<Label>& faces = part_.mesh.faces;
        isInPart_.assign(index(mesh_.cellCount), 0);
        for (const Label cell : region_.part.cellFrom)
            isInPart_[index(cell)] = 1;
        std::vector<Label> partCell(index(mesh_.cellCount), -1);
        for (Label c = part_.mesh.cellCount - 1; c >= 0; --c)
            partCell[index(part_.cellFrom[index(c)])] = c;
        wholeCellNumber_.assign(index(mesh_.cellCount), -1);
        partCellNumber_.assign(index(part_.mesh.cellCount), -1);
        for (Label cell = 0; cell < mesh_.cellCount; ++cell) {
            if (isInPart(cell) && partCell[index(cell)] < 0) continue; // joined with another
            const Label number = toLabel(joined_.cellFrom.size());
            joined_.cellFrom.push_back(whole_.cellFrom[index(cell)]);
            wholeCellNumber_[index(cell)] = number;
            if (isInPart(cell)) partCellNumber_[index(partCell[index(cell)])] = number;
        }
        for (Label c = 0; c < part_.mesh.cellCount; ++c) {
            if (partCellNumber_[index(c)] >= 0) continue;
            partCellNumber_[index(c)] = toLabel(joined_.cellFrom.size());
            joined_.cellFrom.push_back(whole_.cellFrom[index(part_.cellFrom[index(c)])]);
        }
        partFacePlace_.assign(index(faces.size()), -1);
        isPartFaceTurned_.assign(index(faces.size()), 0);
    }

    void addInternal() {
        for (Label face = 0; face < mesh_.internalFaceCount(); ++face)
            if (!isInPart(mesh_.owner[index(face)]) && !isInPart(mesh_.neighbour[index(face)]))
                list_.push_back({wholeCellNumber_[index(mesh_.owner[index(face)])],
                                 wholeCellNumber_[index(mesh_.neighbour[index(face)])],
                                 face,
                                 -1});
        for (Label face = 0; face < part_.mesh.internalFaceCount(); ++face)
            addPartFace(partCellNumber_[index(part_.mesh.owner[index(face)])],
                        partCellNumber_[index(part_.mesh.neighbour[index(face)])],
                        -1,
                        face);
        for (Label face = firstRim(); face < part_.mesh.faceCount(); ++face) {
            const Label from = part_.boundaryFrom[index(face - part_.mesh.internalFaceCount())];
            const Label owner = mesh_.owner[index(from)];
            const Label other = isInPart(owner) ? mesh_.neighbour[index(from)] : owner;
            addPartFace(partCellNumber_[index(part_.mesh.owner[index(face)])],
                        wholeCellNumber_[index(other)],
                        from,
                        face);
        }
        parallelSort(list_);
        joined_.mesh.neighbour.reserve(list_.size());
        for (const JoinedFace& f : list_)
            joined_.mesh.neighbour.push_back(f.neighbour);
    }

    Label firstRim() const { return part_.mesh.patches.back().start; }

    /// The face's normal leaves `inside`.
    void addPartFace(Label inside, Label outside, Label wholeFace, Label partFace) {
        const bool isTurned = inside > outside;
        list_.push_back(
            {std::min(inside, outside), std::max(inside, outside), wholeFace, partFace, isTurned});
    }

    /// The faces of a patch; those of the region stand where what they are from stood.
    void addPatch(std::size_t p) {
        const Patch& patch = mesh_.patches[p];
        const Patch& edited = part_.mesh.patches[p];
        const Label internal = part_.mesh.internalFaceCount();
        Patch own = patch;
        own.start = toLabel(list_.size());
        Label next = edited.start;
        for (Label face = patch.start; face < patch.start + patch.size; ++face) {
            if (!isInPart(mesh_.owner[index(face)])) {
                list_.push_back({wholeCellNumber_[index(mesh_.owner[index(face)])], -1, face, -1});
                continue;
            }
            for (; next < edited.start + edited.size &&
                   part_.boundaryFrom[index(next - internal)] == face;
                 ++next)
                list_.push_back(
                    {partCellNumber_[index(part_.mesh.owner[index(next)])], -1, face, next});
        }
        own.size = toLabel(list_.size()) - own.start;
        joined_.mesh.patches.push_back(own);
    }

    void addPoints() {
        const std::vector<Vec3>& points = part_.mesh.points;
        joined_.mesh.points = mesh_.points;
        joined_.mesh.points.insert(joined_.mesh.points.end(),
                                   points.begin() +
                                       static_cast<std::ptrdiff_t>(region_.points.size()),
                                   points.end());
    }

    Label pointInWhole(Label partPoint) const {
        const Label old = toLabel(region_.points.size());
        return partPoint < old ? region_.points[index(partPoint)]
                               : mesh_.pointCount() + partPoint - old;
    }

    void addFaces() {
        PolyMesh& mesh = joined_.mesh;
        mesh.owner.reserve(list_.size());
        std::vector<Label> loop;
        for (std::size_t i = 0; i < list_.size(); ++i) {
            const JoinedFace& f = list_[i];
            loop.clear();
            if (f.partFace < 0)
                loop.assign(mesh_.faces[f.wholeFace].begin(), mesh_.faces[f.wholeFace].end());
            else
                for (const Label p : part_.mesh.faces[f.partFace])
                    loop.push_back(pointInWhole(p));
            if (f.isTurned) std::ranges::reverse(loop);
            mesh.faces.add(loop);
            mesh.owner.push_back(f.owner);
            if (f.neighbour < 0) {
                const std::size_t place = index(f.wholeFace - mesh_.internalFaceCount());
                joined_.boundaryFrom.push_back(whole_.boundaryFrom[place]);
                joined_.boundaryOrigin.push_back(whole_.boundaryOrigin[place]);
            }
            if (f.wholeFace >= 0) {
                const bool wasOwner = f.partFace < 0 || isInPart(mesh_.owner[index(f.wholeFace)]);
                wholePlaces_.push_back({f.wholeFace, toLabel(i), wasOwner == f.isTurned});
            }
            if (f.partFace < 0) continue;
            partFacePlace_[index(f.partFace)] = toLabel(i);
            isPartFaceTurned_[index(f.partFace)] = f.isTurned ? 1 : 0;
        }
    }

    void addCellZones() {
        for (std::size_t z = 0; z < mesh_.cellZones.size(); ++z) {
            Zone zone{mesh_.cellZones[z].name, {}, {}};
            for (const Label cell : mesh_.cellZones[z].labels)
                if (!isInPart(cell)) zone.labels.push_back(wholeCellNumber_[index(cell)]);
            for (const Label cell : part_.mesh.cellZones[z].labels)
                zone.labels.push_back(partCellNumber_[index(cell)]);
            std::ranges::sort(zone.labels);
            joined_.mesh.cellZones.push_back(std::move(zone));
        }
    }

    /// Faces between the region and the rest are in the zones of the whole only.
    void addFaceZones() {
        std::ranges::sort(
            wholePlaces_, {}, [](const WholePlace& at) { return std::pair(at.face, at.place); });
        for (std::size_t z = 0; z < mesh_.faceZones.size(); ++z) {
            const Zone& outside = mesh_.faceZones[z];
            const Zone& inside = part_.mesh.faceZones[z];
            std::vector<std::pair<Label, bool>> list;
            const auto flip = [](const Zone& zone, std::size_t i) {
                return i < zone.flip.size() && zone.flip[i];
            };
            for (std::size_t i = 0; i < outside.labels.size(); ++i) {
                if (!isOutside(outside.labels[i])) continue;
                auto at = std::ranges::lower_bound(
                    wholePlaces_, outside.labels[i], {}, &WholePlace::face);
                for (; at != wholePlaces_.end() && at->face == outside.labels[i]; ++at)
                    list.emplace_back(at->place, flip(outside, i) != at->isTurned);
            }
            for (std::size_t i = 0; i < inside.labels.size(); ++i) {
                const std::size_t face = index(inside.labels[i]);
                list.emplace_back(partFacePlace_[face],
                                  flip(inside, i) != (isPartFaceTurned_[face] != 0));
            }
            std::ranges::sort(list);
            Zone zone{outside.name, {}, {}};
            for (const auto& [face, isFlipped] : list) {
                zone.labels.push_back(face);
                zone.flip.push_back(isFlipped);
            }
            joined_.mesh.faceZones.push_back(std::move(zone));
        }
    }

    /// Whether a face of the whole is not within the region.
    bool isOutside(Label face) const {
        return !isInPart(mesh_.owner[index(face)]) ||
               (mesh_.isInternal(face) && !isInPart(mesh_.neighbour[index(face)]));
    }

    /// Bends that are points now are no bends any more.
    void joinBends() {
        Bends left;
        for (const Bend& bend : part_.bends)
            left.push_back({{pointInWhole(bend.ends[0]), pointInWhole(bend.ends[1])}, bend.at});
        for (const Bend& bend : whole_.bends) {
            const bool wasInPart = findBend(region_.bends, bend.ends[0], bend.ends[1]) != nullptr;
            const bool isGone = wasInPart && findBend(left, bend.ends[0], bend.ends[1]) == nullptr;
            if (!isGone) joined_.bends.push_back(bend);
        }
    }

    const EditedMesh& whole_;
    const PolyMesh& mesh_;
    const MeshRegion& region_;
    const EditedMesh& part_;
    EditedMesh joined_;
    std::vector<JoinedFace> list_;
    std::vector<char> isInPart_;
    std::vector<Label> wholeCellNumber_;
    std::vector<Label> partCellNumber_;
    std::vector<WholePlace> wholePlaces_;
    std::vector<Label> partFacePlace_;
    std::vector<char> isPartFaceTurned_;
};

} // namespace

EditedMesh unedited(PolyMesh mesh) {
    EditedMesh edited;
    edited.boundaryFrom.resize(index(mesh.faceCount() - mesh.internalFaceCount()));
    std::iota(edited.boundaryFrom.begin(), edited.boundaryFrom.end(), 0);
    edited.boundaryOrigin = edited.boundaryFrom;
    edited.cellFrom.resize(index(mesh.cellCount));
    std::iota(edited.cellFrom.begin(), edited.cellFrom.end(), 0);
    edited.mesh = std::move(mesh);
    return edited;
}

MeshRegion regionRound(const EditedMesh& whole, std::span<const Label> cells) {
    return RegionCutter(whole, cells).cut();
}

JoinedRegion withRegion(const EditedMesh& whole, const MeshRegion& region, const EditedMesh& part) {
    return RegionJoiner(whole, region, part).join();
}

} // namespace polymesh
