// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/mps/numberedEdges.h"

#include <span>
#include <utility>
#include <vector>

namespace polymesh {

/// What a cell is divided of: a mesh with its edges and the faces of its cells.
struct DividedMesh {
    const PolyMesh& mesh;
    const NumberedEdges& edges;
    const Rows<Label>& cellFaces;
};

/// The corners of a cell's faces, how they follow each other along the faces and round the nodes,
/// and the parts that mid-point subdivision makes there (paper, section 3.2).
///
/// A node is a point of the cell with the corners round it; a point at which the cell touches
/// itself is several nodes. A node of valence 3 has one part, a hexahedron. One of valence v has
/// 2v, a pyramid on each quadrilateral of its 2v-hedron: part 2j on that at its corner j (node,
/// middle of the out edge, face, middle of the in edge), part 2j + 1 on that at the in edge of
/// corner j (middle of the edge, face of j, cell, face of the corner across).
/// Laws: (1) corners of a face are in the order of its outward loop, seen from outside;
/// (2) nodes are in the order of their first corners; parts in the order of nodes.
class CellCorners {
public:
    struct Corner {
        Label position; // in mesh.faces.values
        Label point;
        Label face;
        Label outEdge; // to the next corner in the outward loop
        Label inEdge;  // from the previous one
        int next;      // corners in the outward loop
        int previous;
        int across; // corner of the same node in the face on the other side of the in edge
        int node;
        int facePart; // the part that has the quadrilateral at the corner
        int edgePart; // the part that has the quadrilateral at the in edge
    };

    struct Node {
        int firstCorner;
        int valence;
        int firstPart;
    };

    /// Loads a cell; buffers are kept, so that loading many takes no memory.
    /// Returns false when the cell is not closed: then the rest means nothing.
    bool load(const DividedMesh& divided, Label cell);

    std::span<const Corner> corners() const { return corners_; }

    const Corner& corner(int i) const { return corners_[static_cast<std::size_t>(i)]; }

    std::span<const Node> nodes() const { return nodes_; }

    Label partCount() const { return partCount_; }

    /// How many nodes have a further point, which is all but those of valence 3.
    Label apexCount() const { return apexCount_; }

    /// The two corners whose out edge is the same, one at either end, for every edge of the cell.
    std::span<const std::pair<int, int>> edgePairs() const { return pairs_; }

private:
    void addFace(const DividedMesh& divided, Label face, bool isOwned);
    bool pairEdges();
    void findNodes();

    std::vector<Corner> corners_;
    std::vector<Node> nodes_;
    std::vector<std::pair<int, int>> pairs_;
    std::vector<std::pair<Label, int>> byEdge_;
    Label partCount_ = 0;
    Label apexCount_ = 0;
};

} // namespace polymesh
