// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"
#include "libpolymesh/shapes/baseShapes.h"

#include <optional>

namespace polymesh::star {

/// Shape codes of cell files of version 4.
enum ShapeCode : Label {
    pointCode = 1,
    lineCode = 2,
    shellCode = 3,
    hexahedronCode = 11,
    prismCode = 12,
    tetrahedronCode = 13,
    pyramidCode = 14,
    polyhedronCode = 255
};

/// Material codes of cell files.
enum MaterialCode : Label { fluidCode = 1, solidCode = 2, baffleCode = 3, mostMaterialCode = 6 };

inline constexpr Label labelsPerLine = 8;

} // namespace polymesh::star
