// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/movingMesh.h"

#include "libpolymesh/base/freshList.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/quality/checks.h"
#include "libpolymesh/quality/metrics.h"

#include <algorithm>
#include <array>
#include <utility>

namespace polymesh {

namespace {

constexpr std::size_t mostFaces = 6;

} // namespace

MovingMesh::MovingMesh(PolyMesh& mesh, const Rows<Label>& cellFaces)
    : mesh_(mesh),
      cellFaces_(cellFaces),
      faces_(freshList<FaceGeometry>(index(mesh.faceCount()))),
      cells_(freshList<CellGeometry>(index(mesh.cellCount))),
      isMeasured_(index(mesh.cellCount), 0) {}

void MovingMesh::updateFace(Label face) {
    faces_[index(face)] = faceGeometry(mesh_.points, std::as_const(mesh_.faces)[face]);
}

void MovingMesh::updateCell(Label cell) {
    std::array<FaceGeometry, mostFaces> outward;
    std::size_t count = 0;
    for (const Label face : cellFaces_[cell]) {
        const FaceGeometry& own = faces_[index(face)];
        const bool isOwned = mesh_.owner[index(face)] == cell;
        outward[count++] = {own.centre, isOwned ? own.area : -own.area};
    }
    cells_[index(cell)] = cellGeometry(std::span(outward).first(count));
}

void MovingMesh::measureOne(Label cell) {
    if (isMeasured_[index(cell)] != 0) return;
    for (const Label face : cellFaces_[cell])
        updateFace(face);
    updateCell(cell);
    isMeasured_[index(cell)] = 1;
}

void MovingMesh::measure(Label cell) {
    for (const Label face : cellFaces_[cell]) {
        measureOne(mesh_.owner[index(face)]);
        if (mesh_.isInternal(face)) measureOne(mesh_.neighbour[index(face)]);
    }
}

void MovingMesh::measure(std::span<const char> isMarked) {
    const auto touches = [&](Label face, const auto& is) {
        return is[index(mesh_.owner[index(face)])] != 0 ||
               (mesh_.isInternal(face) && is[index(mesh_.neighbour[index(face)])] != 0);
    };
    parallelFor(mesh_.cellCount, [&](Label cell) {
        const bool isNear = std::ranges::any_of(
            cellFaces_[cell], [&](Label face) { return touches(face, isMarked); });
        isMeasured_[index(cell)] = isNear ? 1 : 0;
    });
    parallelFor(mesh_.faceCount(), [&](Label face) {
        if (touches(face, isMeasured_)) updateFace(face);
    });
    parallelFor(mesh_.cellCount, [&](Label cell) {
        if (isMeasured_[index(cell)] != 0) updateCell(cell);
    });
}

void MovingMesh::move(Label point,
                      const Vec3& to,
                      std::span<const Label> faces,
                      std::span<const Label> cells) {
    mesh_.points[index(point)] = to;
    for (const Label face : faces)
        updateFace(face);
    for (const Label cell : cells)
        updateCell(cell);
}

double MovingMesh::stretch(Label cell) const {
    std::array<Vec3, mostFaces> areas; // of either sense: only openness would mind
    std::size_t count = 0;
    for (const Label face : cellFaces_[cell])
        areas[count++] = faces_[index(face)].area;
    const CellClosedness closedness = cellClosedness(
        std::span(areas).first(count), cells_[index(cell)].volume, {true, true, true});
    return closedness.aspectRatio / limits::aspectRatio;
}

double MovingMesh::skewness(Label face) const {
    const FaceGeometry& geometry = faces_[index(face)];
    const std::span<const Label> loop = std::as_const(mesh_.faces)[face];
    const Vec3& owner = cells_[index(mesh_.owner[index(face)])].centre;
    if (!mesh_.isInternal(face))
        return boundarySkewness(mesh_.points, loop, geometry, owner) / limits::skewness;
    const Vec3& neighbour = cells_[index(mesh_.neighbour[index(face)])].centre;
    return internalSkewness(mesh_.points, loop, geometry, owner, neighbour) / limits::skewness;
}

bool MovingMesh::isCompact(Label cell) const {
    constexpr double half = 0.5 * limits::aspectRatio;
    Vec3 sums;
    for (const Label face : cellFaces_[cell]) {
        const Vec3& area = faces_[index(face)].area;
        sums += Vec3{std::abs(area.x), std::abs(area.y), std::abs(area.z)};
    }
    const auto [least, most] = std::minmax({sums.x, sums.y, sums.z});
    const double volume = cells_[index(cell)].volume;
    const double area = (sums.x + sums.y + sums.z) / (6 * half);
    return most < half * least && volume > 0 && area * area * area < volume * volume;
}

bool MovingMesh::isStraight(Label face) const {
    constexpr double leastExtent = 0.2; // of the line of centres, that skewness is measured by
    constexpr double half = 0.5 * leastExtent * limits::skewness;
    if (!mesh_.isInternal(face)) return false;
    const FaceGeometry& own = faces_[index(face)];
    const Vec3& owner = cells_[index(mesh_.owner[index(face)])].centre;
    const Vec3 toFace = own.centre - owner;
    const Vec3 line = cells_[index(mesh_.neighbour[index(face)])].centre - owner;
    const double along = dot(own.area, line);
    const double part = dot(own.area, toFace);
    return part > 0 && along > part &&
           squaredNorm(along * toFace - part * line) <
               half * half * along * along * squaredNorm(line);
}

double MovingMesh::lean(Label face) const {
    const FaceGeometry& own = faces_[index(face)];
    const Vec3& owner = cells_[index(mesh_.owner[index(face)])].centre;
    double cosine = orthogonality(owner, own.centre, own.area);
    if (mesh_.isInternal(face)) {
        const Vec3& neighbour = cells_[index(mesh_.neighbour[index(face)])].centre;
        cosine = std::min({cosine,
                           orthogonality(own.centre, neighbour, own.area),
                           orthogonality(owner, neighbour, own.area)});
    }
    return 1 - cosine;
}

} // namespace polymesh
