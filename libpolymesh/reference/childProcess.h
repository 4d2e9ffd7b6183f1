// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"

#include <functional>
#include <optional>
#include <vector>

namespace polymesh {

/// Calls task(i) for i in [0, count) in a child process, so that a task which crashes, aborts or
/// exits takes nothing with it: its result is missing and a new child goes on with the next one.
/// A task that runs longer than `secondsEach` is ended likewise. What tasks print is dropped.
/// Result: one number per task; none where the task failed or returned NaN.
/// Throws WorkError when no process can be started.
/// Cost: one process in all, plus one per crash.
std::vector<std::optional<double>>
inChildProcess(Label count, unsigned secondsEach, const std::function<double(Label)>& task);

} // namespace polymesh
