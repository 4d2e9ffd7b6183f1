// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/checkParts.h"
#include "libpolymesh/quality/metrics.h"

namespace polymesh {

namespace {

constexpr double great = 1e15; // OpenFOAM's GREAT

/// metric(cell, its faces with outward area vectors) for every cell, in parallel.
template<class Metric>
auto cellValues(const CheckContext& context, Metric&& metric) {
    using Value = decltype(metric(Label{0}, std::span<const FaceGeometry>{}));
    std::vector<Value> values(index(context.mesh.cellCount));
    parallelBlocks(context.mesh.cellCount, 1024, [&](Label, Label first, Label last) {
        std::vector<FaceGeometry> outward;
        for (Label cell = first; cell < last; ++cell) {
            outward.clear();
            for (const Label face : context.facesOf[cell]) {
                outward.push_back(context.face(face));
                if (context.mesh.owner[index(face)] != cell)
                    outward.back().area = -outward.back().area;
            }
            values[index(cell)] = metric(cell, std::span<const FaceGeometry>(outward));
        }
    });
    return values;
}

std::vector<Vec3> areasOf(std::span<const FaceGeometry> faces) {
    std::vector<Vec3> areas;
    areas.reserve(faces.size());
    for (const FaceGeometry& face : faces)
        areas.push_back(face.area);
    return areas;
}

void checkClosedness(const CheckContext& context) {
    const Label cells = context.mesh.cellCount;
    MeshReport& report = context.report;
    const auto values = cellValues(context, [&](Label cell, std::span<const FaceGeometry> faces) {
        return cellClosedness(
            areasOf(faces), context.geometry.cellVolumes[index(cell)], report.directions.geometric);
    });
    report.figures.maxCellOpenness = -great;
    report.figures.maxAspectRatio = -great;
    for (const CellClosedness& value : values) {
        report.figures.maxCellOpenness = std::max(report.figures.maxCellOpenness, value.openness);
        report.figures.maxAspectRatio = std::max(report.figures.maxAspectRatio, value.aspectRatio);
    }
    const auto openness = [&](Label cell) { return values[index(cell)].openness; };
    const auto aspectRatio = [&](Label cell) { return values[index(cell)].aspectRatio; };
    store(context,
          CheckId::cellOpenness,
          gather(cells, [&](Label cell) { return openness(cell) > limits::openness; }),
          openness,
          Worse::high);
    store(context,
          CheckId::aspectRatio,
          gather(cells, [&](Label cell) { return aspectRatio(cell) > limits::aspectRatio; }),
          aspectRatio,
          Worse::high);
    const bool isOpen = report[CheckId::cellOpenness].count > 0;
    report[CheckId::cellOpenness].failed = isOpen;
    // OpenFOAM stops at open cells, and counts the two as one check.
    report[CheckId::aspectRatio].failed = !isOpen && report[CheckId::aspectRatio].count > 0;
}

void checkVolumes(const CheckContext& context) {
    MeshFigures& figures = context.report.figures;
    figures.cellVolume = {great, -great};
    for (const double volume : context.geometry.cellVolumes) {
        figures.cellVolume = {std::min(figures.cellVolume.min, volume),
                              std::max(figures.cellVolume.max, volume)};
        figures.volume += volume;
    }
    const auto volume = [&](Label cell) { return context.geometry.cellVolumes[index(cell)]; };
    store(context,
          CheckId::cellVolume,
          gather(context.mesh.cellCount, [&](Label c) { return volume(c) < limits::volume; }),
          volume,
          Worse::low);
    context.report[CheckId::cellVolume].failed = context.report[CheckId::cellVolume].count > 0;
}

void checkDeterminants(const CheckContext& context) {
    const std::vector<double> values = valuesOf(context.mesh.cellCount, [&](Label cell) {
        std::vector<Vec3> areas;
        for (const Label face : context.facesOf[cell])
            if (context.hasNeighbour(face))
                areas.push_back(context.geometry.faceAreas[index(face)]);
        return cellDeterminant(areas, context.report.directions.geometric);
    });
    MeshFigures& figures = context.report.figures;
    figures.minDeterminant = great;
    double sum = 0;
    for (const double value : values) {
        figures.minDeterminant = std::min(figures.minDeterminant, value);
        sum += value;
    }
    if (!values.empty()) figures.averageDeterminant = sum / static_cast<double>(values.size());
    const auto determinant = [&](Label cell) { return values[index(cell)]; };
    store(context,
          CheckId::determinant,
          gather(context.mesh.cellCount,
                 [&](Label cell) { return determinant(cell) < limits::determinant; }),
          determinant,
          Worse::low);
    context.report[CheckId::determinant].failed = context.report[CheckId::determinant].count > 0;
}

void checkConcaveCells(const CheckContext& context) {
    const std::vector<char> isConcave =
        cellValues(context, [&](Label, std::span<const FaceGeometry> faces) -> char {
            return isConcaveCell(faces) ? 1 : 0;
        });
    store(context, CheckId::concaveCells, gather(context.mesh.cellCount, [&](Label cell) {
              return isConcave[index(cell)] != 0;
          }));
    context.report[CheckId::concaveCells].failed = context.report[CheckId::concaveCells].count > 0;
}

} // namespace

void checkCellGeometry(const CheckContext& context) {
    checkClosedness(context);
    checkVolumes(context);
}

void checkCellShapes(const CheckContext& context) {
    checkDeterminants(context);
    checkConcaveCells(context);
}

} // namespace polymesh
