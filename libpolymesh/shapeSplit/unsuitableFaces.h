// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"

namespace polymesh {

/// Cuts the faces of a cell that have more points than any shape allows, for both their cells;
/// boundary faces such that the volume that they bound stays. Returns how many. Faces that cannot
/// be cut so that all cells stay sound are left.
Label cutLargeFaces(MeshEditor& editor, Label cell);

/// Cuts the faces of a cell on which a pyramid would have its centre outside, for both their cells,
/// unless the cell beyond is acceptable as it is. Returns how many. A cell that is acceptable
/// itself is left alone.
Label cutConcaveFaces(MeshEditor& editor, Label cell);

} // namespace polymesh
