// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"

namespace polymesh {

/// True when STAR-CD accepts the shape of a cell (shapes/recognise.h).
bool isAcceptable(const MeshEditor& editor, Label cell);

/// True when a face of the cell has more points than any face of an acceptable shape.
bool hasLargeFace(const MeshEditor& editor, Label cell);

/// True when the cell has a positive volume that is not only rounding.
bool isPositive(MeshEditor& editor, Label cell);

/// True when all cells that have changed since the mark are positive, closed beyond rounding, and
/// have no face without area.
bool areSound(MeshEditor& editor, const MeshEditor::Mark& mark);

} // namespace polymesh
