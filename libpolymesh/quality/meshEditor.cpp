// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/meshEditor.h"

#include "libpolymesh/base/freshList.h"
#include "libpolymesh/base/parallel.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace polymesh {

namespace {

Rows<Label> facesByPoint(const EditMesh& mesh) {
    Rows<Label> rows;
    rows.offsets = freshList<Label>(mesh.points.size() + 1);
    for (const EditFace& face : mesh.faces)
        if (!face.isRemoved())
            for (const Label p : face.points)
                ++rows.offsets[index(p) + 1];
    for (std::size_t i = 1; i < rows.offsets.size(); ++i)
        rows.offsets[i] += rows.offsets[i - 1];
    rows.values = freshList<Label>(index(rows.offsets.back()));
    std::vector<Label> next(rows.offsets.begin(), rows.offsets.end() - 1);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        if (!mesh.faces[f].isRemoved())
            for (const Label p : mesh.faces[f].points)
                rows.values[index(next[index(p)]++)] = toLabel(f);
    return rows;
}

template<class List>
void eraseValue(List& list, Label value) {
    const auto found = std::find(list.begin(), list.end(), value);
    assert(found != list.end());
    list.erase(found);
}

} // namespace

MeshEditor::MeshEditor(EditMesh& mesh)
    : mesh_(mesh),
      pointFaces_(facesByPoint(mesh)),
      ownListOf_(freshList<Label>(mesh.points.size(), -1)),
      faceGeometry_(freshList<FaceGeometry>(mesh.faces.size())),
      cellGeometry_(freshList<CellGeometry>(mesh.cells.size())),
      faceKnown_(mesh.faces.size(), 0),
      cellKnown_(mesh.cells.size(), 0) {}

std::span<const Label> MeshEditor::facesOfPoint(Label p) const {
    const Label own = ownListOf_[index(p)];
    if (own < 0) return pointFaces_[p];
    const PointFaces& list = ownLists_[index(own)];
    return {list.data(), list.size()};
}

MeshEditor::PointFaces& MeshEditor::ownList(Label p) {
    Label& own = ownListOf_[index(p)];
    if (own < 0) {
        const std::span<const Label> row = pointFaces_[p];
        own = toLabel(ownLists_.size());
        ownLists_.emplace_back(row.begin(), row.end());
    }
    return ownLists_[index(own)];
}

Label MeshEditor::addPoint(const Vec3& position, PointRank rank) {
    mesh_.points.push_back(position);
    mesh_.ranks.push_back(rank);
    ownListOf_.push_back(toLabel(ownLists_.size()));
    ownLists_.emplace_back();
    return toLabel(mesh_.points.size()) - 1;
}

Label MeshEditor::addPartOf(Label cell) {
    EditCell part;
    part.size = mesh_.cells[index(cell)].size;
    part.origin = mesh_.cells[index(cell)].origin;
    mesh_.cells.push_back(part);
    cellGeometry_.emplace_back();
    cellKnown_.push_back(0);
    return cellCount() - 1;
}

Label MeshEditor::addFace(const EditFace& value) {
    mesh_.faces.emplace_back();
    faceGeometry_.emplace_back();
    faceKnown_.push_back(0);
    replaceFace(faceCount() - 1, value);
    return faceCount() - 1;
}

void MeshEditor::replaceFace(Label f, const EditFace& value) {
    changes_.push_back({f, mesh_.faces[index(f)]});
    setFace(f, value);
}

void MeshEditor::setFacePoints(Label f, const Polygon& corners) {
    EditFace value = face(f);
    value.points = corners;
    replaceFace(f, value);
}

void MeshEditor::giveFace(Label f, Label from, Label to) {
    EditFace value = face(f);
    (value.owner == from ? value.owner : value.neighbour) = to;
    replaceFace(f, value);
}

MeshEditor::Mark MeshEditor::mark() const {
    return {changes_.size(), mesh_.points.size(), mesh_.faces.size(), mesh_.cells.size()};
}

void MeshEditor::undoTo(const Mark& mark) {
    while (changes_.size() > mark.changes) {
        setFace(changes_.back().face, changes_.back().before);
        changes_.pop_back();
    }
    mesh_.faces.resize(mark.faces);
    faceGeometry_.resize(mark.faces);
    faceKnown_.resize(mark.faces);
    mesh_.cells.resize(mark.cells);
    cellGeometry_.resize(mark.cells);
    cellKnown_.resize(mark.cells);
    mesh_.points.resize(mark.points);
    mesh_.ranks.resize(mark.points);
    ownListOf_.resize(mark.points);
}

std::vector<Label> MeshEditor::reshapedSince(const Mark& mark) const {
    std::vector<Label> cells;
    const auto add = [&](Label c) {
        if (c >= 0 && !cell(c).isRemoved()) cells.push_back(c);
    };
    for (std::size_t i = mark.changes; i < changes_.size(); ++i) {
        const EditFace& before = changes_[i].before;
        const EditFace& now = face(changes_[i].face);
        const bool isSame = !before.isRemoved() && !now.isRemoved() && before.points == now.points;
        for (const Label c : {before.owner, before.neighbour})
            if (!before.isRemoved() && (!isSame || (c != now.owner && c != now.neighbour))) add(c);
        for (const Label c : {now.owner, now.neighbour})
            if (!now.isRemoved() && (!isSame || (c != before.owner && c != before.neighbour)))
                add(c);
    }
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return cells;
}

void MeshEditor::setFace(Label f, const EditFace& value) {
    EditFace& face = mesh_.faces[index(f)];
    forgetGeometry(f);
    const std::array<Label, 2> before{face.owner, face.owner < 0 ? -1 : face.neighbour};
    const std::array<Label, 2> after{value.owner, value.owner < 0 ? -1 : value.neighbour};
    for (const Label c : before)
        if (c >= 0 && c != after[0] && c != after[1]) leaveCell(c, f);
    for (const Label c : after)
        if (c >= 0 && c != before[0] && c != before[1]) enterCell(c, f);
    if (face.isRemoved() != value.isRemoved() || face.points != value.points) setPoints(f, value);
    face = value;
    forgetGeometry(f);
}

void MeshEditor::setPoints(Label f, const EditFace& value) {
    const EditFace& face = mesh_.faces[index(f)];
    const auto has = [](const EditFace& a, Label p) {
        return !a.isRemoved() && std::find(a.points.begin(), a.points.end(), p) != a.points.end();
    };
    if (!face.isRemoved())
        for (const Label p : face.points)
            if (!has(value, p)) eraseValue(ownList(p), f);
    if (!value.isRemoved())
        for (const Label p : value.points)
            if (!has(face, p)) ownList(p).push_back(f);
}

void MeshEditor::leaveCell(Label c, Label f) {
    eraseValue(mesh_.cells[index(c)].faces, f);
    cellKnown_[index(c)] = 0;
}

void MeshEditor::enterCell(Label c, Label f) {
    mesh_.cells[index(c)].faces.push_back(f);
    cellKnown_[index(c)] = 0;
}

void MeshEditor::forgetGeometry(Label f) {
    const EditFace& face = mesh_.faces[index(f)];
    faceKnown_[index(f)] = 0;
    if (face.isRemoved()) return;
    cellKnown_[index(face.owner)] = 0;
    if (face.neighbour >= 0) cellKnown_[index(face.neighbour)] = 0;
}

const FaceGeometry& MeshEditor::faceGeometry(Label f) {
    if (!faceKnown_[index(f)]) {
        const Polygon& corners = face(f).points;
        faceGeometry_[index(f)] = polymesh::faceGeometry(
            mesh_.points, std::span<const Label>(corners.data(), corners.size()));
        faceKnown_[index(f)] = 1;
    }
    return faceGeometry_[index(f)];
}

CellGeometry MeshEditor::computeCell(Label c) {
    boost::container::small_vector<FaceGeometry, 16> outward;
    for (const Label f : cell(c).faces) {
        outward.push_back(faceGeometry(f));
        if (face(f).owner != c) outward.back().area = -outward.back().area;
    }
    return polymesh::cellGeometry(std::span<const FaceGeometry>(outward.data(), outward.size()));
}

const CellGeometry& MeshEditor::cellGeometry(Label c) {
    if (!cellKnown_[index(c)]) {
        cellGeometry_[index(c)] = computeCell(c);
        cellKnown_[index(c)] = 1;
    }
    return cellGeometry_[index(c)];
}

void MeshEditor::computeGeometry() {
    parallelFor(faceCount(), [&](Label f) {
        if (!face(f).isRemoved()) faceGeometry(f);
    });
    parallelFor(cellCount(), [&](Label c) {
        if (!cell(c).isRemoved() && !cell(c).frozen) cellGeometry(c);
    });
}

} // namespace polymesh
