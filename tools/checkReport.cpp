// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/checkReport.h"

#include "tools/checkReportWriter.h"

#include <array>

namespace polymesh::tools {

namespace {

/// What OpenFOAM calls the members of its sets.
constexpr std::array<std::string_view, checkCount> setContents{
    "illegal cells",
    "unused points",
    "unordered faces",
    "faces with out-of-range or duplicate vertices",
    "cells with over used edges",
    "faces with non-standard edge connectivity",
    "cells with zero or one non-boundary face",
    "cells with two non-boundary faces",
    "points that are in multiple regions",
    "conflicting points",
    "points on non-aligned edges",
    "",
    "non closed cells",
    "cells with high aspect ratio",
    "zero area faces",
    "zero volume cells",
    "non-orthogonal faces",
    "faces with incorrect orientation",
    "skew faces",
    "faces with incorrectly matched 0th (or consecutive) vertex",
    "faces with low quality or negative volume decomposition tets",
    "points on short edges",
    "", // with the distance
    "faces with concave angles",
    "warped faces",
    "under-determined cells",
    "concave cells",
    "faces with low interpolation weights",
    "faces with low volume ratio cells"};

} // namespace

/// Names the set of a check's offenders, and where the worst of a failing check are.
void ReportWriter::set(CheckId id) {
    set(id, std::string(setContents[static_cast<std::size_t>(id)]));
}

void ReportWriter::set(CheckId id, const std::string& contents) {
    if (!result(id).offenders.empty())
        line("  <<Writing {} {} to set {}",
             result(id).offenders.size(),
             contents,
             infoOf(id).setName);
    if (result(id).failed) worst(id);
}

void ReportWriter::worst(CheckId id) {
    constexpr std::array<std::string_view, 3> kinds{"point", "face", "cell"};
    const ElementKind kind = infoOf(id).kind;
    for (const Offender& offender : result(id).worst) {
        std::string where =
            fmt::format("{} {}", kinds[static_cast<std::size_t>(kind)], offender.element);
        if (kind == ElementKind::face) where += fmt::format(" of cell {}", offender.cell);
        if (offender.value != 0) where += fmt::format(", {}", num(offender.value));
        line("    worst: {} at {}", where, vec(offender.position));
    }
}

std::string ReportWriter::text() {
    stats();
    shapes();
    addressing();
    connectivity();
    regions();
    patches();
    cellZones();
    domain();
    alignment();
    closedness();
    sizes();
    orthogonality();
    faces();
    if (report_.options.allGeometry) {
        tetsAndEdges();
        faceShapes();
        cellShapes();
        interpolation();
    }
    return std::move(out_);
}

std::string reportText(const PolyMesh& mesh, const MeshReport& report, int precision) {
    return ReportWriter(mesh, report, precision).text();
}

std::string verdictText(const MeshReport& report) {
    return report.isOk() ? "Mesh OK."
                         : fmt::format("Failed {} mesh checks.", report.failed().size());
}

} // namespace polymesh::tools
