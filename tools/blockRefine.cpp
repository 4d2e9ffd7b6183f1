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
                if ((c & bit) == 0)
                    least2 = std::min(least2,
                                      squaredNorm(cells.points[index(corners[c])] -
                                                  cells.points[index(corners[c | bit])]));
    return std::sqrt(least2);
}

void report(ToolRun& tool, const HexCells& cells, const RefinedMesh& refined) {
    const PolyMesh& mesh = refined.mesh;
    const std::uintmax_t bytes = bytesIn(tool.meshDir());
    std::vector<Label> counts(mostLevel + 1, 0);
    for (const Label level : refined.cellLevel)
        ++counts[index(level)];
    while (counts.back() == 0)
        counts.pop_back();
    tool.say("initial    {} cells", cells.cellCount());
    for (std::size_t level = 0; level < counts.size(); ++level)
        tool.say("level {:<4} {} cells", level, counts[level]);
    tool.say("cells      {}", mesh.cellCount);
    tool.say("faces      {} ({} internal)", mesh.faceCount(), mesh.internalFaceCount());
    tool.say("points     {}", mesh.pointCount());
    tool.say("written    {}, {:.1f} MB", tool.meshDir().string(), static_cast<double>(bytes) / 1e6);
    tool.report["initialCells"] = cells.cellCount();
    tool.report["cells"] = mesh.cellCount;
    tool.report["cellsOfLevel"] = counts;
    tool.report["faces"] = mesh.faceCount();
    tool.report["points"] = mesh.pointCount();
    tool.report["bytes"] = bytes;
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
        {"nCellsBetweenLevels",
         "N",
         "layers of cells of a level before a coarser one; default: 1"}};
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
    if (options.criteria.empty()) return std::nullopt;
    return options;
}

ExitCode runRefine(ToolRun& tool, const HexCells& cells, const RefineOptions& options) {
    tool.clock.start("refine");
    const RefinedMesh refined = refine(cells, options);
    tool.clock.start("write mesh");
    foam::writePolyMesh(
        refined.mesh, tool.meshDir(), tool.writeFormat(), [&](const foam::PolyMeshWriter& writer) {
            writer.writeLabelList("cellLevel", refined.cellLevel);
            writer.writeLabelList("pointLevel", refined.pointLevel);
            writer.writeUniformScalar("level0Edge", "[0 1 0 0 0 0 0]", shortestEdge(cells));
        });
    tool.clock.stop();
    report(tool, cells, refined);
    return ExitCode::success;
}

} // namespace polymesh::tools
