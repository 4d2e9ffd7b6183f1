// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"
#include "libpolymesh/geometry/vec3.h"

#include <cstdint>
#include <vector>

namespace polymesh {

/// What is done to nodes of the initial mesh that are near the surface.
/// avoid: as repel, and edges of the mesh keep away from feature edges, faces from corners.
enum class Adjust : std::uint8_t { none, project, repel, avoid };

struct AdjustOptions {
    Adjust how = Adjust::none;
    double distance = 0.3;         // nearer is near; fraction of the shortest edge at the node
    std::vector<Label> kept;       // nodes that stay where they are, ascending
    std::vector<Label> repelled{}; // nodes that are not projected but repelled, ascending
    std::vector<Vec3> avoided{}; // edges and faces of the mesh keep away from these places too [m]
    bool isForTrim = true;       // projected nodes stand a little inside: see SettledNode
};

/// Where a node was moved to; the first is the most important.
enum class AdjustTarget : std::uint8_t { corner, edge, face, away };

/// Passages that make short edges where the surface cuts the mesh.
struct CloseCounts {
    Label edges = 0; // of the mesh, near feature edges of the surface
    Label faces = 0; // of the mesh, near corners of the surface
};

struct AdjustCounts {
    Label corners = 0;       // nodes moved onto corners of the surface
    Label edges = 0;         // onto its feature edges
    Label faces = 0;         // onto its triangles
    Label away = 0;          // away from it
    Label refused = 0;       // left where they were for the sake of a cell
    CloseCounts closeBefore; // with avoid only
    CloseCounts closeAfter;
};

} // namespace polymesh
