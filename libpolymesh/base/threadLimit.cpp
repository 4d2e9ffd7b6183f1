// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/threadLimit.h"

#include <tbb/global_control.h>

namespace polymesh {

struct ThreadLimit::Control {
    explicit Control(std::size_t threadCount)
        : limit(tbb::global_control::max_allowed_parallelism, threadCount) {}

    tbb::global_control limit;
};

ThreadLimit::ThreadLimit(std::size_t threadCount)
    : control_(std::make_unique<Control>(threadCount)) {}

ThreadLimit::~ThreadLimit() = default;

} // namespace polymesh
