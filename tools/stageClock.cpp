// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/stageClock.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <sys/resource.h>

namespace polymesh::tools {

namespace {

double secondsBetween(StageClock::Clock::time_point a, StageClock::Clock::time_point b) {
    return std::chrono::duration<double>(b - a).count();
}

} // namespace

StageClock::StageClock(std::string progress) : progress_(std::move(progress)) {}

void StageClock::start(const std::string& name) {
    stop();
    const auto same = [&](const Stage& stage) { return stage.name == name; };
    const auto found = std::find_if(stages_.begin(), stages_.end(), same);
    running_ = static_cast<int>(found - stages_.begin());
    if (found == stages_.end()) stages_.push_back({name, 0});
    stageBegin_ = Clock::now();
    if (!progress_.empty()) fmt::print(stderr, "\r\033[K{}: {} ...", progress_, name);
}

void StageClock::stop() {
    if (running_ < 0) return;
    stages_[static_cast<std::size_t>(running_)].seconds +=
        secondsBetween(stageBegin_, Clock::now());
    running_ = -1;
    if (!progress_.empty()) fmt::print(stderr, "\r\033[K");
}

double StageClock::seconds() const {
    return secondsBetween(begin_, Clock::now());
}

std::int64_t peakMemoryBytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return std::int64_t{usage.ru_maxrss} * 1024; // Linux counts in KiB
}

} // namespace polymesh::tools
