// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/starFuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    polymesh::fuzz::testStar(data, size, polymesh::star::Version::v4);
    return 0;
}
