// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/star/cellRecords.h"

namespace polymesh::star {

/// Joins cells that couples (.cpl) say lie on each other. An integral couple is a face of a master
/// cell that the faces of slave cells tile, with the vertices of the master's face among theirs:
/// the tiles take its place, and vertices of theirs on its edges go into all faces that have these
/// edges. Couples that are not integral are left out, with a note: their faces stay boundary faces.
/// Throws InputError with the line for a cell or face that does not exist, for a face that two
/// couples replace, and for couples that leave a cell open.
void joinCouples(const TextFile& file, CellRecords& cells);

} // namespace polymesh::star
