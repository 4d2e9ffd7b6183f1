// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The frame of every tool: options, dictionary, threads, report and exit status.

#include "formats/foam/caseDirectory.h"
#include "tools/options.h"
#include "tools/stageClock.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace polymesh::tools {

enum class ExitCode : std::uint8_t { success = 0, failure = 1, usage = 2 };

/// What a running tool is given, and what it leaves behind.
struct ToolRun {
    std::string name; // of the tool
    Settings settings;
    std::filesystem::path caseDir;
    /// The dictionary that was read; empty when there is none.
    std::filesystem::path dictionary;
    StageClock clock;
    /// Written to the file of -json at the end; runTool adds stages, wallSeconds, peakMemoryBytes.
    nlohmann::ordered_json report;
    bool quiet = false;
    bool reports = true; // whether this process writes the report: the first of several does

    /// The case, with the region that -region names.
    foam::CaseDirectory caseDirectory() const;

    /// constant/polyMesh of the case, or of the region that -region names.
    std::filesystem::path meshDir() const;

    /// How to write the mesh: as -format says, else as system/controlDict does, else binary.
    foam::WriteFormat writeFormat() const;

    /// `path` as it is when absolute or when it exists; else inside constant/triSurface of the
    /// case when it exists there, so that dictionaries may name a surface by its file name alone.
    std::filesystem::path surfaceFile(const std::string& path) const;

    /// Prints one line on stdout, unless -quiet.
    template<class... Args>
    void say(fmt::format_string<Args...> message, Args&&... args) const {
        if (!quiet) fmt::print("{}\n", fmt::format(message, std::forward<Args>(args)...));
    }

    /// Prints one line on stderr, also with -quiet.
    template<class... Args>
    void warn(fmt::format_string<Args...> message, Args&&... args) const {
        std::fflush(stdout); // lines come in the order in which they were said
        fmt::print(
            stderr, "{}: warning: {}\n", name, fmt::format(message, std::forward<Args>(args)...));
    }
};

/// The size of all files of a directory together [byte].
std::uintmax_t bytesIn(const std::filesystem::path& directory);

/// What makes one tool different from another.
struct Tool {
    std::string name;            // also names the dictionary system/<name>Dict
    std::string purpose;         // one sentence for -help
    std::vector<Option> options; // its own; all tools have the common ones
    std::function<ExitCode(ToolRun&)> run;
    /// Dictionary entries that are no options: the tool reads them itself.
    std::vector<std::string> dictionaryOnly = {};
    /// Options whose values may stand alone on the command line, in this order.
    std::vector<std::string> words = {};
    /// Whether a dictionary is in another language, which the tool reads itself.
    std::function<bool(const foam::Dictionary&)> isOwnDictionary = {};
};

/// The tool that a program is. Each program defines it; main.cpp, the same for all, runs it.
Tool thisTool();

/// Runs a tool and returns its exit status: reads the command line and the dictionary (an option
/// of the command line wins), calls its function, writes the report. InputError: status 2;
/// WorkError and anything else: status 1; in both cases one line "tool: message" on stderr.
int runTool(int argc, char** argv, const Tool& tool);

} // namespace polymesh::tools
