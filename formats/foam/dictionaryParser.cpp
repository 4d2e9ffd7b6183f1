// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/dictionary.h"
#include "formats/foam/dictionaryScopes.h"
#include "formats/foam/dictionaryTokens.h"
#include "formats/foam/expression.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>

namespace polymesh::foam {
namespace {

namespace fs = std::filesystem;

constexpr int deepest = 100; // nested lists, dictionaries and includes

/// State that a file shares with those that it includes.
struct Session {
    DictionaryScopes scopes;
    Directives directives = Directives::refuse;
    std::vector<fs::path> openFiles = {};
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

bool isInclude(std::string_view directive) {
    return directive == "#include" || directive == "#includeIfPresent" || directive == "#sinclude";
}

class Parser {
public:
    Parser(std::string_view text, const std::string& name, Session& session)
        : tokens_(text, name), session_(session) {}

    /// Reads entries into the innermost scope up to the end of the file, or past a }.
    void readEntries(bool nested);

    /// Reads values up to the end of the file: one that is included inside a list or an entry.
    void readItems(std::vector<Value>& values);

private:
    void readEntry();
    void readValues(Entry& entry);
    bool readSpecialValue(std::vector<Value>& values);
    void readValueDirective(std::vector<Value>& values);
    Value readExpression(const std::string& directive);
    Value readValue();
    Value readList(char close);
    Value readWordOrList();
    Value readSizedList(const Value& count);
    Value readDictionaryValue();
    std::shared_ptr<const Dictionary> readDictionary(const std::string& key);

    void readDirective();
    void include(bool optional, std::vector<Value>* values);
    void removeEntries();

    const Entry& readMacro();
    void copyMacro(std::vector<Value>& values);
    void mergeMacro();

    Level enter() const;

    DictionaryTokens tokens_;
    Session& session_;
};

Level Parser::enter() const {
    if (session_.depth >= deepest) tokens_.fail("more than {} levels of nesting", deepest);
    return Level(session_);
}

void Parser::readEntries(bool nested) {
    const Place start = tokens_.place();
    while (true) {
        tokens_.skipBlanks();
        if (tokens_.atEnd()) {
            if (nested) throw InputError(start.text() + ": this { has no matching }");
            return;
        }
        const char c = tokens_.look();
        if (c == '}') {
            if (!nested) tokens_.fail("a }} without a {{ before it");
            tokens_.skip();
            return;
        }
        if (c == ';') {
            tokens_.skip();
        } else if (c == '#') {
            readDirective();
        } else if (c == '$') {
            mergeMacro();
        } else {
            readEntry();
        }
    }
}

void Parser::readEntry() {
    Entry entry;
    entry.place = tokens_.place();
    if (tokens_.look() == '"') {
        entry.key = tokens_.readQuoted();
    } else {
        const Value name = readWordOrList();
        entry.key = name.text;
    }
    tokens_.skipBlanks();
    if (tokens_.look() == '{') {
        entry.dictionary = readDictionary(entry.key);
    } else {
        try {
            readValues(entry);
        } catch (const Skipped&) {
            tokens_.skipEntry();
            return;
        }
    }
    session_.scopes.innermost().add(std::move(entry));
}

void Parser::readValues(Entry& entry) {
    std::vector<Value>& values = entry.values;
    while (true) {
        tokens_.skipBlanks();
        if (tokens_.look() == ';') break;
        if (tokens_.atEnd() || tokens_.look() == '}')
            throw InputError(
                fmt::format("{}: {}: no ; at the end of the entry", entry.place.text(), entry.key));
        if (!readSpecialValue(values)) values.push_back(readValue());
    }
    tokens_.skip();
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
    if (tokens_.look() == '$') {
        copyMacro(values);
        return true;
    }
    if (tokens_.look() == '#' && tokens_.look(1) != '{') {
        readValueDirective(values);
        return true;
    }
    return false;
}

/// Reads #eval, #calc or #include in place of values.
void Parser::readValueDirective(std::vector<Value>& values) {
    const std::string name = tokens_.readName();
    if (name == "#eval" || name == "#calc") {
        values.push_back(readExpression(name));
    } else if (isInclude(name)) {
        include(name != "#include", &values);
    } else {
        if (session_.directives == Directives::skip) throw Skipped{};
        tokens_.fail("{} is not supported; write its result instead", name);
    }
}

/// Reads "expression", {expression} or #{ expression #} and gives its value.
Value Parser::readExpression(const std::string& directive) {
    tokens_.skipBlanks();
    Value value = tokens_.blank(Value::Kind::number);
    const char c = tokens_.look();
    if (c != '"' && c != '{' && c != '#')
        tokens_.fail("{}: expected \"expression\" or {{expression}}", directive);
    const std::string text = c == '"'   ? tokens_.readQuoted()
                             : c == '{' ? tokens_.readBraced()
                                        : tokens_.readVerbatim();
    const auto variable = [this](std::string_view name) -> std::optional<double> {
        const Entry* entry = session_.scopes.find(name);
        if (entry == nullptr || entry->values.size() != 1) return std::nullopt;
        const Value& found = entry->values.front();
        return found.kind == Value::Kind::number ? std::optional(found.number) : std::nullopt;
    };
    const Division division = directive == "#calc" ? Division::whole : Division::exact;
    try {
        value.number = evaluateExpression(text, variable, value.place, division);
    } catch (const InputError&) {
        if (session_.directives == Directives::skip) throw Skipped{};
        throw;
    }
    value.text = fmt::format("{}", value.number);
    return value;
}

Value Parser::readValue() {
    const char c = tokens_.look();
    if (c == '(') return readList(')');
    if (c == '[') return readList(']');
    if (c == '{') return readDictionaryValue();
    if (c == '"' || c == '#') {
        Value value = tokens_.blank(Value::Kind::string);
        value.text = c == '"' ? tokens_.readQuoted() : tokens_.readVerbatim();
        return value;
    }
    return readWordOrList();
}

Value Parser::readList(char close) {
    const Level level = enter();
    Value list = tokens_.blank(Value::Kind::list);
    tokens_.skip();
    while (true) {
        tokens_.skipBlanks();
        if (tokens_.look() == close) break;
        if (tokens_.atEnd() || tokens_.look() == ';' || tokens_.look() == '}' ||
            tokens_.look() == ')' || tokens_.look() == ']')
            throw InputError(fmt::format(
                "{}: the list that begins here has no matching {}", list.place.text(), close));
        if (!readSpecialValue(list.items)) list.items.push_back(readValue());
    }
    tokens_.skip();
    return list;
}

Value Parser::readDictionaryValue() {
    Value value = tokens_.blank(Value::Kind::dictionary);
    value.dictionary = readDictionary("");
    return value;
}

std::shared_ptr<const Dictionary> Parser::readDictionary(const std::string& key) {
    const Level level = enter();
    const std::string& outer = session_.scopes.innermost().path();
    const bool whole = outer.empty() || key.empty();
    auto dictionary =
        std::make_shared<Dictionary>(tokens_.place(), whole ? outer + key : outer + "." + key);
    tokens_.skip();
    session_.scopes.open(*dictionary);
    readEntries(true);
    session_.scopes.close();
    return dictionary;
}

Value Parser::readWordOrList() {
    Value value = tokens_.readWordOrNumber();
    const bool isCount = value.kind == Value::Kind::number && tokens_.look() == '(';
    return isCount ? readSizedList(value) : value;
}

/// Reads n(...), where the count touches the list.
Value Parser::readSizedList(const Value& count) {
    Value list = readList(')');
    if (count.number != static_cast<double>(list.items.size()))
        count.fail("list", fmt::format("{}, the length of the list", list.items.size()));
    return list;
}

void Parser::readDirective() {
    const std::string name = tokens_.readName();
    if (isInclude(name)) return include(name != "#include", nullptr);
    if (name == "#remove") return removeEntries();
    if (session_.directives == Directives::refuse)
        tokens_.fail("{} is not supported; write what it stands for", name);
    tokens_.skipDirective();
}

void Parser::removeEntries() {
    tokens_.skipBlanks();
    const Value key = readValue();
    for (const Value& each : key.kind == Value::Kind::list ? key.items : std::vector{key})
        session_.scopes.innermost().remove(each.string("#remove"));
}

std::string readWholeFile(const fs::path& path) {
    std::error_code ignored;
    require(fs::exists(path, ignored), "{}: no such file", path.string());
    require(fs::is_regular_file(path, ignored), "{}: this is not a file", path.string());
    std::ifstream file(path, std::ios::binary);
    require(file.good(), "{}: cannot be opened", path.string());
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Reads a file as entries, or, when there is `values`, as values.
void parseFile(const fs::path& path, Session& session, std::vector<Value>* values = nullptr) {
    const fs::path canonical = fs::weakly_canonical(path);
    session.openFiles.push_back(canonical);
    const std::string text = readWholeFile(path);
    Parser parser(text, path.string(), session);
    if (values == nullptr)
        parser.readEntries(false);
    else
        parser.readItems(*values);
    session.openFiles.pop_back();
}

void Parser::readItems(std::vector<Value>& values) {
    while (true) {
        tokens_.skipBlanks();
        if (tokens_.atEnd()) return;
        if (tokens_.look() == ')' || tokens_.look() == ']' || tokens_.look() == '}' ||
            tokens_.look() == ';')
            tokens_.fail("'{}' is not expected in a file that is included inside a list",
                         tokens_.look());
        if (!readSpecialValue(values)) values.push_back(readValue());
    }
}

void Parser::include(bool optional, std::vector<Value>* values) {
    tokens_.skipBlanks();
    if (tokens_.look() != '"') tokens_.fail("#include: expected a \"file name\"");
    const Level level = enter();
    fs::path path = expandEnvironment(tokens_.readQuoted(), tokens_.place());
    if (path.is_relative()) path = fs::path(tokens_.fileName()).parent_path() / path;
    std::error_code ignored;
    const bool there = fs::is_regular_file(path, ignored);
    if (!there && (optional || session_.directives == Directives::skip)) return;
    if (!there) tokens_.fail("#include: there is no file {}", path.string());
    const auto& open = session_.openFiles;
    if (std::ranges::find(open, fs::weakly_canonical(path)) != open.end())
        tokens_.fail("#include: {} includes itself", path.string());
    parseFile(path, session_, values);
}

/// Reads $name and returns the entry that it means.
const Entry& Parser::readMacro() {
    const std::optional<std::string_view> name = tokens_.readMacroName();
    const Entry* entry = name ? session_.scopes.find(*name) : nullptr;
    if (entry == nullptr) {
        if (session_.directives == Directives::skip) throw Skipped{};
        if (!name) tokens_.fail("a macro whose name holds another one is not supported");
        tokens_.fail("${}: there is no such entry before this line", *name);
    }
    if (!session_.scopes.countCopy(*entry))
        tokens_.fail("macros make more than {} entries", DictionaryScopes::mostCopied);
    return *entry;
}

void Parser::copyMacro(std::vector<Value>& values) {
    const Entry& entry = readMacro();
    if (entry.dictionary) {
        Value value = tokens_.blank(Value::Kind::dictionary);
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
        if (!entry.dictionary) tokens_.fail("{} is a value; expected a dictionary here", entry.key);
        const std::shared_ptr<const Dictionary> source = entry.dictionary;
        for (const Entry& each : source->entries())
            session_.scopes.innermost().add(each);
    } catch (const Skipped&) {
        return; // without what can not be found
    }
}

} // namespace

Dictionary readDictionary(const fs::path& path, Directives directives) {
    Dictionary dictionary({std::make_shared<const std::string>(path.string()), 1}, "");
    Session session{.scopes = DictionaryScopes(dictionary), .directives = directives};
    parseFile(path, session);
    return dictionary;
}

Dictionary parseDictionary(std::string_view text, const std::string& name, Directives directives) {
    Dictionary dictionary({std::make_shared<const std::string>(name), 1}, "");
    Session session{.scopes = DictionaryScopes(dictionary), .directives = directives};
    Parser(text, name, session).readEntries(false);
    return dictionary;
}

} // namespace polymesh::foam
