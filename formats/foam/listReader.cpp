// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/listReader.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace polymesh::foam {
namespace {

constexpr std::int64_t mostLabels = std::numeric_limits<Label>::max();

void checkRange(FoamReader& reader, std::int64_t count) {
    if (count < 0 || count >= mostLabels)
        reader.fail("list of {} elements: expected 0 to {}", count, mostLabels - 1);
}

/// The element count that a list begins with, checked against what the file can hold.
std::size_t checkedCount(FoamReader& reader, std::int64_t count, std::size_t leastBytesEach) {
    checkRange(reader, count);
    const auto size = static_cast<std::size_t>(count);
    if (size > (reader.file().mostBytesLeft() + 1) / leastBytesEach)
        reader.fail("list of {} elements: the file is too short for them; it was truncated or "
                    "the count is wrong",
                    count);
    return size;
}

/// How many elements to make room for: decompressed data vouches for its length only as it comes.
std::size_t room(FoamReader& reader, std::size_t count) {
    constexpr std::size_t mostUnseen = std::size_t{1} << 22;
    return reader.file().isCompressed() ? std::min(count, mostUnseen) : count;
}

void expectBegin(FoamReader& reader) {
    reader.expect('(', "list");
}

void expectEnd(FoamReader& reader, std::size_t count) {
    if (!reader.accept(')'))
        reader.fail("expected ')' after {} elements, found {}", count, reader.found());
}

/// Reads raw elements of type Stored and hands each to `keep`, block by block.
template<class Stored, class Keep>
void readRaw(FoamReader& reader, std::size_t count, Keep&& keep) {
    constexpr std::size_t blockSize = (std::size_t{1} << 17) / sizeof(Stored);
    std::vector<Stored> block(std::min(count, blockSize));
    for (std::size_t first = 0; first < count; first += blockSize) {
        const std::size_t size = std::min(blockSize, count - first);
        if (!reader.file().read(block.data(), size * sizeof(Stored)))
            reader.failAtByte("the file ends after some of {} elements; it was truncated", count);
        keep(std::span<const Stored>(block.data(), size));
    }
}

/// Reads the raw bytes of a non-empty binary list with its parentheses.
template<class Stored, class Keep>
void readRawList(FoamReader& reader, std::size_t count, Keep&& keep) {
    reader.expect('(', "binary list");
    readRaw<Stored>(reader, count, keep);
    if (!reader.accept(')'))
        reader.failAtByte("expected ')' after {} binary elements, found {}; the header's format or "
                          "arch is wrong, or the file is damaged",
                          count,
                          reader.found());
}

/// Appends narrowed 64-bit labels.
void appendWide(FoamReader& reader,
                std::span<const std::int64_t> block,
                std::vector<Label>& labels) {
    for (const std::int64_t value : block) {
        if (!std::in_range<Label>(value))
            reader.failAtByte("label {} just before does not fit {} bits; use a build with 64-bit "
                              "labels",
                              value,
                              8 * sizeof(Label));
        labels.push_back(static_cast<Label>(value));
    }
}

void appendRawLabels(FoamReader& reader, std::size_t count, std::vector<Label>& labels) {
    if (reader.header().labelBytes == sizeof(std::int64_t)) {
        readRawList<std::int64_t>(
            reader, count, [&](auto block) { appendWide(reader, block, labels); });
    } else {
        readRawList<std::int32_t>(reader, count, [&](auto block) {
            labels.insert(labels.end(), block.begin(), block.end());
        });
    }
}

std::vector<Label> readBinaryLabels(FoamReader& reader) {
    std::vector<Label> labels;
    const std::size_t count =
        checkedCount(reader, reader.integer("list length"), reader.header().labelBytes);
    if (count == 0) return labels; // written without parentheses
    labels.reserve(room(reader, count));
    appendRawLabels(reader, count, labels);
    return labels;
}

/// Reads a text list whose elements `readElement` reads; `Sink` has push_back and reserve.
template<class Sink, class ReadElement>
void readTextList(FoamReader& reader, Sink& sink, Label mostEqual, ReadElement&& readElement) {
    if (reader.accept('(')) { // without a count
        while (!reader.accept(')'))
            sink.push_back(readElement());
        return;
    }
    const std::int64_t count = reader.integer("list length");
    checkRange(reader, count);
    if (reader.accept('{')) {
        if (count > mostEqual)
            reader.fail("list of {} equal elements: expected at most {}", count, mostEqual);
        sink.assign(static_cast<std::size_t>(count), readElement());
        reader.expect('}', "list of equal elements");
        return;
    }
    const std::size_t size = checkedCount(reader, count, 2);
    if (size == 0 && reader.peek() != '(') return;
    expectBegin(reader);
    sink.reserve(room(reader, size));
    for (std::size_t i = 0; i < size; ++i)
        sink.push_back(readElement());
    expectEnd(reader, size);
}

bool flagFromText(FoamReader& reader) {
    const std::string text = reader.word("flag");
    for (const std::string_view yes : {"1", "true", "on", "yes", "t", "y"})
        if (text == yes) return true;
    for (const std::string_view no : {"0", "false", "off", "no", "f", "n", "none"})
        if (text == no) return false;
    reader.fail("expected 0 or 1, found '{}'", text);
}

Vec3 vectorFromText(FoamReader& reader) {
    reader.expect('(', "vector");
    const double x = reader.scalar("x coordinate");
    const double y = reader.scalar("y coordinate");
    const double z = reader.scalar("z coordinate");
    reader.expect(')', "vector");
    return {x, y, z};
}

template<class Stored>
struct RawVector {
    Stored x, y, z;
};

template<class Stored>
std::vector<Vec3> readBinaryVectors(FoamReader& reader) {
    std::vector<Vec3> vectors;
    const std::size_t count =
        checkedCount(reader, reader.integer("list length"), sizeof(RawVector<Stored>));
    if (count == 0) return vectors;
    vectors.reserve(room(reader, count));
    readRawList<RawVector<Stored>>(reader, count, [&](auto block) {
        for (const RawVector<Stored>& v : block) {
            const Vec3 vector{v.x, v.y, v.z};
            if (!isFinite(vector))
                reader.failAtByte("vector {} of the list is ({} {} {}); expected finite numbers",
                                  vectors.size(),
                                  v.x,
                                  v.y,
                                  v.z);
            vectors.push_back(vector);
        }
    });
    return vectors;
}

void checkFaceSize(FoamReader& reader, std::int64_t size, Label face) {
    if (size < 3) reader.fail("face {} has {} points; expected at least 3", face, size);
}

void closeFace(FoamReader& reader, Rows<Label>& faces) {
    if (faces.values.size() >= static_cast<std::size_t>(mostLabels))
        reader.fail("the faces have more than {} points together; use a build with 64-bit labels",
                    mostLabels);
    faces.offsets.push_back(toLabel(faces.values.size()));
}

/// One face of a faceList: 4(a b c d), or without the count.
void readFaceText(FoamReader& reader, Rows<Label>& faces) {
    std::int64_t size = 0;
    if (reader.accept('(')) {
        for (; !reader.accept(')'); ++size)
            faces.values.push_back(reader.label("point label"));
    } else {
        size = reader.integer("face size");
        reader.expect('(', "face");
        for (std::int64_t i = 0; i < size; ++i)
            faces.values.push_back(reader.label("point label"));
        expectEnd(reader, static_cast<std::size_t>(std::max<std::int64_t>(size, 0)));
    }
    checkFaceSize(reader, size, faces.size());
    closeFace(reader, faces);
}

void readFaceBinary(FoamReader& reader, Rows<Label>& faces) {
    const std::int64_t size = reader.integer("face size");
    checkFaceSize(reader, size, faces.size());
    appendRawLabels(reader, checkedCount(reader, size, reader.header().labelBytes), faces.values);
    closeFace(reader, faces);
}

Rows<Label> readFaceList(FoamReader& reader) {
    constexpr std::size_t leastBytes = 8; // 3(0 1 2), or a count and three raw labels
    Rows<Label> faces;
    std::optional<std::size_t> count;
    if (reader.peek() != '(')
        count = checkedCount(reader, reader.integer("list length"), leastBytes);
    if (count == std::size_t{0} && reader.peek() != '(') return faces;
    expectBegin(reader);
    if (count) {
        faces.offsets.reserve(room(reader, *count) + 1);
        faces.values.reserve(4 * room(reader, *count));
    }
    while (count ? index(faces.size()) < *count : reader.peek() != ')') {
        if (reader.header().binary) {
            readFaceBinary(reader, faces);
        } else {
            readFaceText(reader, faces);
        }
    }
    expectEnd(reader, index(faces.size()));
    return faces;
}

Rows<Label> readCompactFaces(FoamReader& reader) {
    Rows<Label> faces;
    faces.offsets = readLabels(reader, 1);
    faces.values = readLabels(reader, 1);
    if (faces.offsets.empty()) faces.offsets = {0};
    if (faces.offsets.front() != 0 || index(faces.offsets.back()) != faces.values.size())
        reader.failInFile("the face offsets run from {} to {}; expected 0 to {}, the label count",
                          faces.offsets.front(),
                          faces.offsets.back(),
                          faces.values.size());
    for (std::size_t i = 0; i + 1 < faces.offsets.size(); ++i) {
        const std::int64_t size = std::int64_t{faces.offsets[i + 1]} - faces.offsets[i];
        if (size < 3) reader.failInFile("face {} has {} points; expected at least 3", i, size);
    }
    return faces;
}

} // namespace

std::vector<Label> readLabels(FoamReader& reader, Label mostEqual) {
    return reader.header().binary ? readBinaryLabels(reader) : readLabelText(reader, mostEqual);
}

std::vector<Label> readLabelText(FoamReader& reader, Label mostEqual) {
    std::vector<Label> labels;
    readTextList(reader, labels, mostEqual, [&] { return reader.label("label"); });
    return labels;
}

std::vector<bool> readFlags(FoamReader& reader, Label mostEqual) {
    std::vector<bool> flags;
    if (!reader.header().binary) {
        readTextList(reader, flags, mostEqual, [&] { return flagFromText(reader); });
        return flags;
    }
    const std::size_t count = checkedCount(reader, reader.integer("list length"), 1);
    if (count == 0) return flags;
    flags.reserve(room(reader, count));
    readRawList<char>(reader, count, [&](auto block) {
        for (const char flag : block)
            flags.push_back(flag != 0);
    });
    return flags;
}

std::vector<Vec3> readVectors(FoamReader& reader) {
    if (reader.header().binary)
        return reader.header().scalarBytes == sizeof(float) ? readBinaryVectors<float>(reader)
                                                            : readBinaryVectors<double>(reader);
    std::vector<Vec3> vectors;
    readTextList(reader, vectors, 1, [&] { return vectorFromText(reader); });
    return vectors;
}

Rows<Label> readFaces(FoamReader& reader) {
    const std::string& name = reader.header().className;
    if (name == "faceCompactList") return readCompactFaces(reader);
    if (name == "faceList") return readFaceList(reader);
    reader.fail("class '{}': expected faceList or faceCompactList", name);
}

} // namespace polymesh::foam
