// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/textScanner.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace polymesh::ply {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

enum class Encoding { text, littleEndian, bigEndian };

struct Property {
    std::string name;
    Type type;                     // of the value, or of a list's entries
    std::optional<Type> countType; // of lists only
};

/// Rows of a table: one value or list a property.
struct Element {
    std::string name;
    std::int64_t count = 0;
    std::vector<Property> properties;
};

struct Header {
    Encoding encoding = Encoding::text;
    std::vector<Element> elements;
};

/// Reads up to the line "end_header" and leaves the scanner at the first byte after it.
/// Throws InputError for unknown encodings, types and words, and for negative counts.
Header readHeader(TextScanner& scanner);

} // namespace polymesh::ply
