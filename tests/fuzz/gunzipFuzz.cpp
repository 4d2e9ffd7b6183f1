// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Any bytes as a gzip file: unpacked or refused, never more than deflate can have packed.

#include "formats/gunzip.h"
#include "libpolymesh/base/error.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view packed(reinterpret_cast<const char*>(data), size);
    try {
        if (polymesh::gunzip(packed, "fuzz.gz").size() > 1032 * size) std::abort();
    } catch (const polymesh::InputError&) {
    }
    return 0;
}
