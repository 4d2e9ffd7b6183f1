// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Any bytes are a mesh that keeps PolyMesh's laws, but that volumes may be negative, or an
// InputError.

#include "formats/star/fileTexts.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/mesh/validate.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace polymesh::fuzz {

/// The parts of a text between form feeds: vertices, cells, boundary, names, couples.
inline std::vector<std::string> partsOf(std::string_view text) {
    std::vector<std::string> parts(1);
    for (const char c : text)
        if (c == '\f' && parts.size() < 5)
            parts.emplace_back();
        else
            parts.back() += c;
    parts.resize(5);
    return parts;
}

inline void testStar(const std::uint8_t* data, std::size_t size, star::Version version) {
    const auto parts = partsOf({reinterpret_cast<const char*>(data), size});
    star::FileTexts texts{{"a.vrt", parts[0]}, {"a.cel", parts[1]}, {}, {}, {}};
    texts.boundary.emplace("a.bnd", parts[2]);
    if (parts[2].empty()) texts.boundary.reset();
    texts.names.emplace("a.inp", parts[3]);
    if (version == star::Version::v3) texts.couples.emplace("a.cpl", parts[4]);
    try {
        const star::StarMesh read = star::read(std::move(texts), version, 1);
        for (const Defect& defect : validate(read.mesh)) {
            const bool isInsideOut = defect.law == 1 && defect.message.starts_with("cell");
            if (isInsideOut) continue;
            fmt::print(stderr, "broken: {}\n", defect.message);
            std::abort();
        }
    } catch (const InputError&) { // as it should be
    }
}

} // namespace polymesh::fuzz
