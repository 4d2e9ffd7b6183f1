// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/star/starFiles.h"
#include "formats/star/textFile.h"

#include <optional>

namespace polymesh::star {

/// A set of files in memory; those that may be missing are empty then.
struct FileTexts {
    TextFile vertices;
    TextFile cells;
    std::optional<TextFile> boundary;
    std::optional<TextFile> names;
    std::optional<TextFile> couples; // version 3 only
};

/// The same as reading the files by their prefix.
StarMesh read(FileTexts texts, Version version, double scale);

} // namespace polymesh::star
