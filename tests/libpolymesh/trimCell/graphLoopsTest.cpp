// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trimCell/graphLoops.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/mps/edgeLoops.h"
#include "tests/libpolymesh/trimCell/bothWays.h"

#include <array>
#include <cmath>
#include <map>
#include <set>

namespace polymesh::test {
namespace {

/// The unit cube cut by a plane: what lies below it, seen against its normal.
class CutCube {
public:
    CutCube(const Vec3& onPlane, const Vec3& normal)
        : arranged_(unitCube(), below(onPlane, normal)), searched_(arranged_.cutter) {
        sites = findSites(inputs(), 0);
        const std::vector<std::uint8_t> isByFacets(sites.facets.size(), 0);
        graph = buildGraph(inputs(), sites, isByFacets);
    }

    CellInputs inputs() const { return {arranged_.probe, searched_, 0}; }

    /// Where a point of the graph is: here all crossings lie between two nodes.
    Vec3 placeOf(const PointName& name) const {
        if (name.kind == PointName::Kind::node)
            return arranged_.probe.nodePoints[index(name.first)];
        const Label first = arranged_.arrangement.crossings.offsets[index(name.first)];
        return arranged_.positions[index(arranged_.arrangement.firstCrossing() + first)];
    }

    CellSites sites;
    CellGraph graph;

private:
    /// A tetrahedron so large that only one of its faces comes near the cube.
    static TriSurface below(const Vec3& p, const Vec3& normal) {
        const Vec3 n = normal / norm(normal);
        const Vec3 other = std::abs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        const Vec3 u = cross(n, other) / norm(cross(n, other));
        const Vec3 v = cross(n, u);
        return surfaceOf({p + 8 * u, p - 5 * u + 8 * v, p - 5 * u - 8 * v, p - 8 * n},
                         {{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}});
    }

    Arranged arranged_;
    SearchedSurface searched_;
};

/// Calls use(cube) for cubes cut by random planes.
template<class Use>
void forCutCubes(Use&& use) {
    std::mt19937 random(1);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    for (int i = 0; i < 200; ++i) {
        const double x = between(0.1, 0.9);
        const double y = between(0.1, 0.9);
        const Vec3 p{x, y, between(0.1, 0.9)};
        const double a = between(-1, 1);
        const double b = between(-1, 1);
        use(CutCube(p, {a, b, between(-1, 1)}));
    }
}

TEST(GraphLoops, areTheFacesOfAClosedPolyhedronSeenFromOutside) {
    forCutCubes([](const CutCube& cube) {
        const std::vector<GraphLoop> loops = findLoops(cube.inputs(), cube.graph);
        std::map<std::pair<PointName, PointName>, int> uses;
        std::set<PointName> points;
        double volume = 0;
        for (const GraphLoop& loop : loops) {
            std::vector<Vec3> at;
            for (const LoopStep& step : loop.steps) {
                const auto& ends = cube.graph.edges[index(step.edge)].points;
                ++uses[{ends[step.from], ends[1 - step.from]}];
                points.insert(ends[step.from]);
                at.push_back(cube.placeOf(ends[step.from]));
            }
            for (std::size_t i = 1; i + 1 < at.size(); ++i)
                volume += dot(at[0], cross(at[i], at[i + 1])) / 6;
        }
        EXPECT_EQ(points.size() + loops.size(), cube.graph.edges.size() + 2); // Euler
        for (const auto& [step, count] : uses) {
            EXPECT_EQ(count, 1);
            EXPECT_EQ(uses.count({step.second, step.first}), 1U);
        }
        EXPECT_GT(volume, 0);
        EXPECT_LT(volume, 1);
    });
}

/// How far a closed loop is out of plane (equation 7): 0 for a plane convex one.
double outOfPlane(const std::vector<Vec3>& loop) {
    const std::size_t n = loop.size();
    const auto turn = [&](std::size_t k) {
        const Vec3 v =
            cross(loop[(k + 1) % n] - loop[k % n], loop[(k + 2) % n] - loop[(k + 1) % n]);
        return v / norm(v);
    };
    double sum = 0;
    for (std::size_t k = 0; k < n; ++k)
        sum += 1 - dot(turn(k), turn(k + 1));
    return sum;
}

/// A face in the paper's sense is a loop of least weight, 1 for each edge and how far it is out of
/// plane (equation 6): the two lightest through an edge are the faces that the edge knows.
TEST(GraphLoops, areThePapersLightestLoops) {
    forCutCubes([](const CutCube& cube) {
        std::vector<PointName> names;
        for (const GraphEdge& edge : cube.graph.edges)
            names.insert(names.end(), edge.points.begin(), edge.points.end());
        std::ranges::sort(names);
        names.erase(std::unique(names.begin(), names.end()), names.end());
        const auto labelOf = [&](const PointName& name) {
            return static_cast<Label>(std::ranges::lower_bound(names, name) - names.begin());
        };
        EdgeLoops ways(8);
        for (const GraphEdge& edge : cube.graph.edges)
            ways.add(labelOf(edge.points[0]), labelOf(edge.points[1]));
        ways.sort();
        std::map<std::set<Label>, std::set<std::set<Label>>> facesAt; // edge -> its faces
        for (const GraphLoop& loop : findLoops(cube.inputs(), cube.graph)) {
            std::set<Label> face;
            for (const LoopStep& step : loop.steps)
                face.insert(labelOf(cube.graph.edges[index(step.edge)].points[step.from]));
            for (const LoopStep& step : loop.steps) {
                const auto& ends = cube.graph.edges[index(step.edge)].points;
                facesAt[{labelOf(ends[0]), labelOf(ends[1])}].insert(face);
            }
        }
        for (const GraphEdge& edge : cube.graph.edges) {
            std::multimap<double, std::set<Label>> loops; // by weight
            const Label from = labelOf(edge.points[0]);
            const Label to = labelOf(edge.points[1]);
            ways.through(from, to, [&](const std::vector<Label>& loop) {
                std::vector<Vec3> at(loop.size());
                std::ranges::transform(
                    loop, at.begin(), [&](Label p) { return cube.placeOf(names[index(p)]); });
                loops.emplace(static_cast<double>(loop.size()) + outOfPlane(at),
                              std::set<Label>(loop.begin(), loop.end()));
            });
            ASSERT_GE(loops.size(), 2U);
            const std::set<std::set<Label>> lightest{loops.begin()->second,
                                                     std::next(loops.begin())->second};
            EXPECT_EQ(lightest, (facesAt[{from, to}]));
        }
    });
}

TEST(GraphLoops, aGraphThatIsNoPolyhedronIsRefused) {
    const CutCube cube({0.5, 0.5, 0.5}, {0.1, 0.2, 1});
    CellGraph graph = cube.graph;
    graph.edges.pop_back(); // a node with one edge of a face
    EXPECT_THROW(findLoops(cube.inputs(), graph), InputError);
    graph = cube.graph;
    const auto outline = std::ranges::find(graph.edges, GraphEdge::Kind::outline, &GraphEdge::kind);
    std::swap(outline->carriers[0], outline->carriers[1]); // against the rest of both faces
    EXPECT_THROW(findLoops(cube.inputs(), graph), InputError);
}

} // namespace
} // namespace polymesh::test
