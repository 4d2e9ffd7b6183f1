// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/editMesh.h"

#include "libpolymesh/base/parallel.h"

#include <algorithm>
#include <atomic>

namespace polymesh {

namespace {

/// Calls body(cell, face) for both sides of each face, in parallel.
template<class Body>
void forSides(const EditMesh& mesh, Body&& body) {
    parallelFor(toLabel(mesh.faces.size()), [&](Label f) {
        const EditFace& face = mesh.faces[index(f)];
        if (face.isRemoved()) return;
        body(face.owner, f);
        if (face.neighbour >= 0) body(face.neighbour, f);
    });
}

Label fetchAndAdd(std::vector<Label>& counts, Label i) {
    return std::atomic_ref<Label>(counts[index(i)]).fetch_add(1, std::memory_order_relaxed);
}

} // namespace

void listFacesOfCells(EditMesh& mesh) {
    std::vector<Label> counts(mesh.cells.size(), 0);
    forSides(mesh, [&](Label c, Label) { fetchAndAdd(counts, c); });
    parallelFor(toLabel(counts.size()), [&](Label c) {
        mesh.cells[index(c)].faces.resize(index(counts[index(c)]));
        counts[index(c)] = 0;
    });
    forSides(mesh, [&](Label c, Label f) {
        mesh.cells[index(c)].faces[index(fetchAndAdd(counts, c))] = f;
    });
    // In whatever order the threads came, they stand in the same one now.
    parallelFor(toLabel(counts.size()),
                [&](Label c) { std::ranges::sort(mesh.cells[index(c)].faces); });
}

} // namespace polymesh
