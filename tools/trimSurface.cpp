// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// trimSurface: constant/polyMesh and a surface -> trim -> constant/polyMesh.

#include "formats/foam/polyMeshIo.h"
#include "formats/foam/runAll.h"
#include "formats/surfaceIo.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/trim/adjustMesh.h"
#include "libpolymesh/trimCell/cutByCells.h"
#include "tools/toolMain.h"
#include "tools/trimPrepare.h"
#include "tools/trimReport.h"

#include <array>
#include <functional>
#include <utility>

namespace polymesh::tools {

namespace {

const std::vector<Option> options{
    surfaceOption("trim by this closed surface"),
    {"keep", "SIDE", "inside (default) or outside the surface"},
    {"deviation",
     "F",
     "points of the surface farther than this from what would replace them are kept, fraction of "
     "the cell size; faces may be up to twice as far, and round single cells that would fail "
     "checkMesh all of it four times; 0: exact; default 0.1"},
    {"featureAngle", "DEG", "keep edges of the surface sharper than this [deg]; default 30"},
    {"minEdge", "F", "collapse shorter edges, fraction of the cell size; 0: off; default 0.05"},
    {"minVolume", "F", "merge smaller cells, fraction of the uncut cell; 0: off; default 0.01"},
    {"concave", "WHAT", "split (default) or keep cells that are concave or fail checkMesh"},
    {"patchType",
     "TYPE",
     "OpenFOAM type of the surface's patches; default wall; patchTypes { REGION TYPE; } in the "
     "dictionary for single ones"},
    {"algorithm",
     "NAME",
     "how the exact cut is found: mesh (default): nodes, edges and faces once for all cells; cell: "
     "each cell by itself, slower; the mesh is the same"},
    {"adjust",
     "HOW",
     "nodes near the surface: none (default) stay; project: go onto it, corners and feature edges "
     "first; repel: go away from it; avoid: as repel, and edges keep off its feature edges, faces "
     "off its corners"},
    {"adjustDistance", "F", "how near, fraction of the shortest edge at the node; default 0.3"},
    {"adjustOnly", "", "move the nodes, but do not trim"}};

AdjustOptions adjustOptions(const Settings& settings) {
    AdjustOptions adjust;
    const std::string how = settings.word("adjust", {"none", "project", "repel", "avoid"}, "none");
    if (how == "project") adjust.how = Adjust::project;
    if (how == "repel") adjust.how = Adjust::repel;
    if (how == "avoid") adjust.how = Adjust::avoid;
    adjust.distance = settings.numberOr(adjust.distance, "adjustDistance", 0, 0.5);
    return adjust;
}

TrimOptions trimOptions(const Settings& settings) {
    TrimOptions trim;
    if (settings.word("algorithm", {"mesh", "cell"}, "mesh") == "cell")
        trim.findCut = findCutByCells;
    trim.adjust = adjustOptions(settings);
    trim.keep = settings.word("keep", {"inside", "outside"}, "inside") == "outside" ? Keep::outside
                                                                                    : Keep::inside;
    trim.deviation = settings.numberOr(trim.deviation, "deviation", 0);
    trim.featureAngle = settings.angle("featureAngle", 30);
    trim.minEdge = settings.numberOr(trim.minEdge, "minEdge", 0, 0.5);
    trim.minVolume = settings.numberOr(trim.minVolume, "minVolume", 0, 0.5);
    // An exact trim without clean-up stays just that.
    const bool isPlain = trim.deviation == 0 && trim.minEdge == 0 && trim.minVolume == 0;
    trim.mendsCells =
        settings.word("concave", {"split", "keep"}, isPlain ? "keep" : "split") == "split";
    return trim;
}

/// The mesh to trim once more, after a failure. Throws InputError when the mesh is the reason.
PolyMesh readAgain(const ToolRun& tool) {
    PolyMesh mesh = foam::readPolyMesh(tool.meshDir());
    const std::vector<Defect> defects = validate(mesh);
    require(defects.empty(),
            "{}: {}; a mesh that is not valid cannot be trimmed, checkMesh says more",
            tool.meshDir().string(),
            defects.empty() ? "" : defects.front().message);
    return mesh;
}

/// Trims and validates. Should the clean-up spoil the mesh (a bug, but no reason to leave the user
/// without one), the trim is done again without it, and said so.
Trimmed trimValid(ToolRun& tool, PolyMesh mesh, const TriSurface& surface, TrimOptions how) {
    const auto attempt = [&](PolyMesh initial) {
        Trimmed trimmed = trim(std::move(initial), surface, how);
        tool.clock.start("validate");
        requireValid(trimmed.mesh, "the trimmed mesh");
        return trimmed;
    };
    const bool hasCleanUp = how.mendsCells || how.minEdge > 0 || how.minVolume > 0;
    PolyMesh again;
    try {
        return attempt(std::move(mesh));
    } catch (const WorkError& error) {
        again = readAgain(tool);
        if (!hasCleanUp) throw;
        tool.warn("{}; the mesh is made without clean-up instead", error.what());
    }
    how.mendsCells = false;
    how.minEdge = how.minVolume = 0;
    return attempt(std::move(again));
}

/// Whether the surface was mended so that it does not intersect itself any more.
bool isUnited(const nlohmann::ordered_json& surface) {
    return surface.contains("united") && surface["united"]["pairsLeft"] == 0;
}

/// The same; what fails on a surface that intersects itself is a matter of the surface.
Trimmed trimOrRefuse(ToolRun& tool,
                     const std::string& file,
                     PolyMesh mesh,
                     const TriSurface& surface,
                     const TrimOptions& how) {
    try {
        return trimValid(tool, std::move(mesh), surface, how);
    } catch (const WorkError& error) {
        const auto& found = tool.report["surface"];
        if (found["selfIntersections"]["pairs"] == 0 || isUnited(found)) throw;
        throw InputError(fmt::format("{}: the surface intersects itself (places above), so that no "
                                     "valid mesh can be made: {}; unite the parts that overlap",
                                     file,
                                     error.what()));
    }
}

/// Writes the mesh with its nodes moved.
ExitCode runAdjust(ToolRun& tool, PolyMesh mesh, TriSurface surface, const TrimOptions& how) {
    require(how.adjust.how != Adjust::none,
            "{}: nothing is to be moved; say -adjust project, repel or avoid",
            tool.settings.place("adjustOnly"));
    tool.clock.start("adjust");
    const AdjustCounts counts = adjustMesh(mesh, std::move(surface), how);
    tool.clock.start("write");
    foam::writePolyMesh(mesh, tool.meshDir(), tool.writeFormat());
    tool.clock.stop();
    reportAdjust(tool, how.adjust.how, counts);
    return ExitCode::success;
}

ExitCode run(ToolRun& tool) {
    TrimOptions how = trimOptions(tool.settings);
    how.onStage = [&](const std::string& name) { tool.clock.start(name); };
    const std::string file = tool.surfaceFile(tool.settings.text("surface")).string();
    tool.clock.start("read");
    TriSurface surface;
    PolyMesh mesh;
    foam::runAll(std::array<std::function<void()>, 2>{
        [&] { surface = readSurface(file); }, [&] { mesh = foam::readPolyMesh(tool.meshDir()); }});
    tool.say("surface    {}, {} triangles", file, surface.triangleCount());
    how.regionTypes = patchTypes(tool, surface);
    const foam::WriteFormat format = tool.writeFormat();
    tool.clock.start("check surface");
    prepareSurface(tool, file, surface);
    const InitialMesh initial = describe(mesh);
    const bool isWithin = checkPlace(tool, file, surface, initial.box);
    if (tool.settings.isOn("adjustOnly"))
        return runAdjust(tool, std::move(mesh), std::move(surface), how);
    const Trimmed trimmed = trimOrRefuse(tool, file, std::move(mesh), surface, how);
    tool.clock.start("write");
    const TrimRun done{initial, surface, how, trimmed, isWithin};
    TrimFigures figures;
    foam::runAll(std::array<std::function<void()>, 2>{
        [&] { foam::writePolyMesh(trimmed.mesh, tool.meshDir(), format); },
        [&] { figures = measureTrim(done); }});
    reportTrim(tool, done, figures);
    return ExitCode::success;
}

} // namespace

Tool thisTool() {
    return {"trimSurface",
            "trims the mesh of the case by a closed surface; regions become patches",
            options,
            run,
            {"patchTypes"}};
}

} // namespace polymesh::tools
