// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/editParts.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/geometry/box.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <utility>

namespace polymesh {

namespace {

constexpr int seamRings = 2;    // face neighbours on both sides of a seam that are edited again
constexpr Label mostParts = 32; // each part clears arrays of the size of the whole
constexpr Label unseen = -2;    // a point that no face uses
constexpr Label ofSeveralParts = -1; // or of none

bool isFree(const EditCell& cell) {
    return !cell.frozen && !cell.isRemoved();
}

/// A place of a cell that does not depend on the numbering of anything.
double lowestCoordinate(const EditMesh& mesh, const EditCell& cell, double Vec3::*axis) {
    double lowest = std::numeric_limits<double>::max();
    for (const Label f : cell.faces)
        for (const Label p : mesh.faces[index(f)].points)
            lowest = std::min(lowest, mesh.points[index(p)].*axis);
    return lowest;
}

double Vec3::*longestAxis(const EditMesh& mesh) {
    Box box;
    for (const Vec3& p : mesh.points)
        box.add(p);
    const Vec3 size = box.size();
    if (size.x >= size.y && size.x >= size.z) return &Vec3::x;
    return size.y >= size.z ? &Vec3::y : &Vec3::z;
}

/// The part that has a face to itself, or that it has none.
Label partOfFace(const EditFace& face, const CellParts& parts) {
    const Label own = parts.ofCell[index(face.owner)];
    const bool isShared = face.neighbour >= 0 && parts.ofCell[index(face.neighbour)] != own;
    return isShared ? ofSeveralParts : own;
}

/// The part that has all faces of a point to itself, for each point.
std::vector<Label> partsOfPoints(const EditMesh& mesh, const CellParts& parts) {
    std::vector<Label> ofPoint(mesh.points.size(), unseen);
    parallelFor(toLabel(mesh.faces.size()), [&](Label f) {
        const EditFace& face = mesh.faces[index(f)];
        if (face.isRemoved()) return;
        const Label part = partOfFace(face, parts);
        for (const Label p : face.points) {
            std::atomic_ref<Label> known(ofPoint[index(p)]);
            Label before = unseen;
            // Whatever the order of the faces: one part if all agree, or else several.
            if (!known.compare_exchange_strong(before, part) && before != part)
                known.store(ofSeveralParts);
        }
    });
    return ofPoint;
}

std::vector<std::vector<Label>> cellsByPart(const CellParts& parts) {
    std::vector<std::vector<Label>> cells(index(parts.count));
    for (std::size_t c = 0; c < parts.ofCell.size(); ++c)
        if (parts.ofCell[c] >= 0) cells[index(parts.ofCell[c])].push_back(toLabel(c));
    return cells;
}

/// A part as a mesh of its own.
struct Part {
    EditMesh mesh;
    std::vector<Label> points; // label in the whole of each point, face and cell from the start
    std::vector<Label> faces;
    std::vector<Label> cells;
};

/// Copies a part out of the whole.
class Extraction {
public:
    Extraction(const EditMesh& whole, const std::vector<Label>& partOfPoint, Label part)
        : whole_(whole),
          partOfPoint_(partOfPoint),
          part_(part),
          pointOf_(whole.points.size(), -1),
          faceOf_(whole.faces.size(), -1),
          cellOf_(whole.cells.size(), -1) {}

    Part run(const std::vector<Label>& cells) {
        for (const Label c : cells)
            addCell(c, false);
        for (const Label c : cells)
            for (const Label f : whole_.cells[index(c)].faces)
                if (faceOf_[index(f)] < 0) addFace(f);
        return std::move(result_);
    }

private:
    Label addCell(Label c, bool isFrozen) {
        EditCell cell;
        cell.size = whole_.cells[index(c)].size;
        cell.origin = whole_.cells[index(c)].origin;
        cell.frozen = isFrozen;
        cellOf_[index(c)] = toLabel(result_.cells.size());
        result_.mesh.cells.push_back(std::move(cell));
        result_.cells.push_back(c);
        return cellOf_[index(c)];
    }

    Label sideOf(Label c, Label face) {
        if (c < 0) return -1;
        const Label side = cellOf_[index(c)] >= 0 ? cellOf_[index(c)] : addCell(c, true);
        result_.mesh.cells[index(side)].faces.push_back(face);
        return side;
    }

    Label pointOf(Label p) {
        Label& known = pointOf_[index(p)];
        if (known < 0) {
            known = toLabel(result_.points.size());
            result_.points.push_back(p);
            result_.mesh.points.push_back(whole_.points[index(p)]);
            const bool isOwn = partOfPoint_[index(p)] == part_;
            result_.mesh.ranks.push_back(isOwn ? whole_.ranks[index(p)] : PointRank::fixed);
        }
        return known;
    }

    void addFace(Label f) {
        const EditFace& from = whole_.faces[index(f)];
        const Label number = toLabel(result_.faces.size());
        faceOf_[index(f)] = number;
        result_.faces.push_back(f);
        EditFace face;
        for (const Label p : from.points)
            face.points.push_back(pointOf(p));
        face.owner = sideOf(from.owner, number);
        face.neighbour = sideOf(from.neighbour, number);
        face.patch = from.patch;
        result_.mesh.faces.push_back(std::move(face));
    }

    const EditMesh& whole_;
    const std::vector<Label>& partOfPoint_;
    Label part_;
    std::vector<Label> pointOf_; // label in the part, or -1
    std::vector<Label> faceOf_;
    std::vector<Label> cellOf_;
    Part result_;
};

/// Where the new points, faces and cells of a part go in the whole.
struct Place {
    std::size_t points = 0;
    std::size_t faces = 0;
    std::size_t cells = 0;
};

/// Makes room for what is new, part by part.
std::vector<Place> makeRoom(EditMesh& whole, CellParts& division, const std::vector<Part>& parts) {
    std::vector<Place> places;
    Place next{whole.points.size(), whole.faces.size(), whole.cells.size()};
    for (const Part& part : parts) {
        places.push_back(next);
        next.points += part.mesh.points.size() - part.points.size();
        next.faces += part.mesh.faces.size() - part.faces.size();
        next.cells += part.mesh.cells.size() - part.cells.size();
    }
    whole.points.resize(next.points);
    whole.ranks.resize(next.points);
    whole.faces.resize(next.faces);
    whole.cells.resize(next.cells);
    division.ofCell.resize(next.cells, -1);
    return places;
}

/// Appends the labels in the whole of what a part has made itself.
void extendLabels(std::vector<Label>& labels, std::size_t size, std::size_t place) {
    for (std::size_t next = place; labels.size() < size; ++next)
        labels.push_back(toLabel(next));
}

/// What a part has made of its side of a face that it shares with another part.
struct SeamFace {
    Label face = -1; // in the whole
    Label side = -1; // cell in the whole; -1: the boundary
    Label patch = -1;
};

bool isFrozenSide(const EditMesh& mesh, Label side) {
    return side >= 0 && mesh.cells[index(side)].frozen;
}

/// Whether a part shares the face with others, and so may not have changed more than its own side.
bool isSeamFace(const EditMesh& mesh, const EditFace& face) {
    return !face.isRemoved() &&
           (isFrozenSide(mesh, face.owner) || isFrozenSide(mesh, face.neighbour));
}

SeamFace seamFace(const Part& part, std::size_t f) {
    const EditFace& face = part.mesh.faces[f];
    const Label side = isFrozenSide(part.mesh, face.owner) ? face.neighbour : face.owner;
    return {part.faces[f], side < 0 ? -1 : part.cells[index(side)], face.patch};
}

/// Enters the side of a shared face that belongs to the given part.
void takeOverSide(const SeamFace& seam, Label part, const CellParts& division, EditMesh& whole) {
    EditFace& face = whole.faces[index(seam.face)];
    const bool isOwner = division.ofCell[index(face.owner)] == part;
    if (seam.side >= 0) {
        (isOwner ? face.owner : face.neighbour) = seam.side;
        return;
    }
    if (isOwner) {
        face.owner = face.neighbour;
        std::reverse(face.points.begin(), face.points.end());
    }
    face.neighbour = -1;
    face.patch = seam.patch;
}

/// Moves a part back into the whole, but for its faces at seams, which are returned; other parts
/// may do the same at the same time.
std::vector<SeamFace> putBack(Part& part, const Place& place, EditMesh& whole) {
    const std::size_t oldPoints = part.points.size();
    extendLabels(part.points, part.mesh.points.size(), place.points);
    extendLabels(part.faces, part.mesh.faces.size(), place.faces);
    extendLabels(part.cells, part.mesh.cells.size(), place.cells);
    for (std::size_t p = oldPoints; p < part.points.size(); ++p) {
        whole.points[index(part.points[p])] = part.mesh.points[p];
        whole.ranks[index(part.points[p])] = part.mesh.ranks[p];
    }
    std::vector<SeamFace> seam;
    for (std::size_t f = 0; f < part.faces.size(); ++f) {
        EditFace& face = part.mesh.faces[f];
        if (isSeamFace(part.mesh, face)) {
            seam.push_back(seamFace(part, f));
            continue;
        }
        for (Label& p : face.points)
            p = part.points[index(p)];
        for (Label* side : {&face.owner, &face.neighbour})
            if (*side >= 0) *side = part.cells[index(*side)];
        whole.faces[index(part.faces[f])] = std::move(face);
    }
    for (std::size_t c = 0; c < part.cells.size(); ++c) {
        EditCell& cell = part.mesh.cells[c];
        if (cell.frozen) continue;
        for (Label& f : cell.faces)
            f = part.faces[index(f)];
        whole.cells[index(part.cells[c])] = std::move(cell);
    }
    return seam;
}

/// The cell on the other side of the face; -1 when there is none.
Label otherCell(const EditFace& face, Label c) {
    return face.owner == c ? face.neighbour : face.owner;
}

} // namespace

CellParts divideIntoSlabs(const EditMesh& mesh, Label leastCells) {
    CellParts parts;
    parts.ofCell.assign(mesh.cells.size(), -1);
    double Vec3::*axis = longestAxis(mesh);
    std::vector<double> coordinates(mesh.cells.size());
    parallelFor(toLabel(mesh.cells.size()), [&](Label c) {
        coordinates[index(c)] = lowestCoordinate(mesh, mesh.cells[index(c)], axis);
    });
    std::vector<double> sorted;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        if (isFree(mesh.cells[c])) sorted.push_back(coordinates[c]);
    const Label free = toLabel(sorted.size());
    const Label wanted = std::clamp(free / std::max(leastCells, Label{1}), Label{1}, mostParts);
    std::vector<double> cuts;
    for (Label i = 1; i < wanted; ++i) {
        const auto at = sorted.begin() + std::ptrdiff_t{i} * free / wanted;
        std::nth_element(sorted.begin(), at, sorted.end());
        if (cuts.empty() || cuts.back() != *at) cuts.push_back(*at);
    }
    parts.count = toLabel(cuts.size()) + 1;
    parallelFor(toLabel(mesh.cells.size()), [&](Label c) {
        if (!isFree(mesh.cells[index(c)])) return;
        const auto above = std::upper_bound(cuts.begin(), cuts.end(), coordinates[index(c)]);
        parts.ofCell[index(c)] = toLabel(static_cast<std::size_t>(above - cuts.begin()));
    });
    return parts;
}

CellParts alongSeams(const EditMesh& mesh, const CellParts& parts) {
    CellParts seams;
    seams.count = std::max(parts.count - 1, Label{0});
    seams.ofCell.assign(mesh.cells.size(), -1);
    std::vector<Label> ring;
    const auto add = [&](Label c, Label seam) {
        if (parts.ofCell[index(c)] < 0 || seams.ofCell[index(c)] >= 0) return;
        seams.ofCell[index(c)] = seam;
        ring.push_back(c);
    };
    for (const EditFace& face : mesh.faces) {
        if (face.isRemoved() || face.isBoundary()) continue;
        const Label a = parts.ofCell[index(face.owner)];
        const Label b = parts.ofCell[index(face.neighbour)];
        if (a < 0 || b < 0 || a == b) continue;
        for (const Label c : {face.owner, face.neighbour})
            add(c, std::min(a, b));
    }
    for (int i = 0; i < seamRings; ++i)
        for (const Label c : std::exchange(ring, {}))
            for (const Label f : mesh.cells[index(c)].faces) {
                const Label other = otherCell(mesh.faces[index(f)], c);
                if (other >= 0) add(other, seams.ofCell[index(c)]);
            }
    return seams;
}

std::vector<Label> editParts(EditMesh& mesh, CellParts& parts, const EditOfPart& edit) {
    const std::vector<Label> partOfPoint = partsOfPoints(mesh, parts);
    const std::vector<std::vector<Label>> cells = cellsByPart(parts);
    std::vector<Part> edited(index(parts.count));
    std::vector<std::vector<Label>> noted(index(parts.count));
    parallelBlocks(parts.count, 1, [&](Label part, Label, Label) {
        Part& own = edited[index(part)];
        own = Extraction(mesh, partOfPoint, part).run(cells[index(part)]);
        noted[index(part)] = edit(own.mesh, part);
    });
    const std::vector<Place> places = makeRoom(mesh, parts, edited);
    std::vector<std::vector<SeamFace>> seams(index(parts.count));
    parallelBlocks(parts.count, 1, [&](Label part, Label, Label) {
        Part& own = edited[index(part)];
        const std::size_t old = own.cells.size();
        seams[index(part)] = putBack(own, places[index(part)], mesh);
        for (std::size_t c = old; c < own.cells.size(); ++c)
            parts.ofCell[index(own.cells[c])] = part;
        for (Label& c : noted[index(part)])
            c = own.cells[index(c)];
    });
    for (Label part = 0; part < parts.count; ++part)
        for (const SeamFace& face : seams[index(part)])
            takeOverSide(face, part, parts, mesh);
    std::vector<Label> all;
    for (const std::vector<Label>& cellsOfPart : noted)
        all.insert(all.end(), cellsOfPart.begin(), cellsOfPart.end());
    return all;
}

} // namespace polymesh
