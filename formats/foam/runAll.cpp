// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/runAll.h"

#include "libpolymesh/base/parallel.h"

#include <exception>
#include <vector>

namespace polymesh::foam {

void runAll(std::span<const std::function<void()>> tasks) {
    std::vector<std::exception_ptr> failures(tasks.size());
    parallelBlocks(toLabel(tasks.size()), 1, [&](Label task, Label, Label) {
        try {
            tasks[index(task)]();
        } catch (...) {
            failures[index(task)] = std::current_exception();
        }
    });
    for (const std::exception_ptr& failure : failures)
        if (failure) std::rethrow_exception(failure);
}

} // namespace polymesh::foam
