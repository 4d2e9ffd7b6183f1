// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/foam/dictionary.h"

#include <functional>
#include <optional>
#include <string_view>

namespace polymesh::foam {

/// What $name stands for in an expression; nothing when it is no number.
using Variables = std::function<std::optional<double>(std::string_view name)>;

/// How whole numbers divide: 1/2 is 0.5, or, as in C++, 0.
enum class Division { exact, whole };

/// The value of an arithmetic expression: + - * / %, parentheses, $name, ${name}, the constants pi
/// and e, and functions of <cmath> such as sqrt, pow, sin, max, also degToRad and radToDeg.
/// Throws InputError, which begins with `place`, for anything else.
double evaluateExpression(std::string_view text,
                          const Variables& variables,
                          const Place& place,
                          Division division = Division::exact);

} // namespace polymesh::foam
