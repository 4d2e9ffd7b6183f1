// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/stitchParts.h"

#include "libpolymesh/base/disjointSets.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/initial/joinFaces.h"
#include "libpolymesh/initial/partMisfits.h"
#include "libpolymesh/surface/boxTree.h"

#include <cmath>
#include <utility>

namespace polymesh {
namespace {

/// A point on the boundary of a part.
struct BoundaryPoint {
    Label point = 0;
    Label part = 0;
    double size = Box::inf; // shortest boundary edge there [m]
};

/// By ascending point. Cost: linear.
std::vector<BoundaryPoint> boundaryPoints(const PolyMesh& mesh,
                                          const std::vector<MeshPart>& parts) {
    std::vector<Label> place(mesh.points.size(), -1);
    std::vector<BoundaryPoint> found;
    for (Label f = mesh.internalFaceCount(); f < mesh.faceCount(); ++f) {
        const auto face = mesh.faces[f];
        const Label part = partOf(parts, mesh.owner[index(f)]);
        for (std::size_t i = 0; i < face.size(); ++i) {
            const Label p = face[i];
            if (place[index(p)] < 0) {
                place[index(p)] = toLabel(found.size());
                found.push_back({p, part, Box::inf});
            }
            double& size = found[index(place[index(p)])].size;
            for (const std::size_t step : {std::size_t{1}, face.size() - 1}) {
                const Label q = face[(i + step) % face.size()];
                size = std::min(size, norm(mesh.points[index(q)] - mesh.points[index(p)]));
            }
        }
    }
    std::ranges::sort(found, {}, &BoundaryPoint::point);
    return found;
}

/// For each point the lowest of those that are one with it.
std::vector<Label> coincidentPoints(const PolyMesh& mesh,
                                    const std::vector<BoundaryPoint>& points) {
    DisjointSets merged(toLabel(mesh.points.size()));
    std::vector<Box> boxes;
    boxes.reserve(points.size());
    for (const BoundaryPoint& p : points)
        boxes.push_back({mesh.points[index(p.point)], mesh.points[index(p.point)]});
    const BoxTree tree(boxes);
    for (const BoundaryPoint& p : points) {
        const Vec3& at = mesh.points[index(p.point)];
        const double reach = stitchDistance * p.size;
        const Vec3 way{reach, reach, reach};
        tree.forEachNear({at - way, at + way}, [&](Label item) {
            const BoundaryPoint& q = points[index(item)];
            if (q.part == p.part || q.point > p.point) return;
            const double limit = std::min(reach, stitchDistance * q.size);
            if (norm(mesh.points[index(q.point)] - at) <= limit) merged.join(p.point, q.point);
        });
    }
    return std::move(merged).lowestOfEach();
}

/// A boundary face by the points that it will have.
struct KeyedFace {
    std::vector<Label> points; // ascending
    Label face = 0;
};

/// The boundary faces all of whose points are one with points of other parts, the same together.
std::vector<KeyedFace> stitchedFaces(const PolyMesh& mesh, const std::vector<Label>& merged) {
    std::vector<std::uint8_t> isShared(mesh.points.size(), 0);
    for (std::size_t p = 0; p < merged.size(); ++p)
        if (index(merged[p]) != p) isShared[p] = isShared[index(merged[p])] = 1;
    std::vector<KeyedFace> faces;
    for (Label f = mesh.internalFaceCount(); f < mesh.faceCount(); ++f) {
        const auto face = std::as_const(mesh.faces)[f];
        if (!std::ranges::all_of(face, [&](Label p) { return isShared[index(p)] != 0; })) continue;
        KeyedFace keyed{{}, f};
        for (const Label p : face)
            keyed.points.push_back(merged[index(p)]);
        std::ranges::sort(keyed.points);
        faces.push_back(std::move(keyed));
    }
    std::ranges::sort(faces, [](const KeyedFace& a, const KeyedFace& b) {
        return a.points != b.points ? a.points < b.points : a.face < b.face;
    });
    return faces;
}

Vec3 middleOf(const PolyMesh& mesh, Label face) {
    Vec3 sum;
    for (const Label p : mesh.faces[face])
        sum += mesh.points[index(p)];
    return sum / static_cast<double>(mesh.faces.rowSize(face));
}

/// Whether the normals of two faces with the same points look the same way.
bool isSameSide(const PolyMesh& mesh, const FacePair& pair, const std::vector<Label>& merged) {
    const auto a = mesh.faces[pair[0]];
    const auto b = mesh.faces[pair[1]];
    const Label first = merged[index(a[0])];
    const Label second = merged[index(a[1])];
    for (std::size_t i = 0; i < b.size(); ++i)
        if (merged[index(b[i])] == first) return merged[index(b[(i + 1) % b.size()])] == second;
    return false;
}

std::vector<FacePair> pairFaces(const PolyMesh& mesh,
                                const std::vector<MeshPart>& parts,
                                const std::vector<Label>& merged) {
    const std::vector<KeyedFace> faces = stitchedFaces(mesh, merged);
    const auto where = [&](Label face) {
        return parts[index(partOf(parts, mesh.owner[index(face)]))].where;
    };
    std::vector<FacePair> pairs;
    for (std::size_t i = 0; i < faces.size();) {
        std::size_t end = i + 1;
        while (end < faces.size() && faces[end].points == faces[i].points)
            ++end;
        if (end - i > 1) {
            const FacePair pair{faces[i].face, faces[i + 1].face};
            const Vec3 at = middleOf(mesh, pair[0]);
            require(end - i == 2 && !isSameSide(mesh, pair, merged),
                    "{}: overlaps the part at {} near ({:.6g} {:.6g} {:.6g}); move or shrink one "
                    "of them",
                    where(pair[1]),
                    where(pair[0]),
                    at.x,
                    at.y,
                    at.z);
            pairs.push_back(pair);
        }
        i = end;
    }
    return pairs;
}

/// Refuses a part that is not joined with the first one, by way of others perhaps.
void refuseLoose(const PolyMesh& mesh,
                 const std::vector<MeshPart>& parts,
                 const std::vector<FacePair>& pairs) {
    DisjointSets groups(toLabel(parts.size()));
    for (const auto& [a, b] : pairs)
        groups.join(partOf(parts, mesh.owner[index(a)]), partOf(parts, mesh.owner[index(b)]));
    const std::vector<Label> group = std::move(groups).lowestOfEach();
    const auto loose = std::ranges::find_if(group, [](Label g) { return g != 0; });
    if (loose == group.end()) return;
    const auto part = static_cast<std::size_t>(loose - group.begin());
    const Gap gap = nearestOther(mesh, parts, group, toLabel(part));
    throw InputError(
        fmt::format("{}: misses the other parts: no face is common with one of them; the nearest "
                    "is that at {}, {:.6g} m from ({:.6g} {:.6g} {:.6g}); parts must touch with "
                    "the same faces",
                    parts[part].where,
                    parts[index(gap.otherPart)].where,
                    gap.distance,
                    gap.place.x,
                    gap.place.y,
                    gap.place.z));
}

} // namespace

void stitchParts(PolyMesh& mesh, const std::vector<MeshPart>& parts) {
    std::vector<Label> merged = coincidentPoints(mesh, boundaryPoints(mesh, parts));
    const std::vector<FacePair> pairs = pairFaces(mesh, parts, merged);
    refuseMisfits(mesh, parts, pairs);
    refuseLoose(mesh, parts, pairs);
    joinFaces(mesh, std::move(merged), pairs);
}

} // namespace polymesh
