// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/probe.h"

#include "libpolymesh/base/freshList.h"
#include "libpolymesh/base/kept.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/geometry/predicates.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/internalFaces.h"
#include "libpolymesh/surface/triangleBins.h"

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <span>

namespace polymesh {

namespace {

using Range = TriangleBins::Range;

/// The bins of all points, in 6 bytes each: there is one for each point of the mesh.
class PointBins {
public:
    PointBins(const PolyMesh& mesh, const TriangleBins& bins)
        : values_(freshList<std::int16_t>(3 * mesh.points.size() + 1)) {
        parallelFor(mesh.pointCount(), [&](Label p) {
            const TriangleBins::Index bin = bins.binOf(mesh.points[index(p)]);
            for (std::size_t axis = 0; axis < 3; ++axis)
                values_[3 * index(p) + axis] = bin[axis];
        });
    }

    /// Reads one number too many, which has no meaning, so that it is one load.
    TriangleBins::Index operator[](Label p) const {
        TriangleBins::Index bin{};
        std::memcpy(&bin, values_.data() + std::size_t{3} * index(p), sizeof(bin));
        return bin;
    }

private:
    std::vector<std::int16_t> values_;
};

using Polygon = boost::container::small_vector<Vec3, 8>;

/// Whether the triangle's plane misses the box by more than rounding can hide.
bool planeMisses(const TriSurface& surface, Label triangle, const Box& box) {
    const Vec3& a = surface.corner(triangle, 0);
    const Vec3 ab = surface.corner(triangle, 1) - a;
    const Vec3 ac = surface.corner(triangle, 2) - a;
    const Vec3 n = cross(ab, ac);
    const Vec3 half = 0.5 * box.size();
    const Vec3 toCentre = box.centre() - a;
    const double reach = std::abs(n.x) * half.x + std::abs(n.y) * half.y + std::abs(n.z) * half.z;
    const double scale = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    // The normal of a sliver can be nothing but rounding, whatever its direction.
    const double normalError = 1e-14 * norm(ab) * norm(ac);
    const double slack = (1e-9 * scale + normalError) * (norm(toCentre) + norm(half));
    return std::abs(dot(n, toCentre)) > reach + slack;
}

/// Mean edge length of a cell, the wish for the size of bins.
double meanCellSize(const PolyMesh& mesh) {
    const double volume = std::max(boundedVolume(mesh), 1e-300);
    return std::cbrt(volume / std::max<double>(1, static_cast<double>(mesh.cellCount)));
}

/// The cells whose range of bins holds a triangle, and those ranges.
struct NearCells {
    std::vector<std::uint8_t> marked; // one per mesh cell: 1 or 0
    std::vector<Range> ranges;        // of the marked cells, in order
};

/// The range of bins of every cell.
std::vector<Range> rangesOfCells(const PolyMesh& mesh, const PointBins& binOf) {
    std::vector<Range> ranges = freshList<Range>(index(mesh.cellCount));
    const auto rangeOf = [&](Label f) {
        Range range;
        for (const Label p : mesh.faces[f])
            range.add(binOf[p]);
        return range;
    };
    forInternalFaces(mesh, [&](Label f) {
        const Range range = rangeOf(f);
        ranges[index(mesh.owner[index(f)])].add(range);
        ranges[index(mesh.neighbour[index(f)])].add(range);
    });
    for (Label f = mesh.internalFaceCount(); f < mesh.faceCount(); ++f)
        ranges[index(mesh.owner[index(f)])].add(rangeOf(f));
    return ranges;
}

NearCells findNearCells(const PolyMesh& mesh, const TriangleBins& bins) {
    const PointBins binOf(mesh, bins);
    std::vector<Range> ranges = rangesOfCells(mesh, binOf);
    NearCells cells;
    cells.marked = freshList<std::uint8_t>(index(mesh.cellCount));
    parallelFor(mesh.cellCount, [&](Label c) {
        cells.marked[index(c)] = bins.isOccupied(ranges[index(c)]) ? 1 : 0;
    });
    for (Label c = 0; c < mesh.cellCount; ++c)
        if (cells.marked[index(c)] != 0) cells.ranges.push_back(ranges[index(c)]);
    return cells;
}

/// Lists the faces of the probe's cells by cell.
void listCellFaces(Probe& probe) {
    auto& offsets = probe.cellFaces.offsets;
    offsets.assign(index(probe.cellCount()) + 1, 0);
    for (const auto& cells : probe.faceCells)
        for (const Label c : cells)
            if (c >= 0) ++offsets[index(c) + 1];
    for (std::size_t c = 1; c < offsets.size(); ++c)
        offsets[c] += offsets[c - 1];
    probe.cellFaces.values = freshList<Label>(index(offsets.back()));
    std::vector<Label> next(offsets.begin(), offsets.end() - 1);
    for (Label f = 0; f < probe.faceCount(); ++f)
        for (const Label c : probe.faceCells[index(f)])
            if (c >= 0) probe.cellFaces.values[index(next[index(c)]++)] = f;
}

/// Numbers the marked cells and lists their faces.
void addCells(const PolyMesh& mesh, const std::vector<std::uint8_t>& marked, Probe& probe) {
    probe.localCell = freshList<Label>(index(mesh.cellCount), -1);
    for (Label c = 0; c < mesh.cellCount; ++c)
        if (marked[index(c)] != 0) {
            probe.localCell[index(c)] = probe.cellCount();
            probe.cells.push_back(c);
        }
    const Kept faces(mesh.faceCount(), [&](Label f) {
        return marked[index(mesh.owner[index(f)])] != 0 ||
               (mesh.isInternal(f) && marked[index(mesh.neighbour[index(f)])] != 0);
    });
    probe.faces = freshList<Label>(index(faces.count()));
    faces.forEach([&](Label f, Label to) { probe.faces[index(to)] = f; });
    probe.faceCells = freshList<std::array<Label, 2>>(probe.faces.size());
    parallelFor(probe.faceCount(), [&](Label i) {
        const Label f = probe.faces[index(i)];
        const Label other = mesh.isInternal(f) ? mesh.neighbour[index(f)] : -1;
        probe.faceCells[index(i)] = {probe.localCell[index(mesh.owner[index(f)])],
                                     other >= 0 ? probe.localCell[index(other)] : -1};
    });
    listCellFaces(probe);
}

/// Lets the cells without a triangle go, and the faces that no other cell has.
void dropEmptyCells(Rows<Label> triangles, Probe& probe) {
    std::vector<Label> renumbered(probe.cells.size(), -1);
    Label count = 0;
    for (Label c = 0; c < probe.cellCount(); ++c) {
        const Label cell = probe.cells[index(c)];
        const bool isEmpty = triangles.rowSize(c) == 0;
        probe.localCell[index(cell)] = isEmpty ? -1 : count;
        if (isEmpty) continue;
        probe.triangles.offsets.push_back(probe.triangles.offsets.back() + triangles.rowSize(c));
        probe.cells[index(count)] = cell;
        renumbered[index(c)] = count++;
    }
    probe.cells.resize(index(count));
    probe.triangles.values = std::move(triangles.values); // empty rows held none
    std::size_t faces = 0;
    for (std::size_t f = 0; f < probe.faces.size(); ++f) {
        std::array<Label, 2> cells = probe.faceCells[f];
        for (Label& c : cells)
            if (c >= 0) c = renumbered[index(c)];
        if (cells[0] < 0 && cells[1] < 0) continue;
        probe.faces[faces] = probe.faces[f];
        probe.faceCells[faces++] = cells;
    }
    probe.faces.resize(faces);
    probe.faceCells.resize(faces);
    listCellFaces(probe);
}

Box cellBox(const PolyMesh& mesh, const Probe& probe, Label cell) {
    Box box;
    for (const Label f : probe.cellFaces[cell])
        for (const Label p : mesh.faces[probe.faces[index(f)]])
            box.add(mesh.points[index(p)]);
    return box;
}

struct SearchableSurface {
    const TriSurface& surface;
    const std::vector<Box>& boxes; // of the triangles
    const TriangleBins& bins;
};

/// The triangles that may touch each cell of the probe.
Rows<Label> findTriangles(const PolyMesh& mesh,
                          const SearchableSurface& triangles,
                          const std::vector<Range>& cellRanges,
                          const Probe& probe) {
    constexpr Label block = 512;
    const Label blocks = (probe.cellCount() + block - 1) / block;
    std::vector<Rows<Label>> parts(index(blocks));
    parallelBlocks(probe.cellCount(), block, [&](Label b, Label first, Label last) {
        std::vector<Label> found;
        for (Label c = first; c < last; ++c) {
            found.clear();
            triangles.bins.collect(cellRanges[index(c)], found);
            const Box box = cellBox(mesh, probe, c);
            std::erase_if(found, [&](Label t) {
                return !overlaps(triangles.boxes[index(t)], box) ||
                       planeMisses(triangles.surface, t, box);
            });
            parts[index(b)].add(found);
        }
    });
    return joined(parts);
}

/// Numbers the points of the probe's faces in their order in the mesh.
void numberNodes(const PolyMesh& mesh, Probe& probe) {
    Rows<Label>& rows = probe.faceNodes;
    rows.offsets = freshList<Label>(probe.faces.size() + 1);
    for (std::size_t f = 0; f < probe.faces.size(); ++f)
        rows.offsets[f + 1] = rows.offsets[f] + mesh.faces.rowSize(probe.faces[f]);
    rows.values = freshList<Label>(index(rows.offsets.back()));
    std::vector<Label> local = freshList<Label>(mesh.points.size(), -1);
    parallelFor(probe.faceCount(), [&](Label f) {
        for (const Label p : mesh.faces[probe.faces[index(f)]])
            std::atomic_ref<Label>(local[index(p)]).store(0, std::memory_order_relaxed);
    });
    const Kept used(toLabel(local.size()), [&](Label p) { return local[index(p)] == 0; });
    probe.nodes = freshList<Label>(index(used.count()));
    used.forEach([&](Label p, Label to) {
        local[index(p)] = to;
        probe.nodes[index(to)] = p;
    });
    probe.nodePoints = freshList<Vec3>(probe.nodes.size());
    parallelFor(toLabel(probe.nodes.size()), [&](Label n) {
        probe.nodePoints[index(n)] = mesh.points[index(probe.nodes[index(n)])];
    });
    parallelFor(probe.faceCount(), [&](Label f) {
        std::ranges::transform(mesh.faces[probe.faces[index(f)]], rows[f].begin(), [&](Label p) {
            return local[index(p)];
        });
    });
}

/// Whether any triangle of the face's cell comes near the face: else it is not cut.
bool mayBeCut(const Probe& probe,
              const std::vector<Box>& triangleBoxes,
              Label face,
              const Box& box) {
    const auto& cells = probe.faceCells[index(face)];
    const Label cell = cells[0] >= 0 ? cells[0] : cells[1];
    return std::ranges::any_of(probe.triangles[cell],
                               [&](Label t) { return overlaps(triangleBoxes[index(t)], box); });
}

/// Whether the face must be cut into a fan: 1, else 0.
std::vector<std::uint8_t> findFans(const Probe& probe, const std::vector<Box>& triangleBoxes) {
    std::vector<std::uint8_t> isFan(probe.faces.size(), 0);
    parallelFor(probe.faceCount(), [&](Label f) {
        Polygon polygon;
        for (const Label n : probe.faceNodes[f])
            polygon.push_back(probe.nodePoints[index(n)]);
        if (isPlanarConvex(std::span<const Vec3>(polygon.data(), polygon.size()))) return;
        const Box box = boundingBox(std::span<const Vec3>(polygon.data(), polygon.size()));
        isFan[index(f)] = mayBeCut(probe, triangleBoxes, f, box) ? 1 : 0;
    });
    return isFan;
}

void divideFaces(const std::vector<std::uint8_t>& isFan, Probe& probe) {
    probe.facetOffsets.assign(1, 0);
    for (Label f = 0; f < probe.faceCount(); ++f) {
        const auto nodes = probe.faceNodes[f];
        if (isFan[index(f)] == 0) {
            probe.facetNodes.add(std::span<const Label>(nodes.data(), nodes.size()));
            probe.facetFace.push_back(f);
        } else {
            Vec3 centre;
            for (const Label n : nodes)
                centre += probe.nodePoints[index(n)];
            const Label c = probe.nodeCount();
            probe.nodePoints.push_back(centre / static_cast<double>(nodes.size()));
            for (std::size_t i = 0; i < nodes.size(); ++i) {
                const std::array<Label, 3> triangle{nodes[i], nodes[(i + 1) % nodes.size()], c};
                probe.facetNodes.add(triangle);
                probe.facetFace.push_back(f);
            }
        }
        probe.facetOffsets.push_back(probe.facetCount());
    }
}

/// Numbers the edges of all facets in the order of their lower node, then their higher one.
void numberEdges(Probe& probe) {
    const auto& corners = probe.facetNodes;

    struct Use {
        Label high;
        Label corner;
    };

    Rows<Use> uses; // by lower node
    uses.offsets.assign(index(probe.nodeCount()) + 1, 0);
    const auto visit = [&](auto&& use) { // (node, next node, corner) of every facet
        for (Label f = 0; f < corners.size(); ++f) {
            const Label first = corners.offsets[index(f)];
            const Label last = corners.offsets[index(f) + 1];
            for (Label i = first; i < last; ++i)
                use(corners.values[index(i)],
                    corners.values[index(i + 1 < last ? i + 1 : first)],
                    i);
        }
    };
    visit([&](Label a, Label b, Label) { ++uses.offsets[index(std::min(a, b)) + 1]; });
    for (std::size_t n = 1; n < uses.offsets.size(); ++n)
        uses.offsets[n] += uses.offsets[n - 1];
    uses.values.resize(corners.values.size());
    std::vector<Label> next(uses.offsets.begin(), uses.offsets.end() - 1);
    visit([&](Label a, Label b, Label corner) {
        uses.values[index(next[index(std::min(a, b))]++)] = {std::max(a, b), corner};
    });
    parallelFor(probe.nodeCount(), [&](Label n) {
        std::ranges::sort(uses[n], [](const Use& a, const Use& b) {
            return a.high != b.high ? a.high < b.high : a.corner < b.corner;
        });
    });
    probe.facetEdges.resize(corners.values.size());
    for (Label n = 0; n < probe.nodeCount(); ++n) {
        Label previous = -1;
        for (const Use& use : uses[n]) {
            if (use.high != previous) probe.edges.push_back({n, use.high});
            previous = use.high;
            probe.facetEdges[index(use.corner)] = probe.edgeCount() - 1;
        }
    }
}

void finishEdges(const std::vector<std::uint8_t>& isFan, Probe& probe) {
    probe.edgeCell.assign(probe.edges.size(), -1);
    probe.isFanEdge.assign(probe.edges.size(), 0);
    probe.faceEdges.resize(probe.faceNodes.values.size());
    for (Label f = 0; f < probe.faceCount(); ++f) {
        const auto& cells = probe.faceCells[index(f)];
        const Label cell = cells[0] >= 0 ? cells[0] : cells[1];
        const Label firstNode = probe.faceNodes.offsets[index(f)];
        for (Label k = probe.facetOffsets[index(f)]; k < probe.facetOffsets[index(f) + 1]; ++k) {
            const Label corner = probe.facetNodes.offsets[index(k)];
            for (Label i = 0; i < probe.facetNodes.rowSize(k); ++i) {
                const Label e = probe.facetEdges[index(corner + i)];
                if (probe.edgeCell[index(e)] < 0) probe.edgeCell[index(e)] = cell;
                if (isFan[index(f)] != 0 && i > 0)
                    probe.isFanEdge[index(e)] = 1;
                else
                    probe.faceEdges[index(firstNode + (isFan[index(f)] != 0
                                                           ? k - probe.facetOffsets[index(f)]
                                                           : i))] = e;
            }
        }
    }
}

} // namespace

Probe findProbe(const PolyMesh& mesh,
                const TriSurface& surface,
                const std::vector<Box>& triangleBoxes) {
    const TriangleBins bins(surface, meanCellSize(mesh));
    const NearCells nearCells = findNearCells(mesh, bins);
    Probe probe;
    addCells(mesh, nearCells.marked, probe);
    dropEmptyCells(findTriangles(mesh, {surface, triangleBoxes, bins}, nearCells.ranges, probe),
                   probe);
    numberNodes(mesh, probe);
    return probe;
}

void addFacets(const std::vector<Box>& triangleBoxes, Probe& probe) {
    const std::vector<std::uint8_t> isFan = findFans(probe, triangleBoxes);
    divideFaces(isFan, probe);
    numberEdges(probe);
    finishEdges(isFan, probe);
}

} // namespace polymesh
