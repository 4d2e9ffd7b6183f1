// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/obj/obj.h"
#include "tests/fuzz/surfaceFuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace polymesh;
    fuzz::testReader(fuzz::textOf(data, size), obj::read, obj::write);
    return 0;
}
