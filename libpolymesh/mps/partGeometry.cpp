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

/// Shallower points would make thin parts.
constexpr Search search{.least = 3e-4};

double scaled(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double lengths = norm(a) * norm(b) * norm(c);
    return lengths > 0 ? dot(cross(a, b), c) / lengths : 0;
}

bool isInvertedAt(const PartPoints& parts, const PartCorner& corner) {
    const Vec3& at = parts.at(corner[0]);
    return isInverted(parts.at(corner[1]) - at, parts.at(corner[2]) - at, parts.at(corner[3]) - at);
}

/// The quadrilateral at a corner: node, middle of the out edge, face, middle of the in edge.
std::array<Label, 4> faceQuad(const PartPoints& parts, const Corner& c) {
    return {c.point, parts.middle(c.outEdge), parts.ofFace(c.face), parts.middle(c.inEdge)};
}

/// The quadrilateral at a corner's in edge: its middle, the corner's face, the cell, the other
/// face.
std::array<Label, 4> edgeQuad(const PartPoints& parts, const Corner& c) {
    return {parts.middle(c.inEdge),
            parts.ofFace(c.face),
            parts.centre(),
            parts.ofFace(parts.cell.corner(c.across).face)};
}

/// The points of the hexahedron of a node, but for that of the cell. The out edge of corner k is
/// the in edge of the corner before it round the node.
struct HexPoints {
    Label node;
    std::array<Label, 3> in;   // middles of the in edges of the three corners
    std::array<Label, 3> face; // their faces

    PartCorner atNode() const { return {node, in[2], in[1], in[0]}; }

    PartCorner atEdge(std::size_t k) const { return {in[k], face[k], node, face[(k + 1) % 3]}; }

    PartCorner atFace(std::size_t k, Label centre) const {
        return {face[k], in[(k + 2) % 3], in[k], centre};
    }

    PartCorner atCentre(Label centre) const { return {centre, face[0], face[1], face[2]}; }
};

HexPoints hexPoints(const PartPoints& parts, const CellCorners::Node& node) {
    HexPoints points{parts.cell.corner(node.firstCorner).point, {}, {}};
    int i = node.firstCorner;
    for (std::size_t k = 0; k < 3; ++k) {
        const Corner& c = parts.cell.corner(i);
        points.in[k] = parts.middle(c.inEdge);
        points.face[k] = parts.ofFace(c.face);
        i = c.across;
    }
    return points;
}

/// Calls use(corner) for the 8 corners of the hexahedron of a node until it returns true.
template<class Use>
bool anyHexCorner(const PartPoints& parts, const CellCorners::Node& node, Use&& use) {
    const HexPoints hex = hexPoints(parts, node);
    if (use(hex.atNode())) return true;
    for (std::size_t k = 0; k < 3; ++k)
        if (use(hex.atEdge(k)) || use(hex.atFace(k, parts.centre()))) return true;
    return use(hex.atCentre(parts.centre()));
}

/// Calls use(corner) for those of the corners of a node's hexahedron that its cell's point takes no
/// part in until it returns true.
template<class Use>
bool anyOuterHexCorner(const PartPoints& parts, const CellCorners::Node& node, Use&& use) {
    const HexPoints hex = hexPoints(parts, node);
    return use(hex.atNode()) || use(hex.atEdge(0)) || use(hex.atEdge(1)) || use(hex.atEdge(2));
}

/// The same for the corners that it takes part in.
template<class Use>
bool anyInnerHexCorner(const PartPoints& parts, const CellCorners::Node& node, Use&& use) {
    const HexPoints hex = hexPoints(parts, node);
    const Label centre = parts.centre();
    return use(hex.atFace(0, centre)) || use(hex.atFace(1, centre)) || use(hex.atFace(2, centre)) ||
           use(hex.atCentre(centre));
}

/// Calls use(corner) for the 4 corners of the base of each pyramid of a node until it returns true.
template<class Use>
bool anyPyramidCorner(const PartPoints& parts,
                      const CellCorners::Node& node,
                      Label apex,
                      Use&& use) {
    int i = node.firstCorner;
    for (int k = 0; k < node.valence; ++k) {
        const Corner& c = parts.cell.corner(i);
        for (const auto& quad : {faceQuad(parts, c), edgeQuad(parts, c)})
            for (std::size_t q = 0; q < 4; ++q)
                if (use(PartCorner{quad[q], quad[(q + 3) % 4], quad[(q + 1) % 4], apex}))
                    return true;
        i = c.across;
    }
    return false;
}

/// Calls use(corner) for all corners of all parts until it returns true.
template<class Use>
bool anyPartCorner(const PartPoints& parts, Use&& use) {
    Label apex = parts.firstApex;
    for (const CellCorners::Node& node : parts.cell.nodes())
        if (node.valence == 3 ? anyHexCorner(parts, node, use)
                              : anyPyramidCorner(parts, node, apex++, use))
            return true;
    return false;
}

double reachOf(const PartPoints& parts, const Vec3& from) {
    double reach = 0;
    for (const Corner& c : parts.cell.corners())
        reach = std::max(reach, squaredNorm(parts.at(parts.ofFace(c.face)) - from));
    return std::sqrt(reach);
}

Vec3 apexOf(const PartPoints& parts, const CellCorners::Node& node, Apices which) {
    Vec3 sum = parts.at(parts.cell.corner(node.firstCorner).point) + parts.at(parts.centre());
    for (int k = 0, i = node.firstCorner; k < node.valence; ++k) {
        const Corner& c = parts.cell.corner(i);
        sum += parts.at(parts.middle(c.inEdge)) + parts.at(parts.ofFace(c.face));
        i = c.across;
    }
    const std::array<Vec3, 1> mean{sum / (2.0 * node.valence + 2.0)};
    PartPoints own = parts;
    own.apices = mean;
    const auto isBad = [&](const PartCorner& corner) { return isInvertedAt(own, corner); };
    if (which == Apices::means || !anyPyramidCorner(own, node, own.firstApex, isBad))
        return mean[0];
    std::vector<HalfSpace> halfSpaces;
    double reach = 0;
    anyPyramidCorner(own, node, own.firstApex, [&](const PartCorner& corner) {
        const Vec3& at = own.at(corner[0]);
        addHalfSpace(own.at(corner[1]) - at, own.at(corner[2]) - at, at, halfSpaces);
        reach = std::max(reach, squaredNorm(mean[0] - at));
        return false;
    });
    return pointWithin(halfSpaces, mean[0], std::sqrt(reach), search).value_or(mean[0]);
}

} // namespace

bool isInverted(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double d = dot(cross(a, b), c);
    const double lengths = squaredNorm(a) * squaredNorm(b) * squaredNorm(c);
    return !(d > 0) || !(d * d > leastJacobian * leastJacobian * lengths);
}

void addPartCorners(const PartPoints& parts, std::vector<PartCorner>& corners) {
    anyPartCorner(parts, [&](const PartCorner& corner) {
        corners.push_back(corner);
        return false;
    });
}

double leastScaledJacobian(const PartPoints& parts) {
    double least = 1;
    anyPartCorner(parts, [&](const PartCorner& corner) {
        const Vec3& at = parts.at(corner[0]);
        least = std::min(
            least,
            scaled(parts.at(corner[1]) - at, parts.at(corner[2]) - at, parts.at(corner[3]) - at));
        return false;
    });
    return least;
}

bool hasInvertedPart(const PartPoints& parts) {
    return anyPartCorner(parts,
                         [&](const PartCorner& corner) { return isInvertedAt(parts, corner); });
}

bool isNeverRight(const PartPoints& parts) {
    const auto isBad = [&](const PartCorner& corner) { return isInvertedAt(parts, corner); };
    return std::ranges::any_of(parts.cell.nodes(), [&](const CellCorners::Node& node) {
        return node.valence == 2 || (node.valence == 3 && anyOuterHexCorner(parts, node, isBad));
    });
}

bool hasInvertedInside(const PartPoints& parts) {
    const auto isBad = [&](const PartCorner& corner) { return isInvertedAt(parts, corner); };
    Label apex = parts.firstApex;
    return std::ranges::any_of(parts.cell.nodes(), [&](const CellCorners::Node& node) {
        return node.valence == 3 ? anyInnerHexCorner(parts, node, isBad)
                                 : anyPyramidCorner(parts, node, apex++, isBad);
    });
}

Vec3 cellPoint(const PartPoints& parts, const Vec3& start) {
    std::vector<HalfSpace> halfSpaces;
    const auto add = [&](Label a, Label b, Label at) {
        addHalfSpace(
            parts.at(a) - parts.at(at), parts.at(b) - parts.at(at), parts.at(at), halfSpaces);
    };
    for (const Corner& c : parts.cell.corners())
        add(parts.middle(c.outEdge), parts.middle(c.inEdge), parts.ofFace(c.face));
    for (const CellCorners::Node& node : parts.cell.nodes()) {
        if (node.valence != 3) continue;
        const Corner& a = parts.cell.corner(node.firstCorner);
        const Corner& b = parts.cell.corner(a.across);
        add(parts.ofFace(parts.cell.corner(b.across).face),
            parts.ofFace(b.face),
            parts.ofFace(a.face));
    }
    return pointWithin(halfSpaces, start, reachOf(parts, start), search).value_or(start);
}

void addApices(const PartPoints& parts, Apices which, std::vector<Vec3>& apices) {
    for (const CellCorners::Node& node : parts.cell.nodes())
        if (node.valence != 3) apices.push_back(apexOf(parts, node, which));
}

} // namespace polymesh
