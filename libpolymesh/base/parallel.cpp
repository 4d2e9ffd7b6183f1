// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

namespace polymesh {

void runRanges(Label count, Label grain, RangeBody body) {
    tbb::parallel_for(tbb::blocked_range<Label>(0, count, index(grain)),
                      [&](const auto& range) { body(range.begin(), range.end()); });
}

void runTasks(Label count, RangeBody body) {
    tbb::parallel_for(
        tbb::blocked_range<Label>(0, count, 1),
        [&](const auto& range) { body(range.begin(), range.end()); },
        tbb::simple_partitioner{});
}

} // namespace polymesh
