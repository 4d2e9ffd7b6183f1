// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/stl/stl.h"

#include "formats/textScanner.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/surface/regions.h"
#include "libpolymesh/surface/surfaceBuilder.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <map>

namespace polymesh::stl {

namespace {

// Layout of a binary file, little-endian: 80 bytes of comment, the number of triangles, and for
// each triangle normal and corners as 12 floats and a 16-bit attribute.
constexpr std::size_t countOffset = 80;
constexpr std::size_t headerSize = 84;
constexpr std::size_t triangleSize = 50;
constexpr std::size_t cornersOffset = 12;
constexpr std::size_t attributeOffset = 48;

static_assert(std::endian::native == std::endian::little, "binary STL is read by plain copying");

template<class T>
T load(const char* from) {
    T value;
    std::memcpy(&value, from, sizeof value);
    return value;
}

std::size_t announcedSize(std::string_view bytes) {
    return headerSize + triangleSize * std::size_t{load<std::uint32_t>(bytes.data() + countOffset)};
}

std::uint16_t attributeAt(std::string_view bytes, std::size_t triangleAt) {
    return load<std::uint16_t>(bytes.data() + triangleAt + attributeOffset);
}

bool hasZones(std::string_view bytes) {
    for (std::size_t at = headerSize; at < bytes.size(); at += triangleSize)
        if (attributeAt(bytes, at) != attributeAt(bytes, headerSize)) return true;
    return false;
}

Vec3 loadPoint(std::string_view bytes, std::size_t at, const std::string& fileName) {
    const char* from = bytes.data() + at;
    const Vec3 point{load<float>(from), load<float>(from + 4), load<float>(from + 8)};
    require(isFinite(point),
            "{}: at byte {}: ({} {} {}) is not a point",
            fileName,
            at,
            point.x,
            point.y,
            point.z);
    return point;
}

void readBinary(std::string_view bytes, const std::string& fileName, SurfaceBuilder& builder) {
    const bool zones = hasZones(bytes);
    std::map<std::uint16_t, Label> regions; // of attributes
    for (std::size_t at = headerSize; at < bytes.size(); at += triangleSize) {
        std::array<Label, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = builder.addPoint(loadPoint(bytes, at + cornersOffset + 12 * i, fileName));
        const auto [region, isNew] = regions.try_emplace(attributeAt(bytes, at));
        if (isNew)
            region->second =
                builder.addRegion(zones ? fmt::format("zone{}", regions.size() - 1) : "");
        builder.addPolygon(corners, region->second);
    }
}

void expectWord(TextScanner& scanner, std::string_view expected) {
    const auto word = scanner.word();
    if (isSameWord(word, expected)) return;
    if (word.empty()) scanner.fail(fmt::format("the file ends where '{}' should be", expected));
    scanner.fail(fmt::format("expected '{}', found '{}'", expected, toPrintable(word)));
}

/// What follows the word "facet", to "endfacet".
void readFacet(TextScanner& scanner, SurfaceBuilder& builder, Label region) {
    // The normal is computed from the corners wherever it is needed: it may be anything here.
    for (auto word = scanner.word(); !isSameWord(word, "outer"); word = scanner.word())
        if (word.empty()) scanner.fail("the file ends where 'outer loop' should be");
    expectWord(scanner, "loop");
    std::array<Label, 3> corners{};
    for (Label& corner : corners) {
        expectWord(scanner, "vertex");
        corner = builder.addPoint(scanner.point());
    }
    expectWord(scanner, "endloop");
    expectWord(scanner, "endfacet");
    builder.addPolygon(corners, region);
}

void readText(TextScanner& scanner, SurfaceBuilder& builder) {
    Label region = -1;
    while (scanner.findWord()) {
        const auto word = scanner.word();
        if (isSameWord(word, "facet") && region >= 0) {
            readFacet(scanner, builder, region);
        } else if (isSameWord(word, "solid")) {
            region = builder.addRegion(scanner.restOfLine());
        } else if (isSameWord(word, "endsolid")) {
            scanner.restOfLine();
            region = -1;
        } else {
            scanner.fail(fmt::format("expected '{}', found '{}'",
                                     region < 0 ? "solid" : "facet' or 'endsolid",
                                     toPrintable(word)));
        }
    }
    if (region >= 0) scanner.fail("the file ends without 'endsolid': is it cut short?");
}

bool isText(std::string_view bytes) {
    const auto first = bytes.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && isSameWord(bytes.substr(first, 5), "solid");
}

Vec3 normalOf(const TriSurface& surface, Label t) {
    const Vec3& a = surface.corner(t, 0);
    const Vec3 normal = cross(surface.corner(t, 1) - a, surface.corner(t, 2) - a);
    const double length = norm(normal);
    return length > 0 ? normal / length : Vec3{};
}

void writeFacet(const TriSurface& surface, Label t, std::back_insert_iterator<std::string> out) {
    const Vec3 n = normalOf(surface, t);
    fmt::format_to(out, "facet normal {:.6g} {:.6g} {:.6g}\nouter loop\n", n.x, n.y, n.z);
    for (int i = 0; i < 3; ++i) {
        const Vec3& p = surface.corner(t, i);
        fmt::format_to(out, "vertex {} {} {}\n", p.x, p.y, p.z);
    }
    fmt::format_to(out, "endloop\nendfacet\n");
}

void appendFloats(std::string& bytes, const Vec3& p) {
    const std::array<float, 3> values{
        static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    bytes.append(reinterpret_cast<const char*>(values.data()), sizeof values);
}

} // namespace

TriSurface read(std::string_view bytes, const std::string& fileName, std::string_view name) {
    SurfaceBuilder builder;
    const bool hasCount = bytes.size() >= headerSize;
    if (hasCount && announcedSize(bytes) == bytes.size()) {
        readBinary(bytes, fileName, builder);
    } else if (isText(bytes)) {
        TextScanner scanner(bytes, fileName);
        readText(scanner, builder);
    } else {
        require(!bytes.empty(), "{}: the file is empty", fileName);
        require(hasCount, "{}: neither a text ('solid ...') nor a binary STL file", fileName);
        throw InputError(
            fmt::format("{}: at byte {}: the header promises {} bytes, the file has {}: "
                        "cut short, or not an STL file",
                        fileName,
                        countOffset,
                        announcedSize(bytes),
                        bytes.size()));
    }
    TriSurface surface = builder.finish(name);
    require(!surface.triangles.empty(), "{}: the file has no triangles", fileName);
    return surface;
}

std::string writeText(const TriSurface& surface) {
    std::string text;
    const auto out = std::back_inserter(text);
    const Rows<Label> triangles = trianglesOfRegions(surface);
    for (Label region = 0; region < triangles.size(); ++region) {
        const auto& name = surface.regionNames[index(region)];
        fmt::format_to(out, "solid {}\n", name);
        for (Label t : triangles[region])
            writeFacet(surface, t, out);
        fmt::format_to(out, "endsolid {}\n", name);
    }
    return text;
}

std::string writeBinary(const TriSurface& surface) {
    std::string bytes = "binary STL, one attribute a region";
    bytes.resize(countOffset, ' ');
    const auto count = static_cast<std::uint32_t>(surface.triangleCount());
    bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
    for (Label t = 0; t < surface.triangleCount(); ++t) {
        appendFloats(bytes, normalOf(surface, t));
        for (int i = 0; i < 3; ++i)
            appendFloats(bytes, surface.corner(t, i));
        const auto attribute = static_cast<std::uint16_t>(surface.region[index(t)]);
        bytes.append(reinterpret_cast<const char*>(&attribute), sizeof attribute);
    }
    return bytes;
}

} // namespace polymesh::stl
