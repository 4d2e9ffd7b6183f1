// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/cellCorners.h"

#include <algorithm>

namespace polymesh {

void CellCorners::addFace(const DividedMesh& divided, Label face, bool isOwned) {
    const Rows<Label>& faces = divided.mesh.faces;
    const Label first = faces.offsets[index(face)];
    const int size = static_cast<int>(faces.rowSize(face));
    const int base = static_cast<int>(corners_.size());
    for (int i = 0; i < size; ++i) {
        const int after = i + 1 < size ? i + 1 : 0;
        const int before = i > 0 ? i - 1 : size - 1;
        const Label position = first + i;
        Label toAfter = divided.edges.ofCorner[index(position)];
        Label toBefore = divided.edges.ofCorner[index(first + before)];
        if (!isOwned) std::swap(toAfter, toBefore);
        corners_.push_back({.position = position,
                            .point = faces.values[index(position)],
                            .face = face,
                            .outEdge = toAfter,
                            .inEdge = toBefore,
                            .next = base + (isOwned ? after : before),
                            .previous = base + (isOwned ? before : after),
                            .across = -1,
                            .node = -1,
                            .facePart = -1,
                            .edgePart = -1});
    }
}

bool CellCorners::pairEdges() {
    byEdge_.clear();
    for (std::size_t i = 0; i < corners_.size(); ++i)
        byEdge_.emplace_back(corners_[i].outEdge, static_cast<int>(i));
    std::ranges::sort(byEdge_);
    pairs_.clear();
    if (byEdge_.size() % 2 != 0) return false;
    for (std::size_t i = 0; i < byEdge_.size(); i += 2) {
        const auto [edge, a] = byEdge_[i];
        const auto [twin, b] = byEdge_[i + 1];
        const bool isLastUse = i + 2 == byEdge_.size() || byEdge_[i + 2].first != edge;
        Corner& from = corners_[static_cast<std::size_t>(a)];
        Corner& to = corners_[static_cast<std::size_t>(b)];
        if (edge != twin || !isLastUse || from.point == to.point) return false;
        pairs_.emplace_back(a, b);
        corners_[static_cast<std::size_t>(from.next)].across = b;
        corners_[static_cast<std::size_t>(to.next)].across = a;
    }
    return true;
}

void CellCorners::findNodes() {
    nodes_.clear();
    partCount_ = 0;
    apexCount_ = 0;
    for (std::size_t first = 0; first < corners_.size(); ++first) {
        if (corners_[first].node >= 0) continue;
        const int node = static_cast<int>(nodes_.size());
        const int start = static_cast<int>(first);
        int valence = 0;
        for (int i = start; valence == 0 || i != start; ++valence) {
            Corner& here = corners_[static_cast<std::size_t>(i)];
            here.node = node;
            here.facePart = static_cast<int>(partCount_) + 2 * valence;
            here.edgePart = here.facePart + 1;
            i = here.across;
        }
        nodes_.push_back({start, valence, static_cast<int>(partCount_)});
        if (valence != 3) {
            partCount_ += 2 * valence;
            ++apexCount_;
            continue;
        }
        for (int k = 0, i = start; k < 3; ++k, i = corner(i).across) {
            Corner& here = corners_[static_cast<std::size_t>(i)];
            here.facePart = here.edgePart = static_cast<int>(partCount_);
        }
        ++partCount_;
    }
}

bool CellCorners::load(const DividedMesh& divided, Label cell) {
    corners_.clear();
    for (const Label face : divided.cellFaces[cell])
        addFace(divided, face, divided.mesh.owner[index(face)] == cell);
    if (!pairEdges()) return false;
    findNodes();
    return true;
}

} // namespace polymesh
