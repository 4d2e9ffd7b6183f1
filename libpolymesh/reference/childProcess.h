// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"

#include <functional>
#include <optional>
#include <vector>

namespace polymesh {

/// What a child process is told, and what it tells.
using Numbers = std::vector<double>;

/// A child process that answers questions one at a time, so that a task which crashes, aborts or
/// exits takes nothing with it: its answer is missing and a new child takes the next question. A
/// task that runs longer than `secondsEach` is ended likewise. What tasks print is dropped.
/// Cost: one process, started with the first question, and one more after each crash.
class ChildWorker {
public:
    using Task = std::function<Numbers(const Numbers&)>;

    ChildWorker(unsigned secondsEach, Task task);
    ~ChildWorker();
    ChildWorker(const ChildWorker&) = delete;
    ChildWorker& operator=(const ChildWorker&) = delete;

    /// What the task makes of the question; none where it failed.
    /// Throws WorkError when no process can be started.
    std::optional<Numbers> ask(const Numbers& question);

private:
    void start();
    void stop();

    unsigned secondsEach_;
    Task task_;
    int socket_ = -1;
    int child_ = -1;
};

/// Calls task(i) for i in [0, count) in a child process.
/// Result: one number per task; none where the task failed or returned NaN.
/// Throws WorkError when no process can be started.
std::vector<std::optional<double>>
inChildProcess(Label count, unsigned secondsEach, const std::function<double(Label)>& task);

} // namespace polymesh
