// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/toolMain.h"

#include "formats/fileBytes.h"
#include "formats/foam/dictionary.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/base/threadLimit.h"

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

fs::path existingCase(const Settings& settings) {
    fs::path dir = settings.text("case", ".");
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
    if (!tool.settings.has("json") || !tool.reports) return;
    tool.report["tool"] = name;
    tool.report["stages"] = stagesOf(tool.clock);
    tool.report["wallSeconds"] = tool.clock.seconds();
    tool.report["peakMemoryBytes"] = peakMemoryBytes();
    writeBytes(tool.settings.text("json"), tool.report.dump(2) + "\n");
}

/// The dictionary of the tool: the one that -dict names, seen from here or from the case, else
/// system/<tool>Dict when it is there, else none (an empty path).
fs::path dictionaryOf(const ToolRun& tool, const std::string& name) {
    const fs::path usual = tool.caseDirectory().system(name + "Dict");
    if (!tool.settings.has("dict")) return fs::is_regular_file(usual) ? usual : fs::path();
    fs::path given = tool.settings.text("dict");
    if (fs::is_regular_file(given)) return given;
    fs::path inCase = tool.caseDir / given;
    require(fs::is_regular_file(inCase),
            "{}: {}: no such file",
            tool.settings.place("dict"),
            given.string());
    return inCase;
}

ToolRun prepare(const Tool& tool, Settings settings) {
    const bool quiet = settings.isOn("quiet");
    const bool progress = !quiet && !settings.isOn("noProgress") && isatty(STDERR_FILENO) == 1;
    fs::path dir = existingCase(settings);
    ToolRun toolRun{.name = tool.name,
                    .settings = std::move(settings),
                    .caseDir = std::move(dir),
                    .dictionary = {},
                    .clock = StageClock(progress ? tool.name : ""),
                    .report = nlohmann::ordered_json::object(),
                    .quiet = quiet};
    toolRun.dictionary = dictionaryOf(toolRun, tool.name);
    if (toolRun.dictionary.empty()) return toolRun;
    const foam::Dictionary dictionary = foam::readDictionary(toolRun.dictionary);
    if (!tool.isOwnDictionary || !tool.isOwnDictionary(dictionary))
        addDictionary(toolRun.settings, dictionary, tool.dictionaryOnly);
    return toolRun;
}

ExitCode runWith(const Tool& tool, Settings settings) {
    if (settings.isOn("help")) {
        fmt::print("{}", helpText(tool.name, tool.purpose, settings));
        return ExitCode::success;
    }
    std::optional<ThreadLimit> limit;
    if (settings.has("threads"))
        limit.emplace(static_cast<std::size_t>(settings.integer("threads", 1, mostThreads)));
    ToolRun toolRun = prepare(tool, std::move(settings));
    const ExitCode code = tool.run(toolRun);
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
    return caseDirectory().polyMesh();
}

fs::path ToolRun::surfaceFile(const std::string& path) const {
    if (fs::exists(path)) return path;
    const fs::path inCase = caseDirectory().triSurface() / path;
    return fs::exists(inCase) ? inCase : fs::path(path);
}

foam::CaseDirectory ToolRun::caseDirectory() const {
    return {caseDir, settings.text("region", "")};
}

foam::WriteFormat ToolRun::writeFormat() const {
    std::optional<std::string> option;
    if (settings.has("format"))
        option = settings.word("format", {"ascii", "binary", "ascii.gz", "binary.gz"}, "");
    return foam::writeFormat(caseDirectory(), option);
}

std::uintmax_t bytesIn(const fs::path& directory) {
    std::uintmax_t bytes = 0;
    for (const auto& entry : fs::directory_iterator(directory))
        if (entry.is_regular_file()) bytes += entry.file_size();
    return bytes;
}

int runTool(int argc, char** argv, const Tool& tool) {
    try {
        Settings settings = settingsOf(tool.options);
        addCommandLine(settings, std::vector<std::string>(argv + 1, argv + argc), tool.words);
        const ExitCode code = runWith(tool, std::move(settings));
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
