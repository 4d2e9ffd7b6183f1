// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mpsSplitReport.h"

#include "formats/foam/sets.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/quality/standardShape.h"

#include <algorithm>

namespace polymesh::tools {

namespace {

constexpr std::size_t shownCells = 5;
constexpr const char* invertedSet = "invertedParts";

std::string shown(const Vec3& p) {
    return fmt::format("({:.6g} {:.6g} {:.6g})", p.x, p.y, p.z);
}

std::vector<InvertedCell> invertedOf(const PolyMesh& mesh, const SubdivisionPlan& plan) {
    const DividedMesh divided{mesh, plan.edges, plan.cellFaces};
    CellCorners corners;
    std::vector<InvertedCell> cells;
    for (const Label cell : plan.inverted) {
        corners.load(divided, cell);
        cells.push_back({cell,
                         plan.points[index(plan.layout.firstCell + cell)],
                         leastScaledJacobian(plan.parts(corners, cell))});
    }
    std::ranges::stable_sort(cells, {}, &InvertedCell::jacobian);
    return cells;
}

/// What was done so that parts are not inverted.
void reportHelp(ToolRun& tool, const DivisibleCounts& counts) {
    tool.say(
        "helped     {} cells that would have had an inverted part: {} faces split, {} cells "
        "cut, {} of them from a new point, {} joined with a neighbour; {} more cells; {} points "
        "moved",
        counts.firstInverted,
        counts.splitFaces,
        counts.conedCells + counts.cutCells,
        counts.conedCells,
        counts.joinedCells,
        counts.newCells,
        counts.movedPoints);
    tool.report["helpedCells"] = counts.firstInverted;
    tool.report["splitFaces"] = counts.splitFaces;
    tool.report["newPointCells"] = counts.conedCells;
    tool.report["concaveCuts"] = counts.cutCells;
    tool.report["joinedCells"] = counts.joinedCells;
    tool.report["newCells"] = counts.newCells;
    tool.report["movedPoints"] = counts.movedPoints;
}

void reportInverted(ToolRun& tool, const MpsFigures& figures) {
    tool.report["invertedCells"] = figures.inverted.size();
    nlohmann::ordered_json worst = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < std::min(shownCells, figures.inverted.size()); ++i) {
        const auto& [cell, centre, jacobian] = figures.inverted[i];
        worst.push_back({{"cell", cell},
                         {"centre", {centre.x, centre.y, centre.z}},
                         {"scaledJacobian", jacobian}});
    }
    tool.report["worst"] = worst;
    if (figures.inverted.empty()) return;
    tool.say("inverted   {} cells could not be divided without a part that is inverted or flat; "
             "the worst:",
             figures.inverted.size());
    for (std::size_t i = 0; i < worst.size(); ++i)
        tool.say("           cell {} at {} m, scaled Jacobian {:.3g}",
                 figures.inverted[i].cell,
                 shown(figures.inverted[i].centre),
                 figures.inverted[i].jacobian);
    foam::writeSet(tool.meshDir(), foam::SetKind::cell, invertedSet, figures.invertedParts);
    tool.say("           their parts are in the cell set {}; finer cells there or trimSurface "
             "-adjust repel -concave keep make fewer",
             invertedSet);
}

[[noreturn]] void refuse(const ToolRun& tool,
                         const std::string& what,
                         const std::string& set,
                         const std::vector<Label>& cells) {
    foam::writeSet(tool.meshDir(), foam::SetKind::cell, set, cells);
    throw InputError(fmt::format("{}: {}; all are in the cell set {}; mend the mesh first "
                                 "(checkMesh says more)",
                                 tool.meshDir().string(),
                                 what,
                                 set));
}

} // namespace

UndividedMesh describe(const PolyMesh& mesh) {
    return {mesh.cellCount, boundedVolume(mesh)};
}

MpsFigures figuresOf(const UndividedMesh& undivided, const Divisible& divisible) {
    const SubdivisionPlan& plan = divisible.plan;
    MpsFigures figures{undivided,
                       divisible.counts,
                       demandedCounts(divisible.mesh),
                       {plan.hexahedra, plan.pyramids},
                       invertedOf(divisible.mesh, plan),
                       {},
                       {},
                       {}};
    for (const Label cell : plan.inverted)
        for (Label part = plan.firstPart[index(cell)]; part < plan.firstPart[index(cell) + 1];
             ++part)
            figures.invertedParts.push_back(part);
    return figures;
}

void takeOnlyDivided(const Divisible& divisible,
                     const std::vector<Fate>& fates,
                     const PartlyDivided& partly,
                     MpsFigures& figures) {
    const SubdivisionPlan& plan = divisible.plan;
    const auto isDivided = [&](Label cell) { return fates[index(cell)] == Fate::divided; };
    figures.demanded = demandedCounts(divisible.mesh, isDivided);
    std::erase_if(figures.inverted, [&](const InvertedCell& c) { return !isDivided(c.cell); });
    figures.invertedParts.clear();
    for (const Label cell : plan.inverted)
        for (Label part = partly.firstCell[index(cell)];
             isDivided(cell) && part < partly.firstCell[index(cell) + 1];
             ++part)
            figures.invertedParts.push_back(part);
    PartFigures& counts = figures.part;
    counts.isPart = true;
    const Rows<Label> faces = cellFaces(partly.mesh);
    for (Label c = 0; c < toLabel(fates.size()); ++c) {
        counts.whole += fates[index(c)] == Fate::whole ? 1 : 0;
        if (fates[index(c)] != Fate::layer) continue;
        ++counts.layer;
        for (Label cone = partly.firstCell[index(c)]; cone < partly.firstCell[index(c) + 1]; ++cone)
            ++(faces.rowSize(cone) == 4 ? counts.tetrahedra : counts.pyramids);
    }
}

void requireConformal(const PolyMesh& result, const MpsFigures& figures) {
    for (const Defect& defect : validate(result))
        if (defect.law != 1 || figures.inverted.empty())
            throw WorkError(fmt::format("the divided mesh is not valid: {}", defect.message));
}

void refuseInvalid(ToolRun& tool, const PolyMesh& mesh) {
    const std::vector<Defect> defects = validate(mesh);
    std::vector<Label> open;
    for (const Defect& defect : defects)
        if (defect.law == 4) open.push_back(defect.element);
    if (!open.empty())
        refuse(tool,
               fmt::format("{} cells are not closed: {}", open.size(), defects.front().message),
               "openCells",
               open);
    const std::vector<double> volumes = computeGeometry(mesh).cellVolumes;
    std::vector<Label> inverted;
    for (Label cell = 0; cell < mesh.cellCount; ++cell)
        if (!(volumes[index(cell)] > 0)) inverted.push_back(cell);
    if (!inverted.empty())
        refuse(tool,
               fmt::format("{} cells are inverted or without volume, the first is {}",
                           inverted.size(),
                           inverted.front()),
               "invertedCells",
               inverted);
    if (!defects.empty())
        throw InputError(fmt::format("{}: {}", tool.meshDir().string(), defects.front().message));
}

void reportProjection(ToolRun& tool, const ProjectionCounts& counts) {
    tool.say(
        "projected  {} new boundary points, {} of them onto feature edges, by {:.3g} m at most; "
        "{} taken back, since a part would have been inverted",
        counts.moved,
        counts.onFeatures,
        counts.largestMove,
        counts.refused);
    tool.report["projected"] = counts.moved;
    tool.report["projectedOnFeatures"] = counts.onFeatures;
    tool.report["projectionRefused"] = counts.refused;
    tool.report["largestMove"] = counts.largestMove;
}

namespace {

/// Throws WorkError when the result has other shapes than theory demands.
void requireDemanded(const MpsFigures& figures, const ShapeCounts& shapes, Label cells) {
    const PartFigures& part = figures.part;
    const std::int64_t hexahedra = shapes[StandardShape::hexahedron] - part.whole;
    const std::int64_t pyramids = shapes[StandardShape::pyramid] - part.pyramids;
    const Label tetrahedra = shapes[StandardShape::tetrahedron];
    if (hexahedra == figures.demanded.hexahedra && pyramids == figures.demanded.pyramids &&
        tetrahedra == part.tetrahedra &&
        hexahedra + pyramids + part.whole + part.pyramids + tetrahedra == cells)
        return;
    throw WorkError(fmt::format("the division has {} hexahedra and {} pyramids of {} cells, where "
                                "theory demands {} and {}",
                                hexahedra,
                                pyramids,
                                cells,
                                figures.demanded.hexahedra,
                                figures.demanded.pyramids));
}

void reportPart(ToolRun& tool, const PartFigures& part) {
    if (!part.isPart) return;
    tool.say(
        "left alone {} hexahedra; {} others are a layer of {} pyramids and {} tetrahedra round "
        "what is divided",
        part.whole,
        part.layer,
        part.pyramids,
        part.tetrahedra);
    tool.report["wholeHexahedra"] = part.whole;
    tool.report["layerHexahedra"] = part.layer;
    tool.report["layerPyramids"] = part.pyramids;
    tool.report["layerTetrahedra"] = part.tetrahedra;
}

void reportRelaxed(ToolRun& tool, const RelaxCounts& counts) {
    tool.report["beyondLimits"] = counts.offenders;
    tool.report["beyondLimitsLeft"] = counts.left;
    tool.report["movedForQuality"] = counts.moved;
    if (counts.offenders == 0) return;
    tool.say("quality    {} new points moved for the sake of {} cells and faces that OpenFOAM's "
             "checkMesh finds too stretched or skew; {} are left",
             counts.moved,
             counts.offenders,
             counts.left);
}

} // namespace

bool reportSplit(ToolRun& tool, const MpsFigures& figures, const PolyMesh& result) {
    const Rows<Label> faces = cellFaces(result);
    const ShapeCounts shapes = countShapes(result, faces);
    requireDemanded(figures, shapes, result.cellCount);
    const std::int64_t hexahedra = shapes[StandardShape::hexahedron];
    const std::int64_t pyramids = shapes[StandardShape::pyramid];
    const double volume = boundedVolume(result);
    tool.clock.stop();
    tool.say("cells      {} divided into {}: {} hexahedra and {} pyramids ({:.2f} %)",
             figures.undivided.cells,
             result.cellCount,
             hexahedra,
             pyramids,
             100.0 * static_cast<double>(pyramids) / std::max<Label>(1, result.cellCount));
    tool.say(
        "           as theory demands: one for each node of valence 3, 2v for each other one{}",
        figures.part.isPart ? ", of the cells that are divided" : "");
    reportPart(tool, figures.part);
    tool.say("volume     {:.9g} m^3, {:.2g} of it off that of the undivided mesh",
             volume,
             std::abs(volume / figures.undivided.volume - 1));
    tool.report["cells"] = result.cellCount;
    tool.report["hexahedra"] = hexahedra;
    tool.report["pyramids"] = pyramids;
    tool.report["demandedHexahedra"] = figures.demanded.hexahedra;
    tool.report["demandedPyramids"] = figures.demanded.pyramids;
    tool.report["dividedCells"] = figures.undivided.cells;
    tool.report["volume"] = volume;
    tool.report["volumeError"] = volume / figures.undivided.volume - 1;
    reportHelp(tool, figures.counts);
    reportRelaxed(tool, figures.relaxed);
    reportInverted(tool, figures);
    return figures.inverted.empty();
}

} // namespace polymesh::tools
