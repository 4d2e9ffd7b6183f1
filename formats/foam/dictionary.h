// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/label.h"
#include "libpolymesh/geometry/vec3.h"

#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace polymesh::foam {

class Dictionary;

/// Where something stands in a file.
struct Place {
    std::shared_ptr<const std::string> file;
    int line = 0; // from 1

    /// "file:line"
    std::string text() const;
};

/// One thing in an entry: a word, a "string", a number, a (list) or a {dictionary}.
struct Value {
    enum class Kind { word, string, number, list, dictionary };
    Kind kind = Kind::word;
    std::string text;         // word and number as they are written, string without its quotes
    double number = 0;        // of a number
    std::vector<Value> items; // of a list
    std::shared_ptr<const Dictionary> dictionary;
    Place place;

    // The value as a type; `key` is named in the InputError "file:line: key: found .., expected
    // ..".
    std::string word(std::string_view key) const;
    std::string string(std::string_view key) const; // also a word
    double scalar(std::string_view key) const;      // finite
    Label label(std::string_view key) const;
    bool flag(std::string_view key) const; // on/off, yes/no, true/false
    Vec3 vector(std::string_view key) const;
    const std::vector<Value>& list(std::string_view key) const;

    /// Throws InputError "file:line: key: found .., expected .."
    [[noreturn]] void fail(std::string_view key, std::string_view expected) const;
};

/// `key value value ...;` or `key { ... }`. A value count that stands before a list is dropped.
struct Entry {
    std::string key;
    std::vector<Value> values;
    std::shared_ptr<const Dictionary> dictionary; // of `key { ... }`, else empty
    Place place;
    std::vector<Place> earlier; // of the dictionaries that were merged into this one

    /// The only value. Throws InputError when there are more or none.
    const Value& value() const;
};

/// An OpenFOAM dictionary: entries in the order of the file. An entry that comes again replaces the
/// earlier one; a dictionary that comes again is merged into the earlier one.
/// The getters throw InputError that names file, line and key when the entry is missing or is of
/// another type; those with a default give it when the entry is missing.
class Dictionary {
public:
    /// `path` is the name in its file, such as geometry.wing; empty for the file as a whole.
    Dictionary(Place place, std::string path) : place_(std::move(place)), path_(std::move(path)) {}

    const std::vector<Entry>& entries() const { return entries_; }

    const Place& place() const { return place_; }

    const std::string& path() const { return path_; }

    /// The entry, or null.
    const Entry* find(std::string_view key) const;

    bool has(std::string_view key) const { return find(key) != nullptr; }

    const Entry& entry(std::string_view key) const;

    std::string word(std::string_view key) const { return entry(key).value().word(key); }

    std::string string(std::string_view key) const { return entry(key).value().string(key); }

    double scalar(std::string_view key) const { return entry(key).value().scalar(key); }

    Label label(std::string_view key) const { return entry(key).value().label(key); }

    bool flag(std::string_view key) const { return entry(key).value().flag(key); }

    Vec3 vector(std::string_view key) const { return entry(key).value().vector(key); }

    const std::vector<Value>& list(std::string_view key) const {
        return entry(key).value().list(key);
    }

    std::vector<std::string> words(std::string_view key) const;
    std::vector<Label> labels(std::string_view key) const;
    std::vector<Vec3> vectors(std::string_view key) const;
    const Dictionary& dictionary(std::string_view key) const;

    std::string word(std::string_view key, std::string_view standard) const {
        return has(key) ? word(key) : std::string(standard);
    }

    std::string string(std::string_view key, std::string_view standard) const {
        return has(key) ? string(key) : std::string(standard);
    }

    double scalar(std::string_view key, double standard) const {
        return has(key) ? scalar(key) : standard;
    }

    Label label(std::string_view key, Label standard) const {
        return has(key) ? label(key) : standard;
    }

    bool flag(std::string_view key, bool standard) const { return has(key) ? flag(key) : standard; }

    Vec3 vector(std::string_view key, const Vec3& standard) const {
        return has(key) ? vector(key) : standard;
    }

    /// Adds an entry by the rules above.
    void add(Entry entry);
    void remove(std::string_view key);

private:
    std::string fullName(std::string_view key) const;

    Place place_;
    std::string path_;
    std::vector<Entry> entries_;
};

/// What to do with #codeStream and other directives that would need OpenFOAM itself.
enum class Directives {
    refuse, // InputError that names the directive
    skip    // as if the entry were not there: for files of which we need a few plain entries
};

/// Reads a dictionary file: nested dictionaries, lists, $macros ($key, ${key}, $..key, $:top.key),
/// #include (also inside a list), #includeIfPresent and #remove, #eval and #calc of arithmetic
/// (expression.h), comments, "strings" and #{ verbatim text #}.
/// Throws InputError with file and line.
Dictionary readDictionary(const std::filesystem::path& path,
                          Directives directives = Directives::refuse);

/// The same from memory; `name` is used in messages and as the place that #include starts from.
Dictionary parseDictionary(std::string_view text,
                           const std::string& name,
                           Directives directives = Directives::refuse);

/// Throws InputError for the first key that is not known (FoamFile apart), naming the nearest one.
void requireKnownKeys(const Dictionary& dictionary, std::initializer_list<std::string_view> known);

/// The dictionaries of a list `( name { ... } name { ... } )`, in order.
std::vector<std::pair<std::string, const Dictionary*>> namedDictionaries(const Entry& entry);

} // namespace polymesh::foam
