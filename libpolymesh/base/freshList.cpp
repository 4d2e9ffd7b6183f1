// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/freshList.h"

#include "libpolymesh/base/parallel.h"

#include <algorithm>
#include <cstdint>
#include <sys/mman.h>

namespace polymesh {

void backPages(void* begin, std::size_t bytes) {
#ifdef MADV_POPULATE_WRITE
    constexpr std::size_t pageSize = 4096; // a multiple of it is refused, and left, where it is not
    constexpr std::size_t chunk = 512 * pageSize;
    if (bytes < 4 * chunk) return;
    const auto first = reinterpret_cast<std::uintptr_t>(begin);
    const std::size_t skipped = (pageSize - first % pageSize) % pageSize;
    const std::size_t end = skipped + (bytes - skipped) / pageSize * pageSize;
    char* const base = static_cast<char*>(begin);
    madvise(base + skipped, end - skipped, MADV_HUGEPAGE); // where the system has them
    parallelBlocks(toLabel((end - skipped + chunk - 1) / chunk), 1, [&](Label i, Label, Label) {
        const std::size_t from = skipped + index(i) * chunk;
        madvise(base + from, std::min(chunk, end - from), MADV_POPULATE_WRITE);
    });
#else
    static_cast<void>(begin);
    static_cast<void>(bytes);
#endif
}

} // namespace polymesh
