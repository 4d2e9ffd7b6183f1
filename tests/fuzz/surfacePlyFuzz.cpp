// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/ply/ply.h"
#include "tests/fuzz/surfaceFuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace polymesh;
    fuzz::testReader(fuzz::textOf(data, size), ply::read, ply::write);
    return 0;
}
