// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/meshPart.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/mesh/cellGeometry.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>

namespace polymesh {

namespace {

using Flags = std::vector<std::uint8_t>;

/// Sets the flags of both cells of each face for which `isChosen`.
template<class Chosen>
void flagCells(const PolyMesh& mesh, Chosen&& isChosen, Flags& cells) {
    Flags chosen(index(mesh.faceCount()), 0);
    parallelFor(mesh.faceCount(), [&](Label f) { chosen[index(f)] = isChosen(f); });
    for (Label f = 0; f < mesh.faceCount(); ++f) {
        if (!chosen[index(f)]) continue;
        cells[index(mesh.owner[index(f)])] = 1;
        if (mesh.isInternal(f)) cells[index(mesh.neighbour[index(f)])] = 1;
    }
}

Label otherCellOf(const PolyMesh& mesh, Label f) {
    return mesh.isInternal(f) ? mesh.neighbour[index(f)] : -1;
}

bool isCellFlagged(const PolyMesh& mesh, const Flags& cells, Label f) {
    const Label other = otherCellOf(mesh, f);
    return cells[index(mesh.owner[index(f)])] || (other >= 0 && cells[index(other)]);
}

/// Numbers the elements that are flagged; the others get -1.
std::vector<Label> numbered(const Flags& flags, std::vector<Label>& chosen) {
    std::vector<Label> numbers(flags.size(), -1);
    for (std::size_t i = 0; i < flags.size(); ++i)
        if (flags[i]) {
            numbers[i] = toLabel(chosen.size());
            chosen.push_back(toLabel(i));
        }
    return numbers;
}

void addFaces(const PolyMesh& mesh,
              const std::vector<Label>& cellNumbers,
              const std::vector<Label>& pointNumbers,
              MeshPart& part) {
    for (const Label f : part.faces) {
        EditFace face;
        for (const Label p : mesh.faces[f])
            face.points.push_back(pointNumbers[index(p)]);
        const Label other = otherCellOf(mesh, f);
        face.owner = cellNumbers[index(mesh.owner[index(f)])];
        face.neighbour = other < 0 ? -1 : cellNumbers[index(other)];
        face.patch = f;
        for (const Label c : {face.owner, face.neighbour})
            if (c >= 0) part.mesh.cells[index(c)].faces.push_back(toLabel(part.mesh.faces.size()));
        part.mesh.faces.push_back(face);
    }
}

/// Frozen cells fix their points; sizes are those of cubes of the same volume.
void finishCells(MeshPart& part) {
    for (const EditFace& face : part.mesh.faces)
        for (const Label c : {face.owner, face.neighbour})
            if (c >= 0 && part.mesh.cells[index(c)].frozen)
                for (const Label p : face.points)
                    part.mesh.ranks[index(p)] = PointRank::fixed;
    parallelFor(toLabel(part.mesh.cells.size()), [&](Label c) {
        EditCell& cell = part.mesh.cells[index(c)];
        if (cell.frozen) return;
        std::vector<FaceGeometry> outward;
        for (const Label f : cell.faces) {
            const EditFace& face = part.mesh.faces[index(f)];
            outward.push_back(
                faceGeometry(part.mesh.points, {face.points.data(), face.points.size()}));
            if (face.owner != c) outward.back().area = -outward.back().area;
        }
        cell.size = std::cbrt(std::abs(cellGeometry(outward).volume));
    });
}

} // namespace

MeshPart partRound(const PolyMesh& mesh, std::span<const Label> cells) {
    Flags centre(index(mesh.cellCount), 0);
    for (const Label c : cells)
        centre[index(c)] = 1;
    Flags centrePoints(mesh.points.size(), 0);
    for (Label f = 0; f < mesh.faceCount(); ++f)
        if (isCellFlagged(mesh, centre, f))
            for (const Label p : mesh.faces[f])
                centrePoints[index(p)] = 1;
    Flags edited = centre;
    flagCells(
        mesh,
        [&](Label f) {
            const auto corners = mesh.faces[f];
            return std::any_of(
                corners.begin(), corners.end(), [&](Label p) { return centrePoints[index(p)]; });
        },
        edited);
    Flags inPart = edited;
    flagCells(
        mesh, [&](Label f) { return isCellFlagged(mesh, edited, f); }, inPart);

    MeshPart part;
    const std::vector<Label> cellNumbers = numbered(inPart, part.cells);
    Flags points(mesh.points.size(), 0);
    for (Label f = 0; f < mesh.faceCount(); ++f) {
        if (!isCellFlagged(mesh, edited, f)) continue;
        part.faces.push_back(f);
        for (const Label p : mesh.faces[f])
            points[index(p)] = 1;
    }
    const std::vector<Label> pointNumbers = numbered(points, part.points);
    for (const Label p : part.points)
        part.mesh.points.push_back(mesh.points[index(p)]);
    part.mesh.ranks.assign(part.points.size(), PointRank::interior);
    part.mesh.cells.resize(part.cells.size());
    for (std::size_t c = 0; c < part.cells.size(); ++c) {
        part.mesh.cells[c].origin = part.cells[c];
        part.mesh.cells[c].frozen = !edited[index(part.cells[c])];
    }
    addFaces(mesh, cellNumbers, pointNumbers, part);
    finishCells(part);
    return part;
}

namespace {

/// A face of the new mesh.
struct NewFace {
    Label owner = -1;
    Label neighbour = -1;
    Label source = -1;    // face of the old mesh that it is or is a part of; -1: none
    Label edited = -1;    // face of the part; -1: as in the old mesh
    bool flipped = false; // against its corners there
};

class PartJoiner {
public:
    PartJoiner(const PolyMesh& mesh, const MeshPart& part) : mesh_(mesh), part_(part) {}

    JoinedPart join() {
        numberElements();
        gatherFaces();
        addPoints();
        addFaces();
        addPatches();
        addZones();
        std::vector<Label> origins(index(mesh_.cellCount));
        std::iota(origins.begin(), origins.end(), 0);
        origins.insert(origins.end(), addedOrigins_.begin(), addedOrigins_.end());
        return {std::move(result_), std::move(cells_), std::move(origins)};
    }

private:
    static constexpr Label unnumbered = -2;

    /// Labels of the part's points and cells in the new mesh: new ones come last, cells in the
    /// order of those that they are parts of.
    void numberElements() {
        numberPoints();
        cells_ = part_.cells;
        const std::size_t old = cells_.size();
        std::vector<Label> added;
        for (std::size_t c = old; c < part_.mesh.cells.size(); ++c)
            if (!part_.mesh.cells[c].isRemoved()) added.push_back(toLabel(c));
        std::stable_sort(added.begin(), added.end(), [&](Label a, Label b) {
            return part_.mesh.cells[index(a)].origin < part_.mesh.cells[index(b)].origin;
        });
        cells_.resize(part_.mesh.cells.size(), -1);
        for (const Label c : added) {
            cells_[index(c)] = mesh_.cellCount + toLabel(addedOrigins_.size());
            addedOrigins_.push_back(part_.mesh.cells[index(c)].origin);
        }
    }

    /// New points that no face uses any more are left out.
    void numberPoints() {
        points_ = part_.points;
        points_.resize(part_.mesh.points.size(), -1);
        for (const EditFace& face : part_.mesh.faces)
            for (const Label p : face.points)
                if (!face.isRemoved() && points_[index(p)] < 0) points_[index(p)] = unnumbered;
        for (std::size_t p = part_.points.size(); p < points_.size(); ++p)
            if (points_[p] == unnumbered) {
                points_[p] = mesh_.pointCount() + toLabel(addedPoints_.size());
                addedPoints_.push_back(part_.mesh.points[p]);
            }
    }

    NewFace asNewFace(Label f) const {
        const EditFace& face = part_.mesh.faces[index(f)];
        NewFace value{cells_[index(face.owner)], -1, face.patch, f, false};
        if (!face.isBoundary()) value.neighbour = cells_[index(face.neighbour)];
        if (value.neighbour >= 0 && value.neighbour < value.owner) {
            std::swap(value.owner, value.neighbour);
            value.flipped = true;
        }
        return value;
    }

    /// The faces of the part are sorted among each other and merged with the rest.
    void gatherFaces() {
        std::vector<NewFace> ours;
        for (Label f = 0; f < toLabel(part_.mesh.faces.size()); ++f)
            if (!part_.mesh.faces[index(f)].isRemoved()) ours.push_back(asNewFace(f));
        std::vector<NewFace> others;
        auto next = part_.faces.begin();
        for (Label f = 0; f < mesh_.faceCount(); ++f) {
            if (next != part_.faces.end() && *next == f) {
                ++next;
                continue;
            }
            others.push_back({mesh_.owner[index(f)], otherCellOf(mesh_, f), f, -1, false});
        }
        const auto isBefore = [](const NewFace& a, const NewFace& b) {
            if ((a.neighbour < 0) != (b.neighbour < 0)) return b.neighbour < 0;
            if (a.neighbour < 0) return std::tie(a.source, a.edited) < std::tie(b.source, b.edited);
            return std::tie(a.owner, a.neighbour, a.edited) <
                   std::tie(b.owner, b.neighbour, b.edited);
        };
        std::sort(ours.begin(), ours.end(), isBefore);
        faces_.resize(ours.size() + others.size());
        std::merge(
            ours.begin(), ours.end(), others.begin(), others.end(), faces_.begin(), isBefore);
    }

    void addPoints() {
        result_.points = mesh_.points;
        result_.points.insert(result_.points.end(), addedPoints_.begin(), addedPoints_.end());
        result_.cellCount = mesh_.cellCount + toLabel(addedOrigins_.size());
    }

    void addFaces() {
        result_.faces.offsets.reserve(faces_.size() + 1);
        result_.owner.reserve(faces_.size());
        std::vector<Label> corners;
        for (const NewFace& face : faces_) {
            if (face.edited < 0) {
                result_.faces.add(mesh_.faces[face.source]);
            } else {
                corners.clear();
                for (const Label p : part_.mesh.faces[index(face.edited)].points)
                    corners.push_back(points_[index(p)]);
                if (face.flipped) std::reverse(corners.begin() + 1, corners.end());
                result_.faces.add(corners);
            }
            result_.owner.push_back(face.owner);
            if (face.neighbour >= 0) result_.neighbour.push_back(face.neighbour);
        }
    }

    void addPatches() {
        auto face = faces_.begin() + static_cast<std::ptrdiff_t>(result_.neighbour.size());
        for (const Patch& patch : mesh_.patches) {
            result_.patches.push_back(patch);
            result_.patches.back().start = static_cast<Label>(face - faces_.begin());
            const auto first = face;
            while (face != faces_.end() && face->source < patch.start + patch.size)
                ++face;
            result_.patches.back().size = static_cast<Label>(face - first);
        }
    }

    void addZones() {
        result_.pointZones = mesh_.pointZones;
        for (const Zone& zone : mesh_.cellZones) {
            Flags isMember(index(mesh_.cellCount), 0);
            for (const Label c : zone.labels)
                isMember[index(c)] = 1;
            result_.cellZones.push_back(zone);
            for (std::size_t i = 0; i < addedOrigins_.size(); ++i)
                if (isMember[index(addedOrigins_[i])])
                    result_.cellZones.back().labels.push_back(mesh_.cellCount + toLabel(i));
        }
        for (const Zone& zone : mesh_.faceZones)
            result_.faceZones.push_back(partsOf(zone));
    }

    Zone partsOf(const Zone& zone) const {
        std::vector<Label> place(index(mesh_.faceCount()), -1); // of a face in the zone
        for (std::size_t i = 0; i < zone.labels.size(); ++i)
            place[index(zone.labels[i])] = toLabel(i);
        Zone parts;
        parts.name = zone.name;
        for (std::size_t f = 0; f < faces_.size(); ++f) {
            const Label i = faces_[f].source < 0 ? -1 : place[index(faces_[f].source)];
            if (i < 0) continue;
            parts.labels.push_back(toLabel(f));
            if (!zone.flip.empty()) parts.flip.push_back(zone.flip[index(i)] != faces_[f].flipped);
        }
        return parts;
    }

    const PolyMesh& mesh_;
    const MeshPart& part_;
    std::vector<Label> points_; // of the part: labels in the new mesh
    std::vector<Label> cells_;
    std::vector<Vec3> addedPoints_;
    std::vector<Label> addedOrigins_; // of the cells after the old ones
    std::vector<NewFace> faces_;
    PolyMesh result_;
};

} // namespace

JoinedPart withPart(const PolyMesh& mesh, const MeshPart& part) {
    return PartJoiner(mesh, part).join();
}

} // namespace polymesh
