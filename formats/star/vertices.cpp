// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/vertices.h"

#include "formats/star/numberText.h"
#include "formats/star/textFields.h"
#include "formats/textScanner.h"
#include "libpolymesh/base/error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fast_float/fast_float.h>
#include <optional>

namespace polymesh::star {

namespace {

constexpr std::size_t numberColumns = 15;
constexpr std::size_t coordinateColumns = 16;
constexpr int leastDigits = 9;
constexpr int mostDigits = 14; // that fit between blanks, beside the decimal point

struct Vertex {
    Label number = 0;
    std::array<double, 3> coordinates{};
};

bool isBlank(char c) {
    return NumberReader::isBlank(c);
}

const char* skipBlanks(const char* here, const char* end) {
    while (here != end && isBlank(*here))
        ++here;
    return here;
}

/// A number as Fortran may write it, with blanks round it: 1.5D-03, 1.5-103.
std::optional<double> parseFortran(std::string_view field) {
    std::string text;
    for (const char c : field) {
        const bool isExponent = c == 'D' || c == 'd' || c == 'E' || c == 'e';
        const bool isBareSign = (c == '-' || c == '+') && !text.empty() && text.back() != 'e';
        if (isBareSign) text += 'e';
        if (!isBlank(c) && !(c == '+' && text.empty())) text += isExponent ? 'e' : c;
    }
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [last, error] = fast_float::from_chars(text.data(), end, value);
    if (text.empty() || error != std::errc{} || last != end) return {};
    return value;
}

/// Words one after the other.
std::optional<Vertex> parseFree(std::string_view line) {
    const char* end = line.data() + line.size();
    Vertex vertex;
    const auto number = std::from_chars(skipBlanks(line.data(), end), end, vertex.number);
    if (number.ec != std::errc{} || number.ptr == end || !isBlank(*number.ptr)) return {};
    const char* here = number.ptr;
    for (double& x : vertex.coordinates) {
        here = skipBlanks(here, end);
        if (here != end && *here == '+') ++here;
        const auto [last, error] = fast_float::from_chars(here, end, x);
        if (last != end && (*last == 'D' || *last == 'd')) {
            const char* wordEnd = std::find_if(here, end, isBlank);
            const auto value = parseFortran({here, static_cast<std::size_t>(wordEnd - here)});
            if (!value) return {};
            x = *value;
            here = wordEnd;
            continue;
        }
        const bool isEnd = last == end || isBlank(*last) || *last == '-' || *last == '+';
        if (error != std::errc{} || !isEnd) return {};
        here = last;
    }
    if (here != end && !isBlank(*here)) return {}; // a fourth number that touches the third
    return vertex;
}

std::optional<Vertex> parseColumns(std::string_view line) {
    if (line.size() <= numberColumns + 2 * coordinateColumns) return {};
    const std::string_view first = line.substr(0, numberColumns);
    Vertex vertex;
    const char* end = first.data() + first.size();
    const auto number = std::from_chars(skipBlanks(first.data(), end), end, vertex.number);
    if (number.ec != std::errc{} || skipBlanks(number.ptr, end) != end) return {};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto field = line.substr(numberColumns + i * coordinateColumns, coordinateColumns);
        const std::optional<double> x = parseFortran(field);
        if (!x) return {};
        vertex.coordinates[i] = *x;
    }
    return vertex;
}

bool isUsable(const Vertex& vertex) {
    const auto& [x, y, z] = vertex.coordinates;
    return vertex.number > 0 && std::isfinite(x) && std::isfinite(y) && std::isfinite(z);
}

} // namespace

Vertices readVertices(const TextFile& file, Version version, double scale) {
    NumberReader reader(file, skipHeader(file, version == Version::v4 ? "PROSTAR_VERTEX" : ""));
    std::vector<Vec3> points;
    std::vector<Label> numbers;
    std::vector<std::size_t> places;
    constexpr std::size_t usualLine = 40; // bytes
    points.reserve(file.bytes.size() / usualLine);
    numbers.reserve(points.capacity());
    places.reserve(points.capacity());
    while (reader.findWord()) {
        const std::size_t place = reader.place();
        const std::string_view rest = reader.restOfLine();
        std::optional<Vertex> vertex = parseFree(rest);
        if (!vertex && version == Version::v3) vertex = parseColumns(lineAt(file, place));
        if (!vertex || !isUsable(*vertex))
            file.fail(place,
                      fmt::format("'{}': expected a positive vertex number and three coordinates",
                                  toPrintable(rest)));
        const auto& [x, y, z] = vertex->coordinates;
        points.push_back({x * scale, y * scale, z * scale});
        numbers.push_back(vertex->number);
        places.push_back(place);
    }
    Vertices vertices{file.name, std::move(points), NumberMap(numbers)};
    if (const auto repeated = vertices.numbers.repeated())
        file.fail(places[index(*repeated)],
                  fmt::format("vertex {} is there already", numbers[index(*repeated)]));
    return vertices;
}

namespace {

/// The digits of x with a decimal point, since Fortran puts one where there is none; as few as
/// give x back when `digits` is 0. Returns the end.
char* formatReal(char* first, char* last, double x, int digits) {
    char* end = digits == 0 ? std::to_chars(first, last, x).ptr
                            : std::to_chars(first, last, x, std::chars_format::general, digits).ptr;
    char* exponent = std::find(first, end, 'e');
    if (std::find(first, exponent, '.') != exponent) return end;
    std::copy_backward(exponent, end, end + 2);
    *exponent = '.';
    *(exponent + 1) = '0';
    return end + 2;
}

using Digits = std::array<char, 32>;

void appendFixed(std::string& text, double x) {
    constexpr std::size_t widest = coordinateColumns - 1; // a blank divides it from its neighbour
    Digits field{};
    std::string_view shown;
    const auto format = [&](int digits) {
        const char* end = formatReal(field.data(), field.data() + field.size(), x, digits);
        shown = {field.data(), static_cast<std::size_t>(end - field.data())};
    };
    format(0);
    for (int digits = mostDigits; shown.size() > widest && digits >= leastDigits; --digits)
        format(digits);
    text.append(coordinateColumns - std::min(coordinateColumns, shown.size()), ' ').append(shown);
}

} // namespace

void appendVertex(std::string& text, Version version, Label number, const Vec3& point) {
    if (version == Version::v3) {
        appendLabel(text, number, 9);
        text.append(numberColumns - 9, ' ');
        for (const double x : {point.x, point.y, point.z})
            appendFixed(text, x);
    } else {
        appendLabel(text, number);
        for (const double x : {point.x, point.y, point.z}) {
            Digits field{};
            const char* end = formatReal(field.data(), field.data() + field.size(), x, 0);
            text.append(1, ' ').append(field.data(), static_cast<std::size_t>(end - field.data()));
        }
    }
    text += '\n';
}

} // namespace polymesh::star
