// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tbb/parallel_sort.h>

#include <vector>

namespace polymesh {

/// Sorts values in parallel; no two may be equal: else their order would depend on the threads.
template<class T>
void parallelSort(std::vector<T>& values) {
    tbb::parallel_sort(values.begin(), values.end());
}

} // namespace polymesh
