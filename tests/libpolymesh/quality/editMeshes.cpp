// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editMeshes.h"

#include "libpolymesh/quality/editQuality.h"
#include "libpolymesh/quality/mergeCells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace polymesh::test {

namespace {

using Edge = std::pair<Label, Label>;

Edge edgeOf(Label a, Label b) {
    return {std::min(a, b), std::max(a, b)};
}

void addFace(EditMesh& mesh, const EditFace& face) {
    const Label f = toLabel(mesh.faces.size());
    mesh.faces.push_back(face);
    mesh.cells[index(face.owner)].faces.push_back(f);
    if (face.neighbour >= 0) mesh.cells[index(face.neighbour)].faces.push_back(f);
}

/// Faces with a normal along one axis.
void addFaces(EditMesh& mesh, std::array<Label, 3> n, int axis) {
    const std::size_t a = static_cast<std::size_t>(axis);
    const std::size_t b = (a + 1) % 3;
    const std::size_t c = (a + 2) % 3;
    const auto cellAt = [&](std::array<Label, 3> at) {
        return at[0] + n[0] * (at[1] + n[1] * at[2]);
    };
    const auto pointAt = [&](std::array<Label, 3> at, Label db, Label dc) {
        at[b] += db;
        at[c] += dc;
        return at[0] + (n[0] + 1) * (at[1] + (n[1] + 1) * at[2]);
    };
    std::array<Label, 3> at{};
    for (at[a] = 0; at[a] <= n[a]; ++at[a])
        for (at[b] = 0; at[b] < n[b]; ++at[b])
            for (at[c] = 0; at[c] < n[c]; ++at[c]) {
                EditFace face;
                face.points = {
                    pointAt(at, 0, 0), pointAt(at, 1, 0), pointAt(at, 1, 1), pointAt(at, 0, 1)};
                std::array<Label, 3> below = at;
                --below[a];
                if (at[a] == 0) {
                    face.owner = cellAt(at);
                    face.patch = 2 * axis;
                    std::reverse(face.points.begin(), face.points.end());
                } else {
                    face.owner = cellAt(below);
                    if (at[a] < n[a])
                        face.neighbour = cellAt(at);
                    else
                        face.patch = 2 * axis + 1;
                }
                addFace(mesh, face);
            }
}

/// The plane's cut through a mesh: which points are above, and the new point of each edge.
struct PlaneCut {
    EditMesh& mesh;
    Vec3 normal;
    double distance;
    std::vector<bool> above;
    std::map<Edge, Label> crossings;

    Label crossing(Label a, Label b) {
        const auto [found, isNew] =
            crossings.try_emplace(edgeOf(a, b), toLabel(mesh.points.size()));
        if (isNew) {
            const auto [low, high] = found->first;
            const double s = dot(normal, mesh.points[index(low)]) - distance;
            const double t = dot(normal, mesh.points[index(high)]) - distance;
            const double weight = s / (s - t);
            mesh.points.push_back((1 - weight) * mesh.points[index(low)] +
                                  weight * mesh.points[index(high)]);
            mesh.ranks.push_back(PointRank::interior);
        }
        return found->second;
    }

    /// The part of a polygon on one side.
    Polygon part(const Polygon& polygon, bool wantAbove) {
        Polygon kept;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Label p = polygon[i];
            const Label q = polygon[(i + 1) % polygon.size()];
            if (above[index(p)] == wantAbove) kept.push_back(p);
            if (above[index(p)] != above[index(q)]) kept.push_back(crossing(p, q));
        }
        return kept;
    }
};

bool isCut(const PlaneCut& cut, const Polygon& polygon) {
    return std::any_of(polygon.begin(), polygon.end(), [&](Label p) {
        return cut.above[index(p)] != cut.above[index(polygon[0])];
    });
}

/// For each cell its part above the plane; -1 where it has none, itself where it is all above.
std::vector<Label> partsAbove(EditMesh& mesh, const PlaneCut& cut) {
    std::vector<Label> parts(mesh.cells.size(), -1);
    for (std::size_t c = 0; c < parts.size(); ++c) {
        bool someAbove = false;
        bool someBelow = false;
        for (const Label f : mesh.cells[c].faces)
            for (const Label p : mesh.faces[index(f)].points)
                (cut.above[index(p)] ? someAbove : someBelow) = true;
        if (!someAbove) continue;
        parts[c] = toLabel(c);
        if (!someBelow) continue;
        parts[c] = toLabel(mesh.cells.size());
        EditCell cell;
        cell.size = mesh.cells[c].size;
        mesh.cells.push_back(cell);
    }
    return parts;
}

/// The face between the two parts of a cell, normal from below to above: the loop through the
/// crossings, backward to how the faces below run.
EditFace capOf(PlaneCut& cut,
               Label below,
               Label above,
               const std::vector<EditFace>& oldFaces,
               const std::vector<Label>& faces) {
    std::map<Label, Label> next;
    for (const Label f : faces) {
        const EditFace& face = oldFaces[index(f)];
        const std::size_t n = face.points.size();
        Label enters = -1;
        Label leaves = -1;
        for (std::size_t i = 0; i < n; ++i) {
            const Label p = face.points[i];
            const Label q = face.points[(i + 1) % n];
            if (cut.above[index(p)] == cut.above[index(q)]) continue;
            (cut.above[index(p)] ? enters : leaves) = cut.crossing(p, q);
        }
        if (enters < 0) continue;
        // The part below, seen from outside, runs leaves -> enters along the cut.
        if (face.owner == below)
            next[enters] = leaves;
        else
            next[leaves] = enters;
    }
    EditFace cap;
    cap.owner = below;
    cap.neighbour = above;
    for (Label p = next.begin()->first; cap.points.size() < next.size(); p = next.at(p))
        cap.points.push_back(p);
    return cap;
}

/// Adds the part of a face below the plane and the one above it to the cells there.
void addParts(EditMesh& mesh,
              PlaneCut& cut,
              const EditFace& face,
              const std::vector<Label>& parts) {
    for (const bool wantAbove : {false, true}) {
        EditFace part = face;
        part.points = isCut(cut, face.points) ? cut.part(face.points, wantAbove) : face.points;
        if (part.points.size() < 3) continue;
        if (!isCut(cut, face.points) && cut.above[index(face.points[0])] != wantAbove) continue;
        if (wantAbove) {
            part.owner = parts[index(part.owner)];
            if (part.neighbour >= 0) part.neighbour = parts[index(part.neighbour)];
        }
        addFace(mesh, part);
    }
}

} // namespace

EditMesh boxOfHexes(std::array<Label, 3> n, double h) {
    EditMesh mesh;
    for (Label k = 0; k <= n[2]; ++k)
        for (Label j = 0; j <= n[1]; ++j)
            for (Label i = 0; i <= n[0]; ++i)
                mesh.points.push_back({i * h, j * h, k * h});
    mesh.ranks.assign(mesh.points.size(), PointRank::interior);
    mesh.cells.resize(index(n[0] * n[1] * n[2]));
    for (EditCell& cell : mesh.cells)
        cell.size = h;
    for (int axis = 0; axis < 3; ++axis)
        addFaces(mesh, n, axis);
    rankPoints(mesh);
    return mesh;
}

Label splitByPlane(EditMesh& mesh, const Vec3& normal, double distance) {
    PlaneCut cut{mesh, normal, distance, {}, {}};
    for (const Vec3& p : mesh.points)
        cut.above.push_back(dot(normal, p) - distance > 0);
    const std::size_t oldCells = mesh.cells.size();
    const std::vector<Label> parts = partsAbove(mesh, cut);
    const std::vector<EditFace> oldFaces = std::move(mesh.faces);
    mesh.faces.clear();
    std::vector<std::vector<Label>> facesOfCell;
    for (std::size_t c = 0; c < oldCells; ++c)
        facesOfCell.emplace_back(mesh.cells[c].faces.begin(), mesh.cells[c].faces.end());
    for (EditCell& cell : mesh.cells)
        cell.faces.clear();
    for (const EditFace& face : oldFaces)
        if (!face.isRemoved()) addParts(mesh, cut, face, parts);
    Label count = 0;
    for (std::size_t c = 0; c < oldCells; ++c) {
        if (parts[c] < 0 || parts[c] == toLabel(c)) continue;
        addFace(mesh, capOf(cut, toLabel(c), parts[c], oldFaces, facesOfCell[c]));
        ++count;
    }
    return count;
}

void removeCells(EditMesh& mesh, Label patch, const std::function<bool(const Vec3&)>& isGone) {
    MeshEditor editor(mesh);
    std::vector<bool> gone(mesh.cells.size(), false);
    for (Label c = 0; c < editor.cellCount(); ++c)
        if (!editor.cell(c).isRemoved()) gone[index(c)] = isGone(editor.cellGeometry(c).centre);
    for (Label f = 0; f < editor.faceCount(); ++f) {
        EditFace face = editor.face(f);
        if (face.isRemoved()) continue;
        const bool ownerGone = gone[index(face.owner)];
        const bool neighbourGone = face.neighbour < 0 || gone[index(face.neighbour)];
        if (ownerGone && neighbourGone) {
            editor.removeFace(f);
        } else if (ownerGone || (neighbourGone && face.neighbour >= 0)) {
            if (ownerGone) {
                face.owner = face.neighbour;
                std::reverse(face.points.begin(), face.points.end());
            }
            face.neighbour = -1;
            face.patch = patch;
            editor.replaceFace(f, face);
        }
    }
}

void rankPoints(EditMesh& mesh) {
    std::map<Edge, std::vector<Label>> boundaryFaces;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const EditFace& face = mesh.faces[f];
        if (face.isRemoved() || !face.isBoundary()) continue;
        for (std::size_t i = 0; i < face.points.size(); ++i)
            boundaryFaces[edgeOf(face.points[i], face.points[(i + 1) % face.points.size()])]
                .push_back(toLabel(f));
    }
    std::vector<std::vector<Vec3>> features(mesh.points.size());
    mesh.ranks.assign(mesh.points.size(), PointRank::interior);
    for (const auto& [edge, faces] : boundaryFaces) {
        for (const Label p : {edge.first, edge.second})
            mesh.ranks[index(p)] = std::max(mesh.ranks[index(p)], PointRank::surface);
        if (faces.size() < 2) continue;
        const EditFace& a = mesh.faces[index(faces[0])];
        const EditFace& b = mesh.faces[index(faces[1])];
        const Vec3 aNormal = faceGeometry(mesh.points, {a.points.data(), a.points.size()}).area;
        const Vec3 bNormal = faceGeometry(mesh.points, {b.points.data(), b.points.size()}).area;
        const double cosine =
            dot(aNormal, bNormal) / std::max(norm(aNormal) * norm(bNormal), 1e-300);
        if (a.patch == b.patch && cosine > 0.866) continue;
        const Vec3 along = mesh.points[index(edge.second)] - mesh.points[index(edge.first)];
        features[index(edge.first)].push_back(along / std::max(norm(along), 1e-300));
        features[index(edge.second)].push_back(-along / std::max(norm(along), 1e-300));
    }
    for (std::size_t p = 0; p < features.size(); ++p) {
        const auto& edges = features[p];
        if (edges.empty()) continue;
        const bool straight = edges.size() == 2 && dot(edges[0], edges[1]) < -0.866;
        mesh.ranks[p] = straight ? PointRank::feature : PointRank::corner;
    }
}

void cutByPlane(EditMesh& mesh, const Vec3& normal, double distance, Label patch) {
    const Label before = toLabel(mesh.cells.size());
    std::vector<Vec3> old = mesh.points;
    splitByPlane(mesh, normal, distance);
    std::vector<bool> above(mesh.cells.size(), false);
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
        above[c] = toLabel(c) >= before;
        for (const Label f : mesh.cells[c].faces)
            for (const Label p : mesh.faces[index(f)].points)
                if (index(p) < old.size() && dot(normal, old[index(p)]) - distance > 0)
                    above[c] = true;
    }
    std::size_t next = 0;
    std::vector<bool> ordered;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        if (!mesh.cells[c].isRemoved()) ordered.push_back(above[c]);
    removeCells(mesh, patch, [&](const Vec3&) { return ordered[next++]; });
    rankPoints(mesh);
}

void rejoinPieces(EditMesh& mesh) {
    MeshEditor editor(mesh);
    const auto hexOf = [&](Label c) {
        const Vec3 centre = editor.cellGeometry(c).centre;
        return std::array{std::floor(centre.x), std::floor(centre.y), std::floor(centre.z)};
    };
    std::vector<std::array<double, 3>> hexes(mesh.cells.size());
    for (Label c = 0; c < editor.cellCount(); ++c)
        if (!editor.cell(c).isRemoved()) hexes[index(c)] = hexOf(c);
    for (int pass = 0; pass < 8; ++pass)
        for (Label c = editor.cellCount() - 1; c >= 0; --c) {
            if (editor.cell(c).isRemoved()) continue;
            for (const MergePartner& partner : mergePartners(editor, c)) {
                if (hexes[index(partner.cell)] != hexes[index(c)]) continue;
                const MeshEditor::Mark mark = editor.mark();
                if (mergeCells(editor, c, partner.cell)) break;
                editor.undoTo(mark);
            }
        }
}

double totalVolume(EditMesh& mesh) {
    MeshEditor editor(mesh);
    double volume = 0;
    for (Label c = 0; c < editor.cellCount(); ++c)
        if (!editor.cell(c).isRemoved() && !editor.isFrozen(c))
            volume += editor.cellGeometry(c).volume;
    return volume;
}

Badness totalBadness(EditMesh& mesh) {
    MeshEditor editor(mesh);
    std::vector<Label> all(mesh.cells.size());
    std::iota(all.begin(), all.end(), 0);
    return badnessOf(editor, all);
}

Label liveCells(const EditMesh& mesh) {
    return toLabel(static_cast<std::size_t>(std::count_if(
        mesh.cells.begin(), mesh.cells.end(), [](const EditCell& c) { return !c.isRemoved(); })));
}

Label liveFaces(const EditMesh& mesh) {
    return toLabel(static_cast<std::size_t>(std::count_if(
        mesh.faces.begin(), mesh.faces.end(), [](const EditFace& f) { return !f.isRemoved(); })));
}

std::vector<Label> coincidentPoints(const EditMesh& mesh) {
    std::map<Vec3, Label> first;
    std::vector<Label> representative;
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
        representative.push_back(first.try_emplace(mesh.points[p], toLabel(p)).first->second);
    return representative;
}

} // namespace polymesh::test
