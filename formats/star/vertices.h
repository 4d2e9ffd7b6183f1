// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/star/numberMap.h"
#include "formats/star/starFiles.h"
#include "formats/star/textFile.h"
#include "libpolymesh/geometry/vec3.h"

#include <string>
#include <vector>

namespace polymesh::star {

/// The vertices of a file of either version.
struct Vertices {
    std::string fileName;
    std::vector<Vec3> points; // [m]
    NumberMap numbers;        // of the points
};

/// Reads vertices, one a line: a number and three coordinates, which are multiplied by `scale`.
/// Numbers may have gaps. Coordinates may touch where a minus sign divides them; lines of version
/// 3 that cannot be read otherwise are read by their columns, 15 for the number and 16 for each
/// coordinate. Throws InputError with the line for anything else.
/// Cost: linear, about 300 MB/s.
Vertices readVertices(const TextFile& file, Version version, double scale);

/// The text of vertex `number` in a file of that version, with its line end, appended to `text`.
/// Version 4: as many digits as give the same coordinates back. Version 3: as many as leave a
/// blank in 16 columns, at least 9.
void appendVertex(std::string& text, Version version, Label number, const Vec3& point);

} // namespace polymesh::star
