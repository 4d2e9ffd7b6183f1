// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/partMisfits.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/surface/boxTree.h"

#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace polymesh {
namespace {

constexpr double overlapDepth = 0.1;   // of the shortest edge: more is an overlap
constexpr double nearestFaces = 0.2;   // of the shortest edge: less is a contact
constexpr double onFace = 0.01;        // of the shortest edge: less is touching
constexpr double towardsCorner = 0.98; // where faces are probed, from their middles

std::string shown(const Vec3& p) {
    return fmt::format("({:.6g} {:.6g} {:.6g})", p.x, p.y, p.z);
}

Box widened(Box box, double by) {
    const Vec3 way{by, by, by};
    return {box.min - way, box.max + way};
}

/// What decides whether two cells overlap.
struct CellBody {
    std::vector<Vec3> points;
    std::vector<Vec3> normals; // of the faces
    std::vector<Vec3> edges;   // directions, parallel ones once
    double shortest = Box::inf;

    Vec3 middle() const {
        Vec3 sum;
        for (const Vec3& p : points)
            sum += p;
        return sum / static_cast<double>(points.size());
    }
};

void addDirection(std::vector<Vec3>& directions, const Vec3& way) {
    const double length = norm(way);
    if (!(length > 0)) return;
    const Vec3 unit = way / length;
    const auto isParallel = [&](const Vec3& d) { return norm(cross(d, unit)) < 1e-6; };
    if (std::ranges::none_of(directions, isParallel)) directions.push_back(unit);
}

CellBody bodyOf(const PolyMesh& mesh, std::span<const Label> faces) {
    CellBody body;
    std::set<Label> points;
    for (const Label f : faces) {
        const auto face = mesh.faces[f];
        const Vec3& first = mesh.points[index(face[0])];
        Vec3 area;
        for (std::size_t i = 0; i < face.size(); ++i) {
            points.insert(face[i]);
            const Vec3& a = mesh.points[index(face[i])];
            const Vec3& b = mesh.points[index(face[(i + 1) % face.size()])];
            area += cross(a - first, b - first);
            addDirection(body.edges, b - a);
            body.shortest = std::min(body.shortest, norm(b - a));
        }
        addDirection(body.normals, area);
    }
    for (const Label p : points)
        body.points.push_back(mesh.points[index(p)]);
    return body;
}

/// How far two cells reach into each other along a direction; negative: they do not.
double depthAlong(const CellBody& a, const CellBody& b, const Vec3& way) {
    std::array<double, 2> low{Box::inf, Box::inf};
    std::array<double, 2> high{-Box::inf, -Box::inf};
    const std::array<const CellBody*, 2> bodies{&a, &b};
    for (std::size_t i = 0; i < 2; ++i)
        for (const Vec3& p : bodies[i]->points) {
            low[i] = std::min(low[i], dot(p, way));
            high[i] = std::max(high[i], dot(p, way));
        }
    return std::min(high[0] - low[1], high[1] - low[0]);
}

/// Whether no plane parts two convex cells, but for a little of the shorter of their edges.
bool overlap(const CellBody& a, const CellBody& b) {
    const double limit = overlapDepth * std::min(a.shortest, b.shortest);
    const auto isApart = [&](const Vec3& way) { return depthAlong(a, b, way) <= limit; };
    if (std::ranges::any_of(a.normals, isApart) || std::ranges::any_of(b.normals, isApart))
        return false;
    std::vector<Vec3> across;
    for (const Vec3& u : a.edges)
        for (const Vec3& v : b.edges)
            if (norm(cross(u, v)) > 1e-6) addDirection(across, cross(u, v));
    return std::ranges::none_of(across, isApart);
}

/// The cells of the mesh, their boxes, and those of the parts.
class PartCells {
public:
    PartCells(const PolyMesh& mesh, const std::vector<MeshPart>& parts)
        : mesh_(mesh), parts_(parts), boxes_(parts.size()) {
        for (Label f = mesh.internalFaceCount(); f < mesh.faceCount(); ++f)
            for (const Label p : mesh.faces[f])
                boxes_[index(partOf(parts, mesh.owner[index(f)]))].add(mesh.points[index(p)]);
    }

    void refuseOverlaps() {
        for (Label a = 0; a < toLabel(parts_.size()); ++a)
            for (Label b = 0; b < a; ++b)
                refuseOverlap(a, b);
    }

private:
    /// Where the boxes of two parts overlap; empty when they have no volume in common.
    std::optional<Box> common(Label a, Label b) const {
        const Box& one = boxes_[index(a)];
        const Box& other = boxes_[index(b)];
        Box box;
        for (int axis = 0; axis < 3; ++axis) {
            box.min[axis] = std::max(one.min[axis], other.min[axis]);
            box.max[axis] = std::min(one.max[axis], other.max[axis]);
            const double hair = 1e-9 * std::max(norm(one.size()), norm(other.size()));
            if (box.max[axis] - box.min[axis] <= hair) return std::nullopt;
        }
        return box;
    }

    void findCells() {
        if (!faces_.empty()) return;
        faces_ = cellFaces(mesh_);
        cellBoxes_.resize(index(mesh_.cellCount));
        for (Label c = 0; c < mesh_.cellCount; ++c)
            for (const Label f : faces_[c])
                for (const Label p : mesh_.faces[f])
                    cellBoxes_[index(c)].add(mesh_.points[index(p)]);
    }

    Label endOf(Label part) const {
        return index(part) + 1 < parts_.size() ? parts_[index(part) + 1].firstCell
                                               : mesh_.cellCount;
    }

    std::vector<Label> cellsIn(const Box& box, Label part) const {
        std::vector<Label> cells;
        for (Label c = parts_[index(part)].firstCell; c < endOf(part); ++c)
            if (overlaps(cellBoxes_[index(c)], box)) cells.push_back(c);
        return cells;
    }

    bool isOnBoundary(Label cell) const {
        return std::ranges::any_of(faces_[cell], [&](Label f) { return !mesh_.isInternal(f); });
    }

    /// Where two parts overlap, a cell on the boundary of one of them overlaps one of the other.
    void refuseOverlap(Label a, Label b) {
        const std::optional<Box> box = common(a, b);
        if (!box) return;
        findCells();
        const std::vector<Label> mine = cellsIn(*box, a);
        const std::vector<Label> others = cellsIn(*box, b);
        std::vector<Box> boxes;
        boxes.reserve(others.size());
        for (const Label c : others)
            boxes.push_back(cellBoxes_[index(c)]);
        const BoxTree tree(boxes);
        for (const Label c : mine) {
            std::optional<CellBody> body;
            const bool isOuter = isOnBoundary(c);
            tree.forEachNear(cellBoxes_[index(c)], [&](Label item) {
                const Label other = others[index(item)];
                if (!overlaps(cellBoxes_[index(c)], cellBoxes_[index(other)])) return;
                if (!isOuter && !isOnBoundary(other)) return;
                if (!body) body = bodyOf(mesh_, faces_[c]);
                require(!overlap(*body, bodyOf(mesh_, faces_[other])),
                        "{}: overlaps the part at {} near {}; move or shrink one of them",
                        parts_[index(a)].where,
                        parts_[index(b)].where,
                        shown(body->middle()));
            });
        }
    }

    const PolyMesh& mesh_;
    const std::vector<MeshPart>& parts_;
    std::vector<Box> boxes_; // of the parts
    Rows<Label> faces_;      // of the cells
    std::vector<Box> cellBoxes_;
};

/// A boundary face as a fan of triangles round its middle.
struct OuterFace {
    Label face = 0;
    Label part = 0;
    Vec3 middle;
    Vec3 normal;
    double shortest = Box::inf;
    Box box;
};

OuterFace outerFace(const PolyMesh& mesh, Label f, Label part) {
    OuterFace outer;
    outer.face = f;
    outer.part = part;
    const auto face = mesh.faces[f];
    for (const Label p : face)
        outer.middle += (1 / static_cast<double>(face.size())) * mesh.points[index(p)];
    Vec3 area;
    for (std::size_t i = 0; i < face.size(); ++i) {
        const Vec3& a = mesh.points[index(face[i])];
        const Vec3& b = mesh.points[index(face[(i + 1) % face.size()])];
        area += cross(a - outer.middle, b - outer.middle);
        outer.shortest = std::min(outer.shortest, norm(b - a));
        outer.box.add(a);
    }
    outer.normal = area / norm(area);
    return outer;
}

/// The distance from a point along a direction to a face; infinite when it is not met.
double distanceAlong(const PolyMesh& mesh, const Vec3& p, const Vec3& way, const OuterFace& outer) {
    const double slope = dot(way, outer.normal);
    const auto face = mesh.faces[outer.face];
    for (std::size_t i = 0; i < face.size(); ++i) {
        const Vec3 a = mesh.points[index(face[i])] - p;
        const Vec3 b = mesh.points[index(face[(i + 1) % face.size()])] - p;
        const Vec3 m = outer.middle - p;
        const double hair = -1e-9 * std::abs(dot(way, cross(a - m, b - m)));
        const double turn = slope < 0 ? -1 : 1;
        if (turn * dot(way, cross(m, a)) >= hair && turn * dot(way, cross(a, b)) >= hair &&
            turn * dot(way, cross(b, m)) >= hair)
            return dot(m, outer.normal) / slope;
    }
    return Box::inf;
}

/// Points all over a face: its middle, and near its corners and the middles of its edges.
std::vector<Vec3> samples(const PolyMesh& mesh, const OuterFace& outer) {
    std::vector<Vec3> points{outer.middle};
    const auto face = mesh.faces[outer.face];
    for (std::size_t i = 0; i < face.size(); ++i) {
        const Vec3& a = mesh.points[index(face[i])];
        const Vec3& b = mesh.points[index(face[(i + 1) % face.size()])];
        for (const Vec3& to : {a, 0.5 * (a + b)})
            points.push_back(outer.middle + towardsCorner * (to - outer.middle));
    }
    return points;
}

/// Refuses a face that another one, of another part, looks at from nearby.
void refuseContact(const PolyMesh& mesh,
                   const std::vector<MeshPart>& parts,
                   const OuterFace& a,
                   const OuterFace& b) {
    if (dot(a.normal, b.normal) > -0.7) return;
    const double unit = std::min(a.shortest, b.shortest);
    for (const Vec3& p : samples(mesh, a)) {
        const double gap = std::abs(distanceAlong(mesh, p, a.normal, b));
        if (gap >= nearestFaces * unit) continue;
        const std::string& one = parts[index(std::max(a.part, b.part))].where;
        const std::string& other = parts[index(std::min(a.part, b.part))].where;
        require(gap > onFace * unit,
                "{}: touches the part at {} near {}, but their faces there are not the same; give "
                "both the same cells and grading where they touch",
                one,
                other,
                shown(p));
        throw InputError(fmt::format(
            "{}: misses the part at {} by {:.3g} m near {}; let them touch with the same faces, or "
            "keep them apart by more than a fifth of a cell",
            one,
            other,
            gap,
            shown(p)));
    }
}

void refuseContacts(const PolyMesh& mesh,
                    const std::vector<MeshPart>& parts,
                    const std::vector<FacePair>& pairs) {
    std::vector<bool> isPaired(index(mesh.faceCount()), false);
    for (const FacePair& pair : pairs)
        for (const Label f : pair)
            isPaired[index(f)] = true;
    std::vector<OuterFace> faces;
    std::vector<Box> boxes;
    for (Label f = mesh.internalFaceCount(); f < mesh.faceCount(); ++f) {
        if (isPaired[index(f)]) continue;
        faces.push_back(outerFace(mesh, f, partOf(parts, mesh.owner[index(f)])));
        boxes.push_back(widened(faces.back().box, nearestFaces * faces.back().shortest));
    }
    const BoxTree tree(boxes);
    for (std::size_t i = 0; i < faces.size(); ++i)
        tree.forEachNear(boxes[i], [&](Label item) {
            const OuterFace& other = faces[index(item)];
            if (other.part != faces[i].part && overlaps(boxes[i], boxes[index(item)]))
                refuseContact(mesh, parts, faces[i], other);
        });
}

} // namespace

void refuseMisfits(const PolyMesh& mesh,
                   const std::vector<MeshPart>& parts,
                   const std::vector<FacePair>& pairs) {
    PartCells(mesh, parts).refuseOverlaps();
    refuseContacts(mesh, parts, pairs);
}

Gap nearestOther(const PolyMesh& mesh,
                 const std::vector<MeshPart>& parts,
                 const std::vector<Label>& group,
                 Label part) {
    std::vector<Label> own;
    std::vector<std::pair<Label, Label>> others; // point and part
    for (Label f = mesh.internalFaceCount(); f < mesh.faceCount(); ++f) {
        const Label of = partOf(parts, mesh.owner[index(f)]);
        for (const Label p : mesh.faces[f]) {
            if (of == part) own.push_back(p);
            if (group[index(of)] != group[index(part)]) others.emplace_back(p, of);
        }
    }
    std::vector<Box> boxes;
    boxes.reserve(others.size());
    for (const auto& [p, of] : others)
        boxes.push_back({mesh.points[index(p)], mesh.points[index(p)]});
    const BoxTree tree(boxes);
    Gap gap{Box::inf, {}, -1};
    for (const Label p : own)
        tree.searchNearest(mesh.points[index(p)], [&](Label item) {
            const auto& [q, of] = others[index(item)];
            const double distance = norm(mesh.points[index(q)] - mesh.points[index(p)]);
            if (distance < gap.distance) gap = {distance, mesh.points[index(p)], of};
            return distance * distance;
        });
    return gap;
}

} // namespace polymesh
