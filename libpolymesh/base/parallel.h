// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The only file that includes oneTBB. Results never depend on the number of threads: loops write
// only what belongs to their element, and sums have a fixed order.

#include "libpolymesh/base/label.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <tbb/parallel_sort.h>
#include <tbb/partitioner.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace polymesh {

/// Limits the number of threads of all parallel loops for the lifetime of the object.
class ThreadLimit {
public:
    explicit ThreadLimit(std::size_t threadCount)
        : control_(tbb::global_control::max_allowed_parallelism, threadCount) {}

private:
    tbb::global_control control_;
};

/// Calls body(i) for every i in [0, count), in parallel and in no particular order.
/// body(i) may read anything but write only what belongs to i.
template<class Body>
void parallelFor(Label count, Body&& body) {
    constexpr Label grain = 512;
    tbb::parallel_for(tbb::blocked_range<Label>(0, count, grain), [&](const auto& range) {
        for (Label i = range.begin(); i != range.end(); ++i)
            body(i);
    });
}

/// Calls body(block, first, last) for consecutive blocks of `blockSize` elements of [0, count), in
/// parallel. Blocks are the same whatever the number of threads, so a body may fill a buffer per
/// block, to be joined in block order.
template<class Body>
void parallelBlocks(Label count, Label blockSize, Body&& body) {
    const Label blocks = (count + blockSize - 1) / blockSize;
    tbb::parallel_for(
        tbb::blocked_range<Label>(0, blocks, 1),
        [&](const auto& range) {
            for (Label b = range.begin(); b != range.end(); ++b)
                body(b, b * blockSize, std::min(count, (b + 1) * blockSize));
        },
        tbb::simple_partitioner{});
}

/// Reduces term(i) over [0, count) with `combine`, which must be associative up to rounding; the
/// result does not depend on the number of threads.
template<class T, class Term, class Combine>
T parallelReduce(Label count, T identity, Term&& term, Combine&& combine) {
    constexpr Label grain = 4096; // fixed: the order of the operations depends on it alone
    return tbb::parallel_deterministic_reduce(
        tbb::blocked_range<Label>(0, count, grain),
        identity,
        [&](const tbb::blocked_range<Label>& range, T value) {
            for (Label i = range.begin(); i != range.end(); ++i)
                value = combine(value, term(i));
            return value;
        },
        combine,
        tbb::simple_partitioner{});
}

/// Sorts values, no two of which may be equal: else their order would depend on the threads.
template<class T>
void parallelSort(std::vector<T>& values) {
    tbb::parallel_sort(values.begin(), values.end());
}

/// Sums term(i) over [0, count); the result does not depend on the number of threads.
template<class T, class Term>
T parallelSum(Label count, T zero, Term&& term) {
    return parallelReduce(count, zero, term, [](T a, T b) { return a + b; });
}

} // namespace polymesh
