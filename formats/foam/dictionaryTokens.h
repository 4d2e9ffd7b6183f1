// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/foam/dictionary.h"

#include <fmt/format.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace polymesh::foam {

/// The text of a dictionary and how far it has been read: blanks, words, numbers and strings.
/// All functions throw InputError with file and line. The text must outlive the object.
class DictionaryTokens {
public:
    DictionaryTokens(std::string_view text, const std::string& name)
        : here_(text.data()),
          end_(text.data() + text.size()),
          file_(std::make_shared<const std::string>(name)) {}

    Place place() const { return {file_, line_}; }

    const std::string& fileName() const { return *file_; }

    /// The next character, or one further on; '\0' past the end.
    char look(std::ptrdiff_t ahead = 0) const { return end_ - here_ > ahead ? here_[ahead] : '\0'; }

    bool atEnd() const { return here_ == end_; }

    /// Moves past one character, which is not the end of a line.
    void skip() { ++here_; }

    /// Moves past blanks and comments.
    void skipBlanks();

    /// Moves to the end of the line, or to a } before it.
    void skipDirective();

    /// Moves past the rest of an entry that may have been left inside a list.
    void skipEntry();

    /// A value of this kind that stands here, still without content.
    Value blank(Value::Kind kind) const;

    /// Reads the name of a directive.
    std::string readName();

    /// Reads a word or a number. Parentheses belong to a word when they are balanced.
    Value readWordOrNumber();

    /// Reads "text".
    std::string readQuoted();

    /// Reads {text}, in which braces are balanced.
    std::string readBraced();

    /// Reads #{ text #}.
    std::string readVerbatim();

    /// Reads $name or ${name}; no name when it holds another macro, as in ${a${b}}.
    std::optional<std::string_view> readMacroName();

    template<class... Args>
    [[noreturn]] void fail(fmt::format_string<Args...> message, Args&&... args) const {
        throw InputError(place().text() + ": " + fmt::format(message, std::forward<Args>(args)...));
    }

private:
    void step();
    void skipComment();
    void skipLine();
    void skipWord();
    void skipNestedMacro();

    const char* here_;
    const char* end_;
    int line_ = 1;
    std::shared_ptr<const std::string> file_;
};

} // namespace polymesh::foam
