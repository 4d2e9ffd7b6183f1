// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/textFields.h"

#include <charconv>
#include <optional>

namespace polymesh::star {

namespace {

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && NumberReader::isBlank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && NumberReader::isBlank(text.back()))
        text.remove_suffix(1);
    return text;
}

bool parseFree(std::string_view line, std::span<Label> numbers, std::string_view& rest) {
    const char* here = line.data();
    const char* end = here + line.size();
    for (Label& number : numbers) {
        while (here != end && NumberReader::isBlank(*here))
            ++here;
        const auto [last, error] = std::from_chars(here, end, number);
        if (error != std::errc{} || (last != end && !NumberReader::isBlank(*last))) return false;
        here = last;
    }
    rest = {here, static_cast<std::size_t>(end - here)};
    return true;
}

bool parseColumns(std::string_view line,
                  std::span<const Field> columns,
                  std::span<Label> numbers,
                  std::string_view& rest) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (columns[i].first >= line.size()) return false;
        const std::string_view field = trimmed(line.substr(columns[i].first, columns[i].width));
        const char* end = field.data() + field.size();
        const auto [last, error] = std::from_chars(field.data(), end, numbers[i]);
        if (error != std::errc{} || last != end) return false;
    }
    rest = line.substr(std::min(line.size(), columns.back().first + columns.back().width));
    return true;
}

} // namespace

std::string_view lineAt(const TextFile& file, std::size_t at) {
    const std::string_view text = file.bytes;
    const auto before = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
    const std::size_t first = before == std::string_view::npos ? 0 : before + 1;
    return text.substr(first, text.find('\n', at) - first);
}

bool readNumbers(const TextFile& file,
                 NumberReader& reader,
                 std::span<const Field> columns,
                 std::span<Label> numbers,
                 std::string_view* rest) {
    const std::size_t place = reader.place();
    std::string_view behind;
    const bool isRead = parseFree(reader.restOfLine(), numbers, behind) ||
                        parseColumns(lineAt(file, place), columns, numbers, behind);
    if (rest != nullptr) *rest = trimmed(behind);
    return isRead;
}

} // namespace polymesh::star
