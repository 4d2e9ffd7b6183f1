// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"

#include <optional>
#include <vector>

namespace polymesh {

/// A point inside a cell that sees all of its faces from behind: every triangle between an edge of
/// a face and the face's centre has it on its inner side, by exact signs. Of such points one far
/// from all faces is sought; none where the search finds none. Cost: a hundred looks at each face.
std::optional<Vec3> starPoint(MeshEditor& editor, Label cell);

/// Joins the point to all faces of the cell: it becomes the pyramid over its first face, and a cell
/// is added for each of the others. Returns the pyramids; none, and nothing is changed, when the
/// cell is not a ball.
std::vector<Label> makePyramids(MeshEditor& editor, Label cell, const Vec3& apex);

} // namespace polymesh
