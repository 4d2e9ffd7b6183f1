// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace polymesh::tools {

/// One step of a tool's work.
struct Stage {
    std::string name;
    double seconds = 0;
};

/// Times the stages of a run, one after the other, and shows the running one on a terminal.
class StageClock {
public:
    using Clock = std::chrono::steady_clock;

    /// `progress`: prefix of the progress line on stderr; empty: show none.
    explicit StageClock(std::string progress = {});

    /// Ends the running stage, if any, and starts the next. A name that came before is continued.
    void start(const std::string& name);

    /// Ends the running stage.
    void stop();

    const std::vector<Stage>& stages() const { return stages_; }

    /// Wall-clock time since construction [s].
    double seconds() const;

private:
    std::string progress_;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point stageBegin_ = begin_;
    std::vector<Stage> stages_;
    int running_ = -1;
};

/// The largest memory that this process has held [byte].
std::int64_t peakMemoryBytes();

} // namespace polymesh::tools
