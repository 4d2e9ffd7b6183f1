// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/star/textFile.h"

#include <span>

namespace polymesh::star {

/// Where a number stands in a line of fixed columns.
struct Field {
    std::size_t first = 0;
    std::size_t width = 0;
};

/// Reads the next line of a file of version 3 into `numbers`, whole numbers, and goes on behind
/// it: divided by blanks, or, where large numbers touch, by the columns in which they stand. What
/// follows them in the line comes into `rest`. False when neither way gives numbers.
/// Requires: the reader is at the first word of the line.
bool readNumbers(const TextFile& file,
                 NumberReader& reader,
                 std::span<const Field> columns,
                 std::span<Label> numbers,
                 std::string_view* rest = nullptr);

/// The line in which the byte `at` is, from its beginning, without its end.
std::string_view lineAt(const TextFile& file, std::size_t at);

} // namespace polymesh::star
