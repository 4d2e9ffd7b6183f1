// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mesh/cellGeometry.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/mesh/boundingBox.h"
#include "libpolymesh/mesh/topology.h"

namespace polymesh {

namespace {

constexpr double noArea = 1e-150;   // OpenFOAM's ROOTVSMALL
constexpr double noVolume = 1e-300; // OpenFOAM's VSMALL

FaceGeometry triangleGeometry(const Vec3& a, const Vec3& b, const Vec3& c) {
    return {(1.0 / 3.0) * (a + b + c), 0.5 * cross(b - a, c - a)};
}

Vec3 meanCorner(std::span<const Vec3> points, std::span<const Label> face) {
    Vec3 sum = points[index(face[0])];
    for (std::size_t i = 1; i < face.size(); ++i)
        sum += points[index(face[i])];
    return sum / static_cast<double>(face.size());
}

} // namespace

FaceGeometry faceGeometry(std::span<const Vec3> points, std::span<const Label> face) {
    if (face.empty()) return {};
    if (face.size() == 3)
        return triangleGeometry(
            points[index(face[0])], points[index(face[1])], points[index(face[2])]);
    const Vec3 mean = meanCorner(points, face);
    Vec3 doubleArea;
    Vec3 weightedCentre;
    double weight = 0;
    for (std::size_t i = 0; i < face.size(); ++i) {
        const Vec3& here = points[index(face[i])];
        const Vec3& next = points[index(face[i + 1 == face.size() ? 0 : i + 1])];
        const Vec3 normal = cross(next - here, mean - here);
        const double magnitude = norm(normal);
        doubleArea += normal;
        weight += magnitude;
        weightedCentre += magnitude * (here + next + mean);
    }
    if (weight < noArea) return {mean, {}};
    return {((1.0 / 3.0) * weightedCentre) / weight, 0.5 * doubleArea};
}

CellGeometry cellGeometry(std::span<const FaceGeometry> faces) {
    if (faces.empty()) return {};
    Vec3 estimate;
    for (const FaceGeometry& face : faces)
        estimate += face.centre;
    estimate = estimate / static_cast<double>(faces.size());

    Vec3 weightedCentre;
    double tripleVolume = 0;
    for (const FaceGeometry& face : faces) {
        const double pyramid = dot(face.area, face.centre - estimate); // three times its volume
        weightedCentre += pyramid * (0.75 * face.centre + 0.25 * estimate);
        tripleVolume += pyramid;
    }
    const double volume = tripleVolume * (1.0 / 3.0);
    if (!(std::abs(tripleVolume) > noVolume)) return {estimate, volume};
    return {weightedCentre / tripleVolume, volume};
}

MeshGeometry computeGeometry(const PolyMesh& mesh, const Rows<Label>& cellFaces) {
    MeshGeometry geometry;
    geometry.faceCentres.resize(index(mesh.faceCount()));
    geometry.faceAreas.resize(index(mesh.faceCount()));
    geometry.cellCentres.resize(index(mesh.cellCount));
    geometry.cellVolumes.resize(index(mesh.cellCount));
    parallelFor(mesh.faceCount(), [&](Label face) {
        const FaceGeometry own = faceGeometry(mesh.points, mesh.faces[face]);
        geometry.faceCentres[index(face)] = own.centre;
        geometry.faceAreas[index(face)] = own.area;
    });
    parallelBlocks(mesh.cellCount, 2048, [&](Label, Label first, Label last) {
        std::vector<FaceGeometry> outward;
        for (Label cell = first; cell < last; ++cell) {
            outward.clear();
            for (const Label face : cellFaces[cell]) {
                const Vec3& area = geometry.faceAreas[index(face)];
                const bool owned = mesh.owner[index(face)] == cell;
                outward.push_back({geometry.faceCentres[index(face)], owned ? area : -area});
            }
            const CellGeometry own = cellGeometry(outward);
            geometry.cellCentres[index(cell)] = own.centre;
            geometry.cellVolumes[index(cell)] = own.volume;
        }
    });
    return geometry;
}

MeshGeometry computeGeometry(const PolyMesh& mesh) {
    return computeGeometry(mesh, cellFaces(mesh));
}

double boundedVolume(const PolyMesh& mesh) {
    const Vec3 apex = boundingBox(mesh).centre();
    const Label first = mesh.internalFaceCount();
    const long double sum = parallelSum(mesh.faceCount() - first, 0.0L, [&](Label i) {
        const FaceGeometry face = faceGeometry(mesh.points, mesh.faces[first + i]);
        return static_cast<long double>(dot(face.area, face.centre - apex));
    });
    return static_cast<double>(sum / 3);
}

} // namespace polymesh
