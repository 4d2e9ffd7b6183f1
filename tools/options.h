// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a user asked of a tool, from the command line and from its dictionary.

#include "formats/foam/dictionary.h"
#include "libpolymesh/base/label.h"
#include "libpolymesh/geometry/vec3.h"

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace polymesh::tools {

/// One option of a tool, which is also an entry of its dictionary.
struct Option {
    std::string name;         // without the dash
    std::string value;        // what -help calls its value; empty: a switch
    std::string help;         // with units in brackets
    bool inDictionary = true; // may be an entry of the tool's dictionary
};

/// The options that every tool has: -case, -dict, -region, -format, -threads, -json, -quiet, ...
const std::vector<Option>& commonOptions();

/// -surface, which several tools have; `use`: what the tool does with it.
Option surfaceOption(const std::string& use);

/// The values that were given, each with the place it came from. The first place that gives an
/// option wins: the command line is added before the dictionary.
/// The typed getters throw InputError with that place when the text is not what is asked for.
class Settings {
public:
    explicit Settings(std::vector<Option> options);

    /// Adds a value unless the option has one. `place`: "option -cellSize" or
    /// "system/blockInitDict:12: cellSize". Requires: `name` is one of the options.
    void add(const std::string& name, std::string text, std::string place);

    bool has(const std::string& name) const;

    /// Whether the command line gives it (and not the dictionary).
    bool isOption(const std::string& name) const;

    /// Where the option was given; "option -name" when it was not.
    std::string place(const std::string& name) const;

    /// A switch: given on the command line, or yes, on, true in the dictionary.
    bool isOn(const std::string& name) const;

    /// The text as given. Throws InputError when the option is missing.
    const std::string& text(const std::string& name) const;
    std::string text(const std::string& name, std::string_view otherwise) const;

    /// A finite number in [least, most].
    double number(const std::string& name,
                  double least = std::numeric_limits<double>::lowest(),
                  double most = std::numeric_limits<double>::max()) const;
    double numberOr(double otherwise,
                    const std::string& name,
                    double least = std::numeric_limits<double>::lowest(),
                    double most = std::numeric_limits<double>::max()) const;

    /// An angle, given in degrees in [0, 180] [rad].
    double angle(const std::string& name, double otherwiseDegrees) const;

    /// A whole number in [least, most].
    std::int64_t integer(const std::string& name, std::int64_t least, std::int64_t most) const;

    /// Three finite numbers: "(1 2 3)" or "1 2 3".
    Vec3 vector(const std::string& name) const;

    /// Finite numbers, as many as there are; parentheses may group them in any way.
    std::vector<double> numbers(const std::string& name) const;

    /// `count` finite numbers; parentheses may group them in any way: "(0 0 0) (1 1 1)".
    std::vector<double> numbers(const std::string& name, std::size_t count) const;

    /// One of `words`; the message of another word names the nearest.
    std::string word(const std::string& name,
                     const std::vector<std::string>& words,
                     std::string_view otherwise) const;

    const std::vector<Option>& options() const { return options_; }

private:
    struct Value {
        std::string text;
        std::string place;
    };

    std::vector<Option> options_;
    std::map<std::string, Value> values_;
};

/// Reads "-name value", "--name value", "-name=value" and switches; words that belong to no option
/// are the values of the options `words`, in their order. Throws InputError for an unknown option
/// (naming the nearest), a missing value, or a stray word.
void addCommandLine(Settings& settings,
                    const std::vector<std::string>& arguments,
                    const std::vector<std::string>& words = {});

/// Adds the entries of a tool's dictionary: every option that may be one, by its own name.
/// Throws InputError with file and line for any other entry, naming the nearest, except FoamFile
/// and the keys of `others`, which the tool reads itself.
void addDictionary(Settings& settings,
                   const foam::Dictionary& dictionary,
                   const std::vector<std::string>& others);

/// The text that -help prints.
std::string helpText(std::string_view tool, std::string_view purpose, const Settings& settings);

} // namespace polymesh::tools
