// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/options.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/nearestWord.h"

#include <boost/program_options.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

namespace polymesh::tools {

namespace po = boost::program_options;

namespace {

std::string didYouMean(const std::vector<Option>& options, std::string_view name) {
    std::vector<std::string> names;
    names.reserve(options.size());
    for (const Option& option : options)
        names.push_back(option.name);
    return nearestWord(name, names);
}

/// The whole of `text` as a number; from_chars, so the locale does not matter.
double parseNumber(std::string_view text, const std::string& place) {
    const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool whole = error == std::errc{} && end == digits.data() + digits.size();
    require(whole && std::isfinite(value), "{}: '{}' is not a finite number", place, text);
    return value;
}

std::vector<std::string> splitWords(std::string_view text) {
    std::vector<std::string> words;
    std::string word;
    for (const char c : text) {
        const bool separator = std::string_view(" \t\r\n(),").find(c) != std::string_view::npos;
        if (!separator) word += c;
        if (separator && !word.empty()) words.push_back(std::exchange(word, {}));
    }
    if (!word.empty()) words.push_back(word);
    return words;
}

double checkedRange(double value, double least, double most, const std::string& place) {
    constexpr double unlimited = std::numeric_limits<double>::max();
    require(value >= least && value <= most,
            "{}: {} is out of range: expected a number {}",
            place,
            value,
            most == unlimited ? fmt::format(">= {}", least)
                              : fmt::format("in [{}, {}]", least, most));
    return value;
}

} // namespace

const std::vector<Option>& commonOptions() {
    static const std::vector<Option> options{
        {"case", "DIR", "case directory; default: the current one", false},
        {"region", "NAME", "mesh region: constant/NAME/polyMesh", false},
        {"dict",
         "FILE",
         "dictionary of the tool; default: system/<tool>Dict, if there is one",
         false},
        {"format", "FORMAT", "of the mesh written: ascii, binary, ascii.gz, binary.gz", false},
        {"threads", "N", "number of threads; default: all cores", false},
        {"json", "FILE", "write what is reported to FILE too", false},
        {"quiet", "", "print errors and warnings only", false},
        {"noProgress", "", "no progress lines on a terminal", false},
        {"help", "", "print this and stop", false}};
    return options;
}

Option surfaceOption(const std::string& use) {
    return {"surface", "FILE", use + " (STL, OBJ, OFF, PLY, also .gz) [m]"};
}

Settings::Settings(std::vector<Option> options) : options_(std::move(options)) {}

void Settings::add(const std::string& name, std::string text, std::string place) {
    values_.try_emplace(name, Value{std::move(text), std::move(place)});
}

bool Settings::has(const std::string& name) const {
    return values_.contains(name);
}

bool Settings::isOption(const std::string& name) const {
    return has(name) && place(name).starts_with("option ");
}

std::string Settings::place(const std::string& name) const {
    const auto found = values_.find(name);
    return found == values_.end() ? "option -" + name : found->second.place;
}

bool Settings::isOn(const std::string& name) const {
    const auto found = values_.find(name);
    if (found == values_.end()) return false;
    const auto& [text, place] = found->second;
    const bool on = text == "yes" || text == "on" || text == "true" || text == "1";
    const bool off = text == "no" || text == "off" || text == "false" || text == "0";
    require(on || off, "{}: '{}': expected yes or no", place, text);
    return on;
}

const std::string& Settings::text(const std::string& name) const {
    const auto found = values_.find(name);
    require(found != values_.end(), "option -{} is missing (-help lists the options)", name);
    require(!found->second.text.empty(), "{}: its value is empty", found->second.place);
    return found->second.text;
}

std::string Settings::text(const std::string& name, std::string_view otherwise) const {
    return has(name) ? text(name) : std::string(otherwise);
}

double Settings::number(const std::string& name, double least, double most) const {
    return checkedRange(parseNumber(text(name), place(name)), least, most, place(name));
}

double
Settings::numberOr(double otherwise, const std::string& name, double least, double most) const {
    return has(name) ? number(name, least, most) : otherwise;
}

double Settings::angle(const std::string& name, double otherwiseDegrees) const {
    return numberOr(otherwiseDegrees, name, 0, 180) * std::numbers::pi / 180;
}

std::int64_t
Settings::integer(const std::string& name, std::int64_t least, std::int64_t most) const {
    const std::string& given = text(name);
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(given.data(), given.data() + given.size(), value);
    require(error == std::errc{} && end == given.data() + given.size() && value >= least &&
                value <= most,
            "{}: '{}': expected a whole number in [{}, {}]",
            place(name),
            given,
            least,
            most);
    return value;
}

Vec3 Settings::vector(const std::string& name) const {
    const std::vector<double> v = numbers(name, 3);
    return {v[0], v[1], v[2]};
}

std::vector<double> Settings::numbers(const std::string& name) const {
    std::vector<double> values;
    for (const std::string& word : splitWords(text(name)))
        values.push_back(parseNumber(word, place(name)));
    return values;
}

std::vector<double> Settings::numbers(const std::string& name, std::size_t count) const {
    const std::size_t found = splitWords(text(name)).size();
    require(found == count,
            "{}: '{}': expected {} numbers, found {}",
            place(name),
            text(name),
            count,
            found);
    return numbers(name);
}

std::string Settings::word(const std::string& name,
                           const std::vector<std::string>& words,
                           std::string_view otherwise) const {
    std::string given = text(name, otherwise);
    const bool known = std::find(words.begin(), words.end(), given) != words.end();
    require(known,
            "{}: '{}': expected one of {}; nearest: {}",
            place(name),
            given,
            fmt::join(words, ", "),
            nearestWord(given, words));
    return given;
}

namespace {

po::options_description describe(const Settings& settings) {
    po::options_description description;
    for (const Option& option : settings.options()) {
        if (option.value.empty())
            description.add_options()(option.name.c_str(), option.help.c_str());
        else
            description.add_options()(
                option.name.c_str(), po::value<std::string>(), option.help.c_str());
    }
    return description;
}

po::parsed_options parse(const Settings& settings, const std::vector<std::string>& arguments) {
    const po::options_description description = describe(settings);
    const auto style =
        po::command_line_style::allow_long | po::command_line_style::allow_long_disguise |
        po::command_line_style::long_allow_adjacent | po::command_line_style::long_allow_next;
    return po::command_line_parser(arguments).options(description).style(style).run();
}

[[noreturn]] void throwUnknown(const Settings& settings, std::string_view given) {
    const std::string_view name = given.substr(0, given.find('='));
    const std::string_view bare = name.substr(std::min(name.size(), name.find_first_not_of('-')));
    throw InputError(fmt::format("unknown option -{}; the nearest is -{} (-help lists all)",
                                 bare,
                                 didYouMean(settings.options(), bare)));
}

/// Adds one word that stands alone: the value of the first of `words` that has none.
void addWord(Settings& settings, const std::string& value, const std::vector<std::string>& words) {
    const auto free =
        std::ranges::find_if(words, [&](const std::string& name) { return !settings.has(name); });
    require(free != words.end(),
            "unexpected word '{}': values follow their option (-help lists the options)",
            value);
    settings.add(*free, value, "option -" + *free);
}

void addParsed(Settings& settings,
               const po::parsed_options& parsed,
               const std::vector<std::string>& words) {
    for (const auto& option : parsed.options) {
        const std::string value = option.value.empty() ? "" : option.value.front();
        const bool stray = option.position_key >= 0;
        // Boost takes an unknown option with one dash for a word of its own.
        if (stray && value.size() > 1 && value.starts_with('-')) throwUnknown(settings, value);
        if (stray) {
            addWord(settings, value, words);
            continue;
        }
        const std::string place = "option -" + option.string_key;
        require(!settings.has(option.string_key), "{} is given twice", place);
        settings.add(option.string_key, option.value.empty() ? "yes" : value, place);
    }
}

} // namespace

void addCommandLine(Settings& settings,
                    const std::vector<std::string>& arguments,
                    const std::vector<std::string>& words) {
    try {
        addParsed(settings, parse(settings, arguments), words);
    } catch (const po::unknown_option& error) {
        throwUnknown(settings, error.get_option_name());
    } catch (const po::error& error) {
        throw InputError(fmt::format("{} (-help lists the options)", error.what()));
    }
}

namespace {

/// The value as it would be given on the command line.
std::string textOf(const foam::Value& value, std::string_view place) {
    using Kind = foam::Value::Kind;
    require(value.kind != Kind::dictionary, "{}: expected a value, found a dictionary", place);
    if (value.kind != Kind::list) return value.text;
    std::string text = "(";
    for (const foam::Value& item : value.items)
        text += (text.size() > 1 ? " " : "") + textOf(item, place);
    return text + ")";
}

std::string textOf(const foam::Entry& entry, const Option& option, std::string_view place) {
    require(!entry.dictionary, "{}: expected a value, found a dictionary", place);
    std::string text;
    for (const foam::Value& value : entry.values)
        text += (text.empty() ? "" : " ") + textOf(value, place);
    require(!text.empty(), "{}: its value ({}) is missing", place, option.value);
    return text;
}

} // namespace

void addDictionary(Settings& settings,
                   const foam::Dictionary& dictionary,
                   const std::vector<std::string>& others) {
    std::vector<std::string> known = others;
    for (const Option& option : settings.options())
        if (option.inDictionary) known.push_back(option.name);
    for (const foam::Entry& entry : dictionary.entries()) {
        const std::string& key = entry.key;
        if (key == "FoamFile" || std::ranges::find(others, key) != others.end()) continue;
        const std::string place = fmt::format("{}: {}", entry.place.text(), key);
        const auto option = std::ranges::find(settings.options(), key, &Option::name);
        require(option != settings.options().end() && option->inDictionary,
                "{}: unknown entry; the nearest is {} (-help lists all)",
                place,
                nearestWord(key, known));
        settings.add(key, textOf(entry, *option, place), place);
    }
}

std::string helpText(std::string_view tool, std::string_view purpose, const Settings& settings) {
    std::string own = fmt::format("Options, also entries of system/{}Dict (options win)\n", tool);
    std::string common = "Options of every tool\n";
    for (const Option& option : settings.options()) {
        const std::string value = option.value.empty() ? "" : " " + option.value;
        const bool isCommon =
            std::ranges::find(commonOptions(), option.name, &Option::name) != commonOptions().end();
        (isCommon ? common : own) +=
            fmt::format("  {:<24} {}{}\n",
                        "-" + option.name + value,
                        option.help,
                        isCommon || option.inDictionary ? "" : "; not in the dictionary");
    }
    return fmt::format("{}: {}\n\n{}\n{}\nExit status: 0 done, 1 the work failed or a check did "
                       "not pass, 2 wrong usage or bad input.\n",
                       tool,
                       purpose,
                       own,
                       common);
}

} // namespace polymesh::tools
