// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/inputFile.h"

#include "libpolymesh/base/error.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <limits>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <zlib.h>

namespace polymesh::foam {
namespace {

constexpr std::size_t windowBytes = std::size_t{1} << 18; // fits a core's second-level cache
constexpr std::uint64_t largestInflation = 1032;          // what deflate can reach at most

std::string systemMessage() {
    return std::generic_category().message(errno);
}

} // namespace

struct InputFile::Source {
    std::filesystem::path path; // empty: memory
    int descriptor = -1;
    gzFile gzip = nullptr;
    std::uint64_t storedBytes = std::numeric_limits<std::uint64_t>::max();

    explicit Source(const std::filesystem::path& file) : path(file) {}

    ~Source() {
        if (gzip != nullptr) {
            gzclose_r(gzip);
        } else if (descriptor >= 0) {
            ::close(descriptor);
        }
    }

    Source(const Source&) = delete;
    Source& operator=(const Source&) = delete;

    void open(bool compressed) {
        descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
        require(descriptor >= 0, "{}: cannot be opened: {}", path.string(), systemMessage());

        struct stat status {};

        require(::fstat(descriptor, &status) == 0 && !S_ISDIR(status.st_mode),
                "{}: expected a file, found a directory",
                path.string());
        if (S_ISREG(status.st_mode)) storedBytes = static_cast<std::uint64_t>(status.st_size);
        if (!compressed) return;
        gzip = gzdopen(descriptor, "rb");
        require(gzip != nullptr, "{}: not enough memory to decompress it", path.string());
        gzbuffer(gzip, windowBytes);
    }

    /// Reads up to `bytes`; fewer only at the end of the file.
    std::size_t read(char* target, std::size_t bytes) const {
        std::size_t done = 0;
        while (done < bytes) {
            const std::size_t part = readSome(target + done, bytes - done);
            if (part == 0) break;
            done += part;
        }
        return done;
    }

private:
    std::size_t readSome(char* target, std::size_t bytes) const {
        constexpr std::size_t mostAtOnce = std::size_t{1} << 30;
        bytes = std::min(bytes, mostAtOnce);
        if (gzip != nullptr) return inflateSome(target, static_cast<unsigned>(bytes));
        while (descriptor >= 0) {
            const ssize_t part = ::read(descriptor, target, bytes);
            if (part >= 0) return static_cast<std::size_t>(part);
            require(errno == EINTR, "{}: cannot be read: {}", path.string(), systemMessage());
        }
        return 0;
    }

    std::size_t inflateSome(char* target, unsigned bytes) const {
        const int part = gzread(gzip, target, bytes);
        int problem = Z_OK;
        const char* message = gzerror(gzip, &problem);
        require(problem != Z_BUF_ERROR,
                "{}: the compressed file ends too early; it was truncated",
                path.string());
        require(part >= 0 && (problem == Z_OK || problem == Z_STREAM_END),
                "{}: the compressed file is damaged ({})",
                path.string(),
                problem == Z_ERRNO ? systemMessage() : std::string(message));
        return static_cast<std::size_t>(part);
    }
};

InputFile::InputFile(const std::filesystem::path& path) {
    std::error_code ignored;
    const bool plain = std::filesystem::exists(path, ignored);
    std::filesystem::path file = path;
    if (!plain) file += ".gz";
    require(plain || std::filesystem::exists(file, ignored),
            "{}: no such file, and no {} either",
            path.string(),
            file.filename().string());
    name_ = file.string();
    source_ = std::make_unique<Source>(file);
    source_->open(!plain);
    window_.resize(windowBytes + 1);
    here_ = end_ = window_.data();
    slide();
}

InputFile::InputFile(std::string_view contents, std::string name)
    : name_(std::move(name)), window_(contents.begin(), contents.end()), ended_(true) {
    window_.push_back('\0');
    here_ = window_.data();
    end_ = here_ + contents.size();
}

InputFile::~InputFile() = default;

void InputFile::slide() {
    const auto kept = static_cast<std::size_t>(end_ - here_);
    windowOffset_ += visitedBytes();
    std::memmove(window_.data(), here_, kept);
    const std::size_t room = windowBytes - kept;
    const std::size_t added = source_->read(window_.data() + kept, room);
    ended_ = added < room;
    here_ = window_.data();
    end_ = here_ + kept + added;
    window_[kept + added] = '\0';
}

bool InputFile::read(void* target, std::size_t bytes) {
    if (bytes == 0) return true;
    const std::size_t visible = std::min(bytes, static_cast<std::size_t>(end_ - here_));
    std::memcpy(target, here_, visible);
    here_ += visible;
    if (visible == bytes) return true;
    if (ended_) return false;
    const std::size_t rest = bytes - visible;
    const std::size_t added = source_->read(static_cast<char*>(target) + visible, rest);
    windowOffset_ += visitedBytes() + added; // the window is used up
    here_ = end_ = window_.data();
    window_[0] = '\0';
    ended_ = added < rest;
    return !ended_;
}

bool InputFile::isCompressed() const {
    return source_ != nullptr && source_->gzip != nullptr;
}

std::uint64_t InputFile::mostBytesLeft() const {
    const auto visible = static_cast<std::uint64_t>(end_ - here_);
    if (ended_) return visible;
    constexpr std::uint64_t unknown = std::numeric_limits<std::uint64_t>::max();
    if (source_->storedBytes == unknown) return unknown;
    if (isCompressed()) return source_->storedBytes * largestInflation;
    return source_->storedBytes > offset() ? source_->storedBytes - offset() : visible;
}

std::size_t InputFile::lineNumber() const {
    std::uint64_t left = offset();
    if (source_ == nullptr)
        return 1 + static_cast<std::size_t>(std::count(window_.data(), here_, '\n'));
    Source again(source_->path);
    again.open(isCompressed());
    std::size_t line = 1;
    std::vector<char> block(windowBytes);
    while (left > 0) {
        const std::size_t part =
            again.read(block.data(), std::min<std::uint64_t>(left, windowBytes));
        if (part == 0) break;
        line += static_cast<std::size_t>(std::count(block.data(), block.data() + part, '\n'));
        left -= part;
    }
    return line;
}

} // namespace polymesh::foam
