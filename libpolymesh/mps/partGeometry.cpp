// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/partGeometry.h"

#include "libpolymesh/mps/pointWithin.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace polymesh {

namespace {

using Corner = CellCorners::Corner;

/// Three edges from a corner of a part to its neighbours; right-handed when the part is not
/// inverted there.
using Frame = std::array<Vec3, 3>;

double determinant(const Frame& frame) {
    return dot(cross(frame[0], frame[1]), frame[2]);
}

bool isInverted(const Frame& frame) {
    const double d = determinant(frame);
    const double lengths = squaredNorm(frame[0]) * squaredNorm(frame[1]) * squaredNorm(frame[2]);
    return !(d > 0) || !(d * d > leastJacobian * leastJacobian * lengths);
}

double scaled(const Frame& frame) {
    const double lengths = norm(frame[0]) * norm(frame[1]) * norm(frame[2]);
    return lengths > 0 ? determinant(frame) / lengths : 0;
}

/// The quadrilateral at a corner: node, middle of the out edge, face, middle of the in edge.
std::array<Vec3, 4> faceQuad(const PartPoints& parts, const std::span<const Vec3> points, int i) {
    const Corner& c = parts.cell.corner(i);
    return {points[index(c.point)],
            parts.middle(c.outEdge),
            parts.ofFace(c.face),
            parts.middle(c.inEdge)};
}

/// The quadrilateral at a corner's in edge: its middle, the corner's face, the cell, the other
/// face.
std::array<Vec3, 4> edgeQuad(const PartPoints& parts, int i) {
    const Corner& c = parts.cell.corner(i);
    return {parts.middle(c.inEdge),
            parts.ofFace(c.face),
            parts.centre(),
            parts.ofFace(parts.cell.corner(c.across).face)};
}

/// Calls use(frame) for the 8 corners of the hexahedron of a node until it returns true. Those that
/// involve the cell's point come last.
template<class Use>
bool anyHexFrame(const PartPoints& parts, const CellCorners::Node& node, Use&& use) {
    std::array<Vec3, 3> in;   // middles of the in edges of the three corners
    std::array<Vec3, 3> face; // their faces
    const Vec3 n = parts.points[index(parts.cell.corner(node.firstCorner).point)];
    for (std::size_t k = 0, i = static_cast<std::size_t>(node.firstCorner); k < 3; ++k) {
        const Corner& c = parts.cell.corner(static_cast<int>(i));
        in[k] = parts.middle(c.inEdge);
        face[k] = parts.ofFace(c.face);
        i = static_cast<std::size_t>(c.across);
    }
    // The out edge of corner k is the in edge of the corner before it round the node.
    if (use(Frame{in[2] - n, in[1] - n, in[0] - n})) return true;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t after = (k + 1) % 3;
        if (use(Frame{face[k] - in[k], n - in[k], face[after] - in[k]})) return true;
    }
    const Vec3 c = parts.centre();
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& f = face[k];
        if (use(Frame{in[(k + 2) % 3] - f, in[k] - f, c - f})) return true;
    }
    return use(Frame{face[0] - c, face[1] - c, face[2] - c});
}

/// Calls use(frame) for the 4 corners of the base of each pyramid of a node until it returns true.
template<class Use>
bool anyPyramidFrame(const PartPoints& parts,
                     const CellCorners::Node& node,
                     const Vec3& apex,
                     Use&& use) {
    int i = node.firstCorner;
    for (int k = 0; k < node.valence; ++k) {
        for (const auto& quad : {faceQuad(parts, parts.points, i), edgeQuad(parts, i)})
            for (std::size_t q = 0; q < 4; ++q) {
                const Vec3& at = quad[q];
                if (use(Frame{quad[(q + 3) % 4] - at, quad[(q + 1) % 4] - at, apex - at}))
                    return true;
            }
        i = parts.cell.corner(i).across;
    }
    return false;
}

/// Calls use(frame) for all corners of all parts until it returns true.
template<class Use>
bool anyFrame(const PartPoints& parts, Use&& use) {
    std::size_t apex = 0;
    for (const CellCorners::Node& node : parts.cell.nodes())
        if (node.valence == 3 ? anyHexFrame(parts, node, use)
                              : anyPyramidFrame(parts, node, parts.apices[apex++], use))
            return true;
    return false;
}

double reachOf(const PartPoints& parts, const Vec3& from) {
    double reach = 0;
    for (const Corner& c : parts.cell.corners())
        reach = std::max(reach, squaredNorm(parts.ofFace(c.face) - from));
    return std::sqrt(reach);
}

Vec3 apexOf(const PartPoints& parts, const CellCorners::Node& node) {
    Vec3 sum = parts.points[index(parts.cell.corner(node.firstCorner).point)] + parts.centre();
    for (int k = 0, i = node.firstCorner; k < node.valence; ++k) {
        const Corner& c = parts.cell.corner(i);
        sum += parts.middle(c.inEdge) + parts.ofFace(c.face);
        i = c.across;
    }
    const Vec3 mean = sum / (2.0 * node.valence + 2.0);
    if (!anyPyramidFrame(parts, node, mean, isInverted)) return mean;
    std::vector<HalfSpace> halfSpaces;
    double reach = 0;
    anyPyramidFrame(parts, node, mean, [&](const Frame& frame) {
        addHalfSpace(frame[0], frame[1], mean - frame[2], halfSpaces);
        reach = std::max(reach, squaredNorm(frame[2]));
        return false;
    });
    return pointWithin(halfSpaces, mean, std::sqrt(reach)).value_or(mean);
}

} // namespace

double leastScaledJacobian(const PartPoints& parts) {
    double least = 1;
    anyFrame(parts, [&](const Frame& frame) {
        least = std::min(least, scaled(frame));
        return false;
    });
    return least;
}

bool hasInvertedPart(const PartPoints& parts) {
    return anyFrame(parts, isInverted);
}

Vec3 cellPoint(const PartPoints& parts, const Vec3& start) {
    std::vector<HalfSpace> halfSpaces;
    for (const Corner& c : parts.cell.corners()) {
        const Vec3& f = parts.ofFace(c.face);
        addHalfSpace(parts.middle(c.outEdge) - f, parts.middle(c.inEdge) - f, f, halfSpaces);
    }
    for (const CellCorners::Node& node : parts.cell.nodes()) {
        if (node.valence != 3) continue;
        const Corner& a = parts.cell.corner(node.firstCorner);
        const Corner& b = parts.cell.corner(a.across);
        const Vec3& f = parts.ofFace(a.face);
        const Vec3& g = parts.ofFace(b.face);
        const Vec3& h = parts.ofFace(parts.cell.corner(b.across).face);
        addHalfSpace(h - f, g - f, f, halfSpaces);
    }
    return pointWithin(halfSpaces, start, reachOf(parts, start)).value_or(start);
}

void addApices(const PartPoints& parts, std::vector<Vec3>& apices) {
    for (const CellCorners::Node& node : parts.cell.nodes())
        if (node.valence != 3) apices.push_back(apexOf(parts, node));
}

} // namespace polymesh
