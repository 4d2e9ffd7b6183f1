// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/runAll.h"

#include "libpolymesh/base/parallel.h"

#include <atomic>
#include <cstddef>
#include <exception>
#include <vector>

namespace polymesh::foam {

void runAll(std::span<const std::function<void()>> tasks) {
    std::vector<std::exception_ptr> failures(tasks.size());
    std::atomic<std::size_t> next{0}; // tasks begin in their order, whatever that of the blocks
    parallelBlocks(toLabel(tasks.size()), 1, [&](Label, Label, Label) {
        const std::size_t task = next++;
        try {
            tasks[task]();
        } catch (...) {
            failures[task] = std::current_exception();
        }
    });
    for (const std::exception_ptr& failure : failures)
        if (failure) std::rethrow_exception(failure);
}

} // namespace polymesh::foam
