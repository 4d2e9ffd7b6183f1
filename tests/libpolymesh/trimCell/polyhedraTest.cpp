// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The polyhedra of single cells, made of nothing but what each has found, against the cells of the
// trimmed mesh: so simplification, pieces of cells, and assembly have a second opinion too.

#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/trimCell/cellCut.h"
#include "tests/libpolymesh/trimCell/bothWays.h"

#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace polymesh::test {
namespace {

/// What two polyhedra have in common when they are the same.
struct Measures {
    double volume = 0;
    Label faces = 0;
    Label points = 0;

    // NOLINTNEXTLINE(modernize-use-nullptr): what the compiler makes of it compares with 0
    auto operator<=>(const Measures&) const = default;
};

/// An outline of a face of one cell's polyhedra, seen from outside.
struct NamedLoop {
    std::vector<PointName> points;
    Label face = -1; // of the mesh; -1: on the surface
    bool isClosedCurve = false;
};

std::vector<NamedLoop> outwardLoopsOf(const Probe& probe, const CellCut& cut) {
    std::vector<NamedLoop> loops;
    for (const FaceLoop& face : cut.faceLoops) {
        NamedLoop& loop = loops.emplace_back();
        loop.face = face.face;
        loop.isClosedCurve = std::ranges::all_of(
            face.steps, [](const FaceStep& step) { return step.triangle >= 0; });
        for (const FaceStep& step : face.steps)
            loop.points.push_back(step.point);
        if (probe.faceCells[index(face.face)][0] != cut.sites.cell)
            std::ranges::reverse(loop.points);
    }
    for (const PieceLoop& piece : cut.pieces) {
        NamedLoop& loop = loops.emplace_back();
        for (const PieceStep& step : piece.steps)
            loop.points.push_back(step.point);
    }
    return loops;
}

Vec3 onLine(const Vec3& a, const Vec3& b, const std::array<Vec3, 3>& plane) {
    const Vec3 n = cross(plane[1] - plane[0], plane[2] - plane[0]);
    return a + dot(n, plane[0] - a) / dot(n, b - a) * (b - a);
}

/// Where a named point is.
Vec3 placeOf(const Arranged& arranged, const PointName& name) {
    const Probe& probe = arranged.probe;
    const auto& points = arranged.surface.points;
    const auto node = [&](Label n) { return probe.nodePoints[index(n)]; };
    if (name.kind == PointName::Kind::node) return node(name.first);
    if (name.kind == PointName::Kind::vertex) return points[index(name.first)];
    if (name.kind == PointName::Kind::crossing) {
        const auto& [a, b] = probe.edges[index(name.first)];
        return onLine(node(a), node(b), arranged.cutter.triangle(name.second));
    }
    const SurfaceEdge& edge = arranged.cutter.edges.edges[index(name.second)];
    const auto facet = probe.facetNodes[name.first];
    return onLine(points[index(edge.start)],
                  points[index(edge.end)],
                  {node(facet[0]), node(facet[1]), node(facet[2])});
}

Vec3 areaOf(const Arranged& arranged, const NamedLoop& loop) {
    Vec3 area;
    const Vec3 a = placeOf(arranged, loop.points[0]);
    for (std::size_t k = 1; k + 1 < loop.points.size(); ++k)
        area +=
            cross(placeOf(arranged, loop.points[k]) - a, placeOf(arranged, loop.points[k + 1]) - a);
    return 0.5 * area;
}

/// Which loops belong to the same polyhedron: those with a common edge, and a hole with the
/// outlines of its face. For each loop the number of its polyhedron.
std::vector<std::size_t> connect(const Arranged& arranged, const std::vector<NamedLoop>& loops) {
    std::vector<std::size_t> part(loops.size());
    std::iota(part.begin(), part.end(), std::size_t{0});
    const auto join = [&](std::size_t a, std::size_t b) {
        const std::size_t from = part[a];
        const std::size_t to = part[b];
        std::ranges::replace(part, from, to);
    };
    std::map<std::set<PointName>, std::size_t> loopOfEdge;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const auto& points = loops[i].points;
        for (std::size_t k = 0; k < points.size(); ++k)
            join(i,
                 loopOfEdge.try_emplace({points[k], points[(k + 1) % points.size()]}, i)
                     .first->second);
        for (std::size_t j = 0; j < loops.size() && loops[i].isClosedCurve; ++j)
            if (loops[j].face == loops[i].face && !loops[j].isClosedCurve &&
                dot(areaOf(arranged, loops[i]), areaOf(arranged, loops[j])) < 0)
                join(i, j);
    }
    return part;
}

void addPolyhedra(const Arranged& arranged, const CellCut& cut, std::vector<Measures>& all) {
    const std::vector<NamedLoop> loops = outwardLoopsOf(arranged.probe, cut);
    const std::vector<std::size_t> part = connect(arranged, loops);
    std::map<std::size_t, Measures> measures;
    std::map<std::size_t, std::set<PointName>> points;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        Measures& m = measures[part[i]];
        ++m.faces;
        points[part[i]].insert(loops[i].points.begin(), loops[i].points.end());
        m.volume += dot(placeOf(arranged, loops[i].points[0]), areaOf(arranged, loops[i])) / 3;
    }
    for (auto& [number, m] : measures) {
        m.points = toLabel(points[number].size());
        all.push_back(m);
    }
}

/// The polyhedra of all cells near the surface, each cell cut by itself.
std::vector<Measures> polyhedraOfCells(const Arranged& arranged, int shift) {
    const SearchedSurface searched(arranged.cutter);
    std::vector<Measures> all;
    for (Label c = 0; c < arranged.probe.cellCount(); ++c)
        addPolyhedra(arranged, cutOneCell({arranged.probe, searched, shift}, c), all);
    std::ranges::sort(all);
    return all;
}

/// The cells of the trimmed mesh that are not such of the initial one.
std::vector<Measures> polyhedraOfMesh(const PolyMesh& mesh) {
    const std::vector<double> volumes = computeGeometry(mesh).cellVolumes;
    const Rows<Label> facesOf = cellFaces(mesh);
    std::vector<Measures> all;
    for (Label c = 0; c < mesh.cellCount; ++c) {
        std::set<Label> points;
        for (const Label f : facesOf[c])
            points.insert(mesh.faces[f].begin(), mesh.faces[f].end());
        all.push_back({volumes[index(c)], facesOf.rowSize(c), toLabel(points.size())});
    }
    std::ranges::sort(all);
    return all;
}

/// Lets the cells go that the surface does not cut: hexahedra of the full volume.
void dropWhole(std::vector<Measures>& all, double volume) {
    std::erase_if(all, [&](const Measures& m) {
        return m.faces == 6 && m.points == 8 && std::abs(m.volume / volume - 1) < 1e-9;
    });
}

void expectSamePolyhedra(const TriSurface& part, Label cells, Keep keep, unsigned seed) {
    const PolyMesh mesh = box(cells, cells, cells);
    const Arranged arranged(mesh, part, keep == Keep::outside);
    std::vector<Measures> ofCells = polyhedraOfCells(arranged, keep == Keep::outside ? 1 : 0);
    std::vector<Measures> ofMesh = polyhedraOfMesh(trim(mesh, part, exact(keep)).mesh);
    const double whole = 1.0 / static_cast<double>(cells * cells * cells);
    dropWhole(ofCells, whole);
    dropWhole(ofMesh, whole);
    ASSERT_EQ(ofCells.size(), ofMesh.size()) << "part " << seed;
    ASSERT_GT(ofCells.size(), 8U);
    for (std::size_t i = 0; i < ofCells.size(); ++i) {
        ASSERT_NEAR(ofCells[i].volume, ofMesh[i].volume, 1e-12 * whole) << "part " << seed;
        ASSERT_EQ(ofCells[i].faces, ofMesh[i].faces) << "part " << seed;
        ASSERT_EQ(ofCells[i].points, ofMesh[i].points) << "part " << seed;
    }
}

TEST(PolyhedraOfSingleCells, areTheCellsOfTheTrimmedMesh) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        const double shift = 0.0113 * seed; // nowhere on a grid plane
        const TriSurface part =
            dentedSphere(2, {0.47 + shift, 0.51, 0.53 - shift}, 0.43, 0.05 * seed, seed);
        expectSamePolyhedra(part, 3, Keep::inside, seed);
        expectSamePolyhedra(part, 4, Keep::outside, seed);
    }
}

} // namespace
} // namespace polymesh::test
