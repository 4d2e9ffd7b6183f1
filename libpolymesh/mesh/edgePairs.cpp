// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mesh/edgePairs.h"

#include <algorithm>
#include <array>
#include <bit>

namespace polymesh {

namespace {

/// The directed edges of a cell of at most 8 points, as most have: one bit for each pair of points.
class EdgeMatrix {
public:
    /// False when the cell has more points, or the face uses an edge as another one has, or joins
    /// a point with itself: then this says no more about the cell.
    bool addFace(std::span<const Label> points, bool isReversed) {
        if (points.empty()) return true;
        unsigned previous = placeOf(points.back());
        for (const Label point : points) {
            const unsigned place = placeOf(point);
            if (place >= size || previous >= size || place == previous) return false;
            const unsigned bit = isReversed ? place * size + previous : previous * size + place;
            const std::uint64_t edge = std::uint64_t{1} << bit;
            if ((edges_ & edge) != 0) return false;
            edges_ |= edge;
            previous = place;
        }
        return true;
    }

    /// Whether each edge is used in both directions.
    bool isClosed() const { return edges_ == transposed(edges_); }

private:
    static constexpr unsigned size = 8;

    /// Where the point is, `size` when there is no room. All places are compared, as no branch
    /// could be foretold.
    unsigned placeOf(Label point) {
        unsigned found = 0;
        for (unsigned i = 0; i < size; ++i)
            found |= (points_[i] == point ? 1U : 0U) << i;
        if (found != 0) return static_cast<unsigned>(std::countr_zero(found));
        if (count_ == size) return size;
        points_[count_] = point;
        return count_++;
    }

    /// The transposed 8 x 8 matrix: squares of 1, 2, then 4 bits beside the diagonal are swapped.
    static std::uint64_t transposed(std::uint64_t m) {
        const auto swap = [&m](unsigned shift, std::uint64_t mask) {
            const std::uint64_t differing = (m ^ (m >> shift)) & mask;
            m ^= differing ^ (differing << shift);
        };
        swap(7, 0x00AA00AA00AA00AAU);
        swap(14, 0x0000CCCC0000CCCCU);
        swap(28, 0x00000000F0F0F0F0U);
        return m;
    }

    std::array<Label, size> points_{-1, -1, -1, -1, -1, -1, -1, -1};
    unsigned count_ = 0;
    std::uint64_t edges_ = 0;
};

bool isReversed(const PolyMesh& mesh, Label cell, Label face) {
    return mesh.owner[index(face)] != cell;
}

bool isClosedSmallCell(const PolyMesh& mesh, Label cell, std::span<const Label> faces) {
    EdgeMatrix edges;
    for (const Label face : faces)
        if (!edges.addFace(mesh.faces[face], isReversed(mesh, cell, face))) return false;
    return edges.isClosed();
}

void addEdges(std::span<const Label> points, bool reversed, EdgePairs& pairs) {
    Label previous = points.empty() ? -1 : points.back();
    for (const Label point : points) {
        reversed ? pairs.add(point, previous) : pairs.add(previous, point);
        previous = point;
    }
}

} // namespace

void EdgePairs::reset(std::size_t edgeCount) {
    // Half full when every edge is used twice, never full.
    const std::size_t size = std::bit_ceil(edgeCount + 2);
    mask_ = size - 1;
    slots_.assign(size, Slot{});
}

void EdgePairs::add(Label from, Label to) {
    const Label low = std::min(from, to);
    const Label high = std::max(from, to);
    const auto mix = static_cast<std::uint64_t>(low) * 0x9E3779B97F4A7C15U +
                     static_cast<std::uint64_t>(high) * 0xC2B2AE3D27D4EB4FU;
    std::size_t at = static_cast<std::size_t>(mix >> 32U) & mask_;
    while (slots_[at].low >= 0 && (slots_[at].low != low || slots_[at].high != high))
        at = (at + 1) & mask_;
    slots_[at].low = low;
    slots_[at].high = high;
    ++(from == low ? slots_[at].up : slots_[at].down);
}

std::pair<Label, Label> EdgePairs::unpaired() const {
    for (const Slot& slot : slots_)
        if (slot.low >= 0 && (slot.up != 1 || slot.down != 1)) return {slot.low, slot.high};
    return {-1, -1};
}

std::pair<Label, Label>
unpairedEdge(const PolyMesh& mesh, Label cell, std::span<const Label> faces, EdgePairs& pairs) {
    if (isClosedSmallCell(mesh, cell, faces)) return {-1, -1};
    std::size_t edgeCount = 0;
    for (const Label face : faces)
        edgeCount += index(mesh.faces.rowSize(face));
    pairs.reset(edgeCount);
    for (const Label face : faces)
        addEdges(mesh.faces[face], isReversed(mesh, cell, face), pairs);
    return pairs.unpaired();
}

} // namespace polymesh
