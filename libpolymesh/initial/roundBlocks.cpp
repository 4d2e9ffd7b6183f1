// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/roundBlocks.h"

#include "libpolymesh/initial/blockGrid.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace polymesh {
namespace {

/// The edges of the core bulge, so that cells at its corners are not too flat: the middle of an
/// edge is this share of the way from the chord to the circle.
constexpr double bulge = 0.4;

constexpr std::array<Vec3, 8> cubeCorners{{{-1, -1, -1},
                                           {1, -1, -1},
                                           {1, 1, -1},
                                           {-1, 1, -1},
                                           {-1, -1, 1},
                                           {1, -1, 1},
                                           {1, 1, 1},
                                           {-1, 1, 1}}};

std::array<Grading, 12> edgeGradings(const Grading& x, const Grading& y, const Grading& z) {
    return {x, x, x, x, y, y, y, y, z, z, z, z};
}

void addSide(BlockMeshDescription& mesh,
             const std::string& patch,
             const Block& block,
             std::size_t side) {
    auto found = mesh.patches.begin();
    while (found != mesh.patches.end() && found->patch.name != patch)
        ++found;
    if (found == mesh.patches.end())
        found = mesh.patches.insert(found, BlockPatch{{patch, "patch", 0, 0, {}}, {}});
    BlockSide added;
    for (std::size_t c = 0; c < 4; ++c)
        added.vertices[c] = block.vertices[hexSides[side][c]];
    found->sides.push_back(added);
}

/// Rings of vertices, one of each radius at both ends of a cylinder.
class CylinderBuilder {
public:
    explicit CylinderBuilder(const CylinderSpec& spec)
        : spec_(spec), axis_(spec.end2 - spec.end1), arcs_(arcCount(spec)) {
        const Vec3 z = axis_ / norm(axis_);
        // x lies in the plane of the space's x (or y) axis and the cylinder's.
        const Vec3 other = std::abs(z.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        const Vec3 y = cross(z, other);
        y_ = y / norm(y);
        x_ = cross(y_, z);
    }

    BlockMeshDescription build();

private:
    bool isWhole() const { return spec_.angle == 0; }

    bool hasCore() const { return isWhole() && spec_.holeRadius == 0; }

    /// The number of points on a ring at one end.
    Label ringSize() const { return isWhole() ? arcs_ : arcs_ + 1; }

    double angleOf(double arc) const;
    Vec3 place(double radius, double angle, bool top) const;
    Label addRing(double radius, double roundness);
    Label ringVertex(Label ring, Label arc, bool top) const;
    Block sectorBlock(Label inner, Label outer, Label arc) const;
    Block coreBlock(Label ring) const;
    void addSides(const Block& block, Label arc);

    const CylinderSpec& spec_;
    Vec3 axis_;
    Label arcs_;
    Vec3 x_;
    Vec3 y_;
    BlockMeshDescription mesh_;
};

double CylinderBuilder::angleOf(double arc) const {
    constexpr double pi = std::numbers::pi;
    // The whole begins at -45 degrees: the sides of the core are along the axes.
    if (isWhole()) return (arc - 0.5) * pi / 2;
    return (arc / static_cast<double>(arcs_) - 0.5) * spec_.angle;
}

Vec3 CylinderBuilder::place(double radius, double angle, bool top) const {
    const Vec3& end = top ? spec_.end2 : spec_.end1;
    return end + radius * std::cos(angle) * x_ + radius * std::sin(angle) * y_;
}

/// Adds the vertices and arcs of a ring; roundness 1 is a circle. Returns the first vertex.
Label CylinderBuilder::addRing(double radius, double roundness) {
    const Label first = toLabel(mesh_.vertices.size());
    for (const bool top : {false, true})
        for (Label arc = 0; arc < ringSize(); ++arc)
            mesh_.vertices.push_back(place(radius, angleOf(static_cast<double>(arc)), top));
    for (const bool top : {false, true})
        for (Label arc = 0; arc < arcs_; ++arc) {
            const double from = angleOf(static_cast<double>(arc));
            const double middle = angleOf(static_cast<double>(arc) + 0.5);
            const double flat = radius * std::cos(middle - from);
            const double there = flat + roundness * (radius - flat);
            mesh_.edges.push_back({{ringVertex(first, arc, top), ringVertex(first, arc + 1, top)},
                                   arcThrough(place(there, middle, top), "cylinder")});
        }
    return first;
}

Label CylinderBuilder::ringVertex(Label ring, Label arc, bool top) const {
    return ring + arc % ringSize() + (top ? ringSize() : 0);
}

/// Between two rings, x outwards, y around; `inner` -1: the axis, whose ends are vertices 0 and 1.
Block CylinderBuilder::sectorBlock(Label inner, Label outer, Label arc) const {
    const auto innerVertex = [&](Label a, bool top) {
        return inner < 0 ? Label{top} : ringVertex(inner, a, top);
    };
    Block block;
    for (const bool top : {false, true}) {
        const std::size_t c = top ? 4 : 0;
        block.vertices[c] = innerVertex(arc, top);
        block.vertices[c + 1] = ringVertex(outer, arc, top);
        block.vertices[c + 2] = ringVertex(outer, arc + 1, top);
        block.vertices[c + 3] = innerVertex(arc + 1, top);
    }
    block.cells = {spec_.cells[0], spec_.cells[1] / arcs_, spec_.cells[2]};
    block.grading = edgeGradings(spec_.grading[0], {}, spec_.grading[1]);
    block.where = "cylinder";
    return block;
}

Block CylinderBuilder::coreBlock(Label ring) const {
    Block block;
    // The ring begins at -45 degrees: corner 1 of a square that begins at -135.
    for (Label c = 0; c < 4; ++c) {
        block.vertices[index((c + 1) % 4)] = ringVertex(ring, c, false);
        block.vertices[index((c + 1) % 4 + 4)] = ringVertex(ring, c, true);
    }
    block.cells = {spec_.cells[1] / 4, spec_.cells[1] / 4, spec_.cells[2]};
    block.grading = edgeGradings({}, {}, spec_.grading[1]);
    block.where = "cylinder";
    return block;
}

void CylinderBuilder::addSides(const Block& block, Label arc) {
    addSide(mesh_, "bottom", block, 4);
    addSide(mesh_, "top", block, 5);
    addSide(mesh_, "side", block, 1);
    if (spec_.holeRadius > 0) addSide(mesh_, "hole", block, 0);
    if (isWhole()) return;
    if (spec_.holeRadius == 0) mesh_.defaultPatch.name = "side"; // takes the axis, without faces
    if (arc == 0) addSide(mesh_, "sectorMin", block, 2);
    if (arc == arcs_ - 1) addSide(mesh_, "sectorMax", block, 3);
}

BlockMeshDescription CylinderBuilder::build() {
    Label inner = -1;
    if (spec_.holeRadius > 0)
        inner = addRing(spec_.holeRadius, 1);
    else if (hasCore())
        inner = addRing(spec_.core * spec_.radius, bulge);
    else
        mesh_.vertices = {spec_.end1, spec_.end2};
    const Label outer = addRing(spec_.radius, 1);
    for (Label arc = 0; arc < arcs_; ++arc) {
        mesh_.blocks.push_back(sectorBlock(inner, outer, arc));
        addSides(mesh_.blocks.back(), arc);
    }
    if (hasCore()) {
        mesh_.blocks.push_back(coreBlock(inner));
        addSide(mesh_, "bottom", mesh_.blocks.back(), 4);
        addSide(mesh_, "top", mesh_.blocks.back(), 5);
    }
    return std::move(mesh_);
}

} // namespace

BlockMeshDescription boxBlocks(const GradedBox& box) {
    constexpr std::array<const char*, 6> names{"xMin", "xMax", "yMin", "yMax", "zMin", "zMax"};
    BlockMeshDescription mesh;
    for (const Vec3& c : cubeCorners)
        mesh.vertices.push_back({c.x < 0 ? box.box.min.x : box.box.max.x,
                                 c.y < 0 ? box.box.min.y : box.box.max.y,
                                 c.z < 0 ? box.box.min.z : box.box.max.z});
    Block block;
    block.vertices = {0, 1, 2, 3, 4, 5, 6, 7};
    block.cells = box.cells;
    block.grading = edgeGradings(box.grading[0], box.grading[1], box.grading[2]);
    block.where = "cartesian";
    mesh.blocks.push_back(block);
    for (std::size_t side = 0; side < 6; ++side)
        addSide(mesh, names[side], block, side);
    return mesh;
}

Label arcCount(const CylinderSpec& cylinder) {
    if (cylinder.angle == 0) return 4;
    return std::max(Label{1},
                    static_cast<Label>(std::ceil(cylinder.angle / (std::numbers::pi / 2) - 1e-9)));
}

BlockMeshDescription cylinderBlocks(const CylinderSpec& cylinder) {
    return CylinderBuilder(cylinder).build();
}

BlockMeshDescription ballBlocks(const BallSpec& ball) {
    BlockMeshDescription mesh;
    const double corner = 1 / std::sqrt(3.0);
    for (const double radius : {ball.core * ball.radius, ball.radius})
        for (const Vec3& c : cubeCorners)
            mesh.vertices.push_back(ball.centre + radius * corner * c);
    for (const auto& [a, b] : hexEdges) {
        const Vec3 middle = 0.5 * corner * (cubeCorners[a] + cubeCorners[b]);
        const Vec3 inner = (1 + bulge * (1 / norm(middle) - 1)) * middle;
        const Label p = toLabel(a);
        const Label q = toLabel(b);
        mesh.edges.push_back(
            {{p, q}, arcThrough(ball.centre + ball.core * ball.radius * inner, "sphere")});
        mesh.edges.push_back({{p + 8, q + 8}, arcAbout(ball.centre, "sphere")});
    }
    Block core;
    core.vertices = {0, 1, 2, 3, 4, 5, 6, 7};
    core.cells = {ball.cells[1], ball.cells[1], ball.cells[1]};
    core.where = "sphere";
    mesh.blocks.push_back(core);
    const Shape sphere = sphereShape(ball.centre, ball.radius);
    for (const auto& side : hexSides) {
        Block block;
        for (std::size_t c = 0; c < 4; ++c) {
            block.vertices[c] = toLabel(side[c]);
            block.vertices[c + 4] = toLabel(side[c]) + 8;
        }
        block.cells = {ball.cells[1], ball.cells[1], ball.cells[0]};
        block.grading = edgeGradings({}, {}, ball.grading);
        block.where = "sphere";
        mesh.blocks.push_back(block);
        addSide(mesh, "sphere", block, 5);
        ProjectedSide projected;
        projected.side = mesh.patches[0].sides.back();
        projected.shape = sphere;
        mesh.projectedSides.push_back(projected);
    }
    return mesh;
}

} // namespace polymesh
