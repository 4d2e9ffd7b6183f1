// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/assemble.h"

#include "libpolymesh/base/freshList.h"
#include "libpolymesh/base/kept.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/base/parallelSort.h"

#include <algorithm>
#include <atomic>
#include <compare>

namespace polymesh {

namespace {

/// Where a face comes in the result: internal ones first, by owner and neighbour; then the
/// boundary's by patch. Equal ones in the order of their sources, old faces before edited ones.
struct FacePlace {
    Label patch = -1; // -1: internal
    Label owner = -1;
    Label neighbour = -1; // -1: boundary
    Label source = -1;    // face of the old mesh, or, counted on from there, edited face

    // NOLINTNEXTLINE(modernize-use-nullptr): what the compiler makes of it compares with 0
    auto operator<=>(const FacePlace&) const = default;
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
        meshCell_ = freshList<Label>(index(mesh_.cellCount), -1);
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

    /// The faces of the old mesh that stay, in their order in the result.
    std::vector<Label> listOldFaces() const {
        const Kept kept(mesh_.faceCount(), [&](Label f) {
            return meshCell_[index(mesh_.owner[index(f)])] >= 0 &&
                   (!mesh_.isInternal(f) || meshCell_[index(mesh_.neighbour[index(f)])] >= 0);
        });
        std::vector<Label> faces = freshList<Label>(index(kept.count()));
        kept.forEach([&](Label f, Label to) { faces[index(to)] = f; });
        const Label pairs = std::max(kept.count() - 1, Label{0});
        const Label wrong = parallelSum(pairs, Label{0}, [&](Label i) {
            return placeOfOld(faces[index(i + 1)]) < placeOfOld(faces[index(i)]) ? Label{1}
                                                                                 : Label{0};
        });
        if (wrong > 0) std::ranges::sort(faces, {}, [&](Label f) { return placeOfOld(f); });
        return faces;
    }

    FacePlace placeOfOld(Label f) const {
        const Label own = meshCell_[index(mesh_.owner[index(f)])];
        if (mesh_.isInternal(f)) return {-1, own, meshCell_[index(mesh_.neighbour[index(f)])], f};
        const auto after = std::ranges::upper_bound(mesh_.patches, f, {}, &Patch::start);
        return {toLabel(static_cast<std::size_t>(after - mesh_.patches.begin())) - 1, own, -1, f};
    }

    FacePlace placeOfEdited(Label f) const {
        const EditFace& face = part_.mesh.faces[index(f)];
        FacePlace place{-1, editCell_[index(face.owner)], -1, mesh_.faceCount() + f};
        if (face.isBoundary()) {
            place.patch = face.patch;
        } else {
            place.neighbour = editCell_[index(face.neighbour)];
            if (place.owner > place.neighbour) std::swap(place.owner, place.neighbour);
        }
        return place;
    }

    /// The edited faces in their order in the result.
    std::vector<FacePlace> listEditedFaces() const {
        const auto& faces = part_.mesh.faces;
        const Kept kept(toLabel(faces.size()),
                        [&](Label f) { return !faces[index(f)].isRemoved(); });
        std::vector<FacePlace> places = freshList<FacePlace>(index(kept.count()));
        kept.forEach([&](Label f, Label to) { places[index(to)] = placeOfEdited(f); });
        parallelSort(places);
        return places;
    }

    /// Merges old and edited faces, block by block of the old ones.
    void listFaces() {
        const std::vector<Label> old = listOldFaces();
        const std::vector<FacePlace> edited = listEditedFaces();
        places_ = freshList<FacePlace>(old.size() + edited.size());
        constexpr Label block = 1 << 13;
        const auto firstEdited = [&](Label i) {
            if (i == 0) return edited.begin();
            if (i >= toLabel(old.size())) return edited.end();
            return std::ranges::lower_bound(edited, placeOfOld(old[index(i)]));
        };
        parallelBlocks(toLabel(old.size()), block, [&](Label, Label first, Label last) {
            auto next = firstEdited(first);
            const auto end = firstEdited(last);
            auto to = places_.begin() + first + (next - edited.begin());
            for (Label i = first; i < last; ++i) {
                const FacePlace place = placeOfOld(old[index(i)]);
                for (; next != end && *next < place; ++next)
                    *to++ = *next;
                *to++ = place;
            }
            std::copy(next, end, to);
        });
        if (old.empty()) places_ = edited;
    }

    bool isOld(const FacePlace& place) const { return place.source < mesh_.faceCount(); }

    const EditFace& editFace(const FacePlace& place) const {
        return part_.mesh.faces[index(place.source - mesh_.faceCount())];
    }

    std::span<const Label> pointsOf(const FacePlace& place) const {
        if (isOld(place)) return mesh_.faces[place.source];
        const auto& points = editFace(place).points;
        return {points.data(), points.size()};
    }

    /// The point of the old mesh that an edited point is, or -1.
    Label meshPointOf(Label p) const {
        return p < toLabel(part_.meshPoint.size()) ? part_.meshPoint[index(p)] : -1;
    }

    void numberPoints() {
        oldPoint_ = freshList<Label>(mesh_.points.size(), -1);
        newPoint_ = freshList<Label>(part_.mesh.points.size(), -1);
        const auto use = [](std::vector<Label>& points, Label p) {
            std::atomic_ref<Label>(points[index(p)]).store(0, std::memory_order_relaxed);
        };
        parallelFor(toLabel(places_.size()), [&](Label f) {
            const FacePlace& place = places_[index(f)];
            for (const Label p : pointsOf(place)) {
                const bool isNew = !isOld(place) && meshPointOf(p) < 0;
                use(isNew ? newPoint_ : oldPoint_, isOld(place) || isNew ? p : meshPointOf(p));
            }
        });
        placePoints();
    }

    /// Old points first, then new ones, each in their order.
    void placePoints() {
        const Kept old(toLabel(oldPoint_.size()),
                       [&](Label p) { return oldPoint_[index(p)] == 0; });
        const Kept added(toLabel(newPoint_.size()),
                         [&](Label p) { return newPoint_[index(p)] == 0 && meshPointOf(p) < 0; });
        result_.points = freshList<Vec3>(index(old.count() + added.count()));
        old.forEach([&](Label p, Label to) {
            oldPoint_[index(p)] = to;
            result_.points[index(to)] = mesh_.points[index(p)];
        });
        added.forEach([&](Label p, Label to) {
            newPoint_[index(p)] = old.count() + to;
            result_.points[index(old.count() + to)] = part_.mesh.points[index(p)];
        });
        parallelFor(toLabel(newPoint_.size()), [&](Label p) {
            if (const Label meshPoint = meshPointOf(p); meshPoint >= 0)
                newPoint_[index(p)] = oldPoint_[index(meshPoint)];
        });
    }

    void addPatches(const std::vector<std::string>& names, const std::vector<std::string>& types) {
        const Label oldCount = toLabel(mesh_.patches.size());
        std::vector<Label> sizes(index(oldCount) + names.size(), 0);
        const auto boundary = std::ranges::lower_bound(places_, 0, {}, &FacePlace::patch);
        for (auto place = boundary; place != places_.end(); ++place)
            ++sizes[index(place->patch)];
        internalCount_ = toLabel(static_cast<std::size_t>(boundary - places_.begin()));
        Label start = internalCount_;
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
        const Label count = toLabel(places_.size());
        result_.owner = freshList<Label>(places_.size());
        result_.neighbour = freshList<Label>(index(internalCount_));
        auto& offsets = result_.faces.offsets;
        offsets = freshList<Label>(places_.size() + 1);
        parallelFor(count, [&](Label f) {
            const FacePlace& place = places_[index(f)];
            result_.owner[index(f)] = place.owner;
            if (f < internalCount_) result_.neighbour[index(f)] = place.neighbour;
            offsets[index(f) + 1] = toLabel(pointsOf(place).size());
        });
        for (std::size_t f = 1; f < offsets.size(); ++f)
            offsets[f] += offsets[f - 1];
        result_.faces.values = freshList<Label>(index(offsets.back()));
        parallelFor(count, [&](Label f) {
            const FacePlace& place = places_[index(f)];
            const auto& numbers = isOld(place) ? oldPoint_ : newPoint_;
            // An edited face may have its sides the other way round.
            const bool isTurned =
                !isOld(place) && place.owner != editCell_[index(editFace(place).owner)];
            const auto from = pointsOf(place);
            const auto to = result_.faces[f];
            for (std::size_t i = 0; i < from.size(); ++i)
                to[i] = numbers[index(from[isTurned && i > 0 ? from.size() - i : i])];
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
    std::vector<FacePlace> places_; // of all faces of the result
    Label internalCount_ = 0;
};

} // namespace

PolyMesh assemble(const PolyMesh& mesh,
                  const EditPart& part,
                  const std::vector<std::string>& regionNames,
                  const std::vector<std::string>& regionTypes) {
    return Assembly(mesh, part).run(regionNames, regionTypes);
}

} // namespace polymesh
