// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/foam/dictionary.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace polymesh::foam {

/// The dictionaries that are open while a file is read: what macros look into.
class DictionaryScopes {
public:
    /// What macros may copy in all: without a bound, a few lines multiply to more than any memory.
    static constexpr std::size_t mostCopied = 1'000'000;

    explicit DictionaryScopes(Dictionary& whole) : open_{&whole} {}

    Dictionary& innermost() { return *open_.back(); }

    void open(Dictionary& dictionary) { open_.push_back(&dictionary); }

    void close() { open_.pop_back(); }

    /// The entry that the macro $name means here: `key` and `key.inner` are looked for from the
    /// innermost dictionary outwards, `.key` in the innermost, `..key` in the one around it,
    /// `:key` in the whole file. Null when there is none.
    const Entry* find(std::string_view name) const;

    /// Counts the values that a copy of this entry adds. False when it is more than mostCopied in
    /// all.
    bool countCopy(const Entry& entry);

private:
    std::vector<Dictionary*> open_; // outermost first
    std::size_t copied_ = 0;
};

/// The text with $NAME and ${NAME} replaced by environment variables. Throws InputError, which
/// begins with `place`, when one is not set.
std::string expandEnvironment(const std::string& text, const Place& place);

} // namespace polymesh::foam
