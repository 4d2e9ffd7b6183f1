// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/ply/header.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace polymesh::ply {

namespace {

[[noreturn]] void failAt(const TextScanner& scanner, std::string_view what, std::string_view word) {
    scanner.fail(fmt::format("unknown {} '{}'", what, toPrintable(word)));
}

Encoding readEncoding(TextScanner& scanner) {
    const auto word = scanner.word();
    if (word == "ascii") return Encoding::text;
    if (word == "binary_little_endian") return Encoding::littleEndian;
    if (word == "binary_big_endian") return Encoding::bigEndian;
    failAt(scanner, "format", word);
}

Type toType(const TextScanner& scanner, std::string_view word) {
    constexpr std::array<std::pair<std::string_view, Type>, 16> names{{
        {"char", Type::int8},
        {"uchar", Type::uint8},
        {"short", Type::int16},
        {"ushort", Type::uint16},
        {"int", Type::int32},
        {"uint", Type::uint32},
        {"float", Type::float32},
        {"double", Type::float64},
        {"int8", Type::int8},
        {"uint8", Type::uint8},
        {"int16", Type::int16},
        {"uint16", Type::uint16},
        {"int32", Type::int32},
        {"uint32", Type::uint32},
        {"float32", Type::float32},
        {"float64", Type::float64},
    }};
    for (const auto& [name, type] : names)
        if (name == word) return type;
    failAt(scanner, "type", word);
}

Property readProperty(TextScanner& scanner) {
    Property property{};
    auto word = scanner.word();
    if (word == "list") {
        property.countType = toType(scanner, scanner.word());
        if (*property.countType >= Type::float32) scanner.fail("a list's count must be an integer");
        word = scanner.word();
    }
    property.type = toType(scanner, word);
    property.name = scanner.word();
    return property;
}

Element readElement(TextScanner& scanner) {
    Element element;
    element.name = scanner.word();
    element.count = scanner.integer();
    if (element.count < 0) scanner.fail(fmt::format("{} rows", element.count));
    return element;
}

} // namespace

Header readHeader(TextScanner& scanner) {
    if (const auto magic = scanner.word(); magic != "ply")
        scanner.fail(fmt::format("expected 'ply', found '{}'", toPrintable(magic)));
    Header header;
    while (scanner.findWord()) {
        const auto word = scanner.word();
        if (word == "format") {
            header.encoding = readEncoding(scanner);
        } else if (word == "element") {
            header.elements.push_back(readElement(scanner));
        } else if (word == "property") {
            if (header.elements.empty()) scanner.fail("a property before the first element");
            header.elements.back().properties.push_back(readProperty(scanner));
        } else if (word != "comment" && word != "obj_info" && word != "end_header") {
            failAt(scanner, "word", word);
        }
        scanner.restOfLine();
        if (word == "end_header") return header;
    }
    scanner.fail("the file ends within its header");
}

} // namespace polymesh::ply
