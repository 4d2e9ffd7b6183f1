// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/dictionaryScopes.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace polymesh::foam {
namespace {

/// The entry that a dotted name means, seen from `dictionary`; null when there is none.
const Entry* findDotted(const Dictionary& dictionary, std::string_view name) {
    if (const Entry* whole = dictionary.find(name)) return whole;
    const std::size_t dot = name.find('.');
    if (dot == std::string_view::npos) return nullptr;
    const Entry* outer = dictionary.find(name.substr(0, dot));
    if (outer == nullptr || !outer->dictionary) return nullptr;
    return findDotted(*outer->dictionary, name.substr(dot + 1));
}

std::size_t countEntries(const Dictionary& dictionary, std::size_t most);

/// The number of values in all, lists and dictionaries opened; stops counting above `most`.
std::size_t countValues(const std::vector<Value>& values, std::size_t most) {
    std::size_t count = 1;
    for (const Value& value : values) {
        if (count > most) break;
        count += countValues(value.items, most - count);
        if (value.dictionary && count <= most)
            count += countEntries(*value.dictionary, most - count);
    }
    return count;
}

std::size_t countEntries(const Dictionary& dictionary, std::size_t most) {
    std::size_t count = 1;
    for (const Entry& entry : dictionary.entries()) {
        if (count > most) break;
        count += countValues(entry.values, most - count);
        if (entry.dictionary && count <= most)
            count += countEntries(*entry.dictionary, most - count);
    }
    return count;
}

} // namespace

const Entry* DictionaryScopes::find(std::string_view name) const {
    if (name.starts_with(':')) return findDotted(*open_.front(), name.substr(1));
    const std::size_t dots = std::min(name.find_first_not_of('.'), name.size());
    if (dots > open_.size()) return nullptr;
    if (dots > 0) return findDotted(*open_[open_.size() - dots], name.substr(dots));
    for (std::size_t i = open_.size(); i-- > 0;)
        if (const Entry* found = findDotted(*open_[i], name)) return found;
    return nullptr;
}

bool DictionaryScopes::countCopy(const Entry& entry) {
    copied_ += countValues(entry.values, mostCopied);
    if (entry.dictionary) copied_ += countEntries(*entry.dictionary, mostCopied);
    return copied_ <= mostCopied;
}

std::string expandEnvironment(const std::string& text, const Place& place) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '$') {
            result += text[i];
            continue;
        }
        const bool braced = text.substr(i + 1, 1) == "{";
        std::size_t last = i + (braced ? 2 : 1);
        const std::size_t first = last;
        while (last < text.size() &&
               (std::isalnum(static_cast<unsigned char>(text[last])) != 0 || text[last] == '_'))
            ++last;
        const std::string variable = text.substr(first, last - first);
        const char* value = std::getenv(variable.c_str());
        require(value != nullptr, "{}: environment variable {} is not set", place.text(), variable);
        result += value;
        i = braced ? last : last - 1;
    }
    return result;
}

} // namespace polymesh::foam
