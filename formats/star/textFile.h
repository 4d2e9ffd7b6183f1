// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace polymesh::star {

/// A STAR-CD file in memory.
struct TextFile {
    std::string name; // for messages
    std::string bytes;

    /// Reads the file. Throws InputError when that fails.
    explicit TextFile(const std::filesystem::path& path);

    TextFile(std::string fileName, std::string content)
        : name(std::move(fileName)), bytes(std::move(content)) {}

    /// Throws InputError "file:line: message", where the line is that of the byte `at`.
    [[noreturn]] void fail(std::size_t at, std::string_view message) const;
};

/// Walks through a file number by number; numbers are separated by blanks and line ends.
/// Everything that fails throws an InputError that names file and line.
class NumberReader {
public:
    /// `file` must outlive the reader, which begins at the byte `from`.
    NumberReader(const TextFile& file, std::size_t from)
        : file_(file),
          begin_(file.bytes.data()),
          here_(begin_ + from),
          end_(begin_ + file.bytes.size()) {}

    /// Goes to the next word, over line ends too; false at the end of the file.
    bool findWord() {
        while (here_ != end_ && isBlank(*here_))
            ++here_;
        return here_ != end_;
    }

    /// Goes to the next word of this line; false when the line has no more.
    bool findWordInLine() {
        while (here_ != end_ && isBlank(*here_) && *here_ != '\n')
            ++here_;
        return here_ != end_ && *here_ != '\n';
    }

    /// The next word, a whole number in [least, most]; `what` it is, for the message.
    Label label(const char* what, Label least, Label most) {
        findWord();
        Label value = 0;
        const auto [last, error] = std::from_chars(here_, end_, value);
        const bool isWord = last == end_ || isBlank(*last);
        if (error != std::errc{} || !isWord || value < least || value > most)
            failNumber(what, least, most);
        here_ = last;
        return value;
    }

    /// The next word of this line; empty when there is none.
    std::string_view wordInLine() {
        findWordInLine();
        const char* first = here_;
        while (here_ != end_ && !isBlank(*here_))
            ++here_;
        return {first, static_cast<std::size_t>(here_ - first)};
    }

    /// What is left of the line, without its end; goes to the next line.
    std::string_view restOfLine();

    /// The byte at which the reader is.
    std::size_t place() const { return static_cast<std::size_t>(here_ - begin_); }

    /// Throws InputError for the line at which the reader is.
    [[noreturn]] void fail(std::string_view message) const { file_.fail(place(), message); }

    static bool isBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

private:
    [[noreturn]] void failNumber(const char* what, Label least, Label most) const;

    const TextFile& file_;
    const char* begin_;
    const char* here_;
    const char* end_;
};

/// Where the records of a file begin. A file of version 4 begins with the line `header`
/// (PROSTAR_VERTEX, PROSTAR_CELL, PROSTAR_BOUNDARY) and a line of numbers, one of version 3 has
/// neither and is asked with an empty `header`. Throws InputError for another beginning.
std::size_t skipHeader(const TextFile& file, std::string_view header);

/// True when the text begins as files of version 4 do.
bool hasHeader(std::string_view text);

} // namespace polymesh::star
