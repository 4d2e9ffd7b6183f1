// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/checkParts.h"
#include "libpolymesh/quality/metrics.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace polymesh {

namespace {

constexpr double great = 1e15; // OpenFOAM's GREAT, the start of its searches for the least
constexpr double small = 1e-15;

double toRadians(double degrees) {
    return degrees * std::numbers::pi / 180.0;
}

double angle(double cosine) { // [deg]
    return std::acos(std::min(1.0, std::max(-1.0, cosine))) * 180.0 / std::numbers::pi;
}

double sine(double degrees) {
    return std::sin(toRadians(degrees));
}

void checkBoundaryOpenness(const CheckContext& context) {
    const PolyMesh& mesh = context.mesh;
    Vec3 sum;
    double area = 0;
    for (Label face = mesh.internalFaceCount(); face < mesh.faceCount(); ++face) {
        const Vec3& faceArea = context.geometry.faceAreas[index(face)];
        sum += faceArea;
        area += norm(faceArea);
    }
    MeshFigures& figures = context.report.figures;
    figures.boundaryArea = area;
    figures.boundaryOpenness = sum / (area + 1e-300);
    store(context, CheckId::boundaryOpenness, {});
    const Vec3& o = figures.boundaryOpenness;
    context.report[CheckId::boundaryOpenness].failed =
        std::max({std::abs(o.x), std::abs(o.y), std::abs(o.z)}) > limits::openness;
}

void checkAreas(const CheckContext& context) {
    const std::vector<double> areas = valuesOf(context.mesh.faceCount(), [&](Label face) {
        return norm(context.geometry.faceAreas[index(face)]);
    });
    MinMax& range = context.report.figures.faceArea;
    range = {great, -great};
    for (const double area : areas)
        range = {std::min(range.min, area), std::max(range.max, area)};
    const auto area = [&](Label face) { return areas[index(face)]; };
    store(context,
          CheckId::faceArea,
          gather(context.mesh.faceCount(), [&](Label f) { return area(f) < limits::area; }),
          area,
          Worse::low);
    context.report[CheckId::faceArea].failed = range.min < limits::area;
}

void checkOrthogonality(const CheckContext& context) {
    const double severe = std::cos(toRadians(limits::nonOrthogonality));
    const std::vector<double> cosines = valuesOf(context.mesh.faceCount(), [&](Label face) {
        return context.hasNeighbour(face) ? orthogonality(context.ownerCentre(face),
                                                          context.neighbourCentre(face),
                                                          context.geometry.faceAreas[index(face)])
                                          : 1.0;
    });
    double least = great;
    double sum = 0;
    Label count = 0;
    Label errors = 0;
    for (Label face = 0; face < context.mesh.faceCount(); ++face) {
        const double cosine = cosines[index(face)];
        if (cosine < severe && !(cosine > small)) ++errors;
        if (!context.isCounted(face)) continue;
        least = std::min(least, cosine);
        sum += cosine;
        ++count;
    }
    MeshFigures& figures = context.report.figures;
    if (count > 0) {
        figures.maxNonOrthogonality = angle(least);
        figures.averageNonOrthogonality = angle(sum / static_cast<double>(count));
    }
    store(
        context,
        CheckId::nonOrthogonality,
        gather(context.mesh.faceCount(), [&](Label f) { return cosines[index(f)] < severe; }),
        [&](Label face) { return angle(cosines[index(face)]); },
        Worse::high);
    CheckResult& result = context.report[CheckId::nonOrthogonality];
    figures.severeNonOrthogonality = result.count - errors;
    result.count = errors;
    result.failed = errors > 0;
}

void checkPyramids(const CheckContext& context) {
    struct Pyramids {
        double owner = 0;
        double neighbour = std::numeric_limits<double>::infinity();
    };

    const PolyMesh& mesh = context.mesh;
    const std::vector<Pyramids> volumes = valuesOf(mesh.faceCount(), [&](Label face) {
        Pyramids pyramids;
        pyramids.owner = pyramidVolume(context.face(face), context.ownerCentre(face));
        if (mesh.isInternal(face))
            pyramids.neighbour = -pyramidVolume(context.face(face), context.neighbourCentre(face));
        return pyramids;
    });
    const auto isBad = [](double volume) { return volume < limits::pyramidVolume; };
    store(
        context,
        CheckId::facePyramids,
        gather(mesh.faceCount(),
               [&](Label f) {
                   return isBad(volumes[index(f)].owner) || isBad(volumes[index(f)].neighbour);
               }),
        [&](Label f) { return std::min(volumes[index(f)].owner, volumes[index(f)].neighbour); },
        Worse::low);
    CheckResult& result = context.report[CheckId::facePyramids];
    result.count = 0;
    for (const Label face : result.offenders)
        result.count += (isBad(volumes[index(face)].owner) ? 1 : 0) +
                        (isBad(volumes[index(face)].neighbour) ? 1 : 0);
    result.failed = result.count > 0;
}

void checkSkewness(const CheckContext& context) {
    const PolyMesh& mesh = context.mesh;
    const std::vector<double> values = valuesOf(mesh.faceCount(), [&](Label face) {
        const FaceGeometry geometry = context.face(face);
        const Vec3& owner = context.ownerCentre(face);
        return context.hasNeighbour(face)
                   ? internalSkewness(mesh.points,
                                      mesh.faces[face],
                                      geometry,
                                      owner,
                                      context.neighbourCentre(face))
                   : boundarySkewness(mesh.points, mesh.faces[face], geometry, owner);
    });
    const auto skewness = [&](Label face) { return values[index(face)]; };
    for (const double value : values)
        context.report.figures.maxSkewness = std::max(context.report.figures.maxSkewness, value);
    store(context,
          CheckId::skewness,
          gather(mesh.faceCount(), [&](Label f) { return skewness(f) > limits::skewness; }),
          skewness,
          Worse::high);
    CheckResult& result = context.report[CheckId::skewness];
    result.count = 0; // of coupled pairs the first face only
    for (const Label face : result.offenders)
        result.count += !context.hasNeighbour(face) || context.isCounted(face) ? 1 : 0;
    result.failed = result.count > 0;
}

/// The tetrahedra of one face: how many of OpenFOAM's three tests fail, and the lowest quality.
struct FaceTets {
    Label errors = 0;
    double quality = 0;
};

FaceTets faceTets(const CheckContext& context, Label face) {
    const PolyMesh& mesh = context.mesh;
    const std::span<const Label> points = mesh.faces[face];
    const Vec3& centre = context.geometry.faceCentres[index(face)];
    const Vec3& owner = context.ownerCentre(face);
    const Vec3* neighbour = context.hasNeighbour(face) ? &context.neighbourCentre(face) : nullptr;
    FaceTets result;
    result.quality = faceTetQuality(mesh.points, points, centre, owner, false);
    if (result.quality < limits::tetQuality) ++result.errors;
    if (mesh.isInternal(face)) {
        const double other = faceTetQuality(mesh.points, points, centre, *neighbour, true);
        if (other < limits::tetQuality) ++result.errors;
        result.quality = std::min(result.quality, other);
    }
    if (!hasTetBasePoint(mesh.points, points, owner, neighbour, limits::tetQuality))
        ++result.errors;
    return result;
}

void checkTets(const CheckContext& context) {
    const std::vector<FaceTets> tets =
        valuesOf(context.mesh.faceCount(), [&](Label face) { return faceTets(context, face); });
    store(
        context,
        CheckId::faceTets,
        gather(context.mesh.faceCount(), [&](Label f) { return tets[index(f)].errors > 0; }),
        [&](Label f) { return tets[index(f)].quality; },
        Worse::low);
    CheckResult& result = context.report[CheckId::faceTets];
    result.count = 0;
    for (const Label face : result.offenders)
        result.count += tets[index(face)].errors;
    result.failed = result.count > 0;
}

void checkConcavity(const CheckContext& context) {
    const PolyMesh& mesh = context.mesh;
    const double ignored = sine(limits::concaveAngle);
    const std::vector<double> sines = valuesOf(mesh.faceCount(), [&](Label face) {
        return faceConcavity(
            mesh.points, mesh.faces[face], context.geometry.faceAreas[index(face)], ignored);
    });
    const auto degrees = [](double s) {
        return std::asin(std::min(1.0, s)) * 180.0 / std::numbers::pi;
    };
    store(
        context,
        CheckId::concaveFaces,
        gather(mesh.faceCount(), [&](Label f) { return sines[index(f)] > small; }),
        [&](Label f) { return degrees(sines[index(f)]); },
        Worse::high);
    for (const double s : sines)
        context.report.figures.maxConcaveAngle =
            std::max(context.report.figures.maxConcaveAngle, degrees(s));
}

void checkFlatness(const CheckContext& context) {
    const PolyMesh& mesh = context.mesh;
    const std::vector<double> values = valuesOf(mesh.faceCount(), [&](Label face) {
        return faceFlatness(mesh.points, mesh.faces[face], context.face(face));
    });
    const auto isJudged = [&](Label face) {
        return mesh.faces.rowSize(face) > 3 &&
               norm(context.geometry.faceAreas[index(face)]) > limits::area;
    };
    double least = great;
    double sum = 0;
    Label count = 0;
    for (Label face = 0; face < mesh.faceCount(); ++face) {
        if (!isJudged(face)) continue;
        least = std::min(least, values[index(face)]);
        sum += values[index(face)];
        ++count;
    }
    if (count > 0) {
        context.report.figures.minFlatness = least;
        context.report.figures.averageFlatness = sum / static_cast<double>(count);
    }
    store(
        context,
        CheckId::warpedFaces,
        gather(mesh.faceCount(),
               [&](Label f) { return isJudged(f) && values[index(f)] < limits::flatness; }),
        [&](Label f) { return values[index(f)]; },
        Worse::low);
}

/// A metric of faces between cells that must not be low: least value and average of those counted.
struct LowMetric {
    CheckId id;
    double limit;
    std::optional<double>& least;
    double& average;
};

template<class Metric>
void checkLow(const CheckContext& context, const LowMetric& low, Metric&& metric) {
    const std::vector<double> values = valuesOf(context.mesh.faceCount(), [&](Label face) {
        return context.hasNeighbour(face) ? metric(face) : 1.0;
    });
    double least = great;
    double sum = 0;
    Label count = 0;
    for (Label face = 0; face < context.mesh.faceCount(); ++face) {
        if (!context.isCounted(face)) continue;
        least = std::min(least, values[index(face)]);
        sum += values[index(face)];
        ++count;
    }
    if (count > 0) {
        low.least = least;
        low.average = sum / static_cast<double>(count);
    }
    store(
        context,
        low.id,
        gather(context.mesh.faceCount(), [&](Label f) { return values[index(f)] < low.limit; }),
        [&](Label f) { return values[index(f)]; },
        Worse::low);
    context.report[low.id].failed = context.report[low.id].count > 0;
}

} // namespace

void checkFaceGeometry(const CheckContext& context) {
    checkBoundaryOpenness(context);
    checkAreas(context);
    checkOrthogonality(context);
    checkPyramids(context);
    checkSkewness(context);
    context.report.figures.coupledMismatch = context.coupling.averageMismatch;
    store(context, CheckId::coupledPoints, {});
}

void checkFaceShapes(const CheckContext& context) {
    checkTets(context);
    checkConcavity(context);
    checkFlatness(context);
    MeshFigures& figures = context.report.figures;
    const LowMetric weight{
        CheckId::faceWeight, limits::faceWeight, figures.minFaceWeight, figures.averageFaceWeight};
    checkLow(context, weight, [&](Label face) {
        return faceWeight(
            context.face(face), context.ownerCentre(face), context.neighbourCentre(face));
    });
    const LowMetric ratio{CheckId::volumeRatio,
                          limits::volumeRatio,
                          figures.minVolumeRatio,
                          figures.averageVolumeRatio};
    checkLow(context, ratio, [&](Label face) {
        return volumeRatio(context.geometry.cellVolumes[index(context.mesh.owner[index(face)])],
                           context.neighbourVolume(face));
    });
}

} // namespace polymesh
