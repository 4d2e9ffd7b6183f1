// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"

#include <span>

namespace polymesh {

/// Splits a cell together with others, each of which shares faces with the cell or with one before
/// it: the faces between them go, and where one point sees all the rest they become pyramids on
/// these. Faces of further cells stay. False, and nothing is changed, when the cells do not make a
/// ball or no such point is found. With `mayFold` a point behind all faces will do (innerPoint.h).
bool splitTogether(MeshEditor& editor, Label cell, std::span<const Label> others, bool mayFold);

} // namespace polymesh
