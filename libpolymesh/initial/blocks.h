// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/initial/curves.h"
#include "libpolymesh/initial/grading.h"
#include "libpolymesh/initial/projection.h"
#include "libpolymesh/mesh/polyMesh.h"

#include <array>
#include <string>
#include <vector>

namespace polymesh {

/// A hexahedron that is divided into cells. Vertices in OpenFOAM's order: 0 1 2 3 round the side
/// z = 0, 4 5 6 7 above them; x runs from 0 to 1, y from 0 to 3, z from 0 to 4. Vertices may
/// repeat: edges and sides collapse, and the cells there become prisms and the like.
struct Block {
    std::array<Label, 8> vertices{};
    std::array<Label, 3> cells{1, 1, 1};
    std::array<Grading, 12> grading{}; // one per edge, in the order of hexEdges; empty: even
    std::string zone;                  // of its cells; empty: none
    std::string where;                 // "file:line", for messages
};

/// An edge between two vertices that is not straight.
struct BlockEdge {
    std::array<Label, 2> vertices{};
    Curve curve;
};

/// A side of a block by its vertices, in any order. One vertex may repeat: a triangle.
struct BlockSide {
    std::array<Label, 4> vertices{};
    std::string where; // "file:line", for messages
};

/// A side of a block that lies on a shape.
struct ProjectedSide {
    BlockSide side;
    Shape shape;
};

/// Name, type and entries of a patch, and what it is made of.
struct BlockPatch {
    Patch patch;
    std::vector<BlockSide> sides;
};

/// Two patches that lie on each other; what they have in common becomes internal.
struct PatchPair {
    std::string master;
    std::string slave;
    std::string where; // "file:line", for messages
};

/// Blocks that are described together, up to the first block of the next part.
struct BlockPart {
    Label firstBlock = 0;
    std::string where; // "file:line", for messages
};

struct BlockMeshDescription {
    std::vector<Vec3> vertices; // times scale: [m]
    double scale = 1;
    std::vector<BlockEdge> edges; // of several between the same vertices the first counts
    std::vector<ProjectedSide> projectedSides;
    std::vector<Block> blocks;
    std::vector<BlockPatch> patches;
    Patch defaultPatch{"defaultFaces", "empty", 0, 0, {}}; // of sides without a patch
    std::vector<PatchPair> mergePairs;
    std::vector<BlockPart> parts; // when there are several: they are stitched, see stitchParts.h
};

/// The mesh of a description, as OpenFOAM's blockMesh makes it: points and cells are numbered
/// block by block, x first; where blocks share a side (by its vertices) they share its points.
/// Patches come in the order given, then the default patch if any side is left over.
/// Requires: vertex labels in range, at least one cell in each direction, positive gradings.
/// Throws InputError that begins with the place: a block that is inside out, sides with different
/// numbers of cells or different points, a patch side that is no side of a block, or is inside;
/// parts that overlap or miss each other.
/// Cost: linear, in parallel.
PolyMesh blockMesh(const BlockMeshDescription& description);

} // namespace polymesh
