// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/bends.h"

#include "libpolymesh/mps/numberedEdges.h"

#include <algorithm>
#include <array>
#include <set>

namespace polymesh {

namespace {

Edge edgeOf(Label a, Label b) {
    return {std::min(a, b), std::max(a, b)};
}

/// A point with two edges, and their other ends.
struct PassedPoint {
    Label point;
    Edge ends;
};

/// All points with two edges, ascending.
std::vector<PassedPoint> passedPoints(const PolyMesh& mesh, const NumberedEdges& edges) {
    std::vector<std::uint8_t> degree(index(mesh.pointCount()), 0);
    std::vector<Edge> ends(index(mesh.pointCount()));
    for (const Edge& edge : edges.points)
        for (std::size_t side = 0; side < 2; ++side) {
            const std::size_t here = index(edge[side]);
            if (degree[here] < 2) ends[here][degree[here]] = edge[1 - side];
            if (degree[here] < 3) ++degree[here];
        }
    std::vector<PassedPoint> passed;
    for (Label p = 0; p < mesh.pointCount(); ++p)
        if (degree[index(p)] == 2)
            passed.push_back({p, edgeOf(ends[index(p)][0], ends[index(p)][1])});
    return passed;
}

/// Marks points whose loss would leave a face with less than three corners.
void keepCornersOfFaces(const PolyMesh& mesh, std::vector<char>& isTaken) {
    for (Label face = 0; face < mesh.faceCount(); ++face) {
        Label left = mesh.faces.rowSize(face);
        for (const Label p : mesh.faces[face])
            left -= isTaken[index(p)] != 0 ? 1 : 0;
        if (left >= 3) continue;
        for (const Label p : mesh.faces[face])
            isTaken[index(p)] = 0;
    }
}

std::vector<char> pointsToTake(const PolyMesh& mesh,
                               const NumberedEdges& edges,
                               std::span<const PassedPoint> passed) {
    std::vector<char> isTaken(index(mesh.pointCount()), 0);
    std::set<Edge> joined;
    for (const auto& [point, ends] : passed)
        if (isTaken[index(ends[0])] == 0 && isTaken[index(ends[1])] == 0 &&
            !std::ranges::binary_search(edges.points, ends) && joined.insert(ends).second)
            isTaken[index(point)] = 1;
    if (!joined.empty()) keepCornersOfFaces(mesh, isTaken);
    return isTaken;
}

/// Removes the points that are marked; `place` is where each of the others goes.
void removePoints(PolyMesh& mesh,
                  const std::vector<char>& isTaken,
                  const std::vector<Label>& place) {
    Rows<Label> faces;
    faces.offsets.reserve(mesh.faces.offsets.size());
    faces.values.reserve(mesh.faces.values.size());
    std::vector<Label> loop;
    for (Label face = 0; face < mesh.faceCount(); ++face) {
        loop.clear();
        for (const Label p : std::as_const(mesh.faces)[face])
            if (isTaken[index(p)] == 0) loop.push_back(place[index(p)]);
        faces.add(loop);
    }
    mesh.faces = std::move(faces);
    for (Zone& zone : mesh.pointZones) {
        std::erase_if(zone.labels, [&](Label p) { return isTaken[index(p)] != 0; });
        for (Label& p : zone.labels)
            p = place[index(p)];
    }
    std::size_t count = 0;
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
        if (isTaken[p] == 0) mesh.points[count++] = mesh.points[p];
    mesh.points.resize(count);
}

} // namespace

Bends takeBends(PolyMesh& mesh) {
    const NumberedEdges edges = numberEdges(mesh);
    const std::vector<PassedPoint> passed = passedPoints(mesh, edges);
    if (passed.empty()) return {};
    const std::vector<char> isTaken = pointsToTake(mesh, edges, passed);
    std::vector<Label> place(isTaken.size());
    Label next = 0;
    for (std::size_t p = 0; p < isTaken.size(); ++p) {
        place[p] = next;
        next += isTaken[p] == 0 ? 1 : 0;
    }
    Bends bends;
    for (const auto& [point, ends] : passed)
        if (isTaken[index(point)] != 0)
            bends.push_back(
                {{place[index(ends[0])], place[index(ends[1])]}, mesh.points[index(point)]});
    std::ranges::sort(bends, {}, &Bend::ends);
    removePoints(mesh, isTaken, place);
    return bends;
}

PolyMesh withBendsAsPoints(PolyMesh mesh, const Bends& bends) {
    if (bends.empty()) return mesh;
    const Label first = mesh.pointCount();
    Rows<Label> faces;
    std::vector<Label> loop;
    for (Label face = 0; face < mesh.faceCount(); ++face) {
        loop.clear();
        const auto old = std::as_const(mesh.faces)[face];
        for (std::size_t i = 0; i < old.size(); ++i) {
            loop.push_back(old[i]);
            const Bend* bend = findBend(bends, old[i], old[(i + 1) % old.size()]);
            if (bend != nullptr) loop.push_back(first + static_cast<Label>(bend - bends.data()));
        }
        faces.add(loop);
    }
    mesh.faces = std::move(faces);
    for (const Bend& bend : bends)
        mesh.points.push_back(bend.at);
    return mesh;
}

const Bend* findBend(const Bends& bends, Label a, Label b) {
    const auto found = std::ranges::lower_bound(bends, edgeOf(a, b), {}, &Bend::ends);
    return found != bends.end() && found->ends == edgeOf(a, b) ? &*found : nullptr;
}

} // namespace polymesh
