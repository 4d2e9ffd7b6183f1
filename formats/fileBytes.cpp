// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/fileBytes.h"

#include "formats/gunzip.h"
#include "libpolymesh/base/error.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <unistd.h>
#include <zlib.h>

namespace polymesh {

namespace {

constexpr std::size_t chunkSize = std::size_t{1} << 20U;

struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }

    void operator()(gzFile_s* file) const { gzclose(file); }
};

using File = std::unique_ptr<std::FILE, Close>;
using GzipFile = std::unique_ptr<gzFile_s, Close>;

std::string readPlain(const std::filesystem::path& path) {
    const File file(std::fopen(path.c_str(), "rb"));
    require(file != nullptr, "{}: cannot open: {}", path.string(), std::strerror(errno));
    std::string bytes;
    std::size_t size = 0;
    std::error_code notRegular; // such as a pipe: its size shows in reading
    const auto fileSize = std::filesystem::file_size(path, notRegular);
    std::size_t capacity = notRegular ? chunkSize : fileSize + 1; // + 1: one read sees the end
    do {
        bytes.resize(capacity);
        size += std::fread(bytes.data() + size, 1, bytes.size() - size, file.get());
        capacity = 2 * bytes.size();
    } while (size == bytes.size());
    require(std::ferror(file.get()) == 0, "{}: cannot read", path.string());
    bytes.resize(size);
    return bytes;
}

bool writePlain(const std::filesystem::path& path, std::string_view bytes) {
    File file(std::fopen(path.c_str(), "wb"));
    if (file == nullptr) return false;
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
    return std::fclose(file.release()) == 0 && written;
}

bool writeGzip(const std::filesystem::path& path, std::string_view bytes) {
    GzipFile file(gzopen(path.c_str(), "wb"));
    if (file == nullptr) return false;
    bool written = true;
    for (std::size_t i = 0; i < bytes.size() && written; i += chunkSize) {
        const auto part = bytes.substr(i, chunkSize);
        const auto size = static_cast<unsigned>(part.size());
        written = gzwrite(file.get(), part.data(), size) == static_cast<int>(size);
    }
    return gzclose(file.release()) == Z_OK && written;
}

} // namespace

std::string readBytes(const std::filesystem::path& file) {
    require(std::filesystem::exists(file),
            "{}: no such file; check its name and folder",
            file.string());
    require(
        !std::filesystem::is_directory(file), "{}: is a folder; name a file in it", file.string());
    std::string bytes = readPlain(file);
    return file.extension() == ".gz" ? gunzip(bytes, file.string()) : bytes;
}

void writeBytes(const std::filesystem::path& file, std::string_view bytes) {
    auto temporary = file;
    temporary += fmt::format(".{}.tmp", getpid());
    errno = 0;
    const bool written =
        file.extension() == ".gz" ? writeGzip(temporary, bytes) : writePlain(temporary, bytes);
    std::error_code error(errno, std::generic_category());
    if (written) std::filesystem::rename(temporary, file, error);
    if (written && !error) return;
    const std::string reason = error.message();
    std::filesystem::remove(temporary, error);
    throw WorkError(fmt::format("{}: cannot write: {}", file.string(), reason));
}

} // namespace polymesh
