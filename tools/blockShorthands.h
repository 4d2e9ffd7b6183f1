// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/foam/dictionary.h"
#include "libpolymesh/initial/blocks.h"

namespace polymesh::tools {

/// Whether a dictionary says cartesian {...}, cylinder {...} or sphere {...}.
bool isShorthand(const foam::Dictionary& dictionary);

/// The blocks of a shorthand. Throws InputError, which begins with file and line, for wrong or
/// missing entries, and when there is more than one shorthand.
BlockMeshDescription readShorthand(const foam::Dictionary& dictionary);

} // namespace polymesh::tools
