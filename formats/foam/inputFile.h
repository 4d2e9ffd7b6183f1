// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace polymesh::foam {

/// A file, plain or gzipped, seen through a window that slides over it, so that no file is ever
/// held in memory as a whole. The window always ends with a zero byte that is not part of the file.
class InputFile {
public:
    /// Every token that is parsed in one go must be shorter than this.
    static constexpr std::size_t longestToken = 4096;

    /// Opens the plain file `path`, or `path`.gz when there is no plain one.
    /// Throws InputError when there is neither.
    explicit InputFile(const std::filesystem::path& path);

    /// Reads from memory; `name` is used in messages.
    InputFile(std::string_view contents, std::string name);

    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    /// The visible bytes are [here(), end()).
    const char* here() const { return here_; }

    const char* end() const { return end_; }

    void moveTo(const char* place) { here_ = place; }

    /// Shows at least `count` bytes (at most longestToken), or all that are left.
    void lookAhead(std::size_t count) {
        if (static_cast<std::size_t>(end_ - here_) < count && !ended_) slide();
    }

    bool atEnd() {
        lookAhead(1);
        return here_ == end_;
    }

    /// Copies the next bytes, large amounts straight from the file. Returns false when the file
    /// ends before.
    bool read(void* target, std::size_t bytes);

    bool isCompressed() const;

    /// An upper bound of the bytes left after decompression, to check counts with.
    std::uint64_t mostBytesLeft() const;

    /// Offset of here() in the decompressed file [bytes].
    std::uint64_t offset() const { return windowOffset_ + visitedBytes(); }

    const std::string& name() const { return name_; }

    /// The line of here(), from 1. Reads the file again: for messages only.
    std::size_t lineNumber() const;

private:
    struct Source; // what the bytes come from

    std::size_t visitedBytes() const { return static_cast<std::size_t>(here_ - window_.data()); }

    void slide();

    std::unique_ptr<Source> source_;
    std::string name_;
    std::vector<char> window_;
    const char* here_ = nullptr;
    const char* end_ = nullptr;
    std::uint64_t windowOffset_ = 0;
    bool ended_ = false; // nothing is left beyond the window
};

} // namespace polymesh::foam
