// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/off/off.h"

#include "formats/textScanner.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/surface/surfaceBuilder.h"

#include <iterator>
#include <vector>

namespace polymesh::off {

namespace {

void skipComments(TextScanner& scanner) {
    while (scanner.findWord() && scanner.peek() == '#')
        scanner.restOfLine();
}

void readMagic(TextScanner& scanner) {
    skipComments(scanner);
    const auto magic = scanner.word();
    const bool known = magic.ends_with("OFF") &&
                       magic.substr(0, magic.size() - 3).find_first_not_of("STCN") == magic.npos;
    if (!known) scanner.fail(fmt::format("expected 'OFF', found '{}'", toPrintable(magic)));
    scanner.findWordInLine();
    if (scanner.rest().starts_with("BINARY")) scanner.fail("binary OFF files are not supported");
}

std::int64_t readCount(TextScanner& scanner, std::string_view what) {
    skipComments(scanner);
    const std::int64_t count = scanner.integer();
    if (count < 0) scanner.fail(fmt::format("{} {}", count, what));
    return count;
}

Label readCorner(TextScanner& scanner, const std::vector<Label>& labels) {
    const std::int64_t number = scanner.integer();
    const auto count = static_cast<std::int64_t>(labels.size());
    if (number < 0 || number >= count)
        scanner.fail(fmt::format("a face has vertex {}, of 0 ... {}", number, count - 1));
    return labels[static_cast<std::size_t>(number)];
}

} // namespace

TriSurface read(std::string_view text, const std::string& fileName, std::string_view name) {
    TextScanner scanner(text, fileName);
    readMagic(scanner);
    const std::int64_t vertexCount = readCount(scanner, "vertices");
    const std::int64_t faceCount = readCount(scanner, "faces");
    scanner.restOfLine(); // the number of edges, which nobody needs

    SurfaceBuilder builder;
    const Label region = builder.addRegion("");
    std::vector<Label> labels; // of the file's vertices; grows with what is really there
    for (std::int64_t i = 0; i < vertexCount; ++i) {
        skipComments(scanner);
        labels.push_back(builder.addPoint(scanner.point()));
        scanner.restOfLine();
    }
    std::vector<Label> corners;
    for (std::int64_t i = 0; i < faceCount; ++i) {
        corners.clear();
        for (std::int64_t left = readCount(scanner, "corners"); left > 0; --left)
            corners.push_back(readCorner(scanner, labels));
        builder.addPolygon(corners, region);
        scanner.restOfLine();
    }
    TriSurface surface = builder.finish(name);
    require(!surface.triangles.empty(), "{}: the file has no triangles", fileName);
    return surface;
}

std::string write(const TriSurface& surface) {
    std::string text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "OFF\n{} {} 0\n", surface.pointCount(), surface.triangleCount());
    for (const Vec3& p : surface.points)
        fmt::format_to(out, "{} {} {}\n", p.x, p.y, p.z);
    for (const auto& corners : surface.triangles)
        fmt::format_to(out, "3 {} {} {}\n", corners[0], corners[1], corners[2]);
    return text;
}

} // namespace polymesh::off
