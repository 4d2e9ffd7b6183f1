// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/checks.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/quality/checkParts.h"

namespace polymesh {

namespace {

using enum ElementKind;

constexpr std::array<CheckInfo, checkCount> infos{{
    {"cellFaces", "illegalCells", cell},
    {"unusedPoints", "unusedPoints", point},
    {"faceOrder", "upperTriangularFace", face},
    {"faceVertices", "outOfRangeFaces", face},
    {"zipUp", "zipUpCells", cell},
    {"faceConnectivity", "edgeFaces", face},
    {"oneInternalFace", "oneInternalFaceCells", cell},
    {"twoInternalFaces", "twoInternalFacesCells", cell},
    {"multiRegionPoints", "multiRegionPoints", point},
    {"nonManifoldPoints", "nonManifoldPoints", point},
    {"edgeAlignment", "nonAlignedEdges", point},
    {"boundaryOpenness", "", face},
    {"cellOpenness", "nonClosedCells", cell},
    {"aspectRatio", "highAspectRatioCells", cell},
    {"faceArea", "zeroAreaFaces", face},
    {"cellVolume", "zeroVolumeCells", cell},
    {"nonOrthogonality", "nonOrthoFaces", face},
    {"facePyramids", "wrongOrientedFaces", face},
    {"skewness", "skewFaces", face},
    {"coupledPoints", "coupledFaces", face},
    {"faceTets", "lowQualityTetFaces", face},
    {"shortEdges", "shortEdges", point},
    {"nearPoints", "nearPoints", point},
    {"concaveFaces", "concaveFaces", face},
    {"warpedFaces", "warpedFaces", face},
    {"determinant", "underdeterminedCells", cell},
    {"concaveCells", "concaveCells", cell},
    {"faceWeight", "lowWeightFaces", face},
    {"volumeRatio", "lowVolRatioFaces", face},
}};

void requireReadable(const PolyMesh& mesh) {
    const std::vector<Defect> defects = validateRanges(mesh);
    require(defects.empty(),
            "the mesh cannot be checked: {} ({} such defects)",
            defects.empty() ? "" : defects.front().message,
            defects.size());
}

void checkDirections(const CheckContext& context) {
    MeshReport& report = context.report;
    report.directions = meshDirections(context.mesh, context.geometry);
    if (report.directions.geometric == Directions{true, true, true}) return;
    report.alignment = edgeAlignment(context.mesh, context.geometry, report.directions);
    store(context, CheckId::edgeAlignment, report.alignment.points);
    report[CheckId::edgeAlignment].count = report.alignment.edgeCount;
    report[CheckId::edgeAlignment].failed = !report.alignment.isOk();
}

void checkAll(const CheckContext& context) {
    const CheckOptions& options = context.report.options;
    checkAddressing(context);
    if (options.allTopology) checkConnectivity(context);
    checkRegions(context);
    checkSurfaces(context);
    checkDirections(context);
    checkCellGeometry(context);
    checkFaceGeometry(context);
    if (!options.allGeometry) return;
    checkFaceShapes(context);
    checkPointDistances(context);
    checkCellShapes(context);
}

/// Says where the worst offenders are.
void locate(const CheckContext& context) {
    for (std::size_t i = 0; i < checkCount; ++i)
        for (Offender& offender : context.report.results[i].worst) {
            const std::size_t at = index(offender.element);
            switch (infos[i].kind) {
            case point:
                offender.position = context.mesh.points[at];
                break;
            case face:
                offender.position = context.geometry.faceCentres[at];
                offender.cell = context.mesh.owner[at];
                break;
            case cell:
                offender.position = context.geometry.cellCentres[at];
                offender.cell = offender.element;
                break;
            }
        }
}

} // namespace

const CheckInfo& infoOf(CheckId id) {
    return infos[static_cast<std::size_t>(id)];
}

std::vector<std::string> MeshReport::failed() const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < checkCount; ++i)
        if (results[i].failed) names.emplace_back(infos[i].name);
    return names;
}

void store(const CheckContext& context, CheckId id, std::vector<Label> offenders) {
    store(
        context, id, std::move(offenders), [](Label) { return 0.0; }, Worse::high);
}

MeshReport checkMesh(const PolyMesh& mesh, const CheckOptions& options) {
    requireReadable(mesh);
    MeshReport report;
    report.options = options;
    const Rows<Label> facesOf = cellFaces(mesh);
    const MeshGeometry geometry = computeGeometry(mesh, facesOf);
    const Coupling coupling = coupleFaces(mesh, geometry);
    report.shapes = countShapes(mesh, facesOf);
    const CheckContext context{mesh, facesOf, geometry, coupling, report};
    checkAll(context);
    locate(context);
    return report;
}

} // namespace polymesh
