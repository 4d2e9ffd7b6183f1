// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Loops over all threads. Results never depend on the number of threads: loops write only what
// belongs to their element, and sums have a fixed order. The threads themselves are behind
// parallel.cpp, which a loop enters once a range of elements: half of the files of this project
// include this header, and those of oneTBB cost a compiler longer than the file itself.

#include "libpolymesh/base/label.h"

namespace polymesh {

/// Refers to a callable body(first, last), which has to outlive it.
class RangeBody {
public:
    template<class Body>
    explicit RangeBody(const Body& body)
        : body_(&body), call_([](const void* erased, Label first, Label last) {
              (*static_cast<const Body*>(erased))(first, last);
          }) {}

    void operator()(Label first, Label last) const { call_(body_, first, last); }

private:
    const void* body_;
    void (*call_)(const void* body, Label first, Label last);
};

/// Calls body for ranges that make up [0, count), in parallel: as large as leaves work for every
/// thread, and not below half of `grain`.
void runRanges(Label count, Label grain, RangeBody body);

/// Calls body(i, i + 1) for every i in [0, count), in parallel: each is a task of its own.
void runTasks(Label count, RangeBody body);

/// Calls body(i) for every i in [0, count), in parallel and in no particular order.
/// body(i) may read anything but write only what belongs to i.
template<class Body>
void parallelFor(Label count, Body&& body) {
    constexpr Label grain = 512;
    const auto range = [&](Label first, Label last) {
        for (Label i = first; i != last; ++i)
            body(i);
    };
    runRanges(count, grain, RangeBody(range));
}

/// Calls body(block, first, last) for consecutive blocks of `blockSize` elements of [0, count), in
/// parallel. Blocks are the same whatever the number of threads, so a body may fill a buffer per
/// block, to be joined in block order.
template<class Body>
void parallelBlocks(Label count, Label blockSize, Body&& body) {
    const auto task = [&](Label b, Label) {
        const Label first = b * blockSize;
        body(b, first, count - first < blockSize ? count : first + blockSize);
    };
    runTasks((count + blockSize - 1) / blockSize, RangeBody(task));
}

/// Reduces term(i) over [first, last) as parallelReduce does: halves, until they are short.
template<class T, class Term, class Combine>
T reduceRange(Label first, Label last, const T& identity, Term& term, Combine& combine) {
    constexpr Label grain = 4096; // fixed: the order of the operations depends on it alone
    if (last - first <= grain) {
        T value = identity;
        for (Label i = first; i != last; ++i)
            value = combine(value, term(i));
        return value;
    }
    const Label middle = first + (last - first) / 2;
    T low = identity;
    T high = identity;
    const auto half = [&](Label i, Label) {
        if (i == 0) {
            low = reduceRange(first, middle, identity, term, combine);
        } else {
            high = reduceRange(middle, last, identity, term, combine);
        }
    };
    runTasks(2, RangeBody(half));
    return combine(low, high);
}

/// Reduces term(i) over [0, count) with `combine`, which must be associative up to rounding; the
/// result does not depend on the number of threads.
template<class T, class Term, class Combine>
T parallelReduce(Label count, T identity, Term&& term, Combine&& combine) {
    return reduceRange(Label{0}, count, identity, term, combine);
}

/// Sums term(i) over [0, count); the result does not depend on the number of threads.
template<class T, class Term>
T parallelSum(Label count, T zero, Term&& term) {
    return parallelReduce(count, zero, term, [](T a, T b) { return a + b; });
}

} // namespace polymesh
