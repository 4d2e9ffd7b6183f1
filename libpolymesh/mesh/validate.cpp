// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mesh/validate.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/edgePairs.h"
#include "libpolymesh/mesh/topology.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <utility>

namespace polymesh {

namespace {

using Defects = std::vector<Defect>;

constexpr Label blockSize = 4096;

/// Runs check(element, defects) over [0, count) in parallel; defects keep the elements' order.
template<class Check>
void collect(Label count, Defects& defects, Check&& check) {
    std::vector<Defects> found(index((count + blockSize - 1) / blockSize));
    parallelBlocks(count, blockSize, [&](Label block, Label first, Label last) {
        for (Label i = first; i < last; ++i)
            check(i, found[index(block)]);
    });
    for (Defects& part : found)
        std::move(part.begin(), part.end(), std::back_inserter(defects));
}

bool inRange(Label label, Label count) {
    return label >= 0 && label < count;
}

// Law 0: what the other checks rely on -----------------------------------------------------------

void checkZones(const std::vector<Zone>& zones, Label count, Defects& defects) {
    for (std::size_t z = 0; z < zones.size(); ++z) {
        const auto bad = std::find_if(zones[z].labels.begin(),
                                      zones[z].labels.end(),
                                      [&](Label label) { return !inRange(label, count); });
        if (bad != zones[z].labels.end())
            defects.push_back(
                {0,
                 toLabel(z),
                 fmt::format(
                     "zone {} lists {}, expected less than {}", zones[z].name, *bad, count)});
    }
}

Defects checkRanges(const PolyMesh& mesh) {
    Defects defects;
    const Label faces = mesh.faceCount();
    if (toLabel(mesh.owner.size()) != faces)
        defects.push_back({0, -1, fmt::format("{} owners for {} faces", mesh.owner.size(), faces)});
    if (mesh.internalFaceCount() > faces)
        defects.push_back(
            {0, -1, fmt::format("{} neighbours for {} faces", mesh.neighbour.size(), faces)});
    if (mesh.cellCount < 0) defects.push_back({0, -1, fmt::format("{} cells", mesh.cellCount)});
    for (const Patch& patch : mesh.patches)
        if (patch.size < 0 || patch.start < mesh.internalFaceCount() || patch.size > faces ||
            patch.start > faces - patch.size)
            defects.push_back({0,
                               toLabel(static_cast<std::size_t>(&patch - mesh.patches.data())),
                               fmt::format("patch {} has {} faces from face {}; boundary faces are "
                                           "{} to {}",
                                           patch.name,
                                           patch.size,
                                           patch.start,
                                           mesh.internalFaceCount(),
                                           faces)});
    if (!defects.empty()) return defects;

    collect(faces, defects, [&](Label face, Defects& found) {
        for (const Label point : mesh.faces[face])
            if (!inRange(point, mesh.pointCount()))
                found.push_back({0, face, fmt::format("face {} has point {}", face, point)});
        if (!inRange(mesh.owner[index(face)], mesh.cellCount))
            found.push_back(
                {0, face, fmt::format("face {} has owner {}", face, mesh.owner[index(face)])});
        if (mesh.isInternal(face) && !inRange(mesh.neighbour[index(face)], mesh.cellCount))
            found.push_back(
                {0,
                 face,
                 fmt::format("face {} has neighbour {}", face, mesh.neighbour[index(face)])});
    });
    collect(mesh.pointCount(), defects, [&](Label point, Defects& found) {
        if (!isFinite(mesh.points[index(point)]))
            found.push_back({0, point, fmt::format("point {} is not finite", point)});
    });
    checkZones(mesh.pointZones, mesh.pointCount(), defects);
    checkZones(mesh.faceZones, faces, defects);
    checkZones(mesh.cellZones, mesh.cellCount, defects);
    return defects;
}

// Laws of faces and patches ----------------------------------------------------------------------

bool hasRepeatedPoint(std::span<const Label> points) {
    for (std::size_t i = 1; i < points.size(); ++i)
        if (std::find(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i), points[i]) !=
            points.begin() + static_cast<std::ptrdiff_t>(i))
            return true;
    return false;
}

void checkFaces(const PolyMesh& mesh, Defects& defects) {
    collect(mesh.faceCount(), defects, [&](Label face, Defects& found) {
        const std::span<const Label> points = mesh.faces[face];
        if (points.size() < 3)
            found.push_back({1, face, fmt::format("face {} has {} points", face, points.size())});
        else if (hasRepeatedPoint(points))
            found.push_back({1, face, fmt::format("face {} lists a point twice", face)});
    });
}

void checkOrder(const PolyMesh& mesh, Defects& defects) {
    collect(mesh.internalFaceCount(), defects, [&](Label face, Defects& found) {
        const auto cells = [&](Label f) {
            return std::pair(mesh.owner[index(f)], mesh.neighbour[index(f)]);
        };
        if (cells(face).first >= cells(face).second)
            found.push_back({2,
                             face,
                             fmt::format("face {} has owner {} and neighbour {}, expected a lower "
                                         "owner",
                                         face,
                                         cells(face).first,
                                         cells(face).second)});
        else if (face > 0 && cells(face) < cells(face - 1))
            found.push_back(
                {2,
                 face,
                 fmt::format("face {} between cells {} and {} follows one between {} and {}",
                             face,
                             cells(face).first,
                             cells(face).second,
                             cells(face - 1).first,
                             cells(face - 1).second)});
    });
}

void checkPatches(const PolyMesh& mesh, Defects& defects) {
    Label expected = mesh.internalFaceCount();
    for (std::size_t p = 0; p < mesh.patches.size(); ++p) {
        const Patch& patch = mesh.patches[p];
        if (patch.start != expected || patch.size < 0)
            defects.push_back({3,
                               toLabel(p),
                               fmt::format("patch {} has faces {} to {}, expected to start at {}",
                                           patch.name,
                                           patch.start,
                                           patch.start + patch.size,
                                           expected)});
        expected = patch.start + patch.size;
    }
    if (expected != mesh.faceCount())
        defects.push_back(
            {3, -1, fmt::format("patches end at face {} of {}", expected, mesh.faceCount())});
}

// Laws of cells ----------------------------------------------------------------------------------

/// Six times the volume of the fan tetrahedra of one face against `apex`, and its magnitude.
std::pair<double, double> fanVolume(const PolyMesh& mesh, Label face, const Vec3& apex) {
    const std::span<const Label> points = mesh.faces[face];
    double sum = 0;
    double magnitude = 0;
    const Vec3 a = mesh.points[index(points[0])] - apex;
    for (std::size_t i = 2; i < points.size(); ++i) {
        const Vec3 b = mesh.points[index(points[i - 1])] - apex;
        const Vec3 c = mesh.points[index(points[i])] - apex;
        const double tetrahedron = dot(a, cross(b, c));
        sum += tetrahedron;
        magnitude += std::abs(tetrahedron);
    }
    return {sum, magnitude};
}

/// The volume of one cell by OpenFOAM's definition [m^3].
double volumeOf(const PolyMesh& mesh, Label cell, std::span<const Label> faces) {
    std::vector<FaceGeometry> outward;
    for (const Label face : faces) {
        outward.push_back(faceGeometry(mesh.points, mesh.faces[face]));
        if (mesh.owner[index(face)] != cell) outward.back().area = -outward.back().area;
    }
    return cellGeometry(outward).volume;
}

/// True when the volume is negative. Fans from a corner are a cheap first measure; only where they
/// are in doubt (thin cells, bent faces) the volume itself is asked.
bool isInsideOut(const PolyMesh& mesh, Label cell, std::span<const Label> faces) {
    const Vec3& apex = mesh.points[index(mesh.faces[faces[0]][0])];
    double volume = 0;
    double magnitude = 0;
    for (const Label face : faces) {
        const auto [sum, size] = fanVolume(mesh, face, apex);
        volume += mesh.owner[index(face)] == cell ? sum : -sum;
        magnitude += size;
    }
    return volume < 0.1 * magnitude && volumeOf(mesh, cell, faces) < 0;
}

bool arePolygons(const PolyMesh& mesh, std::span<const Label> faces) {
    return std::ranges::all_of(faces, [&](Label face) { return mesh.faces.rowSize(face) >= 3; });
}

void checkCell(const PolyMesh& mesh,
               Label cell,
               std::span<const Label> faces,
               EdgePairs& pairs,
               Defects& found) {
    if (faces.size() < 4) {
        found.push_back({5, cell, fmt::format("cell {} has {} faces", cell, faces.size())});
        return;
    }
    const auto [a, b] = unpairedEdge(mesh, cell, faces, pairs);
    if (a >= 0)
        found.push_back(
            {4,
             cell,
             fmt::format("cell {} is open: its faces do not use the edge of points {} and {} once "
                         "in each direction",
                         cell,
                         a,
                         b)});
    else if (arePolygons(mesh, faces) && isInsideOut(mesh, cell, faces))
        found.push_back({1, cell, fmt::format("cell {} has its faces inside out", cell)});
}

void checkCells(const PolyMesh& mesh, Defects& defects) {
    const Rows<Label> facesOf = cellFaces(mesh);
    std::vector<Defects> found(index((mesh.cellCount + blockSize - 1) / blockSize));
    parallelBlocks(mesh.cellCount, blockSize, [&](Label block, Label first, Label last) {
        EdgePairs pairs;
        for (Label cell = first; cell < last; ++cell)
            checkCell(mesh, cell, facesOf[cell], pairs, found[index(block)]);
    });
    for (Defects& part : found)
        std::move(part.begin(), part.end(), std::back_inserter(defects));
}

void checkPointUse(const PolyMesh& mesh, Defects& defects) {
    std::vector<char> used(mesh.points.size(), 0);
    parallelFor(toLabel(mesh.faces.values.size()), [&](Label i) {
        std::atomic_ref<char>(used[index(mesh.faces.values[index(i)])])
            .store(1, std::memory_order_relaxed);
    });
    for (Label point = 0; point < mesh.pointCount(); ++point)
        if (used[index(point)] == 0)
            defects.push_back({5, point, fmt::format("point {} is not used by a face", point)});
}

} // namespace

std::vector<Defect> validateRanges(const PolyMesh& mesh) {
    return checkRanges(mesh);
}

std::vector<Defect> validate(const PolyMesh& mesh) {
    Defects defects = checkRanges(mesh);
    if (!defects.empty()) return defects;
    checkFaces(mesh, defects);
    checkOrder(mesh, defects);
    checkPatches(mesh, defects);
    checkCells(mesh, defects);
    checkPointUse(mesh, defects);
    std::stable_sort(defects.begin(), defects.end(), [](const Defect& a, const Defect& b) {
        return a.law < b.law;
    });
    return defects;
}

void requireValid(const PolyMesh& mesh, const std::string& what) {
    const std::vector<Defect> defects = validate(mesh);
    if (defects.empty()) return;
    std::string first;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, defects.size()); ++i)
        first += "; " + defects[i].message;
    throw WorkError(fmt::format("{} is not valid, {} defects{}", what, defects.size(), first));
}

} // namespace polymesh
