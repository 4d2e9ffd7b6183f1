// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/foam/inputFile.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/base/label.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace polymesh::foam {

/// What the FoamFile dictionary at the top of a file says.
struct FileHeader {
    bool binary = false;
    std::size_t labelBytes = sizeof(Label);   // 4 or 8
    std::size_t scalarBytes = sizeof(double); // 4 or 8
    std::string className;
    std::string object;
    std::string note;
};

/// Reads the tokens of an OpenFOAM file. Comments may stand between any two of them.
/// All functions throw InputError with file and line when they find something else.
class FoamReader {
public:
    /// Opens the file, or its .gz, and reads the header.
    explicit FoamReader(const std::filesystem::path& path);

    /// The same from memory; `name` is used in messages.
    FoamReader(std::string_view contents, std::string name);

    const FileHeader& header() const { return header_; }

    InputFile& file() { return file_; }

    /// Moves to the next token and shows InputFile::longestToken bytes from there. Returns the
    /// token's first character, 0 at the end of the file.
    char peek();

    /// Moves over the character when it is the next token.
    bool accept(char character);

    /// Demands the character; `what` says what it begins or ends.
    void expect(char character, std::string_view what);

    /// Reads an integer that fits 64 bits. `what` is the quantity in messages.
    std::int64_t integer(std::string_view what);

    /// Reads a label.
    Label label(std::string_view what) {
        const std::int64_t value = integer(what);
        if (!std::in_range<Label>(value)) failTooLarge(value, what);
        return static_cast<Label>(value);
    }

    /// Reads a finite number.
    double scalar(std::string_view what);

    /// Reads a word or a quoted string (returned with its quotes).
    std::string word(std::string_view what);

    /// Reads what stands before the next semicolon, which is consumed, or a {dictionary}; without
    /// comments, blanks at the ends removed.
    std::string entryText();

    /// Throws InputError "file:line: message".
    template<class... Args>
    [[noreturn]] void fail(fmt::format_string<Args...> message, Args&&... args) const {
        throw InputError(place() + fmt::format(message, std::forward<Args>(args)...));
    }

    /// Throws InputError "file: byte n: message", for binary parts.
    template<class... Args>
    [[noreturn]] void failAtByte(fmt::format_string<Args...> message, Args&&... args) const {
        throw InputError(fmt::format("{}: byte {}: ", file_.name(), file_.offset()) +
                         fmt::format(message, std::forward<Args>(args)...));
    }

    /// Throws InputError "file: message", where the message says the place.
    template<class... Args>
    [[noreturn]] void failInFile(fmt::format_string<Args...> message, Args&&... args) const {
        throw InputError(file_.name() + ": " + fmt::format(message, std::forward<Args>(args)...));
    }

    /// What stands here, shortened, for messages.
    std::string found();

private:
    void readHeader();
    void readArchitecture(std::string_view text);
    bool skipComment();
    void appendQuoted(std::string& text);
    void finishNumber(const char* end, std::string_view what);
    [[noreturn]] void failTooLarge(std::int64_t value, std::string_view what) const;
    std::string place() const;

    InputFile file_;
    FileHeader header_;
};

} // namespace polymesh::foam
