// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/ply/ply.h"

#include "formats/ply/header.h"
#include "formats/textScanner.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/surface/surfaceBuilder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace polymesh::ply {

namespace {

static_assert(std::endian::native == std::endian::little, "other byte orders are not supported");

/// Values of a text body.
class TextValues {
public:
    explicit TextValues(TextScanner scanner) : scanner_(std::move(scanner)) {}

    double number(Type) { return scanner_.number(); }

    std::int64_t integer(Type) {
        const std::int64_t value = scanner_.integer();
        if (!scanner_.isAtWordEnd()) fail("expected a whole number");
        return value;
    }

    void skip(Type) {
        if (scanner_.word().empty()) fail("the file ends before its last element");
    }

    [[noreturn]] void fail(std::string_view message) const { scanner_.fail(message); }

private:
    TextScanner scanner_;
};

/// Values of a binary body.
class BinaryValues {
public:
    BinaryValues(std::string_view bytes, std::size_t bodyOffset, std::string fileName, bool swap)
        : bytes_(bytes), at_(bodyOffset), fileName_(std::move(fileName)), swap_(swap) {}

    double number(Type type) {
        const double value = type == Type::float64   ? load<double>()
                             : type == Type::float32 ? static_cast<double>(load<float>())
                                                     : static_cast<double>(integer(type));
        if (!std::isfinite(value)) fail(fmt::format("a coordinate is {}", value));
        return value;
    }

    /// Requires: an integer type.
    std::int64_t integer(Type type) {
        switch (type) {
        case Type::int8:
            return load<std::int8_t>();
        case Type::uint8:
            return load<std::uint8_t>();
        case Type::int16:
            return load<std::int16_t>();
        case Type::uint16:
            return load<std::uint16_t>();
        case Type::int32:
            return load<std::int32_t>();
        default:
            return load<std::uint32_t>();
        }
    }

    void skip(Type type) {
        constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
        take(sizes[static_cast<std::size_t>(type)]);
    }

    [[noreturn]] void fail(std::string_view message) const {
        throw InputError(fmt::format("{}: at byte {}: {}", fileName_, at_, message));
    }

private:
    const char* take(std::size_t size) {
        if (bytes_.size() - at_ < size) fail("the file ends before its last element");
        at_ += size;
        return bytes_.data() + at_ - size;
    }

    template<class T>
    T load() {
        std::array<char, sizeof(T)> raw{};
        std::memcpy(raw.data(), take(sizeof(T)), sizeof(T));
        if (swap_) std::ranges::reverse(raw);
        return std::bit_cast<T>(raw);
    }

    std::string_view bytes_;
    std::size_t at_;
    std::string fileName_;
    bool swap_;
};

template<class Values>
void skipProperty(Values& values, const Property& property) {
    std::int64_t count = property.countType ? values.integer(*property.countType) : 1;
    for (; count > 0; --count)
        values.skip(property.type);
}

/// Reads the body of a file; one per byte layout.
template<class Values>
class BodyReader {
public:
    explicit BodyReader(Values values) : values_(std::move(values)) {}

    TriSurface read(const Header& header, std::string_view name) {
        for (const Element& element : header.elements)
            readElement(element);
        return builder_.finish(name);
    }

private:
    void readElement(const Element& element) {
        if (element.name == "vertex") {
            readVertices(element);
        } else if (element.name == "face") {
            readFaces(element);
        } else if (!element.properties.empty()) {
            for (std::int64_t row = 0; row < element.count; ++row)
                for (const Property& property : element.properties)
                    skipProperty(values_, property);
        }
    }

    void readVertices(const Element& element) {
        const auto axes = axesOf(element);
        for (std::int64_t row = 0; row < element.count; ++row) {
            Vec3 point;
            for (std::size_t i = 0; i < axes.size(); ++i) {
                const Property& property = element.properties[i];
                if (axes[i] < 0)
                    skipProperty(values_, property);
                else
                    point[axes[i]] = values_.number(property.type);
            }
            labels_.push_back(builder_.addPoint(point));
        }
    }

    /// The coordinate that each property is, -1 for none.
    std::vector<int> axesOf(const Element& element) const {
        std::vector<int> axes;
        for (const Property& property : element.properties) {
            const auto axis = std::string_view("xyz").find(property.name);
            const bool isAxis = property.name.size() == 1 && axis != std::string_view::npos;
            axes.push_back(isAxis && !property.countType ? static_cast<int>(axis) : -1);
        }
        for (int axis = 0; axis < 3; ++axis)
            if (std::ranges::count(axes, axis) != 1)
                values_.fail("the header must give each vertex x, y and z once");
        return axes;
    }

    static bool isCorners(const Property& property) {
        return property.name == "vertex_indices" || property.name == "vertex_index";
    }

    void readFaces(const Element& element) {
        if (std::ranges::count_if(element.properties, isCorners) != 1)
            values_.fail("the header must give each face one list vertex_indices");
        const auto corners = std::ranges::find_if(element.properties, isCorners);
        if (!corners->countType || corners->type >= Type::float32)
            values_.fail("vertex_indices must be a list of integers");
        const Label region = builder_.addRegion("");
        for (std::int64_t row = 0; row < element.count; ++row) {
            for (const Property& property : element.properties) {
                if (&property == &*corners)
                    readFace(property, region);
                else
                    skipProperty(values_, property);
            }
        }
    }

    void readFace(const Property& property, Label region) {
        corners_.clear();
        for (std::int64_t left = values_.integer(*property.countType); left > 0; --left) {
            const std::int64_t number = values_.integer(property.type);
            const auto count = static_cast<std::int64_t>(labels_.size());
            if (number < 0 || number >= count)
                values_.fail(fmt::format("a face has vertex {}, of 0 ... {}", number, count - 1));
            corners_.push_back(labels_[static_cast<std::size_t>(number)]);
        }
        builder_.addPolygon(corners_, region);
    }

    Values values_;
    SurfaceBuilder builder_;
    std::vector<Label> labels_; // of the file's vertices; grows with what is really there
    std::vector<Label> corners_;
};

TriSurface readBody(std::string_view bytes, const std::string& fileName, std::string_view name) {
    TextScanner scanner(bytes, fileName);
    const Header header = readHeader(scanner);
    if (header.encoding == Encoding::text)
        return BodyReader(TextValues(std::move(scanner))).read(header, name);
    const std::size_t bodyOffset = bytes.size() - scanner.rest().size();
    const bool swap = header.encoding == Encoding::bigEndian;
    return BodyReader(BinaryValues(bytes, bodyOffset, fileName, swap)).read(header, name);
}

template<class T>
void append(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

} // namespace

TriSurface read(std::string_view bytes, const std::string& fileName, std::string_view name) {
    TriSurface surface = readBody(bytes, fileName, name);
    require(!surface.triangles.empty(), "{}: the file has no triangles", fileName);
    return surface;
}

std::string write(const TriSurface& surface) {
    std::string bytes = fmt::format("ply\nformat binary_little_endian 1.0\n"
                                    "element vertex {}\n"
                                    "property double x\nproperty double y\nproperty double z\n"
                                    "element face {}\n"
                                    "property list uchar int vertex_indices\nend_header\n",
                                    surface.pointCount(),
                                    surface.triangleCount());
    for (const Vec3& p : surface.points)
        for (int axis = 0; axis < 3; ++axis)
            append(bytes, p[axis]);
    for (const auto& corners : surface.triangles) {
        append(bytes, std::uint8_t{3});
        for (Label corner : corners)
            append(bytes, static_cast<std::int32_t>(corner));
    }
    return bytes;
}

} // namespace polymesh::ply
