// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/textScanner.h"

#include "libpolymesh/base/error.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fast_float/fast_float.h>

namespace polymesh {

std::string_view TextScanner::restOfLine() {
    findWordInLine();
    const char* first = here_;
    while (here_ != end_ && !isLineEnd(*here_))
        ++here_;
    const char* last = here_;
    if (!(skip('\r') && skip('\n'))) skip('\n');
    while (last != first && isBlank(last[-1]))
        --last;
    return {first, static_cast<std::size_t>(last - first)};
}

double TextScanner::number() {
    if (!findWord()) fail("the file ends where a number should be");
    const char* first = here_ + (*here_ == '+' ? 1 : 0);
    double value = 0;
    const auto [last, error] = fast_float::from_chars(first, end_, value);
    const bool isNumber = last != first && (last == end_ || isBlank(*last));
    if (!isNumber) fail(fmt::format("expected a number, found '{}'", toPrintable(wordHere())));
    if (!std::isfinite(value))
        fail(fmt::format("expected a finite number, found '{}'", toPrintable(wordHere())));
    here_ = last;
    return value;
}

std::int64_t TextScanner::integer() {
    if (!findWord()) fail("the file ends where a whole number should be");
    const char* first = here_ + (*here_ == '+' ? 1 : 0);
    std::int64_t value = 0;
    const auto [last, error] = std::from_chars(first, end_, value);
    if (error != std::errc{})
        fail(fmt::format("expected a whole number, found '{}'", toPrintable(wordHere())));
    here_ = last;
    return value;
}

Vec3 TextScanner::point() {
    const double x = number();
    const double y = number();
    return {x, y, number()};
}

std::string_view TextScanner::wordHere() const {
    const char* last = here_;
    while (last != end_ && !isBlank(*last))
        ++last;
    return {here_, static_cast<std::size_t>(last - here_)};
}

void TextScanner::fail(std::string_view message) const {
    const auto line = 1 + std::count(begin_, here_, '\n');
    throw InputError(fmt::format("{}:{}: {}", fileName_, line, message));
}

bool isSameWord(std::string_view word, std::string_view lower) {
    const auto toLower = [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    };
    return std::ranges::equal(word, lower, {}, toLower);
}

std::string toPrintable(std::string_view text) {
    constexpr std::size_t longest = 40;
    std::string printable(text.substr(0, longest));
    for (char& c : printable)
        if (c < ' ' || c > '~') c = '?';
    return text.size() > longest ? printable + "..." : printable;
}

} // namespace polymesh
