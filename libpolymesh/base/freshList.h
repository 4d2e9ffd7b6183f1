// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace polymesh {

/// Has the system back the pages of [begin, begin + bytes) now, by several threads. Never fails: a
/// system that cannot do it backs them as usual, at their first use.
void backPages(void* begin, std::size_t bytes);

/// A list of `count` copies of `value`. A long list in fresh memory costs some twenty times more
/// to get from the system, page by page, than to fill; the pages come in parallel here.
template<class T>
std::vector<T> freshList(std::size_t count, const T& value = T()) {
    std::vector<T> list;
    list.reserve(count);
    backPages(list.data(), count * sizeof(T));
    list.resize(count, value);
    return list;
}

} // namespace polymesh
