// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"

namespace polymesh {

/// The largest angle [rad] by which the angle inside a face at one of its corners, seen along the
/// face's normal, exceeds 180 degrees; at most 0 for a convex face.
double faceExcess(MeshEditor& editor, Label face);

/// Cuts a face from a concave corner to another corner, and the parts again, until no angle exceeds
/// 180 degrees by more than `tolerance` [rad] or no chord can be cut. A chord runs inside the face
/// and is not an edge of a cell on either side. Returns the number of cuts.
Label splitConcaveFace(MeshEditor& editor, Label face, double tolerance);

} // namespace polymesh
