// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/initial/blocks.h"
#include "libpolymesh/initial/hexCells.h"

namespace polymesh {

/// The cells of `mesh`, which is blockMesh(description), as hexahedra. Points inside cells follow
/// the edges of the blocks and their gradings; on projected sides they lie on the shape. What the
/// mesh's points differ from that (they were merged, or moved onto shapes) is spread over the cell.
/// Throws InputError that begins with the place of the block: a cell is no hexahedron, also none
/// with collapsed edges, because faces were cut where blocks meet.
/// Cost: linear, in parallel.
HexCells hexCells(const BlockMeshDescription& description, const PolyMesh& mesh);

} // namespace polymesh
