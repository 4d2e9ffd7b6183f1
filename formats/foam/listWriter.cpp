// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/listWriter.h"

#include "libpolymesh/base/parallel.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace polymesh::foam {
namespace {

constexpr Label blockSize = 1 << 14; // elements made by one thread in one go
constexpr Label blocksInBatch = 32;

template<class T>
std::string_view bytesOf(std::span<const T> values) {
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

/// Writes make(first, last, bytes) for all blocks of [0, count) in order, made in parallel.
template<class Make>
void writeBlocks(OutputFile& file, Label count, Make&& make) {
    constexpr Label batchSize = blockSize * blocksInBatch;
    std::vector<std::string> bytes(blocksInBatch);
    for (std::int64_t start = 0; start < count; start += batchSize) {
        const auto first = static_cast<Label>(start);
        const Label size = std::min(batchSize, count - first);
        parallelBlocks(size, blockSize, [&](Label block, Label from, Label to) {
            bytes[index(block)].clear();
            make(first + from, first + to, bytes[index(block)]);
        });
        for (Label block = 0; block * blockSize < size; ++block)
            file.write(bytes[index(block)]);
    }
}

/// Writes the raw bytes of a list, computed block by block.
template<class T>
void writeRawBlocks(OutputFile& file, Label count, const Fill<T>& fill) {
    writeBlocks(file, count, [&](Label first, Label last, std::string& bytes) {
        std::vector<T> block(index(last - first));
        fill(first, block);
        bytes = bytesOf(std::span<const T>(block));
    });
}

/// Writes a list as text, one element a line, as append(text, element) spells it.
template<class T, class Append>
void writeTextBlocks(OutputFile& file, Label count, const Fill<T>& fill, Append&& append) {
    writeBlocks(file, count, [&](Label first, Label last, std::string& text) {
        std::vector<T> block(index(last - first));
        fill(first, block);
        for (const T& element : block)
            append(text, element);
    });
}

template<class T>
Fill<T> fillFrom(std::span<const T> values) {
    return [values](Label first, std::span<T> block) {
        const auto part = values.subspan(index(first), block.size());
        std::ranges::copy(part, block.begin());
    };
}

void beginText(OutputFile& file, std::size_t count) {
    file.write(fmt::format("{}\n(\n", count));
}

void endText(OutputFile& file) {
    file.write(")\n");
}

/// Writes a binary list; the empty one has no parentheses.
template<class WriteBytes>
void writeBinary(OutputFile& file, std::size_t count, WriteBytes&& writeBytes) {
    file.write(fmt::format("\n{}\n", count));
    if (count == 0) return;
    file.write("(");
    writeBytes();
    file.write(")");
}

void appendLabel(std::string& text, Label label) {
    std::array<char, 24> digits{};
    const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), label);
    text.append(digits.data(), result.ptr);
}

void appendLine(std::string& text, Label label) {
    appendLabel(text, label);
    text += '\n';
}

void appendScalar(std::string& text, double value, int precision) {
    std::array<char, 64> digits{};
    char* end = digits.data() + digits.size();
    const auto result =
        precision >= WriteFormat::exact
            ? std::to_chars(digits.data(), end, value)
            : std::to_chars(digits.data(), end, value, std::chars_format::general, precision);
    text.append(digits.data(), result.ptr);
}

void appendVector(std::string& text, const Vec3& v, int precision) {
    text += '(';
    appendScalar(text, v.x, precision);
    text += ' ';
    appendScalar(text, v.y, precision);
    text += ' ';
    appendScalar(text, v.z, precision);
    text += ")\n";
}

void appendFace(std::string& text, std::span<const Label> face) {
    appendLabel(text, toLabel(face.size()));
    text += '(';
    for (std::size_t i = 0; i < face.size(); ++i) {
        if (i > 0) text += ' ';
        appendLabel(text, face[i]);
    }
    text += ")\n";
}

} // namespace

void writeHeader(OutputFile& file, const HeaderText& header, Format format) {
    const bool binary = format == Format::binary;
    std::string text = "FoamFile\n{\n    version     2.0;\n";
    text += fmt::format("    format      {};\n", binary ? "binary" : "ascii");
    text += fmt::format("    class       {};\n", header.className);
    if (binary)
        text += fmt::format("    arch        \"LSB;label={};scalar=64\";\n", 8 * sizeof(Label));
    if (!header.note.empty()) text += fmt::format("    note        \"{}\";\n", header.note);
    text += fmt::format("    location    \"{}\";\n", header.location);
    text += fmt::format("    object      {};\n}}\n\n", header.object);
    file.write(text);
}

void writeLabels(OutputFile& file, Format format, Label count, const Fill<Label>& fill) {
    if (format == Format::binary) {
        writeBinary(file, index(count), [&] { writeRawBlocks(file, count, fill); });
        return;
    }
    beginText(file, index(count));
    writeTextBlocks(file, count, fill, appendLine);
    endText(file);
}

void writeLabels(OutputFile& file, Format format, std::span<const Label> labels) {
    if (format == Format::binary) {
        writeBinary(file, labels.size(), [&] { file.write(bytesOf(labels)); });
        return;
    }
    writeLabels(file, format, toLabel(labels.size()), fillFrom(labels));
}

void writeFlags(OutputFile& file, Format format, const std::vector<bool>& flags) {
    std::string text;
    const bool binary = format == Format::binary;
    for (const bool flag : flags) {
        text += static_cast<char>((binary ? 0 : '0') + (flag ? 1 : 0));
        if (!binary) text += '\n';
    }
    if (binary) {
        writeBinary(file, flags.size(), [&] { file.write(text); });
        return;
    }
    beginText(file, flags.size());
    file.write(text);
    endText(file);
}

void writeScalars(OutputFile& file, const WriteFormat& format, std::span<const double> values) {
    if (format.format == Format::binary) {
        writeBinary(file, values.size(), [&] { file.write(bytesOf(values)); });
        return;
    }
    const auto append = [&](std::string& text, double value) {
        appendScalar(text, value, format.precision);
        text += '\n';
    };
    beginText(file, values.size());
    writeTextBlocks(file, toLabel(values.size()), fillFrom(values), append);
    endText(file);
}

void writeVectors(OutputFile& file,
                  const WriteFormat& format,
                  Label count,
                  const Fill<Vec3>& fill) {
    if (format.format == Format::binary) {
        writeBinary(file, index(count), [&] { writeRawBlocks(file, count, fill); });
        return;
    }
    const auto append = [&](std::string& text, const Vec3& v) {
        appendVector(text, v, format.precision);
    };
    beginText(file, index(count));
    writeTextBlocks(file, count, fill, append);
    endText(file);
}

void writeVectors(OutputFile& file, const WriteFormat& format, std::span<const Vec3> vectors) {
    if (format.format == Format::binary) {
        writeBinary(file, vectors.size(), [&] { file.write(bytesOf(vectors)); });
        return;
    }
    writeVectors(file, format, toLabel(vectors.size()), fillFrom(vectors));
}

std::string faceListClass(Format format) {
    return format == Format::binary ? "faceCompactList" : "faceList";
}

void writeFaces(OutputFile& file, Format format, const Rows<Label>& faces) {
    if (format == Format::binary) {
        writeLabels(file, format, faces.offsets);
        writeLabels(file, format, faces.values);
        return;
    }
    beginText(file, index(faces.size()));
    writeBlocks(file, faces.size(), [&](Label first, Label last, std::string& text) {
        for (Label face = first; face < last; ++face)
            appendFace(text, faces[face]);
    });
    endText(file);
}

void writeQuads(OutputFile& file, Format format, Label count, const Fill<Quad>& fill) {
    if (format == Format::ascii) {
        beginText(file, index(count));
        writeTextBlocks(file, count, fill, appendFace);
        endText(file);
        return;
    }
    constexpr Label corners = 4;
    writeLabels(file, format, count + 1, [](Label first, std::span<Label> block) {
        for (Label& offset : block)
            offset = corners * first++;
    });
    const auto writeCorners = [&] { writeRawBlocks(file, count, fill); };
    writeBinary(file, corners * index(count), writeCorners);
}

} // namespace polymesh::foam
