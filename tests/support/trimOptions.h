// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/trim/trim.h"

namespace polymesh::test {

/// The exact intersection of mesh and surface, nothing cleaned up.
inline TrimOptions exact(Keep keep = Keep::inside) {
    TrimOptions options;
    options.keep = keep;
    options.deviation = 0;
    options.minEdge = 0;
    options.minVolume = 0;
    options.mendsCells = false;
    return options;
}

} // namespace polymesh::test
