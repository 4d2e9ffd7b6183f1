// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/geometry/vec3.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace polymesh {

/// Walks through a text held in memory, word by word. Words are separated by blanks and line ends.
/// Everything that fails throws an InputError that names the file and the line.
class TextScanner {
public:
    /// `text` must outlive the scanner.
    TextScanner(std::string_view text, std::string fileName)
        : here_(text.data()),
          begin_(text.data()),
          end_(text.data() + text.size()),
          fileName_(std::move(fileName)) {}

    /// Goes to the next word, over line ends too; false at the end of the text.
    bool findWord() {
        while (here_ != end_ && isBlank(*here_))
            ++here_;
        return here_ != end_;
    }

    /// Goes to the next word of this line; false when the line has no more.
    bool findWordInLine() {
        while (here_ != end_ && isBlank(*here_) && !isLineEnd(*here_))
            ++here_;
        return here_ != end_ && !isLineEnd(*here_);
    }

    /// The next word; empty at the end of the text.
    std::string_view word() {
        findWord();
        const char* first = here_;
        while (here_ != end_ && !isBlank(*here_))
            ++here_;
        return {first, static_cast<std::size_t>(here_ - first)};
    }

    /// What is left of the line, without blanks at its ends; goes to the next line.
    std::string_view restOfLine();

    /// The next word as a finite number, correctly rounded.
    double number();

    /// The next word as a whole number.
    std::int64_t integer();

    /// The next three words as a point.
    Vec3 point();

    /// Goes on if the next character is `c`.
    bool skip(char c) {
        const bool found = here_ != end_ && *here_ == c;
        here_ += found ? 1 : 0;
        return found;
    }

    /// True when the character here ends a word.
    bool isAtWordEnd() const { return here_ == end_ || isBlank(*here_); }

    char peek() const { return here_ == end_ ? '\0' : *here_; }

    /// The text from here on.
    std::string_view rest() const { return {here_, static_cast<std::size_t>(end_ - here_)}; }

    /// Throws InputError "file:line: message"; the line is that of the last word.
    [[noreturn]] void fail(std::string_view message) const;

private:
    static bool isBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

    static bool isLineEnd(char c) { return c == '\n' || c == '\r'; }

    std::string_view wordHere() const;

    const char* here_;
    const char* begin_;
    const char* end_;
    std::string fileName_;
};

/// True when the words are equal but for upper and lower case; `lower` is in lower case.
bool isSameWord(std::string_view word, std::string_view lower);

/// `text` for an error message: at most 40 characters, unprintable ones as '?'.
std::string toPrintable(std::string_view text);

} // namespace polymesh
