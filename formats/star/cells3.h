// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"
#include "libpolymesh/shapes/baseShapes.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace polymesh::star {

// Cells of version 3. A regular cell is a line with the eight vertices of a hexahedron, of which
// some may be equal. A trimmed cell is three such lines, thus 24 labels: corners of the parent
// hexahedron that are left in their own slots 0 to 7, points where its edges were cut from slot 8
// on, then the type, a flag without use and the rotation of the cell.

inline constexpr std::size_t linesOfTrimmed = 3;
inline constexpr std::size_t trimmedLabels = 24;
inline constexpr std::size_t trimTypeSlot = 21;
inline constexpr std::size_t rotationSlot = 23;

/// Type flags at the end of a line: of a regular cell, and of the first and the other lines of a
/// trimmed one.
enum TypeFlag : Label { regularFlag = 1, trimmedFlag = -1, continuedFlag = 0 };

/// How a trimmed shape is stored.
struct TrimmedForm {
    BaseShape base = BaseShape::sammTrim1;
    Label type = 0;
    std::span<const std::uint8_t> slots;       // of each vertex of the base shape
    std::span<const std::uint8_t> faceNumbers; // STAR's, of each face: 1 to 6 those of the parent,
                                               // 7 and 8 cuts
};

/// The form of a trimmed shape; null for a regular one.
const TrimmedForm* formOf(BaseShape base);

/// The form with that type. Type 7 is two forms, of which the one with a corner in slot 0 is
/// sammTrim3. Null for an unknown type.
const TrimmedForm* formOfType(Label type, bool hasFirstCorner);

inline constexpr Label rotationCount = 24;

/// The number that a face of the parent, 1 to 6, has when the cell is not rotated, from the one
/// that it has in rotation 0 to 23.
Label unrotatedFace(Label rotation, Label face);

/// The eight slots of a regular cell, of whose vertices some may be equal: placed such that
/// OpenFOAM's star3ToFoam, which knows six ways, recognises it.
std::array<Label, 8> regularSlots(BaseShape base, std::span<const Label> vertices);

} // namespace polymesh::star
