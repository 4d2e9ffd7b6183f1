// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/surfaceIo.h"

#include "formats/fileBytes.h"
#include "formats/obj/obj.h"
#include "formats/off/off.h"
#include "formats/ply/ply.h"
#include "formats/stl/stl.h"
#include "libpolymesh/base/error.h"

#include <algorithm>

namespace polymesh {

namespace {

using std::filesystem::path;

path withoutGz(const path& file) {
    return file.extension() == ".gz" ? file.parent_path() / file.stem() : file;
}

std::string formatOf(const path& file) {
    std::string extension = withoutGz(file).extension().string();
    std::ranges::transform(extension, extension.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    });
    return extension;
}

[[noreturn]] void failUnknown(const path& file) {
    throw InputError(
        fmt::format("{}: unknown surface format: expected .stl, .stlb, .obj, .off or .ply, "
                    "or one of these and .gz; export the surface as one of them",
                    file.string()));
}

path findFile(const path& file) {
    path packed = file;
    packed += ".gz";
    return !exists(file) && exists(packed) ? packed : file;
}

TriSurface
parse(const std::string& bytes, const std::string& format, const path& found, const path& file) {
    const std::string name = withoutGz(file).stem().string();
    if (format == ".obj") return obj::read(bytes, found.string(), name);
    if (format == ".off") return off::read(bytes, found.string(), name);
    if (format == ".ply") return ply::read(bytes, found.string(), name);
    return stl::read(bytes, found.string(), name);
}

} // namespace

TriSurface readSurface(const path& file) {
    const std::string format = formatOf(file);
    const bool isStl = format == ".stl" || format == ".stlb";
    if (!isStl && format != ".obj" && format != ".off" && format != ".ply") failUnknown(file);
    const path found = findFile(file);
    const std::string bytes = readBytes(found);
    try {
        return parse(bytes, format, found, file);
    } catch (const InputError& error) {
        // The readers say what is wrong and where; what helps is the same for all of it.
        throw InputError(
            fmt::format("{}; correct the file there, or export the surface again", error.what()));
    }
}

void writeSurface(const TriSurface& surface, const path& file) {
    const std::string format = formatOf(file);
    if (format == ".stl") return writeBytes(file, stl::writeText(surface));
    if (format == ".stlb") return writeBytes(file, stl::writeBinary(surface));
    if (format == ".obj") return writeBytes(file, obj::write(surface));
    if (format == ".off") return writeBytes(file, off::write(surface));
    if (format == ".ply") return writeBytes(file, ply::write(surface));
    failUnknown(file);
}

} // namespace polymesh
