// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"

namespace polymesh {

/// Splits two cells that share faces as one: the shared faces go, and where one point sees all the
/// others the cells become pyramids on these. Faces of further cells stay. False, and nothing is
/// changed, when the two do not make a ball or no such point is found. With `mayFold` a point
/// behind all faces will do (innerPoint.h).
bool splitTogether(MeshEditor& editor, Label cell, Label other, bool mayFold = false);

} // namespace polymesh
