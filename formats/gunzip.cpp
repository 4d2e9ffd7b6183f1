// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/gunzip.h"

#include "libpolymesh/base/error.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <libdeflate.h>
#include <memory>

namespace polymesh {

namespace {

constexpr std::string_view magic = "\x1f\x8b";

struct Free {
    void operator()(libdeflate_decompressor* d) const { libdeflate_free_decompressor(d); }
};

using Decompressor = std::unique_ptr<libdeflate_decompressor, Free>;

/// No content is longer: deflate packs at most 258 bytes in two bits.
std::size_t mostContent(std::string_view packed) {
    return 1032 * packed.size();
}

/// What the last four bytes say: right for a file of one member below 4 GiB, else a first guess.
std::size_t announcedContent(std::string_view packed) {
    std::uint32_t size = 0;
    if (packed.size() >= sizeof size)
        std::memcpy(&size, packed.data() + packed.size() - sizeof size, sizeof size);
    return std::min(std::size_t{size}, mostContent(packed));
}

/// Appends the content of the first member, content[0, size), to `content`, which grows as needed;
/// takes the member off `packed`. Returns false when the member is damaged.
bool unpackMember(libdeflate_decompressor* decompressor,
                  std::string_view& packed,
                  std::string& content,
                  std::size_t& size) {
    while (true) {
        std::size_t read = 0;
        std::size_t written = 0;
        const auto result = libdeflate_gzip_decompress_ex(decompressor,
                                                          packed.data(),
                                                          packed.size(),
                                                          content.data() + size,
                                                          content.size() - size,
                                                          &read,
                                                          &written);
        if (result == LIBDEFLATE_SUCCESS) {
            packed.remove_prefix(read);
            size += written;
            return true;
        }
        const bool isShort = result == LIBDEFLATE_INSUFFICIENT_SPACE;
        if (!isShort || content.size() >= size + mostContent(packed)) return false;
        content.resize(2 * content.size() + packed.size());
    }
}

} // namespace

std::string gunzip(std::string_view packed, const std::string& fileName) {
    require(packed.starts_with(magic),
            "{}: not a gzip file, though its name says so; take .gz off its name",
            fileName);
    const Decompressor decompressor(libdeflate_alloc_decompressor());
    if (decompressor == nullptr) throw std::bad_alloc();
    std::string content(announcedContent(packed), '\0');
    std::size_t size = 0;
    while (packed.starts_with(magic))
        require(unpackMember(decompressor.get(), packed, content, size),
                "{}: damaged or cut short; copy it again from where it is whole",
                fileName);
    content.resize(size);
    return content;
}

} // namespace polymesh
