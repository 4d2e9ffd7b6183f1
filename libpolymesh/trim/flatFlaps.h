// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"

namespace polymesh {

/// Takes parts without thickness off cells: where a boundary face of a cell lies on another of its
/// faces and looks the other way. What it covers of that face goes to the cell beyond, with the
/// boundary face's patch, or away where nothing is beyond (the surface touches the boundary of the
/// mesh there). Holes that this leaves are cut open. Returns the number of faces taken off.
/// Call when coincident points have one label and points on edges are corners of their faces.
/// Cost: O(pairs of faces) for each cell at the boundary, in parallel; serial for what is found.
Label removeFlatFlaps(MeshEditor& editor);

} // namespace polymesh
