// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/checkReport.h"

#include <nlohmann/json.hpp>

namespace polymesh::tools {

namespace {

using Json = nlohmann::ordered_json;

void addFigures(const MeshReport& report, Json& json) {
    const MeshFigures& figures = report.figures;
    const auto optional = [](const std::optional<double>& v) { return v ? Json(*v) : Json(); };
    json["maxNonOrthogonality"] = figures.maxNonOrthogonality.value_or(0);
    json["averageNonOrthogonality"] = figures.averageNonOrthogonality;
    json["severelyNonOrthogonalFaces"] = figures.severeNonOrthogonality;
    json["maxSkewness"] = figures.maxSkewness;
    json["maxAspectRatio"] = figures.maxAspectRatio;
    json["maxCellOpenness"] = figures.maxCellOpenness;
    json["minVolume"] = figures.cellVolume.min;
    json["maxVolume"] = figures.cellVolume.max;
    json["minFaceArea"] = figures.faceArea.min;
    json["maxFaceArea"] = figures.faceArea.max;
    if (!report.options.allGeometry) return;
    json["minEdgeLength"] = figures.edgeLength.min;
    json["maxEdgeLength"] = figures.edgeLength.max;
    json["maxConcaveAngle"] = figures.maxConcaveAngle;
    json["minFlatness"] = optional(figures.minFlatness);
    json["minDeterminant"] = figures.minDeterminant;
    json["averageDeterminant"] = figures.averageDeterminant;
    json["minFaceWeight"] = optional(figures.minFaceWeight);
    json["minVolumeRatio"] = optional(figures.minVolumeRatio);
}

Json worstOf(const CheckResult& result) {
    Json list = Json::array();
    for (const Offender& offender : result.worst)
        list.push_back(
            {{"element", offender.element},
             {"cell", offender.cell},
             {"value", offender.value},
             {"position", {offender.position.x, offender.position.y, offender.position.z}}});
    return list;
}

/// Every check that objects to something, failing or not.
Json checksOf(const MeshReport& report) {
    Json checks = Json::object();
    for (std::size_t i = 0; i < checkCount; ++i) {
        const CheckResult& result = report.results[i];
        if (result.offenders.empty() && !result.failed) continue;
        const CheckInfo& info = infoOf(static_cast<CheckId>(i));
        checks[std::string(info.name)] = {{"failed", result.failed},
                                          {"count", result.count},
                                          {"set", info.setName},
                                          {"worst", worstOf(result)}};
    }
    return checks;
}

} // namespace

nlohmann::ordered_json reportJson(const PolyMesh& mesh, const MeshReport& report) {
    Json json;
    json["ok"] = report.isOk();
    json["cells"] = mesh.cellCount;
    json["faces"] = mesh.faceCount();
    json["internalFaces"] = mesh.internalFaceCount();
    json["points"] = mesh.pointCount();
    json["volume"] = report.figures.volume;
    json["boundaryArea"] = report.figures.boundaryArea;
    for (std::size_t i = 0; i < standardShapeCount; ++i)
        json["shapes"][std::string(pluralName(static_cast<StandardShape>(i)))] =
            report.shapes.cells[i];
    json["failed"] = report.failed();
    json["regions"] = report.topology.regionSizes.size();
    for (const Patch& patch : mesh.patches)
        json["patches"][patch.name] = patch.size;
    addFigures(report, json);
    json["checks"] = checksOf(report);
    return json;
}

} // namespace polymesh::tools
