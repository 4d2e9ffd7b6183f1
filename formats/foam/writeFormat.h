// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace polymesh::foam {

enum class Format { ascii, binary };

/// How OpenFOAM files are written.
struct WriteFormat {
    /// Coordinates get the fewest digits that give the same number back.
    static constexpr int exact = 17;

    Format format = Format::binary;
    int precision = exact; // significant digits of coordinates in text
    bool compress = false; // gzip points, faces, owner and neighbour

    bool operator==(const WriteFormat&) const = default;
};

} // namespace polymesh::foam
