// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/textFile.h"

#include "formats/fileBytes.h"
#include "formats/textScanner.h"
#include "libpolymesh/base/error.h"

#include <algorithm>
#include <limits>

namespace polymesh::star {

namespace {

constexpr std::string_view headerStart = "PROSTAR_";

} // namespace

TextFile::TextFile(const std::filesystem::path& path)
    : name(path.string()), bytes(readBytes(path)) {}

void TextFile::fail(std::size_t at, std::string_view message) const {
    // A file without a line end at its end ends in its last line, and so does one that has it.
    const auto last = std::min(at, bytes.empty() ? 0 : bytes.size() - 1);
    const auto line = 1 + std::count(bytes.begin(), bytes.begin() + std::ptrdiff_t(last), '\n');
    throw InputError(fmt::format("{}:{}: {}", name, line, message));
}

std::string_view NumberReader::restOfLine() {
    const char* first = here_;
    while (here_ != end_ && *here_ != '\n')
        ++here_;
    const char* last = here_;
    if (here_ != end_) ++here_;
    return {first, static_cast<std::size_t>(last - first)};
}

void NumberReader::failNumber(const char* what, Label least, Label most) const {
    if (here_ == end_) fail(fmt::format("the file ends where {} should be", what));
    const char* last = std::find_if(here_, end_, isBlank);
    const std::string_view word(here_, static_cast<std::size_t>(last - here_));
    const std::string range = most == std::numeric_limits<Label>::max()
                                  ? fmt::format("a whole number from {} on", least)
                                  : fmt::format("a whole number in [{}, {}]", least, most);
    fail(fmt::format("{} '{}': expected {}", what, toPrintable(word), range));
}

bool hasHeader(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && text.substr(first).starts_with(headerStart);
}

std::size_t skipHeader(const TextFile& file, std::string_view header) {
    NumberReader reader(file, 0);
    const bool isVersion4 = hasHeader(file.bytes);
    if (header.empty()) {
        if (isVersion4) reader.fail("the header of version 4, where a file of version 3 has none");
        return 0;
    }
    reader.findWord();
    const std::string_view word = reader.wordInLine();
    if (word != header)
        file.fail(0, fmt::format("expected '{}', found '{}'", header, toPrintable(word)));
    reader.restOfLine();
    reader.label("the version", 4000, std::numeric_limits<Label>::max());
    reader.restOfLine();
    return reader.place();
}

} // namespace polymesh::star
