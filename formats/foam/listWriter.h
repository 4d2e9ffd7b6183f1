// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/foam/outputFile.h"
#include "formats/foam/writeFormat.h"
#include "libpolymesh/base/label.h"
#include "libpolymesh/base/rows.h"
#include "libpolymesh/geometry/vec3.h"

#include <array>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace polymesh::foam {

/// What stands in the header of a file.
struct HeaderText {
    std::string className;
    std::string object;
    std::string location; // such as constant/polyMesh
    std::string note;     // empty: none
};

/// Writes the FoamFile dictionary.
void writeHeader(OutputFile& file, const HeaderText& header, Format format);

/// fill(first, block) computes elements first, first + 1, ... of a list. It is called for several
/// blocks at once and so must write nothing but its block.
template<class T>
using Fill = std::function<void(Label first, std::span<T> block)>;

/// Four points of a face.
using Quad = std::array<Label, 4>;

// Lists, in text or binary as the format says, computed block by block: the memory is a few
// megabytes whatever the length. Cost: linear; text is made in parallel. Errors: WorkError.

void writeLabels(OutputFile& file, Format format, Label count, const Fill<Label>& fill);
void writeLabels(OutputFile& file, Format format, std::span<const Label> labels);
void writeFlags(OutputFile& file, Format format, const std::vector<bool>& flags);
void writeScalars(OutputFile& file, const WriteFormat& format, std::span<const double> values);
void writeVectors(OutputFile& file, const WriteFormat& format, Label count, const Fill<Vec3>& fill);
void writeVectors(OutputFile& file, const WriteFormat& format, std::span<const Vec3> vectors);

/// The class of a faces file in this format.
std::string faceListClass(Format format);
void writeFaces(OutputFile& file, Format format, const Rows<Label>& faces);
void writeQuads(OutputFile& file, Format format, Label count, const Fill<Quad>& fill);

} // namespace polymesh::foam
