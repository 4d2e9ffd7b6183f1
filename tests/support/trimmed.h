// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/trim/trim.h"
#include "tests/support/trimOptions.h"

#include <gtest/gtest.h>

namespace polymesh::test {

/// The trimmed mesh; each of its defects is a failure of the test.
inline PolyMesh
trimmed(const PolyMesh& mesh, const TriSurface& surface, const TrimOptions& options) {
    PolyMesh result = trim(mesh, surface, options).mesh;
    for (const Defect& defect : validate(result))
        ADD_FAILURE() << defect.message;
    return result;
}

} // namespace polymesh::test
