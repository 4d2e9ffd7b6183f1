// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/toolMain.h"

#include "formats/fileBytes.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/base/parallel.h"

#include <cstdio>
#include <exception>
#include <new>
#include <optional>
#include <unistd.h>

namespace polymesh::tools {

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t mostThreads = 4096;

Settings settingsOf(std::vector<Option> options) {
    options.insert(options.end(), commonOptions().begin(), commonOptions().end());
    return Settings(std::move(options));
}

fs::path caseDirectory(const Settings& settings) {
    const fs::path dir = settings.text("case", ".");
    require(
        fs::is_directory(dir), "{}: {} is not a directory", settings.place("case"), dir.string());
    return dir;
}

nlohmann::ordered_json stagesOf(const StageClock& clock) {
    auto stages = nlohmann::ordered_json::array();
    for (const Stage& stage : clock.stages())
        stages.push_back({{"name", stage.name}, {"seconds", stage.seconds}});
    return stages;
}

void finishReport(ToolRun& tool, const std::string& name) {
    tool.clock.stop();
    if (!tool.settings.has("json")) return;
    tool.report["tool"] = name;
    tool.report["stages"] = stagesOf(tool.clock);
    tool.report["wallSeconds"] = tool.clock.seconds();
    tool.report["peakMemoryBytes"] = peakMemoryBytes();
    writeBytes(tool.settings.text("json"), tool.report.dump(2) + "\n");
}

ToolRun prepare(const ToolDescription& tool, Settings settings) {
    const bool quiet = settings.isOn("quiet");
    const bool progress = !quiet && !settings.isOn("noProgress") && isatty(STDERR_FILENO) == 1;
    fs::path dir = caseDirectory(settings);
    return {.settings = std::move(settings),
            .caseDir = std::move(dir),
            .dictionary = {},
            .clock = StageClock(progress ? tool.name : ""),
            .report = nlohmann::ordered_json::object(),
            .quiet = quiet};
}

ExitCode runWith(const ToolDescription& tool,
                 Settings settings,
                 const std::function<ExitCode(ToolRun&)>& run) {
    if (settings.isOn("help")) {
        fmt::print("{}", helpText(tool.name, tool.purpose, settings));
        return ExitCode::success;
    }
    std::optional<ThreadLimit> limit;
    if (settings.has("threads"))
        limit.emplace(static_cast<std::size_t>(settings.integer("threads", 1, mostThreads)));
    ToolRun toolRun = prepare(tool, std::move(settings));
    const ExitCode code = run(toolRun);
    finishReport(toolRun, tool.name);
    return code;
}

/// The message on one line, whatever the library that made it thinks.
int fail(const std::string& tool, std::string message, ExitCode code) {
    for (char& c : message)
        if (c == '\n' || c == '\r') c = ' ';
    std::fflush(stdout);
    fmt::print(stderr, "{}: {}\n", tool, message);
    return static_cast<int>(code);
}

} // namespace

fs::path ToolRun::meshDir() const {
    const fs::path constant = caseDir / "constant";
    return (settings.has("region") ? constant / settings.text("region") : constant) / "polyMesh";
}

fs::path ToolRun::surfaceFile(const std::string& path) const {
    if (fs::exists(path)) return path;
    const fs::path inCase = caseDir / "constant" / "triSurface" / path;
    return fs::exists(inCase) ? inCase : fs::path(path);
}

foam::WriteFormat ToolRun::writeFormat() const {
    const std::string name =
        settings.word("format", {"ascii", "binary", "ascii.gz", "binary.gz"}, "binary");
    return {.format = name.starts_with("ascii") ? foam::Format::ascii : foam::Format::binary,
            .compress = name.ends_with(".gz")};
}

std::uintmax_t bytesIn(const fs::path& directory) {
    std::uintmax_t bytes = 0;
    for (const auto& entry : fs::directory_iterator(directory))
        if (entry.is_regular_file()) bytes += entry.file_size();
    return bytes;
}

int runTool(int argc,
            char** argv,
            const ToolDescription& tool,
            std::vector<Option> options,
            const std::function<ExitCode(ToolRun&)>& run) {
    try {
        Settings settings = settingsOf(std::move(options));
        addCommandLine(settings, std::vector<std::string>(argv + 1, argv + argc));
        const ExitCode code = runWith(tool, std::move(settings), run);
        if (std::fflush(stdout) != 0) throw WorkError("standard output cannot be written");
        return static_cast<int>(code);
    } catch (const InputError& error) {
        return fail(tool.name, error.what(), ExitCode::usage);
    } catch (const std::bad_alloc&) {
        return fail(tool.name, "out of memory; try fewer or larger cells", ExitCode::failure);
    } catch (const std::exception& error) {
        return fail(tool.name, error.what(), ExitCode::failure);
    }
}

} // namespace polymesh::tools
