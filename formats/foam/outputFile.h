// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace polymesh::foam {

/// A new file, plain or gzipped (then `.gz` is added to its name). Every failure to write throws
/// WorkError with the name that the file will bear when all is done.
class OutputFile {
public:
    /// Writes to `path`; messages speak of `finalPath`.
    OutputFile(const std::filesystem::path& path,
               const std::filesystem::path& finalPath,
               bool compress);

    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(std::string_view bytes);

    /// Writes what is left and checks that all of it was accepted.
    void close();

private:
    void writePlain(std::string_view bytes);
    void writeStored(const char* bytes, std::size_t count);
    void compressPending();
    [[noreturn]] void fail() const;

    std::string name_; // for messages
    int descriptor_ = -1;
    bool compress_ = false;
    std::string pending_;
    std::uint32_t checksum_ = 0;
    std::uint64_t plainBytes_ = 0;
};

} // namespace polymesh::foam
