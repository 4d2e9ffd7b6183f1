// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace polymesh {

/// The word among `known` that a misspelt `word` most likely meant: the smallest number of
/// inserted, removed, changed or swapped neighbouring letters, case ignored; the first of equals.
/// Empty when `known` is. Cost: the product of the lengths, for each known word.
std::string nearestWord(std::string_view word, std::span<const std::string> known);

} // namespace polymesh
