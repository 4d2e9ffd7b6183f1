// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/dictionary.h"

#include <algorithm>
#include <cstdlib>
#include <fast_float/fast_float.h>
#include <fstream>
#include <iterator>

namespace polymesh::foam {
namespace {

namespace fs = std::filesystem;

constexpr int deepest = 100;                  // nested lists, dictionaries and includes
constexpr std::size_t mostCopied = 1'000'000; // values that macros may multiply

bool isBlank(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

bool isMacroLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '.' || c == ':' || c == '-' || c == '+' || c == '<' || c == '>' || c == '/';
}

bool endsWord(char c) {
    return isBlank(c) || c == '\0' || c == '"' || c == '\'' || c == ';' || c == '{' || c == '}' ||
           c == '[' || c == ']';
}

/// State that a file shares with those that it includes.
struct Session {
    Directives directives = Directives::refuse;
    std::vector<fs::path> openFiles;
    std::vector<Dictionary*> scopes; // outermost first
    std::size_t copied = 0;
    int depth = 0;
};

/// Counts a level of nesting while it lives.
class Level {
public:
    explicit Level(Session& session) : session_(session) { ++session_.depth; }

    ~Level() { --session_.depth; }

    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

private:
    Session& session_;
};

/// An entry that can not be evaluated here is dropped in skip mode.
struct Skipped {};

class Parser {
public:
    Parser(std::string_view text, const std::string& name, Session& session)
        : here_(text.data()),
          end_(text.data() + text.size()),
          file_(std::make_shared<const std::string>(name)),
          session_(session) {}

    /// Reads entries into the innermost scope up to the end of the file, or past a }.
    void readEntries(bool nested);

    Place place() const { return {file_, line_}; }

private:
    char look(std::ptrdiff_t ahead = 0) const { return end_ - here_ > ahead ? here_[ahead] : '\0'; }

    bool atEnd() const { return here_ == end_; }

    void step();
    void skipBlanks();
    void skipComment();
    void skipLine();
    void skipEntry();

    void readEntry();
    void readDirective();
    void readValues(Entry& entry);
    bool readSpecialValue(std::vector<Value>& values);
    Value readValue();
    Value readList(char close);
    Value readWordOrNumber();
    Value readSizedList(const Value& count);
    void readWordCharacters();
    Value readDictionaryValue();
    std::shared_ptr<const Dictionary> readDictionary(const std::string& key);
    std::string readQuoted();
    std::string readVerbatim();
    std::string readName();

    void include(bool optional);
    std::string expandEnvironment(const std::string& name) const;
    const Entry* findMacro(std::string_view name) const;
    void skipNestedMacro();
    const Entry& readMacro();
    void countCopy(const Entry& entry);
    void copyMacro(std::vector<Value>& values);
    void mergeMacro();

    Value blank(Value::Kind kind) const;
    Level enter() const;

    template<class... Args>
    [[noreturn]] void fail(fmt::format_string<Args...> message, Args&&... args) const {
        throw InputError(place().text() + ": " + fmt::format(message, std::forward<Args>(args)...));
    }

    const char* here_;
    const char* end_;
    int line_ = 1;
    std::shared_ptr<const std::string> file_;
    Session& session_;
};

void Parser::step() {
    if (*here_ == '\n') ++line_;
    ++here_;
}

void Parser::skipBlanks() {
    while (!atEnd()) {
        if (isBlank(*here_)) {
            step();
        } else if (*here_ == '/' && (look(1) == '/' || look(1) == '*')) {
            skipComment();
        } else {
            return;
        }
    }
}

void Parser::skipComment() {
    if (look(1) == '/') return skipLine();
    const Place start = place();
    here_ += 2;
    while (!(look() == '*' && look(1) == '/')) {
        if (atEnd()) throw InputError(start.text() + ": this comment has no end; a */ is missing");
        step();
    }
    here_ += 2;
}

void Parser::skipLine() {
    while (!atEnd() && *here_ != '\n')
        ++here_;
}

/// Skips the rest of an entry that may have been left inside a list.
void Parser::skipEntry() {
    int depth = 0;
    while (true) {
        skipBlanks();
        const char c = look();
        if (atEnd() || (c == '}' && depth == 0)) return;
        if (c == '"') {
            readQuoted();
            continue;
        }
        if (c == '#' && look(1) == '{') {
            readVerbatim();
            continue;
        }
        ++here_;
        if (c == ';' && depth == 0) return;
        if (c == '{') ++depth;
        if (c == '}') --depth;
    }
}

Level Parser::enter() const {
    if (session_.depth >= deepest) fail("more than {} levels of nesting", deepest);
    return Level(session_);
}

Value Parser::blank(Value::Kind kind) const {
    Value value;
    value.kind = kind;
    value.place = place();
    return value;
}

void Parser::readEntries(bool nested) {
    const Place start = place();
    while (true) {
        skipBlanks();
        if (atEnd()) {
            if (nested) throw InputError(start.text() + ": this { has no matching }");
            return;
        }
        const char c = look();
        if (c == '}') {
            if (!nested) fail("a }} without a {{ before it");
            ++here_;
            return;
        }
        if (c == ';') {
            ++here_;
        } else if (c == '#') {
            readDirective();
        } else if (c == '$') {
            mergeMacro();
        } else {
            readEntry();
        }
    }
}

std::string Parser::readName() {
    const char* start = here_;
    while (!endsWord(look()))
        ++here_;
    return {start, here_};
}

void Parser::readEntry() {
    Entry entry;
    entry.place = place();
    if (look() == '"') {
        entry.key = readQuoted();
    } else {
        const Value name = readWordOrNumber();
        entry.key = name.text;
    }
    skipBlanks();
    if (look() == '{') {
        entry.dictionary = readDictionary(entry.key);
    } else {
        try {
            readValues(entry);
        } catch (const Skipped&) {
            skipEntry();
            return;
        }
    }
    session_.scopes.back()->add(std::move(entry));
}

void Parser::readValues(Entry& entry) {
    std::vector<Value>& values = entry.values;
    while (true) {
        skipBlanks();
        if (look() == ';') break;
        if (atEnd() || look() == '}')
            throw InputError(
                fmt::format("{}: {}: no ; at the end of the entry", entry.place.text(), entry.key));
        if (!readSpecialValue(values)) values.push_back(readValue());
    }
    ++here_;
    using Kind = Value::Kind;
    if (values.size() == 1 && values.front().kind == Kind::dictionary) {
        entry.dictionary = values.front().dictionary; // from a macro
        values.clear();
    } else if (values.size() == 2 && values[0].kind == Kind::number &&
               values[1].kind == Kind::list) {
        if (values[0].number != static_cast<double>(values[1].items.size()))
            values[0].fail(entry.key,
                           fmt::format("{}, the length of the list", values[1].items.size()));
        values.erase(values.begin());
    }
}

/// Reads a macro, which may stand for several values, or a directive.
bool Parser::readSpecialValue(std::vector<Value>& values) {
    if (look() == '$') {
        copyMacro(values);
        return true;
    }
    if (look() == '#' && look(1) != '{') {
        const std::string name = readName();
        if (session_.directives == Directives::skip) throw Skipped{};
        fail("{} is not supported; write its result instead", name);
    }
    return false;
}

Value Parser::readValue() {
    const char c = look();
    if (c == '(') return readList(')');
    if (c == '[') return readList(']');
    if (c == '{') return readDictionaryValue();
    if (c == '"' || c == '#') {
        Value value = blank(Value::Kind::string);
        value.text = c == '"' ? readQuoted() : readVerbatim();
        return value;
    }
    return readWordOrNumber();
}

Value Parser::readList(char close) {
    const Level level = enter();
    Value list = blank(Value::Kind::list);
    ++here_;
    while (true) {
        skipBlanks();
        if (look() == close) break;
        if (atEnd() || look() == ';' || look() == '}' || look() == ')' || look() == ']')
            throw InputError(fmt::format(
                "{}: the list that begins here has no matching {}", list.place.text(), close));
        if (!readSpecialValue(list.items)) list.items.push_back(readValue());
    }
    ++here_;
    return list;
}

Value Parser::readDictionaryValue() {
    Value value = blank(Value::Kind::dictionary);
    value.dictionary = readDictionary("");
    return value;
}

std::shared_ptr<const Dictionary> Parser::readDictionary(const std::string& key) {
    const Level level = enter();
    const std::string& outer = session_.scopes.back()->path();
    const bool whole = outer.empty() || key.empty();
    auto dictionary =
        std::make_shared<Dictionary>(place(), whole ? outer + key : outer + "." + key);
    ++here_;
    session_.scopes.push_back(dictionary.get());
    readEntries(true);
    session_.scopes.pop_back();
    return dictionary;
}

/// Moves past the characters of a word; parentheses belong to it when they are balanced.
void Parser::readWordCharacters() {
    int depth = 0;
    const char* start = here_;
    const char* firstOpen = nullptr;
    for (; !endsWord(look()); ++here_) {
        if (*here_ == ')' && depth-- == 0) break;
        if (*here_ == '/' && (look(1) == '/' || look(1) == '*')) break;
        if (*here_ != '(') continue;
        if (firstOpen == nullptr) firstOpen = here_;
        ++depth;
    }
    if (depth > 0) here_ = firstOpen; // a list begins there
    if (here_ != start) return;
    if (atEnd()) fail("the file ends where something is expected");
    fail("'{}' is not expected here", *here_ >= ' ' && *here_ <= '~' ? *here_ : '?');
}

Value Parser::readWordOrNumber() {
    Value value = blank(Value::Kind::word);
    const char* start = here_;
    readWordCharacters();
    const char* number = *start == '+' ? start + 1 : start;
    const auto [stop, problem] = fast_float::from_chars(number, here_, value.number);
    const bool spelledOut = *number == 'n' || *number == 'i' || *number == 'N' || *number == 'I';
    if (problem == std::errc{} && !spelledOut && (stop == here_ || *stop == '(')) {
        value.kind = Value::Kind::number;
        here_ = stop;
    }
    value.text.assign(start, here_);
    if (value.kind == Value::Kind::number && look() == '(') return readSizedList(value);
    return value;
}

/// Reads n(...), where the count touches the list.
Value Parser::readSizedList(const Value& count) {
    Value list = readList(')');
    if (count.number != static_cast<double>(list.items.size()))
        count.fail("list", fmt::format("{}, the length of the list", list.items.size()));
    return list;
}

std::string Parser::readQuoted() {
    const Place start = place();
    std::string text;
    step();
    while (true) {
        if (atEnd()) throw InputError(start.text() + ": this string has no closing \"");
        if (look() == '"') break;
        if (look() == '\\' && look(1) == '"') ++here_;
        text += look();
        step();
    }
    ++here_;
    return text;
}

std::string Parser::readVerbatim() {
    const Place start = place();
    std::string text;
    here_ += 2;
    while (!(look() == '#' && look(1) == '}')) {
        if (atEnd()) throw InputError(start.text() + ": this #{ has no matching #}");
        text += look();
        step();
    }
    here_ += 2;
    return text;
}

void Parser::readDirective() {
    const std::string name = readName();
    if (name == "#include" || name == "#includeIfPresent" || name == "#sinclude")
        return include(name != "#include");
    if (name == "#remove") {
        skipBlanks();
        const Value key = readValue();
        for (const Value& each : key.kind == Value::Kind::list ? key.items : std::vector{key})
            session_.scopes.back()->remove(each.string(name));
        return;
    }
    if (session_.directives == Directives::refuse)
        fail("{} is not supported; write what it stands for", name);
    while (!atEnd() && look() != '\n' && look() != '}')
        ++here_;
}

std::string Parser::expandEnvironment(const std::string& name) const {
    std::string result;
    for (std::size_t i = 0; i < name.size(); ++i) {
        if (name[i] != '$') {
            result += name[i];
            continue;
        }
        const bool braced = name.substr(i + 1, 1) == "{";
        std::size_t last = i + (braced ? 2 : 1);
        const std::size_t first = last;
        while (last < name.size() &&
               (std::isalnum(static_cast<unsigned char>(name[last])) != 0 || name[last] == '_'))
            ++last;
        const std::string variable = name.substr(first, last - first);
        const char* value = std::getenv(variable.c_str());
        if (value == nullptr) fail("environment variable {} is not set", variable);
        result += value;
        i = braced ? last : last - 1;
    }
    return result;
}

std::string readWholeFile(const fs::path& path) {
    std::error_code ignored;
    require(fs::exists(path, ignored), "{}: no such file", path.string());
    require(fs::is_regular_file(path, ignored), "{}: this is not a file", path.string());
    std::ifstream file(path, std::ios::binary);
    require(file.good(), "{}: cannot be opened", path.string());
    return {std::istreambuf_iterator<char>(file), {}};
}

void parseFile(const fs::path& path, Session& session) {
    const fs::path canonical = fs::weakly_canonical(path);
    session.openFiles.push_back(canonical);
    const std::string text = readWholeFile(path);
    Parser(text, path.string(), session).readEntries(false);
    session.openFiles.pop_back();
}

void Parser::include(bool optional) {
    skipBlanks();
    if (look() != '"') fail("#include: expected a \"file name\"");
    const Level level = enter();
    fs::path path = expandEnvironment(readQuoted());
    if (path.is_relative()) path = fs::path(*file_).parent_path() / path;
    std::error_code ignored;
    const bool there = fs::is_regular_file(path, ignored);
    if (!there && (optional || session_.directives == Directives::skip)) return;
    if (!there) fail("#include: there is no file {}", path.string());
    const auto& open = session_.openFiles;
    if (std::ranges::find(open, fs::weakly_canonical(path)) != open.end())
        fail("#include: {} includes itself", path.string());
    parseFile(path, session_);
}

/// The entry that a dotted name means, seen from `dictionary`; null when there is none.
const Entry* findDotted(const Dictionary& dictionary, std::string_view name) {
    if (const Entry* whole = dictionary.find(name)) return whole;
    const std::size_t dot = name.find('.');
    if (dot == std::string_view::npos) return nullptr;
    const Entry* outer = dictionary.find(name.substr(0, dot));
    if (outer == nullptr || !outer->dictionary) return nullptr;
    return findDotted(*outer->dictionary, name.substr(dot + 1));
}

const Entry* Parser::findMacro(std::string_view name) const {
    const std::vector<Dictionary*>& scopes = session_.scopes;
    if (name.starts_with(':')) return findDotted(*scopes.front(), name.substr(1));
    const std::size_t dots = std::min(name.find_first_not_of('.'), name.size());
    if (dots > scopes.size()) return nullptr;
    if (dots > 0) return findDotted(*scopes[scopes.size() - dots], name.substr(dots));
    for (std::size_t i = scopes.size(); i-- > 0;)
        if (const Entry* found = findDotted(*scopes[i], name)) return found;
    return nullptr;
}

/// Moves to the } that closes ${a${b}}.
void Parser::skipNestedMacro() {
    for (int depth = 0; !atEnd() && look() != '\n' && !(look() == '}' && depth == 0); ++here_) {
        if (look() == '{') ++depth;
        if (look() == '}') --depth;
    }
}

/// Reads $name and returns the entry that it means.
const Entry& Parser::readMacro() {
    ++here_;
    const bool braced = look() == '{';
    if (braced) ++here_;
    const char* start = here_;
    while (isMacroLetter(look()))
        ++here_;
    const std::string_view name(start, static_cast<std::size_t>(here_ - start));
    const bool nested = braced && look() == '$';
    if (nested) skipNestedMacro();
    if (braced && look() != '}') fail("${{{}: a }} is missing", name);
    if (braced) ++here_;
    const Entry* entry = nested ? nullptr : findMacro(name);
    if (entry != nullptr) return *entry;
    if (session_.directives == Directives::skip) throw Skipped{};
    if (nested) fail("a macro whose name holds another one is not supported");
    fail("${}: there is no such entry before this line", name);
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

/// Bounds what macros can multiply, in number and so in depth.
void Parser::countCopy(const Entry& entry) {
    session_.copied += countValues(entry.values, mostCopied);
    if (entry.dictionary) session_.copied += countEntries(*entry.dictionary, mostCopied);
    if (session_.copied > mostCopied) fail("macros make more than {} entries", mostCopied);
}

void Parser::copyMacro(std::vector<Value>& values) {
    const Entry& entry = readMacro();
    countCopy(entry);
    if (entry.dictionary) {
        Value value = blank(Value::Kind::dictionary);
        value.dictionary = entry.dictionary;
        values.push_back(std::move(value));
        return;
    }
    values.insert(values.end(), entry.values.begin(), entry.values.end());
}

/// Reads `$name;` among the entries: all entries of that dictionary.
void Parser::mergeMacro() {
    try {
        const Entry& entry = readMacro();
        if (!entry.dictionary) fail("{} is a value; expected a dictionary here", entry.key);
        const std::shared_ptr<const Dictionary> source = entry.dictionary;
        countCopy(entry);
        for (const Entry& each : source->entries())
            session_.scopes.back()->add(each);
    } catch (const Skipped&) {
        return; // without what can not be found
    }
}

} // namespace

Dictionary readDictionary(const fs::path& path, Directives directives) {
    Session session;
    session.directives = directives;
    Dictionary dictionary({std::make_shared<const std::string>(path.string()), 1}, "");
    session.scopes.push_back(&dictionary);
    parseFile(path, session);
    return dictionary;
}

Dictionary parseDictionary(std::string_view text, const std::string& name, Directives directives) {
    Session session;
    session.directives = directives;
    Dictionary dictionary({std::make_shared<const std::string>(name), 1}, "");
    session.scopes.push_back(&dictionary);
    Parser(text, name, session).readEntries(false);
    return dictionary;
}

} // namespace polymesh::foam
