// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/outputFile.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/parallel.h"

#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>
#include <vector>
#include <zlib.h>

namespace polymesh::foam {
namespace {

constexpr std::size_t bufferBytes = std::size_t{1} << 18;
constexpr std::size_t deflateBlock = std::size_t{1} << 19; // compressed by one thread
constexpr std::size_t deflateBatch = 32 * deflateBlock;
constexpr int deflateLevel = 4; // twice as fast as zlib's default for a few per cent more bytes

struct Deflated {
    std::string bytes;
    std::uint32_t checksum = 0;
};

/// Compresses one block on its own so that blocks run in parallel and yet join to one gzip member,
/// which simple readers can follow.
Deflated deflateAlone(std::string_view block) {
    z_stream stream{};
    constexpr int rawDeflate = -15;
    constexpr int memoryLevel = 8;
    if (deflateInit2(
            &stream, deflateLevel, Z_DEFLATED, rawDeflate, memoryLevel, Z_DEFAULT_STRATEGY) != Z_OK)
        throw WorkError("not enough memory to compress");
    Deflated result;
    const auto* bytes = reinterpret_cast<const Bytef*>(block.data());
    result.bytes.resize(deflateBound(&stream, static_cast<uLong>(block.size())) + 16);
    stream.next_in = const_cast<Bytef*>(bytes); // zlib does not write there
    stream.avail_in = static_cast<uInt>(block.size());
    stream.next_out = reinterpret_cast<Bytef*>(result.bytes.data());
    stream.avail_out = static_cast<uInt>(result.bytes.size());
    deflate(&stream, Z_SYNC_FLUSH);
    result.bytes.resize(stream.total_out);
    deflateEnd(&stream);
    result.checksum = static_cast<std::uint32_t>(crc32(0, bytes, static_cast<uInt>(block.size())));
    return result;
}

void appendLittleEndian(std::string& bytes, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8)
        bytes += static_cast<char>((value >> shift) & 0xFFU);
}

} // namespace

OutputFile::OutputFile(const std::filesystem::path& path,
                       const std::filesystem::path& finalPath,
                       bool compress)
    : name_(finalPath.string()), compress_(compress) {
    std::filesystem::path file = path;
    if (compress_) {
        file += ".gz";
        name_ += ".gz";
    }
    constexpr mode_t readWrite = 0666; // less the user's umask
    descriptor_ = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, readWrite);
    if (descriptor_ < 0) fail();
    constexpr char gzipHeader[] = {'\x1f', '\x8b', 8, 0, 0, 0, 0, 0, 0, 3};
    if (compress_) writeStored(gzipHeader, sizeof(gzipHeader)); // no name, no time: same bytes
}

OutputFile::~OutputFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::fail() const {
    const std::string reason = std::generic_category().message(errno);
    throw WorkError(fmt::format("{}: cannot be written: {}", name_, reason));
}

void OutputFile::write(std::string_view bytes) {
    if (!compress_) {
        writePlain(bytes);
        return;
    }
    while (!bytes.empty()) {
        const std::string_view part = bytes.substr(0, deflateBatch - pending_.size());
        pending_ += part;
        bytes.remove_prefix(part.size());
        if (pending_.size() == deflateBatch) compressPending();
    }
}

void OutputFile::writePlain(std::string_view bytes) {
    if (pending_.size() + bytes.size() < bufferBytes) {
        pending_ += bytes;
        return;
    }
    writeStored(pending_.data(), pending_.size());
    pending_.clear();
    if (bytes.size() < bufferBytes) {
        pending_ = bytes;
    } else {
        writeStored(bytes.data(), bytes.size());
    }
}

void OutputFile::writeStored(const char* bytes, std::size_t count) {
    constexpr std::size_t mostAtOnce = std::size_t{1} << 30;
    while (count > 0) {
        const ssize_t part = ::write(descriptor_, bytes, std::min(count, mostAtOnce));
        if (part < 0 && errno == EINTR) continue;
        if (part < 0) fail();
        bytes += part;
        count -= static_cast<std::size_t>(part);
    }
}

void OutputFile::compressPending() {
    const std::string_view all = pending_;
    const std::size_t blockCount = (all.size() + deflateBlock - 1) / deflateBlock;
    std::vector<Deflated> blocks(blockCount);
    parallelBlocks(toLabel(blockCount), 1, [&](Label block, Label, Label) {
        blocks[index(block)] = deflateAlone(all.substr(index(block) * deflateBlock, deflateBlock));
    });
    for (std::size_t i = 0; i < blockCount; ++i) {
        const auto bytes = static_cast<z_off_t>(all.substr(i * deflateBlock, deflateBlock).size());
        checksum_ = static_cast<std::uint32_t>(crc32_combine(checksum_, blocks[i].checksum, bytes));
        writeStored(blocks[i].bytes.data(), blocks[i].bytes.size());
    }
    plainBytes_ += all.size();
    pending_.clear();
}

void OutputFile::close() {
    if (compress_) {
        compressPending();
        std::string trailer("\x03\x00", 2); // an empty last block
        appendLittleEndian(trailer, checksum_);
        appendLittleEndian(trailer, static_cast<std::uint32_t>(plainBytes_)); // modulo 2^32
        writeStored(trailer.data(), trailer.size());
    } else {
        writeStored(pending_.data(), pending_.size());
        pending_.clear();
    }
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (::close(descriptor) != 0) fail(); // network disks tell only now that they are full
}

} // namespace polymesh::foam
