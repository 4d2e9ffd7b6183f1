// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/checkReportWriter.h"

#include <numbers>

namespace polymesh::tools {

void ReportWriter::domain() {
    const auto directions = [](const Directions& d) {
        return fmt::format("({} {} {})", int{d[0]}, int{d[1]}, int{d[2]});
    };
    const auto count = [](const Directions& d) { return int{d[0]} + int{d[1]} + int{d[2]}; };
    const MeshDirections& d = report_.directions;
    line("\nChecking geometry...");
    line("    Overall domain bounding box {} {}",
         vec(report_.figures.bounds.min),
         vec(report_.figures.bounds.max));
    line("    Mesh has {} geometric (non-empty/wedge) directions {}",
         count(d.geometric),
         directions(d.geometric));
    line("    Mesh has {} solution (non-empty) directions {}",
         count(d.solution),
         directions(d.solution));
}

void ReportWriter::alignment() {
    if (!result(CheckId::edgeAlignment).done) return;
    const EdgeAlignment& alignment = report_.alignment;
    for (const Wedge& wedge : alignment.wedges)
        line("    Wedge {} with angle {} degrees",
             wedge.name,
             num(wedge.angle * 180.0 / std::numbers::pi));
    if (!alignment.wedgeFault.empty())
        line(" ***{}", alignment.wedgeFault);
    else if (alignment.edgeCount > 0)
        line(" ***Number of edges not aligned with or perpendicular to non-empty directions: {}",
             alignment.edgeCount);
    else
        line("    All edges aligned with or perpendicular to non-empty directions.");
    set(CheckId::edgeAlignment);
}

void ReportWriter::closedness() {
    const MeshFigures& figures = report_.figures;
    if (result(CheckId::boundaryOpenness).failed)
        line(" ***Boundary openness {} possible hole in boundary description.",
             vec(figures.boundaryOpenness));
    else
        line("    Boundary openness {} OK.", vec(figures.boundaryOpenness));
    if (result(CheckId::cellOpenness).failed) {
        line(" ***Open cells found, max cell openness: {}, number of open cells {}",
             num(figures.maxCellOpenness),
             result(CheckId::cellOpenness).count);
    } else if (result(CheckId::aspectRatio).failed) {
        line(" ***High aspect ratio cells found, Max aspect ratio: {}, number of cells {}",
             num(figures.maxAspectRatio),
             result(CheckId::aspectRatio).count);
    } else {
        line("    Max cell openness = {} OK.", num(figures.maxCellOpenness));
        line("    Max aspect ratio = {} OK.", num(figures.maxAspectRatio));
    }
    set(CheckId::cellOpenness);
    set(CheckId::aspectRatio);
}

void ReportWriter::sizes() {
    const MeshFigures& figures = report_.figures;
    if (result(CheckId::faceArea).failed)
        line(" ***Zero or negative face area detected.  Minimum area: {}",
             num(figures.faceArea.min));
    else
        line("    Minimum face area = {}. Maximum face area = {}.  Face area magnitudes OK.",
             num(figures.faceArea.min),
             num(figures.faceArea.max));
    set(CheckId::faceArea);
    if (result(CheckId::cellVolume).failed)
        line(" ***Zero or negative cell volume detected.  Minimum negative volume: {}, Number of "
             "negative volume cells: {}",
             num(figures.cellVolume.min),
             result(CheckId::cellVolume).count);
    else
        line("    Min volume = {}. Max volume = {}.  Total volume = {}.  Cell volumes OK.",
             num(figures.cellVolume.min),
             num(figures.cellVolume.max),
             num(figures.volume));
    set(CheckId::cellVolume);
}

void ReportWriter::orthogonality() {
    const MeshFigures& figures = report_.figures;
    if (figures.maxNonOrthogonality)
        line("    Mesh non-orthogonality Max: {} average: {}",
             num(*figures.maxNonOrthogonality),
             num(figures.averageNonOrthogonality));
    if (figures.severeNonOrthogonality > 0)
        line("   *Number of severely non-orthogonal (> {} degrees) faces: {}.",
             num(limits::nonOrthogonality),
             figures.severeNonOrthogonality);
    if (result(CheckId::nonOrthogonality).failed)
        line(" ***Number of non-orthogonality errors: {}.",
             result(CheckId::nonOrthogonality).count);
    else
        line("    Non-orthogonality check OK.");
    set(CheckId::nonOrthogonality);
}

void ReportWriter::faces() {
    const MeshFigures& figures = report_.figures;
    if (result(CheckId::facePyramids).failed)
        line(" ***Error in face pyramids: {} faces are incorrectly oriented.",
             result(CheckId::facePyramids).count);
    else
        line("    Face pyramids OK.");
    set(CheckId::facePyramids);
    if (result(CheckId::skewness).failed)
        line(" ***Max skewness = {}, {} highly skew faces detected which may impair the quality of "
             "the results",
             num(figures.maxSkewness),
             result(CheckId::skewness).count);
    else
        line("    Max skewness = {} OK.", num(figures.maxSkewness));
    set(CheckId::skewness);
    line("    Coupled point location match (average {}) OK.", num(figures.coupledMismatch));
}

void ReportWriter::tetsAndEdges() {
    const MeshFigures& figures = report_.figures;
    if (result(CheckId::faceTets).failed)
        line(" ***Error in face tets: {} faces with low quality or negative volume decomposition "
             "tets.",
             result(CheckId::faceTets).count);
    else
        line("    Face tets OK.");
    set(CheckId::faceTets);
    const std::string lengths =
        fmt::format("{} {}", num(figures.edgeLength.min), num(figures.edgeLength.max));
    if (result(CheckId::shortEdges).count > 0)
        line("   *Edges too small, min/max edge length = {}, number too small: {}",
             lengths,
             result(CheckId::shortEdges).count);
    else
        line("    Min/max edge length = {} OK.", lengths);
    set(CheckId::shortEdges);
    const double near = norm(limits::edgeLength * figures.bounds.size());
    set(CheckId::nearPoints, fmt::format("near (closer than {} apart) points", num(near)));
}

void ReportWriter::faceShapes() {
    const MeshFigures& figures = report_.figures;
    if (result(CheckId::concaveFaces).count > 0)
        line("   *There are {} faces with concave angles between consecutive edges. Max concave "
             "angle = {} degrees.",
             result(CheckId::concaveFaces).count,
             num(figures.maxConcaveAngle));
    else
        line("    All angles in faces OK.");
    set(CheckId::concaveFaces);
    if (figures.minFlatness)
        line("    Face flatness (1 = flat, 0 = butterfly) : min = {}  average = {}",
             num(*figures.minFlatness),
             num(figures.averageFlatness));
    if (result(CheckId::warpedFaces).count > 0) {
        line("   *There are {} faces with ratio between projected and actual area < {}",
             result(CheckId::warpedFaces).count,
             num(limits::flatness));
        line("    Minimum ratio (minimum flatness, maximum warpage) = {}",
             num(*figures.minFlatness));
    } else {
        line("    All face flatness OK.");
    }
    set(CheckId::warpedFaces);
}

void ReportWriter::cellShapes() {
    const MeshFigures& figures = report_.figures;
    if (mesh_.cellCount > 0)
        line("    Cell determinant (wellposedness) : minimum: {} average: {}",
             num(figures.minDeterminant),
             num(figures.averageDeterminant));
    if (result(CheckId::determinant).failed)
        line(" ***Cells with small determinant (< {}) found, number of cells: {}",
             num(limits::determinant),
             result(CheckId::determinant).count);
    else
        line("    Cell determinant check OK.");
    set(CheckId::determinant);
    if (result(CheckId::concaveCells).failed)
        line(" ***Concave cells (using face planes) found, number of cells: {}",
             result(CheckId::concaveCells).count);
    else
        line("    Concave cell check OK.");
    set(CheckId::concaveCells);
}

void ReportWriter::interpolation() {
    const MeshFigures& figures = report_.figures;
    if (figures.minFaceWeight)
        line("    Face interpolation weight : minimum: {} average: {}",
             num(*figures.minFaceWeight),
             num(figures.averageFaceWeight));
    if (result(CheckId::faceWeight).failed)
        line(" ***Faces with small interpolation weight (< {}) found, number of faces: {}",
             num(limits::faceWeight),
             result(CheckId::faceWeight).count);
    else
        line("    Face interpolation weight check OK.");
    set(CheckId::faceWeight);
    if (figures.minVolumeRatio)
        line("    Face volume ratio : minimum: {} average: {}",
             num(*figures.minVolumeRatio),
             num(figures.averageVolumeRatio));
    if (result(CheckId::volumeRatio).failed)
        line(" ***Faces with small volume ratio (< {}) found, number of faces: {}",
             num(limits::volumeRatio),
             result(CheckId::volumeRatio).count);
    else
        line("    Face volume ratio check OK.");
    set(CheckId::volumeRatio);
}

} // namespace polymesh::tools
