// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/triangulatedFaces.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mps/pointWithin.h"

#include <algorithm>

namespace polymesh {

namespace {

using Triangles = std::vector<Triangle>;

Edge edgeOf(Label a, Label b) {
    return {std::min(a, b), std::max(a, b)};
}

/// All triangulations by diagonals of the corners first, first + 1, ..., last of a polygon.
std::vector<Triangles>
triangulations(std::span<const Label> polygon, std::size_t first, std::size_t last) {
    if (last < first + 2) return {{}};
    std::vector<Triangles> all;
    for (std::size_t middle = first + 1; middle < last; ++middle)
        for (const Triangles& left : triangulations(polygon, first, middle))
            for (const Triangles& right : triangulations(polygon, middle, last)) {
                all.push_back({{polygon[first], polygon[middle], polygon[last]}});
                all.back().insert(all.back().end(), left.begin(), left.end());
                all.back().insert(all.back().end(), right.begin(), right.end());
            }
    return all;
}

} // namespace

TriangulatedFaces::TriangulatedFaces(const PolyMesh& mesh,
                                     const SubdivisionPlan& plan,
                                     std::vector<Label> faces)
    : mesh_(mesh), plan_(plan), faces_(std::move(faces)) {
    findViewPoints();
    findTriangles();
}

/// A point that is inside all faces of a cell, taken as flat; the cell's own where there is none.
Vec3 TriangulatedFaces::viewPoint(Label cell) const {
    std::vector<HalfSpace> planes;
    const Vec3 start = plan_.points[index(plan_.layout.firstCell + cell)];
    double reach = 0;
    for (const Label face : plan_.cellFaces[cell]) {
        const FaceGeometry g = faceGeometry(mesh_.points, mesh_.faces[face]);
        const double area = norm(g.area);
        const double sense = mesh_.owner[index(face)] == cell ? -1 : 1;
        if (area > 0) planes.push_back({sense / area * g.area, g.centre});
        for (const Label p : mesh_.faces[face])
            reach = std::max(reach, norm(mesh_.points[index(p)] - start));
    }
    return pointWithin(planes, start, reach).value_or(start);
}

void TriangulatedFaces::findViewPoints() {
    for (const Label face : faces_) {
        viewCells_.push_back(mesh_.owner[index(face)]);
        if (mesh_.isInternal(face)) viewCells_.push_back(mesh_.neighbour[index(face)]);
    }
    std::ranges::sort(viewCells_);
    viewCells_.erase(std::unique(viewCells_.begin(), viewCells_.end()), viewCells_.end());
    views_.resize(viewCells_.size());
    parallelFor(toLabel(viewCells_.size()),
                [&](Label i) { views_[index(i)] = viewPoint(viewCells_[index(i)]); });
}

const Vec3& TriangulatedFaces::viewOf(Label cell) const {
    return views_[static_cast<std::size_t>(std::ranges::lower_bound(viewCells_, cell) -
                                           viewCells_.begin())];
}

const Vec3& TriangulatedFaces::middleOf(Label face) const {
    return plan_.points[index(plan_.layout.firstFace + face)];
}

bool TriangulatedFaces::areJoined(Label a, Label b) const {
    return std::ranges::binary_search(plan_.edges.points, edgeOf(a, b));
}

/// How well the cells on both sides see a triangle of a face: the least sine of the angle under
/// which, no more than its shape is good.
double TriangulatedFaces::qualityOf(Label face, const Vec3& a, const Vec3& b, const Vec3& c) const {
    const Vec3 n = cross(b - a, c - a);
    const double area = norm(n);
    const double sides = squaredNorm(b - a) + squaredNorm(c - a) + squaredNorm(c - b);
    if (!(area > 0)) return 0;
    const Vec3 middle = (a + b + c) / 3;
    const Vec3 inward = middle - viewOf(mesh_.owner[index(face)]);
    double quality = std::min(area / sides, dot(n, inward) / (area * norm(inward)));
    if (mesh_.isInternal(face)) {
        const Vec3 outward = viewOf(mesh_.neighbour[index(face)]) - middle;
        quality = std::min(quality, dot(n, outward) / (area * norm(outward)));
    }
    return quality;
}

std::vector<Triangle> TriangulatedFaces::fanOf(Label face) const {
    Triangles fan;
    const auto loop = mesh_.faces[face];
    for (std::size_t i = 0; i < loop.size(); ++i)
        fan.push_back({loop[i], loop[(i + 1) % loop.size()], -1});
    return fan;
}

double TriangulatedFaces::worstOf(Label face, const Triangles& triangles) const {
    const auto at = [&](Label p) { return p < 0 ? middleOf(face) : mesh_.points[index(p)]; };
    double worst = 1;
    for (const Triangle& t : triangles)
        worst = std::min(worst, qualityOf(face, at(t[0]), at(t[1]), at(t[2])));
    return worst;
}

/// By diagonals if that is any good, or as good as from the middle.
std::vector<Triangle> TriangulatedFaces::bestTriangles(Label face, const MayJoin& isFree) const {
    constexpr double good = 0.02;
    const auto at = [&](Label p) { return mesh_.points[index(p)]; };
    const auto loop = mesh_.faces[face];
    if (loop.size() == 3) return {{loop[0], loop[1], loop[2]}};
    Triangles seen = triangulate(loop, isFree, [&](Label a, Label b, Label c) {
        return qualityOf(face, at(a), at(b), at(c));
    });
    const double quality = seen.empty() ? 0 : worstOf(face, seen);
    if (quality > good) return seen;
    Triangles fan = fanOf(face);
    if (worstOf(face, fan) > quality) return fan;
    if (seen.empty()) seen = triangulate(mesh_.points, loop, isFree);
    return seen.empty() ? fan : seen;
}

/// All at once, and again, one after the other, those that take a diagonal of another face.
void TriangulatedFaces::findTriangles() {
    triangles_.resize(faces_.size());
    parallelFor(toLabel(faces_.size()), [&](Label i) {
        triangles_[index(i)] =
            bestTriangles(faces_[index(i)], [&](Label a, Label b) { return !areJoined(a, b); });
    });
    for (std::size_t i = 0; i < faces_.size(); ++i) {
        if (mesh_.faces.rowSize(faces_[i]) == 3) continue;
        std::vector<Edge> own = newEdges(triangles_[i]);
        if (std::ranges::any_of(own, [&](const Edge& e) { return added_.contains(e); })) {
            triangles_[i] = bestTriangles(faces_[i], [&](Label a, Label b) {
                return !areJoined(a, b) && !added_.contains(edgeOf(a, b));
            });
            own = newEdges(triangles_[i]);
        }
        added_.insert(own.begin(), own.end());
    }
}

std::vector<Edge> TriangulatedFaces::newEdges(const Triangles& triangles) const {
    std::vector<Edge> edges;
    for (const Triangle& t : triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const Edge edge = edgeOf(t[i], t[(i + 1) % 3]);
            if (edge[0] >= 0 && !areJoined(edge[0], edge[1])) edges.push_back(edge);
        }
    return edges;
}

std::vector<Triangle>* TriangulatedFaces::find(Label face) {
    const auto found = std::ranges::lower_bound(faces_, face);
    if (found == faces_.end() || *found != face) return nullptr;
    return &triangles_[static_cast<std::size_t>(found - faces_.begin())];
}

std::vector<Triangle> TriangulatedFaces::of(Label face) const {
    const auto found = std::ranges::lower_bound(faces_, face);
    if (found != faces_.end() && *found == face)
        return triangles_[static_cast<std::size_t>(found - faces_.begin())];
    const auto loop = mesh_.faces[face];
    return loop.size() == 3 ? Triangles{{loop[0], loop[1], loop[2]}} : fanOf(face);
}

TriangleHull TriangulatedFaces::hullOf(std::span<const SeenFace> faces) const {
    TriangleHull hull;
    for (const SeenFace& s : faces)
        hull.labels.insert(
            hull.labels.end(), mesh_.faces[s.face].begin(), mesh_.faces[s.face].end());
    std::ranges::sort(hull.labels);
    hull.labels.erase(std::unique(hull.labels.begin(), hull.labels.end()), hull.labels.end());
    for (const Label p : hull.labels)
        hull.points.push_back(mesh_.points[index(p)]);
    for (const SeenFace& s : faces)
        addTriangles(s, hull);
    return hull;
}

TriangleHull TriangulatedFaces::hullOf(Label cell) const {
    std::vector<SeenFace> seen;
    for (const Label face : plan_.cellFaces[cell])
        seen.push_back({face, mesh_.owner[index(face)] == cell});
    return hullOf(seen);
}

void TriangulatedFaces::addTriangles(const SeenFace& seen, TriangleHull& hull) const {
    const Label middle = toLabel(hull.points.size());
    bool hasMiddle = false;
    for (Triangle t : of(seen.face)) {
        for (Label& p : t) {
            hasMiddle = hasMiddle || p < 0;
            p = p < 0 ? middle
                      : static_cast<Label>(std::ranges::lower_bound(hull.labels, p) -
                                           hull.labels.begin());
        }
        if (!seen.isOutward) std::swap(t[1], t[2]);
        hull.triangles.push_back(t);
    }
    if (hasMiddle) hull.points.push_back(middleOf(seen.face));
}

/// Triangles that a face may have while others have theirs: no diagonal of them.
std::vector<TriangulatedFaces::Choice> TriangulatedFaces::choicesFor(Label face) const {
    constexpr std::size_t mostCorners = 9; // 429 triangulations
    const auto loop = mesh_.faces[face];
    std::vector<Choice> choices{{fanOf(face), {}}};
    const auto isFree = [&](Label a, Label b) {
        return !areJoined(a, b) && !added_.contains(edgeOf(a, b));
    };
    std::vector<Triangles> all;
    if (loop.size() <= mostCorners)
        all = triangulations(loop, 0, loop.size() - 1);
    else if (Triangles flat = triangulate(mesh_.points, loop, isFree); !flat.empty())
        all.push_back(std::move(flat));
    for (Triangles& triangles : all) {
        std::vector<Edge> diagonals = newEdges(triangles);
        // Each of the n - 3 is an edge of two triangles, unless it is there already.
        if (diagonals.size() == 2 * (loop.size() - 3) &&
            std::ranges::none_of(diagonals, [&](const Edge& e) { return added_.contains(e); }))
            choices.push_back({std::move(triangles), std::move(diagonals)});
    }
    return choices;
}

Label TriangulatedFaces::crossingsBeside(Label face) const {
    Label count = crossingsOf(hullOf(mesh_.owner[index(face)]));
    if (mesh_.isInternal(face)) count += crossingsOf(hullOf(mesh_.neighbour[index(face)]));
    return count;
}

/// The faces of a cell that cross others and may have other triangles.
std::vector<Label> TriangulatedFaces::crossingFaces(Label cell) const {
    std::vector<Label> faceOf;
    for (const Label face : plan_.cellFaces[cell])
        faceOf.insert(faceOf.end(), of(face).size(), face);
    std::vector<Label> faces;
    for (const auto& pair : crossingPairs(hullOf(cell)))
        for (const Label triangle : pair)
            faces.push_back(faceOf[index(triangle)]);
    std::ranges::sort(faces);
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    std::erase_if(faces, [&](Label face) {
        return mesh_.faces.rowSize(face) == 3 || !std::ranges::binary_search(faces_, face);
    });
    return faces;
}

/// The triangles of a face, whose diagonals are others' to take until it is given some again.
std::vector<Triangle> TriangulatedFaces::released(Label face) {
    for (const Edge& e : newEdges(*find(face)))
        added_.erase(e);
    return *find(face);
}

void TriangulatedFaces::give(Label face, Triangles triangles) {
    for (const Edge& e : newEdges(triangles))
        added_.insert(e);
    *find(face) = std::move(triangles);
}

/// Takes the best choice for each face of a cell in turn.
void TriangulatedFaces::chooseOneByOne(Label cell) {
    for (const Label face : crossingFaces(cell)) {
        Triangles best = released(face);
        Label fewest = crossingsBeside(face);
        for (const Choice& choice : choicesFor(face)) {
            if (fewest == 0) break;
            *find(face) = choice.triangles;
            const Label count = crossingsBeside(face);
            if (count < fewest) best = choice.triangles;
            fewest = std::min(fewest, count);
        }
        give(face, std::move(best));
    }
}

/// Takes the best choices for two faces of a cell together.
void TriangulatedFaces::choosePairs(Label cell) {
    const std::vector<Label> faces = crossingFaces(cell);
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (std::size_t j = i + 1; j < faces.size(); ++j)
            choosePair(cell, faces[i], faces[j]);
}

void TriangulatedFaces::choosePair(Label cell, Label one, Label other) {
    constexpr std::size_t most = 5000;
    std::pair best{released(one), released(other)};
    const std::vector<Choice> choices = choicesFor(one);
    std::vector<Choice> others = choicesFor(other);
    const auto count = [&] { return crossingsBeside(one) + crossingsBeside(other); };
    Label fewest = count();
    if (choices.size() * others.size() > most) others.clear();
    for (const Choice& a : choices)
        for (const Choice& b : others) {
            if (fewest == 0) break;
            if (std::ranges::find_first_of(a.diagonals, b.diagonals) != a.diagonals.end()) continue;
            *find(one) = a.triangles;
            *find(other) = b.triangles;
            if (crossingsOf(hullOf(cell)) >= fewest) continue;
            const Label now = count();
            if (now < fewest) best = {a.triangles, b.triangles};
            fewest = std::min(fewest, now);
        }
    give(one, std::move(best.first));
    give(other, std::move(best.second));
}

void TriangulatedFaces::avoidCrossings(std::span<const Label> cells) {
    constexpr int rounds = 2;
    std::vector<char> crosses(cells.size(), 0);
    parallelBlocks(toLabel(cells.size()), 1, [&](Label, Label i, Label) {
        const TriangleHull hull = hullOf(cells[index(i)]);
        crosses[index(i)] = !pointThatSees(hull) && crossingsOf(hull) > 0 ? 1 : 0;
    });
    for (std::size_t i = 0; i < cells.size(); ++i)
        for (int round = 0; crosses[i] != 0 && round < rounds; ++round) {
            if (round == 0)
                chooseOneByOne(cells[i]);
            else
                choosePairs(cells[i]);
            if (crossingsOf(hullOf(cells[i])) == 0) break;
        }
}

} // namespace polymesh
