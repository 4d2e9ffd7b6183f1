// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/avoidFeatures.h"

#include "libpolymesh/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace polymesh {

namespace {

/// How far edges keep from feature edges, and faces from corners, of the distance that nodes keep
/// from the surface.
constexpr double clearShare = 0.4;

/// How far a node may go in all, of that distance.
constexpr double mostWay = 1.4;

/// Of making room for one after the other.
constexpr int rounds = 6;

Box boxRound(std::span<const Vec3> points, double reach) {
    const Box box = boundingBox(points);
    const Vec3 way{reach, reach, reach};
    return {box.min - way, box.max + way};
}

/// How a feature passes an edge or a face of the mesh.
struct Passage {
    Vec3 away;                       // unit vector along which the edge or face has to go
    double distance = 0;             // [m]
    std::array<double, 2> weights{}; // of the two ends of an edge where it passes
};

/// Of a feature edge, or a point, beside an edge of the mesh.
Passage passageOf(const StraightEdge& edge, const StraightEdge& feature) {
    const SegmentPair closest = closestOnSegments(edge, feature);
    const Vec3 way = pointOn(edge, closest.onFirst) - pointOn(feature, closest.onSecond);
    Passage passage{way, norm(way), {1 - closest.onFirst, closest.onFirst}};
    // Where they cross either side will do.
    if (!(passage.distance > 1e-9 * norm(edge[1] - edge[0])))
        passage.away = cross(edge[1] - edge[0], feature[1] - feature[0]);
    const double length = norm(passage.away);
    passage.away = length > 0 ? passage.away / length : Vec3{};
    return passage;
}

Vec3 meanOf(std::span<const Vec3> points) {
    Vec3 sum;
    for (const Vec3& p : points)
        sum += p;
    return sum / static_cast<double>(points.size());
}

/// Of a corner before a face; distance infinite where it is beside it.
Passage passageOf(std::span<const Vec3> face, const Vec3& corner) {
    const Vec3 middle = meanOf(face);
    Vec3 area;
    for (std::size_t i = 0; i < face.size(); ++i)
        area += cross(face[i] - middle, face[(i + 1) % face.size()] - middle);
    const double size = norm(area);
    if (!(size > 0)) return {{}, Box::inf, {}};
    const Vec3 normal = area / size;
    for (std::size_t i = 0; i < face.size(); ++i)
        if (dot(normal, cross(face[i] - corner, face[(i + 1) % face.size()] - corner)) < 0)
            return {{}, Box::inf, {}};
    const double height = dot(middle - corner, normal);
    return {height < 0 ? -normal : normal, std::abs(height), {}};
}

StraightEdge straight(const std::vector<Vec3>& points) {
    return {points[0], points[1]};
}

} // namespace

FeatureAvoidance::FeatureAvoidance(const PolyMesh& mesh,
                                   const SurfaceTargets& targets,
                                   const std::vector<NearNode>& near,
                                   const AdjustOptions& options)
    : mesh_(mesh),
      targets_(targets),
      near_(near),
      options_(options),
      avoided_(options.avoided),
      places_(near.size()),
      isSettled_(near.size(), 0) {
    std::ranges::sort(avoided_, {}, &Vec3::x);
    placeNodes();
    findPassed();
}

template<class Visit>
void FeatureAvoidance::forAvoided(const Box& box, Visit&& visit) const {
    const auto first = std::ranges::lower_bound(avoided_, box.min.x, {}, &Vec3::x);
    for (auto p = first; p != avoided_.end() && p->x <= box.max.x; ++p)
        if (box.contains(*p)) visit(*p);
}

/// The feature edges that a region may hold, in an order that depends on nothing else; places to
/// avoid are edges without length.
std::vector<StraightEdge> FeatureAvoidance::featuresNear(const Box& box) const {
    std::vector<StraightEdge> found;
    forAvoided(box, [&](const Vec3& p) { found.push_back({p, p}); });
    if (options_.how != Adjust::avoid) return found;
    targets_.forFeatureEdges(box, [&](const Vec3& a, const Vec3& b) {
        if (overlaps(boundingBox(std::array{a, b}), box)) found.push_back({a, b});
    });
    return found;
}

/// The corners and places to avoid in a region.
std::vector<Vec3> FeatureAvoidance::cornersNear(const Box& box) const {
    std::vector<Vec3> found;
    forAvoided(box, [&](const Vec3& p) { found.push_back(p); });
    if (options_.how != Adjust::avoid) return found;
    targets_.forCorners(box, [&](const Vec3& p) {
        if (box.contains(p)) found.push_back(p);
    });
    return found;
}

void FeatureAvoidance::placeNodes() {
    for (std::size_t i = 0; i < near_.size(); ++i)
        places_[i] = mesh_.points[index(near_[i].node)];
}

CloseCounts FeatureAvoidance::count() {
    placeNodes();
    CloseCounts counts;
    for (const NearEdge& edge : passed_.edges) {
        const StraightEdge segment = straight(pointsOf(edge));
        const double clear = clearanceOf(edge);
        const auto features = featuresNear(boxRound(segment, clear));
        if (std::ranges::any_of(features, [&](const StraightEdge& feature) {
                return passageOf(segment, feature).distance < clear;
            }))
            ++counts.edges;
    }
    for (Label f = 0; f < passed_.faces.size(); ++f) {
        const auto points = pointsOf(passed_.faces[f]);
        const double clear = clearanceOf(passed_.faces[f]);
        const auto corners = cornersNear(boxRound(points, clear));
        if (std::ranges::any_of(corners, [&](const Vec3& corner) {
                return passageOf(points, corner).distance < clear;
            }))
            ++counts.faces;
    }
    return counts;
}

std::vector<NodeMove> FeatureAvoidance::extended(const std::vector<NodeMove>& moves) {
    placeNodes();
    for (const NodeMove& move : moves) {
        const auto at = std::ranges::lower_bound(near_, move.node, {}, &NearNode::node);
        const auto i = static_cast<std::size_t>(at - near_.begin());
        places_[i] = move.place;
        isSettled_[i] = move.target != AdjustTarget::away ? 1 : 0;
    }
    std::vector<std::uint8_t> isTouched(near_.size(), 0);
    for (const NearEdge& edge : passed_.edges)
        for (const Label i : edge)
            isTouched[index(i)] = 1;
    for (const Label i : passed_.faces.values)
        isTouched[index(i)] = 1;
    for (int round = 0; round < rounds; ++round) {
        for (const NearEdge& edge : passed_.edges)
            clearEdge(edge);
        for (Label f = 0; f < passed_.faces.size(); ++f)
            clearFace(passed_.faces[f]);
        for (std::size_t i = 0; i < near_.size(); ++i)
            if (isTouched[i] != 0 && isSettled_[i] == 0) clearNode(i);
    }
    std::vector<NodeMove> all = finished();
    for (const NodeMove& move : moves)
        if (move.target != AdjustTarget::away) all.push_back(move);
    std::ranges::sort(all, {}, &NodeMove::node);
    return all;
}

/// Shortest edge at the nodes times the distance that they keep.
double FeatureAvoidance::clearanceOf(std::span<const Label> nodes) const {
    double size = Box::inf;
    for (const Label i : nodes)
        size = std::min(size, near_[index(i)].size);
    return clearShare * options_.distance * size;
}

std::vector<Vec3> FeatureAvoidance::pointsOf(std::span<const Label> nodes) const {
    std::vector<Vec3> points;
    for (const Label i : nodes)
        points.push_back(places_[index(i)]);
    return points;
}

void FeatureAvoidance::findPassed() {
    std::vector<Label> nearOf(mesh_.points.size(), -1);
    for (std::size_t i = 0; i < near_.size(); ++i)
        nearOf[index(near_[i].node)] = toLabel(i);
    constexpr Label block = 4096;
    std::vector<Passed> parts(index((mesh_.faceCount() + block - 1) / block));
    parallelBlocks(mesh_.faceCount(), block, [&](Label b, Label first, Label last) {
        for (Label f = first; f < last; ++f)
            addFace(f, nearOf, parts[index(b)]);
    });
    std::vector<Rows<Label>> faces;
    for (Passed& part : parts) {
        passed_.edges.insert(passed_.edges.end(), part.edges.begin(), part.edges.end());
        faces.push_back(std::move(part.faces));
    }
    passed_.faces = joined(faces);
    std::ranges::sort(passed_.edges);
    passed_.edges.erase(std::unique(passed_.edges.begin(), passed_.edges.end()),
                        passed_.edges.end());
}

/// Looks for features as far as the face's nodes may go, and somewhat on.
void FeatureAvoidance::addFace(Label f, const std::vector<Label>& nearOf, Passed& part) const {
    std::vector<Label> nodes;
    for (const Label p : mesh_.faces[f]) {
        if (nearOf[index(p)] < 0) return;
        nodes.push_back(nearOf[index(p)]);
    }
    const double reach = (1 + mostWay / clearShare) * clearanceOf(nodes);
    const Box box = boxRound(pointsOf(nodes), reach);
    if (!featuresNear(box).empty())
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const Label a = nodes[i];
            const Label b = nodes[(i + 1) % nodes.size()];
            part.edges.push_back({std::min(a, b), std::max(a, b)});
        }
    if (!cornersNear(box).empty()) part.faces.add(nodes);
}

/// Moves a node, as far as it may go.
void FeatureAvoidance::push(Label i, const Vec3& way) {
    if (isSettled_[index(i)] != 0) return;
    const NearNode& node = near_[index(i)];
    const Vec3& from = mesh_.points[index(node.node)];
    Vec3 whole = places_[index(i)] + node.freedom.along(way) - from;
    const double length = norm(whole);
    const double most = mostWay * options_.distance * node.size;
    if (length > most) whole = (most / length) * whole;
    places_[index(i)] = node.freedom.held(from + whole, from);
}

/// Gives the edge its distance from each feature edge in turn, by the shortest ways of its ends
/// together.
void FeatureAvoidance::clearEdge(const NearEdge& edge) {
    const double clear = clearanceOf(edge);
    for (const StraightEdge& feature : featuresNear(boxRound(straight(pointsOf(edge)), clear))) {
        const Passage passage = passageOf(straight(pointsOf(edge)), feature);
        const double missing = clear - passage.distance;
        if (missing <= 0) continue;
        const auto& w = passage.weights;
        const double scale = missing / (w[0] * w[0] + w[1] * w[1]);
        push(edge[0], (scale * w[0]) * passage.away);
        push(edge[1], (scale * w[1]) * passage.away);
    }
}

void FeatureAvoidance::clearFace(std::span<const Label> nodes) {
    const double clear = clearanceOf(nodes);
    for (const Vec3& corner : cornersNear(boxRound(pointsOf(nodes), clear))) {
        const auto points = pointsOf(nodes);
        const Passage passage = passageOf(points, corner);
        const double missing = clear - passage.distance;
        if (missing <= 0) continue;
        for (const Label i : nodes)
            push(i, missing * passage.away);
    }
}

void FeatureAvoidance::clearNode(std::size_t i) {
    const double reach = options_.distance * near_[i].size;
    const ClosestPoint closest = targets_.closest(places_[i], reach);
    if (closest.triangle < 0 || closest.distance < 1e-9 * near_[i].size) return;
    push(toLabel(i),
         ((reach - closest.distance) / closest.distance) * (places_[i] - closest.point));
}

std::vector<NodeMove> FeatureAvoidance::finished() const {
    std::vector<NodeMove> moves;
    for (std::size_t i = 0; i < near_.size(); ++i) {
        const Vec3& from = mesh_.points[index(near_[i].node)];
        if (places_[i] == from || isSettled_[i] != 0) continue;
        NodeMove move;
        move.node = near_[i].node;
        move.target = AdjustTarget::away;
        move.place = places_[i];
        move.size = near_[i].size;
        move.way = norm(places_[i] - from) / near_[i].size;
        moves.push_back(move);
    }
    return moves;
}

} // namespace polymesh
