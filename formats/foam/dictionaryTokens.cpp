// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/dictionaryTokens.h"

#include <fast_float/fast_float.h>

namespace polymesh::foam {
namespace {

bool isBlank(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

bool isMacroLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '.' || c == ':' || c == '-' || c == '+' || c == '<' || c == '>' || c == '/';
}

bool endsWord(char c) {
    return isBlank(c) || c == '\0' || c == '"' || c == '\'' || c == ';' || c == '{' || c == '}' ||
           c == '[' || c == ']';
}

} // namespace

void DictionaryTokens::step() {
    if (*here_ == '\n') ++line_;
    ++here_;
}

void DictionaryTokens::skipBlanks() {
    while (!atEnd()) {
        if (isBlank(*here_)) {
            step();
        } else if (*here_ == '/' && (look(1) == '/' || look(1) == '*')) {
            skipComment();
        } else {
            return;
        }
    }
}

void DictionaryTokens::skipComment() {
    if (look(1) == '/') return skipLine();
    const Place start = place();
    here_ += 2;
    while (!(look() == '*' && look(1) == '/')) {
        if (atEnd()) throw InputError(start.text() + ": this comment has no end; a */ is missing");
        step();
    }
    here_ += 2;
}

void DictionaryTokens::skipLine() {
    while (!atEnd() && *here_ != '\n')
        ++here_;
}

void DictionaryTokens::skipDirective() {
    while (!atEnd() && *here_ != '\n' && *here_ != '}')
        ++here_;
}

void DictionaryTokens::skipEntry() {
    int depth = 0;
    while (true) {
        skipBlanks();
        const char c = look();
        if (atEnd() || (c == '}' && depth == 0)) return;
        if (c == '"') {
            readQuoted();
            continue;
        }
        if (c == '#' && look(1) == '{') {
            readVerbatim();
            continue;
        }
        ++here_;
        if (c == ';' && depth == 0) return;
        if (c == '{') ++depth;
        if (c == '}') --depth;
    }
}

Value DictionaryTokens::blank(Value::Kind kind) const {
    Value value;
    value.kind = kind;
    value.place = place();
    return value;
}

std::string DictionaryTokens::readName() {
    const char* start = here_;
    while (!endsWord(look()))
        ++here_;
    return {start, here_};
}

/// Moves past the characters of a word.
void DictionaryTokens::skipWord() {
    int depth = 0;
    const char* start = here_;
    const char* firstOpen = nullptr;
    for (; !endsWord(look()); ++here_) {
        if (*here_ == ')' && depth-- == 0) break;
        if (*here_ == '/' && (look(1) == '/' || look(1) == '*')) break;
        if (*here_ != '(') continue;
        if (firstOpen == nullptr) firstOpen = here_;
        ++depth;
    }
    if (depth > 0) here_ = firstOpen; // a list begins there
    if (here_ != start) return;
    if (atEnd()) fail("the file ends where something is expected");
    fail("'{}' is not expected here", *here_ >= ' ' && *here_ <= '~' ? *here_ : '?');
}

Value DictionaryTokens::readWordOrNumber() {
    Value value = blank(Value::Kind::word);
    const char* start = here_;
    skipWord();
    const char* number = *start == '+' ? start + 1 : start;
    const auto [stop, problem] = fast_float::from_chars(number, here_, value.number);
    const bool spelledOut = *number == 'n' || *number == 'i' || *number == 'N' || *number == 'I';
    if (problem == std::errc{} && !spelledOut && (stop == here_ || *stop == '(')) {
        value.kind = Value::Kind::number;
        here_ = stop;
    }
    value.text.assign(start, here_);
    return value;
}

std::string DictionaryTokens::readQuoted() {
    const Place start = place();
    std::string text;
    step();
    while (true) {
        if (atEnd()) throw InputError(start.text() + ": this string has no closing \"");
        if (look() == '"') break;
        if (look() == '\\' && look(1) == '"') ++here_;
        text += look();
        step();
    }
    ++here_;
    return text;
}

std::string DictionaryTokens::readBraced() {
    const Place start = place();
    std::string text;
    ++here_;
    for (int depth = 0; look() != '}' || depth > 0; step()) {
        if (atEnd()) throw InputError(start.text() + ": this { has no matching }");
        if (look() == '{') ++depth;
        if (look() == '}') --depth;
        text += look();
    }
    ++here_;
    return text;
}

std::string DictionaryTokens::readVerbatim() {
    const Place start = place();
    std::string text;
    here_ += 2;
    while (!(look() == '#' && look(1) == '}')) {
        if (atEnd()) throw InputError(start.text() + ": this #{ has no matching #}");
        text += look();
        step();
    }
    here_ += 2;
    return text;
}

/// Moves to the } that closes ${a${b}}.
void DictionaryTokens::skipNestedMacro() {
    for (int depth = 0; !atEnd() && look() != '\n' && !(look() == '}' && depth == 0); ++here_) {
        if (look() == '{') ++depth;
        if (look() == '}') --depth;
    }
}

std::optional<std::string_view> DictionaryTokens::readMacroName() {
    ++here_;
    const bool braced = look() == '{';
    if (braced) ++here_;
    const char* start = here_;
    while (isMacroLetter(look()))
        ++here_;
    const std::string_view name(start, static_cast<std::size_t>(here_ - start));
    const bool nested = braced && look() == '$';
    if (nested) skipNestedMacro();
    if (braced && look() != '}') fail("${{{}: a }} is missing", name);
    if (braced) ++here_;
    return nested ? std::nullopt : std::optional(name);
}

} // namespace polymesh::foam
