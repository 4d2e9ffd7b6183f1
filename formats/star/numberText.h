// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"

#include <array>
#include <charconv>
#include <string>

namespace polymesh::star {

/// Appends a number, with blanks before it up to `width`.
inline void appendLabel(std::string& text, Label number, std::size_t width = 0) {
    std::array<char, 24> digits{};
    const char* end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    const auto size = static_cast<std::size_t>(end - digits.data());
    if (size < width) text.append(width - size, ' ');
    text.append(digits.data(), size);
}

} // namespace polymesh::star
