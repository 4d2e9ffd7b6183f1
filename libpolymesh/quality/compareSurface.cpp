// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/compareSurface.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/geometry/box.h"
#include "libpolymesh/surface/distance.h"
#include "libpolymesh/surface/measure.h"

#include <algorithm>
#include <cmath>

namespace polymesh {

namespace {

constexpr double closedLimit = 1e-6; // sum of area vectors by area of a closed boundary

/// A place at which a distance is taken; points have no area and do not count in the mean.
struct Sample {
    Vec3 point;
    double area = 0; // [m^2]
    Label part = -1; // patch or region
};

/// Distances of parts of a boundary and of the whole.
struct PartDistances {
    DistanceFigures whole;
    std::vector<DistanceFigures> parts;
};

/// The running maximum and area-weighted sum of one part.
struct Tally {
    DistanceFigures figures;
    double area = 0;

    void add(const Sample& sample, double distance) {
        if (distance > figures.max) {
            figures.max = distance;
            figures.where = sample.point;
        }
        figures.mean += sample.area * distance;
        area += sample.area;
    }

    DistanceFigures finish() const {
        DistanceFigures result = figures;
        result.mean = area > 0 ? figures.mean / area : 0;
        return result;
    }
};

PartDistances distances(const std::vector<Sample>& samples, const TriSurface& to, Label partCount) {
    const SurfaceTree tree(to);
    std::vector<double> values(samples.size());
    parallelFor(toLabel(samples.size()), [&](Label i) {
        values[index(i)] = tree.closest(samples[index(i)].point).distance;
    });
    Tally whole;
    std::vector<Tally> parts(index(partCount));
    for (std::size_t i = 0; i < samples.size(); ++i) {
        whole.add(samples[i], values[i]);
        parts[index(samples[i].part)].add(samples[i], values[i]);
    }
    PartDistances result{whole.finish(), {}};
    for (const Tally& part : parts)
        result.parts.push_back(part.finish());
    return result;
}

/// The compared boundary faces of a mesh.
class PartBoundary {
public:
    PartBoundary(const PolyMesh& mesh, const std::vector<Label>& patches)
        : mesh_(mesh), patches_(patches), areas_(patches.size(), 0.0) {
        Label part = 0;
        for (const Label p : patches) {
            const Patch& patch = mesh.patches[index(p)];
            for (Label face = patch.start; face < patch.start + patch.size; ++face)
                addFace(face, part);
            ++part;
        }
        require(triangles_.triangleCount() > 0, "the patches to compare have no faces");
        triangles_.regionNames.emplace_back("boundary");
    }

    const TriSurface& triangles() const { return triangles_; }

    const std::vector<Sample>& samples() const { return samples_; }

    double area(Label part) const { return areas_[index(part)]; }

    bool isClosed() const { return norm(areaSum_) <= closedLimit * magnitude_; }

    /// Volume within the faces, positive whichever way they point.
    double volume() const {
        long double sum = 0;
        for (const Label p : patches_) {
            const Patch& patch = mesh_.patches[index(p)];
            for (Label face = patch.start; face < patch.start + patch.size; ++face) {
                const FaceGeometry geometry = faceGeometry(mesh_.points, mesh_.faces[face]);
                sum += static_cast<long double>(dot(geometry.area, geometry.centre - origin_));
            }
        }
        return std::abs(static_cast<double>(sum / 3));
    }

private:
    void addFace(Label face, Label part) {
        const std::span<const Label> points = mesh_.faces[face];
        const FaceGeometry geometry = faceGeometry(mesh_.points, points);
        if (samples_.empty()) origin_ = geometry.centre;
        samples_.push_back({geometry.centre, norm(geometry.area), part});
        areaSum_ += geometry.area;
        magnitude_ += norm(geometry.area);
        areas_[index(part)] += norm(geometry.area);
        for (const Label point : points)
            samples_.push_back({mesh_.points[index(point)], 0, part});
        addTriangles(points, geometry.centre);
    }

    /// The face itself when it is a triangle, else its fan about the centre.
    void addTriangles(std::span<const Label> points, const Vec3& centre) {
        const Label first = triangles_.pointCount();
        const Label size = toLabel(points.size());
        for (const Label point : points)
            triangles_.points.push_back(mesh_.points[index(point)]);
        if (size == 3) {
            addTriangle({first, first + 1, first + 2});
            return;
        }
        triangles_.points.push_back(centre);
        for (Label i = 0; i < size; ++i)
            addTriangle({first + i, first + (i + 1 == size ? 0 : i + 1), first + size});
    }

    void addTriangle(const std::array<Label, 3>& triangle) {
        triangles_.triangles.push_back(triangle);
        triangles_.region.push_back(0);
    }

    const PolyMesh& mesh_;
    const std::vector<Label>& patches_;
    std::vector<double> areas_; // [m^2] one per patch
    TriSurface triangles_;
    std::vector<Sample> samples_;
    Vec3 origin_;
    Vec3 areaSum_;
    double magnitude_ = 0;
};

std::vector<Sample> surfaceSamples(const TriSurface& surface) {
    std::vector<Sample> samples;
    for (Label t = 0; t < surface.triangleCount(); ++t) {
        const Vec3& a = surface.corner(t, 0);
        const Vec3& b = surface.corner(t, 1);
        const Vec3& c = surface.corner(t, 2);
        const Label region = surface.region[index(t)];
        samples.push_back({(1.0 / 3.0) * (a + b + c), 0.5 * norm(cross(b - a, c - a)), region});
        for (const Vec3& corner : {a, b, c})
            samples.push_back({corner, 0, region});
    }
    return samples;
}

/// The patch of each region's name, or -1.
std::vector<Label> patchesOfRegions(const PolyMesh& mesh, const TriSurface& surface) {
    std::vector<Label> result;
    for (const std::string& name : surface.regionNames) {
        const auto found = std::find_if(mesh.patches.begin(),
                                        mesh.patches.end(),
                                        [&](const Patch& patch) { return patch.name == name; });
        result.push_back(found == mesh.patches.end()
                             ? -1
                             : toLabel(static_cast<std::size_t>(found - mesh.patches.begin())));
    }
    return result;
}

double meshVolume(const PolyMesh& mesh) {
    const MeshGeometry geometry = computeGeometry(mesh);
    double sum = 0;
    for (const double volume : geometry.cellVolumes)
        sum += volume;
    return sum;
}

double relative(double value, double reference) {
    return reference == 0 ? 0 : value / reference - 1;
}

} // namespace

double SurfaceComparison::volumeError() const {
    return relative(volume, surfaceVolume);
}

double SurfaceComparison::areaError() const {
    return relative(area, surfaceArea);
}

double SurfaceComparison::maxDistance() const {
    return std::max(meshToSurface.max, surfaceToMesh.max);
}

double SurfaceComparison::meanDistance() const {
    return std::max(meshToSurface.mean, surfaceToMesh.mean);
}

SurfaceComparison compareSurface(const PolyMesh& mesh, const TriSurface& surface) {
    require(surface.triangleCount() > 0, "the surface has no triangles");
    const std::vector<Label> patchOf = patchesOfRegions(mesh, surface);
    std::vector<Label> compared;
    for (const Label patch : patchOf)
        if (patch >= 0) compared.push_back(patch);
    const bool byName = !compared.empty();
    for (std::size_t p = 0; !byName && p < mesh.patches.size(); ++p)
        compared.push_back(toLabel(p));

    const PartBoundary boundary(mesh, compared);
    const SurfaceMeasure measured = measure(surface);
    const PartDistances fromMesh = distances(boundary.samples(), surface, toLabel(compared.size()));
    const PartDistances fromSurface = distances(
        surfaceSamples(surface), boundary.triangles(), toLabel(surface.regionNames.size()));

    SurfaceComparison result;
    result.volume = boundary.isClosed() ? boundary.volume() : meshVolume(mesh);
    result.surfaceVolume = std::abs(measured.volume);
    result.surfaceArea = measured.area;
    result.meshToSurface = fromMesh.whole;
    result.surfaceToMesh = fromSurface.whole;
    for (std::size_t p = 0; p < compared.size(); ++p)
        result.area += boundary.area(toLabel(p));
    Label part = 0;
    for (std::size_t r = 0; r < patchOf.size(); ++r) {
        if (patchOf[r] < 0) {
            result.missing.push_back(surface.regionNames[r]);
            continue;
        }
        result.patches.push_back({surface.regionNames[r],
                                  boundary.area(part),
                                  measured.regionArea[r],
                                  fromMesh.parts[index(part)],
                                  fromSurface.parts[r]});
        ++part;
    }
    return result;
}

} // namespace polymesh
