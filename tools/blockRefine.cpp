// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/blockRefine.h"

#include "formats/foam/polyMeshWriter.h"
#include "formats/foam/sets.h"
#include "formats/surfaceIo.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/refine/octant.h"
#include "libpolymesh/refine/surfaceCriteria.h"
#include "tools/refineDict.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <numbers>

namespace polymesh::tools {

namespace {

namespace fs = std::filesystem;

const char* const surfaceOptions[] = {"level", "levels", "curvature"};

int levelOf(const Settings& settings, const std::string& name, double value) {
    require(value >= 0 && value <= mostLevel && value == std::floor(value),
            "{}: {}: a level is a whole number from 0 to {}",
            settings.place(name),
            value,
            mostLevel);
    return static_cast<int>(value);
}

std::vector<Shell> shellsOf(const Settings& settings) {
    std::vector<Shell> shells;
    const std::vector<double> numbers = settings.numbers("levels");
    require(numbers.size() % 2 == 0,
            "{}: '{}': expected pairs (distance level)",
            settings.place("levels"),
            settings.text("levels"));
    for (std::size_t i = 0; i < numbers.size(); i += 2) {
        require(numbers[i] >= 0,
                "{}: {}: a distance must not be negative",
                settings.place("levels"),
                numbers[i]);
        shells.push_back({numbers[i], levelOf(settings, "levels", numbers[i + 1])});
    }
    return shells;
}

/// What the options ask for of -surface.
void addOptions(const ToolRun& tool, RefineOptions& options) {
    const Settings& settings = tool.settings;
    if (settings.has("nCellsBetweenLevels"))
        options.bufferLayers = static_cast<int>(settings.integer("nCellsBetweenLevels", 1, 20));
    if (std::ranges::none_of(surfaceOptions, [&](const char* o) { return settings.has(o); }))
        return;
    const fs::path file = tool.surfaceFile(settings.text("surface"));
    const auto near = std::make_shared<const NearTriangles>(
        std::make_shared<const TriSurface>(readSurface(file)));
    std::vector<Shell> shells;
    if (settings.has("levels")) shells = shellsOf(settings);
    if (settings.has("level"))
        shells.push_back({0, levelOf(settings, "level", settings.number("level"))});
    if (!shells.empty()) options.criteria.push_back(distanceCriterion(near, shells));
    if (!settings.has("curvature")) return;
    const std::vector<double> limits = settings.numbers("curvature", 2);
    require(limits[0] > 0, "{}: {}: must be positive", settings.place("curvature"), limits[0]);
    constexpr double featureAngle = std::numbers::pi / 6;
    options.criteria.push_back(curvatureCriterion(
        near, {limits[0], levelOf(settings, "curvature", limits[1]), featureAngle}));
}

std::vector<Label> readCellSet(const ToolRun& tool, const std::string& name) {
    return foam::readSet(tool.meshDir(), foam::SetKind::cell, name);
}

/// The shortest edge of the initial cells [m].
double shortestEdge(const HexCells& cells) {
    double least2 = Box::inf;
    for (const std::array<Label, 8>& corners : cells.corners)
        for (std::size_t c = 0; c < 8; ++c)
            for (std::size_t bit = 1; bit < 8; bit *= 2)
                if ((c & bit) == 0 && corners[c] != corners[c | bit])
                    least2 = std::min(least2,
                                      squaredNorm(cells.points[index(corners[c])] -
                                                  cells.points[index(corners[c | bit])]));
    return std::sqrt(least2);
}

/// Numbers of cells of each level, of all processes together.
std::vector<Label> cellsOfLevel(const RefinedMesh& refined, const Processes& processes) {
    std::vector<Label> own(mostLevel + 1, 0);
    for (const Label level : refined.cellLevel)
        ++own[index(level)];
    const std::vector<Label> all = processes.gather(own);
    std::vector<Label> counts(own.size(), 0);
    for (std::size_t i = 0; i < all.size(); ++i)
        counts[i % counts.size()] += all[i];
    while (counts.back() == 0)
        counts.pop_back();
    return counts;
}

void reportLevels(ToolRun& tool, Label initialCells, const std::vector<Label>& counts) {
    tool.say("initial    {} cells", initialCells);
    for (std::size_t level = 0; level < counts.size(); ++level)
        tool.say("level {:<4} {} cells", level, counts[level]);
    tool.report["initialCells"] = initialCells;
    tool.report["cellsOfLevel"] = counts;
}

void reportMesh(ToolRun& tool, const PolyMesh& mesh) {
    const std::uintmax_t bytes = bytesIn(tool.meshDir());
    tool.say("cells      {}", mesh.cellCount);
    tool.say("faces      {} ({} internal)", mesh.faceCount(), mesh.internalFaceCount());
    tool.say("points     {}", mesh.pointCount());
    tool.say("written    {}, {:.1f} MB", tool.meshDir().string(), static_cast<double>(bytes) / 1e6);
    tool.report["cells"] = mesh.cellCount;
    tool.report["faces"] = mesh.faceCount();
    tool.report["points"] = mesh.pointCount();
    tool.report["bytes"] = bytes;
}

void reportProcesses(ToolRun& tool, const PolyMesh& own, const Processes& processes) {
    const std::vector<Label> cells = processes.gather(std::vector<Label>{own.cellCount});
    Label all = 0;
    for (std::size_t r = 0; r < cells.size(); ++r) {
        tool.say("written    {}/processor{}, {} cells", tool.caseDir.string(), r, cells[r]);
        all += cells[r];
    }
    tool.say("cells      {}", all);
    tool.report["cells"] = all;
    tool.report["cellsOfProcess"] = cells;
}

void write(const RefinedMesh& refined,
           const fs::path& directory,
           const foam::WriteFormat& format,
           double level0Edge) {
    const ProcessAddressing& addressing = refined.addressing;
    foam::writePolyMesh(refined.mesh, directory, format, [&](const foam::PolyMeshWriter& writer) {
        writer.writeLabelList("cellLevel", refined.cellLevel);
        writer.writeLabelList("pointLevel", refined.pointLevel);
        writer.writeUniformScalar("level0Edge", "[0 1 0 0 0 0 0]", level0Edge);
        if (addressing.cells.empty()) return;
        writer.writeLabelList("cellProcAddressing", addressing.cells);
        writer.writeLabelList("faceProcAddressing", addressing.faces);
        writer.writeLabelList("pointProcAddressing", addressing.points);
        writer.writeLabelList("boundaryProcAddressing", addressing.patches);
    });
}

/// Each process makes its part and writes it to its own directory.
ExitCode runTogether(ToolRun& tool, const HexCells& cells, const RefineOptions& options) {
    const Processes processes = Processes::ofMpirun();
    require(processes.count() > 1,
            "option -parallel: there is one process; start several: mpirun -np 2 blockInit "
            "-parallel");
    require(processes.count() <= cells.cellCount(),
            "option -parallel: {} processes for {} initial cells; each needs one at least",
            processes.count(),
            cells.cellCount());
    require(!cells.hasCollapsed,
            "option -parallel: blocks with collapsed edges are not supported; run blockInit "
            "without it");
    tool.quiet = tool.quiet || processes.rank() > 0;
    tool.reports = processes.rank() == 0;
    try {
        tool.clock.start("refine");
        const RefinedMesh refined = refine(cells, options, processes);
        tool.clock.start("write mesh");
        const foam::CaseDirectory own{tool.caseDir / fmt::format("processor{}", processes.rank()),
                                      tool.caseDirectory().region};
        write(refined, own.polyMesh(), tool.writeFormat(), shortestEdge(cells));
        tool.clock.stop();
        reportLevels(tool, cells.cellCount(), cellsOfLevel(refined, processes));
        reportProcesses(tool, refined.mesh, processes);
    } catch (const std::exception& error) {
        fmt::print(stderr, "blockInit: process {}: {}\n", processes.rank(), error.what());
        Processes::abort(static_cast<int>(ExitCode::failure)); // the others wait for this one
    }
    return ExitCode::success;
}

} // namespace

const std::vector<Option>& refineOptions() {
    static const std::vector<Option> options{
        {"level", "N", "halve the cells that the surface passes N times"},
        {"levels",
         "SHELLS",
         "halve the cells within distances [m] of the surface: \"((distance N) ...)\""},
        {"curvature",
         "LIMITS",
         "halve cells at the surface where its radius of curvature is less than so many of them, "
         "up to a level: \"(cellsPerRadius N)\""},
        {"nCellsBetweenLevels", "N", "layers of cells of a level before a coarser one; default: 1"},
        {"parallel",
         "",
         "each process that mpirun starts makes its part of the mesh: processor0, processor1, ...",
         false}};
    return options;
}

std::optional<RefineOptions> refinementOf(const ToolRun& tool, const fs::path& blocks) {
    RefineOptions options;
    const RefineFiles files{
        [&](const std::string& name) { return readSurface(tool.surfaceFile(name)); },
        [&](const std::string& name) { return readCellSet(tool, name); }};
    for (const fs::path& path : {tool.dictionary, blocks}) {
        if (path.empty()) continue;
        const foam::Dictionary entries = foam::readDictionary(path);
        if (!entries.has("refinement")) continue;
        options = readRefinement(entries.dictionary("refinement"), files);
        break;
    }
    addOptions(tool, options);
    if (options.criteria.empty() && !tool.settings.isOn("parallel")) return std::nullopt;
    return options;
}

ExitCode runRefine(ToolRun& tool, const HexCells& cells, const RefineOptions& options) {
    if (tool.settings.isOn("parallel")) return runTogether(tool, cells, options);
    tool.clock.start("refine");
    const RefinedMesh refined = refine(cells, options);
    tool.clock.start("write mesh");
    write(refined, tool.meshDir(), tool.writeFormat(), shortestEdge(cells));
    tool.clock.stop();
    reportLevels(tool, cells.cellCount(), cellsOfLevel(refined, Processes()));
    reportMesh(tool, refined.mesh);
    return ExitCode::success;
}

} // namespace polymesh::tools
