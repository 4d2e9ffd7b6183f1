// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/editQuality.h"

#include "libpolymesh/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace polymesh {

namespace {

constexpr double failingSkewness = 4;
constexpr double strictSkewness = 3;
constexpr double strictCosine = 0.12; // of 83 degrees
constexpr double failingAspect = 1000;
constexpr double strictAspect = 300;

void fail(Badness& badness, double excess) {
    ++badness.failures;
    badness.severity += 1 + std::min(excess, 100.0);
}

/// Areas below this are round-off of collinear corners, whatever their last digits say [m^2].
double noArea(const MeshEditor& editor, Label f) {
    const double size = editor.cell(editor.face(f).owner).size;
    return 1e-14 * size * size;
}

void failInvalid(Badness& badness) {
    ++badness.invalid;
    fail(badness, 1);
}

void checkPyramid(MeshEditor& editor, Label f, Label c, Badness& badness) {
    const FaceGeometry& face = editor.faceGeometry(f);
    const CellGeometry& cell = editor.cellGeometry(c);
    const double sign = editor.face(f).owner == c ? 1.0 : -1.0;
    const double pyramid = sign * dot(face.area, face.centre - cell.centre) / 3.0;
    const double volume = std::max(std::abs(cell.volume), 1e-300);
    if (pyramid < -1e-13 * volume) fail(badness, -pyramid / volume);
}

/// The distance from the face's centre of where the line between the centres crosses it, over the
/// face's reach in that direction, but at least `minReach`.
double skewnessOf(MeshEditor& editor, Label f, const Vec3& offset, double minReach) {
    const double length = norm(offset);
    if (length <= 0) return 0;
    const Vec3& centre = editor.faceGeometry(f).centre;
    double reach = minReach;
    for (const Label p : editor.face(f).points)
        reach = std::max(reach, std::abs(dot(offset, editor.point(p) - centre)) / length);
    return length / std::max(reach, 1e-300);
}

void addSkewness(double skewness, Badness& badness) {
    if (skewness > failingSkewness)
        fail(badness, std::log(skewness / failingSkewness));
    else if (skewness > strictSkewness)
        badness.severity += (skewness - strictSkewness) / failingSkewness;
}

void checkBetweenCells(MeshEditor& editor, Label f, Badness& badness) {
    const EditFace& face = editor.face(f);
    const FaceGeometry& g = editor.faceGeometry(f);
    const Vec3 fromOwner = g.centre - editor.cellGeometry(face.owner).centre;
    const Vec3 d =
        editor.cellGeometry(face.neighbour).centre - editor.cellGeometry(face.owner).centre;
    const double area = norm(g.area);
    const double distance = norm(d);
    if (area <= noArea(editor, f) || distance <= 0) return failInvalid(badness);
    const double along = dot(g.area, d);
    const double cosine = along / (area * distance);
    if (cosine <= 1e-12)
        fail(badness, -cosine);
    else if (cosine < strictCosine)
        badness.severity += strictCosine - cosine;
    const double t = std::abs(cosine) > 1e-12 ? dot(g.area, fromOwner) / along : 0.5;
    addSkewness(skewnessOf(editor, f, fromOwner - t * d, 0.2 * distance), badness);
}

void checkAtBoundary(MeshEditor& editor, Label f, Badness& badness) {
    const EditFace& face = editor.face(f);
    const FaceGeometry& g = editor.faceGeometry(f);
    const Vec3 fromOwner = g.centre - editor.cellGeometry(face.owner).centre;
    const double area = norm(g.area);
    if (area <= noArea(editor, f)) return failInvalid(badness);
    const Vec3 normal = g.area / area;
    const double height = dot(normal, fromOwner);
    addSkewness(skewnessOf(editor, f, fromOwner - height * normal, 0.4 * std::abs(height)),
                badness);
}

void checkFace(MeshEditor& editor, Label f, Badness& badness) {
    const EditFace& face = editor.face(f);
    for (const Label c : {face.owner, face.neighbour})
        if (c >= 0 && !editor.isFrozen(c)) checkPyramid(editor, f, c, badness);
    if (face.isBoundary())
        checkAtBoundary(editor, f, badness);
    else if (!editor.isFrozenFace(f))
        checkBetweenCells(editor, f, badness);
}

void checkCell(MeshEditor& editor, Label c, Badness& badness) {
    const double volume = editor.cellGeometry(c).volume;
    if (volume <= 0) return failInvalid(badness);
    Vec3 sums;
    for (const Label f : editor.cell(c).faces) {
        const Vec3& area = editor.faceGeometry(f).area;
        sums += {std::abs(area.x), std::abs(area.y), std::abs(area.z)};
    }
    const double least = std::max(std::min({sums.x, sums.y, sums.z}), 1e-300);
    const double most = std::max({sums.x, sums.y, sums.z});
    if (least < 1e-10 * most) failInvalid(badness); // rounding decides whether it is closed
    const double byVolume = (sums.x + sums.y + sums.z) / (6 * std::cbrt(volume * volume));
    const double aspect = std::max(most / least, byVolume);
    if (aspect > failingAspect)
        fail(badness, std::log(aspect / failingAspect));
    else if (aspect > strictAspect)
        badness.severity += (aspect - strictAspect) / failingAspect;
}

} // namespace

bool isNoWorse(const Badness& after, const Badness& before) {
    if (after.invalid != before.invalid) return after.invalid < before.invalid;
    if (after.failures != before.failures) return after.failures < before.failures;
    return after.severity <= before.severity + 1e-12;
}

bool isBetter(const Badness& after, const Badness& before) {
    if (after.invalid != before.invalid) return after.invalid < before.invalid;
    if (after.failures != before.failures) return after.failures < before.failures;
    return after.severity < before.severity - 1e-3 * (1 + before.severity);
}

Badness badnessOf(MeshEditor& editor, std::span<const Label> cells) {
    thread_local std::vector<Label> faces;
    faces.clear();
    Badness badness;
    for (const Label c : cells) {
        if (editor.cell(c).isRemoved() || editor.isFrozen(c)) continue;
        checkCell(editor, c, badness);
        const auto& list = editor.cell(c).faces;
        faces.insert(faces.end(), list.begin(), list.end());
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    for (const Label f : faces)
        checkFace(editor, f, badness);
    return badness;
}

bool isFailing(MeshEditor& editor, Label cell) {
    const std::array<Label, 1> one{cell};
    return badnessOf(editor, one).failures > 0;
}

std::vector<Label> failingCells(MeshEditor& editor) {
    editor.computeGeometry(); // so that the loops only read
    const auto isEdited = [&](Label c) {
        return c >= 0 && !editor.cell(c).isRemoved() && !editor.isFrozen(c);
    };
    std::vector<std::uint8_t> fails(index(editor.cellCount()), 0);
    parallelFor(editor.cellCount(), [&](Label c) {
        Badness badness;
        if (isEdited(c)) checkCell(editor, c, badness);
        fails[index(c)] = badness.failures > 0;
    });
    std::vector<std::uint8_t> failsAtFace(index(editor.faceCount()), 0);
    parallelFor(editor.faceCount(), [&](Label f) {
        const EditFace& face = editor.face(f);
        Badness badness;
        if (isEdited(face.owner) || (!face.isRemoved() && isEdited(face.neighbour)))
            checkFace(editor, f, badness);
        failsAtFace[index(f)] = badness.failures > 0;
    });
    for (std::size_t f = 0; f < failsAtFace.size(); ++f)
        if (failsAtFace[f])
            for (const Label c : {editor.face(toLabel(f)).owner, editor.face(toLabel(f)).neighbour})
                if (isEdited(c)) fails[index(c)] = 1;
    std::vector<Label> cells;
    for (std::size_t c = 0; c < fails.size(); ++c)
        if (fails[c]) cells.push_back(toLabel(c));
    return cells;
}

std::vector<Label> withNeighbours(const MeshEditor& editor, std::span<const Label> cells) {
    std::vector<Label> all(cells.begin(), cells.end());
    for (const Label c : cells)
        for (const Label f : editor.cell(c).faces) {
            const Label other = editor.otherCell(f, c);
            if (other >= 0 && !editor.isFrozen(other)) all.push_back(other);
        }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

} // namespace polymesh
