// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/rejoinFaces.h"

#include "libpolymesh/base/disjointSets.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace polymesh {

namespace {

/// Faces that are one again.
struct Polygons {
    std::vector<Label> gone;                   // ascending
    std::map<Label, std::vector<Label>> loops; // of the faces that stay
};

class Rejoiner {
public:
    Rejoiner(const EditedMesh& edited, const SubdivisionPlan& plan, std::span<const Label> cells)
        : edited_(edited), mesh_(edited.mesh), plan_(plan) {
        for (const Label cell : cells)
            faces_.insert(faces_.end(), plan.cellFaces[cell].begin(), plan.cellFaces[cell].end());
        std::ranges::sort(faces_);
        faces_.erase(std::unique(faces_.begin(), faces_.end()), faces_.end());
        std::erase_if(faces_, [&](Label f) { return f >= mesh_.faceCount() - edited.rimFaces; });
        groups_.reset(toLabel(faces_.size()));
        uses_.assign(index(plan.edges.size()), 0);
        for (const Label edge : plan.edges.ofCorner)
            ++uses_[index(edge)];
    }

    Polygons find() {
        joinAlongEdges();
        std::map<Label, std::vector<Label>> groups;
        for (std::size_t i = 0; i < faces_.size(); ++i)
            groups[groups_.lowest(toLabel(i))].push_back(faces_[i]);
        Polygons polygons;
        for (const auto& [first, faces] : groups) {
            if (faces.size() < 2) continue;
            std::vector<Label> loop = outlineOf(faces);
            if (loop.empty()) continue;
            polygons.gone.insert(polygons.gone.end(), faces.begin() + 1, faces.end());
            polygons.loops[faces.front()] = std::move(loop);
        }
        std::ranges::sort(polygons.gone);
        return polygons;
    }

private:
    /// The cells and zones of a face, and its origin on the boundary.
    auto keyOf(Label face) const {
        std::vector<std::size_t> zones;
        for (std::size_t z = 0; z < mesh_.faceZones.size(); ++z)
            if (std::ranges::binary_search(mesh_.faceZones[z].labels, face)) zones.push_back(z);
        const Label internal = mesh_.internalFaceCount();
        return std::tuple(mesh_.owner[index(face)],
                          mesh_.isInternal(face) ? mesh_.neighbour[index(face)] : -1,
                          mesh_.isInternal(face) ? -1
                                                 : edited_.boundaryOrigin[index(face - internal)],
                          std::move(zones));
    }

    void joinAlongEdges() {
        std::map<Label, std::size_t> first; // by edge: the place of its first face
        for (std::size_t i = 0; i < faces_.size(); ++i)
            for (Label c = mesh_.faces.offsets[index(faces_[i])];
                 c < mesh_.faces.offsets[index(faces_[i]) + 1];
                 ++c) {
                const Label edge = plan_.edges.ofCorner[index(c)];
                if (uses_[index(edge)] != 2) continue;
                const auto [at, isNew] = first.try_emplace(edge, i);
                if (isNew || keyOf(faces_[at->second]) != keyOf(faces_[i])) continue;
                removed_.insert(edge);
                groups_.join(toLabel(i), toLabel(at->second));
            }
    }

    /// The polygon round some faces; empty when it is not one.
    std::vector<Label> outlineOf(std::span<const Label> faces) const {
        std::map<Label, Label> next;
        std::size_t steps = 0;
        for (const Label face : faces) {
            const auto loop = mesh_.faces[face];
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Label corner = mesh_.faces.offsets[index(face)] + toLabel(i);
                if (removed_.contains(plan_.edges.ofCorner[index(corner)])) continue;
                next[loop[i]] = loop[(i + 1) % loop.size()];
                ++steps;
            }
        }
        if (steps < 3 || next.size() != steps) return {};
        std::vector<Label> outline{next.begin()->first};
        while (outline.size() < steps && next.contains(outline.back()))
            outline.push_back(next[outline.back()]);
        const std::set<Label> met(outline.begin(), outline.end());
        if (met.size() != steps) return {};
        return outline;
    }

    const EditedMesh& edited_;
    const PolyMesh& mesh_;
    const SubdivisionPlan& plan_;
    std::vector<Label> faces_; // ascending
    DisjointSets groups_;      // of places in faces_
    std::vector<Label> uses_;  // by edge: faces
    std::set<Label> removed_;  // edges
};

void removeFromZones(std::vector<Zone>& zones, const std::vector<Label>& gone) {
    for (Zone& zone : zones) {
        Zone kept{zone.name, {}, {}};
        for (std::size_t i = 0; i < zone.labels.size(); ++i) {
            const auto at = std::ranges::lower_bound(gone, zone.labels[i]);
            if (at != gone.end() && *at == zone.labels[i]) continue;
            kept.labels.push_back(zone.labels[i] - static_cast<Label>(at - gone.begin()));
            if (i < zone.flip.size()) kept.flip.push_back(zone.flip[i]);
        }
        zone = std::move(kept);
    }
}

} // namespace

Label rejoinFaces(EditedMesh& edited, const SubdivisionPlan& plan, std::span<const Label> cells) {
    const Polygons polygons = Rejoiner(edited, plan, cells).find();
    const std::vector<Label>& gone = polygons.gone;
    if (gone.empty()) return 0;
    PolyMesh& mesh = edited.mesh;
    Rows<Label> rows;
    std::vector<Label> owner;
    std::vector<Label> neighbour;
    std::vector<Label> from;
    std::vector<Label> origin;
    for (Label face = 0; face < mesh.faceCount(); ++face) {
        if (std::ranges::binary_search(gone, face)) continue;
        const auto loop = polygons.loops.find(face);
        if (loop != polygons.loops.end())
            rows.add(loop->second);
        else
            rows.add(std::as_const(mesh.faces)[face]);
        owner.push_back(mesh.owner[index(face)]);
        if (mesh.isInternal(face)) {
            neighbour.push_back(mesh.neighbour[index(face)]);
            continue;
        }
        from.push_back(edited.boundaryFrom[index(face - mesh.internalFaceCount())]);
        origin.push_back(edited.boundaryOrigin[index(face - mesh.internalFaceCount())]);
    }
    const auto before = [&](Label face) {
        return static_cast<Label>(std::ranges::lower_bound(gone, face) - gone.begin());
    };
    for (Patch& patch : mesh.patches) {
        patch.size -= before(patch.start + patch.size) - before(patch.start);
        patch.start -= before(patch.start);
    }
    removeFromZones(mesh.faceZones, gone);
    mesh.faces = std::move(rows);
    mesh.owner = std::move(owner);
    mesh.neighbour = std::move(neighbour);
    edited.boundaryFrom = std::move(from);
    edited.boundaryOrigin = std::move(origin);
    return toLabel(gone.size());
}

} // namespace polymesh
