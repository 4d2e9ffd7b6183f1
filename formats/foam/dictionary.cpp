// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/dictionary.h"

#include "libpolymesh/base/nearestWord.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polymesh::foam {
namespace {

constexpr std::size_t longestShown = 60; // of a value in a message [characters]

/// Appends the value as it might be written, until the text is long enough.
void describe(const Value& value, std::string& text) {
    if (text.size() > longestShown) return;
    switch (value.kind) {
    case Value::Kind::word:
    case Value::Kind::number:
        text += value.text;
        break;
    case Value::Kind::string:
        text += '"' + value.text + '"';
        break;
    case Value::Kind::dictionary:
        text += "{...}";
        break;
    case Value::Kind::list:
        text += '(';
        for (const Value& item : value.items) {
            if (&item != &value.items.front()) text += ' ';
            describe(item, text);
        }
        text += ')';
    }
}

std::string shortened(std::string text) {
    if (text.size() > longestShown) text = text.substr(0, longestShown) + "...";
    return text;
}

template<class T, class Convert>
std::vector<T> converted(const std::vector<Value>& values, Convert&& convert) {
    std::vector<T> result;
    result.reserve(values.size());
    for (const Value& value : values)
        result.push_back(convert(value));
    return result;
}

} // namespace

std::string Place::text() const {
    return fmt::format("{}:{}", file ? *file : std::string("?"), line);
}

void Value::fail(std::string_view key, std::string_view expected) const {
    std::string shown;
    describe(*this, shown);
    throw InputError(fmt::format(
        "{}: {}: found {}, expected {}", place.text(), key, shortened(std::move(shown)), expected));
}

std::string Value::word(std::string_view key) const {
    if (kind != Kind::word) fail(key, "a word");
    return text;
}

std::string Value::string(std::string_view key) const {
    if (kind != Kind::word && kind != Kind::string) fail(key, "a word or a \"string\"");
    return text;
}

double Value::scalar(std::string_view key) const {
    if (kind != Kind::number || !std::isfinite(number)) fail(key, "a number");
    return number;
}

Label Value::label(std::string_view key) const {
    constexpr double most = static_cast<double>(std::numeric_limits<std::int32_t>::max());
    const double value = scalar(key);
    if (value != std::floor(value) || std::abs(value) > most) fail(key, "an integer");
    return static_cast<Label>(value);
}

bool Value::flag(std::string_view key) const {
    for (const std::string_view yes : {"on", "yes", "true", "y", "t"})
        if (kind == Kind::word && text == yes) return true;
    for (const std::string_view no : {"off", "no", "false", "n", "f", "none"})
        if (kind == Kind::word && text == no) return false;
    fail(key, "on or off");
}

Vec3 Value::vector(std::string_view key) const {
    constexpr std::string_view expected = "three numbers (x y z)";
    if (kind != Kind::list || items.size() != 3) fail(key, expected);
    for (const Value& item : items)
        if (item.kind != Kind::number || !std::isfinite(item.number)) fail(key, expected);
    return {items[0].number, items[1].number, items[2].number};
}

const std::vector<Value>& Value::list(std::string_view key) const {
    if (kind != Kind::list) fail(key, "a list ( ... )");
    return items;
}

const Value& Entry::value() const {
    require(dictionary == nullptr,
            "{}: {}: found a dictionary {{...}}, expected a value",
            place.text(),
            key);
    require(!values.empty(), "{}: {}: there is no value", place.text(), key);
    require(values.size() == 1,
            "{}: {}: found {} values, expected one",
            place.text(),
            key,
            values.size());
    return values.front();
}

const Entry* Dictionary::find(std::string_view key) const {
    const auto found = std::ranges::find(entries_, key, &Entry::key);
    return found == entries_.end() ? nullptr : &*found;
}

std::string Dictionary::fullName(std::string_view key) const {
    return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

const Entry& Dictionary::entry(std::string_view key) const {
    const Entry* found = find(key);
    require(found != nullptr, "{}: {} is missing", place_.text(), fullName(key));
    return *found;
}

std::vector<std::string> Dictionary::words(std::string_view key) const {
    return converted<std::string>(list(key), [&](const Value& v) { return v.string(key); });
}

std::vector<Label> Dictionary::labels(std::string_view key) const {
    return converted<Label>(list(key), [&](const Value& v) { return v.label(key); });
}

std::vector<Vec3> Dictionary::vectors(std::string_view key) const {
    return converted<Vec3>(list(key), [&](const Value& v) { return v.vector(key); });
}

const Dictionary& Dictionary::dictionary(std::string_view key) const {
    const Entry& found = entry(key);
    require(found.dictionary != nullptr,
            "{}: {}: found a value, expected a dictionary {{...}}",
            found.place.text(),
            fullName(key));
    return *found.dictionary;
}

void Dictionary::add(Entry entry) {
    const auto found = std::ranges::find(entries_, entry.key, &Entry::key);
    if (found == entries_.end()) {
        entries_.push_back(std::move(entry));
        return;
    }
    if (found->dictionary && entry.dictionary) {
        auto merged = std::make_shared<Dictionary>(*found->dictionary);
        for (const Entry& inner : entry.dictionary->entries())
            merged->add(inner);
        entry.dictionary = std::move(merged);
        entry.earlier = std::move(found->earlier);
        entry.earlier.push_back(found->place);
    }
    *found = std::move(entry);
}

void Dictionary::remove(std::string_view key) {
    std::erase_if(entries_, [&](const Entry& entry) { return entry.key == key; });
}

void requireKnownKeys(const Dictionary& dictionary, std::initializer_list<std::string_view> known) {
    const std::vector<std::string> words(known.begin(), known.end());
    for (const Entry& entry : dictionary.entries()) {
        if (entry.key == "FoamFile" || std::ranges::find(known, entry.key) != known.end()) continue;
        const std::string nearest = nearestWord(entry.key, words);
        throw InputError(fmt::format("{}: unknown key '{}'{}",
                                     entry.place.text(),
                                     entry.key,
                                     nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
    }
}

std::vector<std::pair<std::string, const Dictionary*>> namedDictionaries(const Entry& entry) {
    std::vector<std::pair<std::string, const Dictionary*>> result;
    const std::vector<Value>& items = entry.value().list(entry.key);
    for (std::size_t i = 0; i < items.size(); i += 2) {
        const std::string name = items[i].string(entry.key);
        if (i + 1 == items.size() || items[i + 1].kind != Value::Kind::dictionary)
            items[i].fail(entry.key, "a name followed by {...}");
        result.emplace_back(name, items[i + 1].dictionary.get());
    }
    return result;
}

} // namespace polymesh::foam
