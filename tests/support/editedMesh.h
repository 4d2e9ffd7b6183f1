// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"
#include "libpolymesh/quality/meshPart.h"
#include "tests/support/meshes.h"

#include <array>

namespace polymesh::test {

/// A mesh that is being edited round its first cell.
struct EditedMesh {
    explicit EditedMesh(const PolyMesh& whole)
        : mesh(whole), part(partRound(mesh, std::array<Label, 1>{0})), editor(part.mesh) {}

    PolyMesh result() const { return withPart(mesh, part).mesh; }

    PolyMesh mesh;
    MeshPart part;
    MeshEditor editor;
};

} // namespace polymesh::test
