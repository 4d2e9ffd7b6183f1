// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// checkMesh: constant/polyMesh -> report as OpenFOAM's checkMesh, sets of the offenders.

#include "formats/foam/polyMeshIo.h"
#include "formats/foam/sets.h"
#include "libpolymesh/quality/checks.h"
#include "tools/checkCompare.h"
#include "tools/checkReport.h"
#include "tools/toolMain.h"

#include <optional>

namespace polymesh::tools {

namespace {

const std::vector<Option> options{
    {"allTopology", "", "check edges of cells and shared points of faces too"},
    {"allGeometry", "", "check tetrahedra, edges, flatness, determinants, weights and ratios too"},
    surfaceOption(
        "compare volume, area and distances with this surface, turned as trimSurface does"),
    {"tetgen", "", "compare volumes of cells, and of the surface, with TetGen's"},
    {"noSets", "", "do not write the offenders to constant/polyMesh/sets"}};

foam::SetKind setKind(ElementKind kind) {
    switch (kind) {
    case ElementKind::point:
        return foam::SetKind::point;
    case ElementKind::face:
        return foam::SetKind::face;
    case ElementKind::cell:
        break;
    }
    return foam::SetKind::cell;
}

/// Writes the cells of each region when there are several.
void writeRegions(const std::filesystem::path& meshDir, const TopologyFacts& facts) {
    if (facts.regionSizes.size() < 2) return;
    std::vector<std::vector<Label>> cells(facts.regionSizes.size());
    for (std::size_t cell = 0; cell < facts.cellRegion.size(); ++cell)
        cells[index(facts.cellRegion[cell])].push_back(toLabel(cell));
    for (std::size_t region = 0; region < cells.size(); ++region)
        foam::writeSet(
            meshDir, foam::SetKind::cell, fmt::format("region{}", region), cells[region]);
}

/// Writes the offenders of each check as OpenFOAM does, and removes what an earlier run left.
void writeSets(const std::filesystem::path& meshDir, const MeshReport& report) {
    for (std::size_t i = 0; i < checkCount; ++i) {
        const CheckInfo& info = infoOf(static_cast<CheckId>(i));
        const std::vector<Label>& offenders = report.results[i].offenders;
        const std::string name(info.setName);
        std::error_code ignored;
        if (!offenders.empty())
            foam::writeSet(meshDir, setKind(info.kind), name, offenders);
        else if (!name.empty())
            std::filesystem::remove(meshDir / "sets" / name, ignored);
    }
    writeRegions(meshDir, report.topology);
}

void compare(ToolRun& tool, const PolyMesh& mesh) {
    const Settings& settings = tool.settings;
    std::optional<TriSurface> surface;
    if (settings.has("surface")) {
        tool.clock.start("surface");
        surface = readToCompare(tool, tool.surfaceFile(settings.text("surface")).string());
        compareWithSurface(tool, mesh, *surface);
    }
    if (!settings.isOn("tetgen")) return;
    tool.clock.start("tetgen");
    compareWithTetgen(tool, mesh, surface ? &*surface : nullptr);
}

ExitCode run(ToolRun& tool) {
    const CheckOptions checkOptions{.allTopology = tool.settings.isOn("allTopology"),
                                    .allGeometry = tool.settings.isOn("allGeometry")};
    tool.clock.start("read");
    const PolyMesh mesh = foam::readPolyMesh(tool.meshDir());
    tool.clock.start("check");
    const MeshReport report = checkMesh(mesh, checkOptions);
    tool.report.update(reportJson(mesh, report));
    tool.say("{}", reportText(mesh, report, 6));
    compare(tool, mesh);
    if (!tool.settings.isOn("noSets")) writeSets(tool.meshDir(), report);
    tool.say("{}\n", verdictText(report));
    return report.isOk() ? ExitCode::success : ExitCode::failure;
}

} // namespace

Tool thisTool() {
    return {"checkMesh",
            "checks topology and quality of the mesh by OpenFOAM's definitions and limits",
            options,
            run};
}

} // namespace polymesh::tools
