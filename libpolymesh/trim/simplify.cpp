// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/simplify.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/trim/cellGroups.h"
#include "libpolymesh/trim/chains.h"

#include <algorithm>
#include <array>
#include <atomic>


namespace polymesh {

namespace {

/// How much is joined at one level.
struct Level {
    double sharpest; // [rad] sharper edges are kept
    double cone;     // [rad] see CellGroups::Limit
};

constexpr std::uint8_t lastLevel = 4;

/// From much to nothing. Where only features are kept at first, faces that bend more and more are
/// taken apart next: few faces for what the tolerance needs, however fine the triangles are.
std::array<Level, lastLevel + 1> levels(const Fidelity& fidelity) {
    constexpr double any = 4;
    constexpr Level everything{-2, any};
    if (fidelity.deviation <= 0) {
        constexpr Level flat{-0.5, any};
        return {flat, flat, flat, flat, everything};
    }
    const double sharp = fidelity.featureAngle;
    return {
        Level{sharp, any}, Level{sharp, 0.7}, Level{sharp, 0.35}, Level{sharp, 0.12}, everything};
}

void set(std::uint8_t& flag) {
    std::atomic_ref<std::uint8_t>(flag).store(1, std::memory_order_relaxed);
}

bool get(std::uint8_t& flag) {
    return std::atomic_ref<std::uint8_t>(flag).load(std::memory_order_relaxed) != 0;
}

/// The state of the simplification of a whole mesh.
class Simplification {
public:
    Simplification(const Probe& probe,
                   const CuttingSurface& cutter,
                   const Arrangement& arrangement,
                   const PointPositions& positions,
                   const CellPieces& pieces,
                   const std::vector<double>& cellSizes,
                   const Fidelity& fidelity,
                   FaceLoops& loops)
        : input_{probe, cutter, arrangement, positions, pieces, edgeOfIntervals(arrangement)},
          cellSizes_(cellSizes),
          fidelity_(fidelity),
          levels_(levels(fidelity)),
          loops_(loops),
          level_(index(probe.cellCount()), 0),
          isDirty_(index(probe.cellCount()), 1) {}

    BoundaryPolygons run() {
        parallelFor(cellCount(), [&](Label c) { raise(c); });
        for (bool isChanged = true; isChanged;) {
            parallelFor(input_.probe.faceCount(), [&](Label f) { keepOnFace(f); });
            isChanged = raiseBadCells();
        }
        BoundaryPolygons result = collect();
        reduceFaces();
        return result;
    }

private:
    Label cellCount() const { return input_.probe.cellCount(); }

    bool isCut(Label c) const {
        return input_.pieces.offsets[index(c)] != input_.pieces.offsets[index(c) + 1];
    }

    /// Whether the point may not be dropped from faces of the mesh.
    bool isKept(Label point) {
        const Label k = point - input_.arrangement.nodeCount;
        return k < 0 || k >= toLabel(loops_.isNeeded.size()) || get(loops_.isNeeded[index(k)]);
    }

    void keep(Label point) { set(loops_.isNeeded[index(point - input_.arrangement.nodeCount)]); }

    void group(Label c, CellGroups& groups) {
        const Level& level = levels_[level_[index(c)]];
        groups.build(input_, c, {fidelity_.sharpness, level.sharpest, level.cone});
    }

    /// Raises a cell's level until its groups are discs, and keeps the pierces that bound them.
    void raise(Label c) {
        if (!isCut(c)) return;
        CellGroups groups;
        group(c, groups);
        while (!groups.areDiscs() && level_[index(c)] < lastLevel) {
            ++level_[index(c)];
            group(c, groups);
        }
        for (const Label point : groups.endsOfBorders())
            if (input_.arrangement.isPierce(point)) keep(point);
    }

    double toleranceOf(Label c) const { return fidelity_.deviation * cellSizes_[index(c)]; }

    void keepOnFace(Label f) {
        double tolerance = Box::inf;
        for (const Label c : input_.probe.faceCells[index(f)])
            if (c >= 0) tolerance = std::min(tolerance, toleranceOf(c));
        // Points still free at deviation 0 lie between exactly coplanar triangles.
        if (fidelity_.deviation <= 0) tolerance = Box::inf;
        for (Label k = loops_.offsets[index(f)]; k < loops_.offsets[index(f) + 1]; ++k) {
            const auto polygon = loops_.polygons[k];
            if (std::ranges::all_of(polygon, [&](Label p) { return isKept(p); })) continue;
            keepWithin(
                input_.positions,
                polygon,
                tolerance,
                [&](std::size_t i) { return isKept(polygon[i]); },
                [&](std::size_t i) { keep(polygon[i]); });
            keepChainsOnOneEdge(polygon);
        }
    }

    /// The mesh edge on which a crossing lies, -1 for other points.
    Label edgeOf(Label point) const {
        const Arrangement& a = input_.arrangement;
        if (!a.isCrossing(point)) return -1;
        const auto& offsets = a.crossings.offsets;
        const auto next = std::ranges::upper_bound(offsets, point - a.firstCrossing());
        return toLabel(static_cast<std::size_t>(next - offsets.begin())) - 1;
    }

    /// A curve that leaves a mesh edge and comes back to it keeps a point off that edge: without it
    /// the faces round the edge would lie on each other.
    void keepChainsOnOneEdge(std::span<const Label> polygon) {
        const std::size_t n = polygon.size();
        for (std::size_t i = 0; i < n; ++i) {
            if (!isKept(polygon[i]) || isKept(polygon[(i + 1) % n])) continue;
            std::size_t j = i + 1;
            while (!isKept(polygon[j % n]))
                ++j;
            const Label e = edgeOf(polygon[i]);
            if (e < 0 || e != edgeOf(polygon[j % n])) continue;
            double distance = 0;
            keep(polygon[detail::farthest(input_.positions, polygon, i, j, distance) % n]);
        }
    }

    bool isGood(Label c, CellGroups& groups) {
        groups.reduce(input_, fidelity_.deviation > 0 ? toleranceOf(c) : 0.0, [&](Label p) {
            return isKept(p);
        });
        return groups.isValid(input_, loops_, [&](Label p) { return isKept(p); }) &&
               (fidelity_.deviation <= 0 || groups.deviation(input_) <= toleranceOf(c));
    }

    bool raiseBadCells() {
        std::vector<std::uint8_t> isBad(index(cellCount()), 0);
        parallelFor(cellCount(), [&](Label c) {
            if (isDirty_[index(c)] == 0 || !isCut(c)) return;
            CellGroups groups;
            group(c, groups);
            if (level_[index(c)] < lastLevel && !isGood(c, groups)) isBad[index(c)] = 1;
        });
        std::ranges::fill(isDirty_, std::uint8_t{0});
        bool isChanged = false;
        for (Label c = 0; c < cellCount(); ++c) {
            if (isBad[index(c)] == 0) continue;
            isChanged = true;
            ++level_[index(c)];
            for (const Label f : input_.probe.cellFaces[c])
                for (const Label other : input_.probe.faceCells[index(f)])
                    if (other >= 0) isDirty_[index(other)] = 1;
        }
        parallelFor(cellCount(), [&](Label c) {
            if (isBad[index(c)] != 0) raise(c);
        });
        return isChanged;
    }

    BoundaryPolygons collect() {
        constexpr Label block = 512;
        const Label blocks = (cellCount() + block - 1) / block;
        std::vector<BoundaryPolygons> parts(index(blocks));
        parallelBlocks(cellCount(), block, [&](Label b, Label first, Label last) {
            BoundaryPolygons& part = parts[index(b)];
            CellGroups groups;
            for (Label c = first; c < last; ++c) {
                const Label before = part.polygons.size();
                if (isCut(c)) {
                    group(c, groups);
                    groups.reduce(input_,
                                  fidelity_.deviation > 0 ? toleranceOf(c) : 0.0,
                                  [&](Label p) { return isKept(p); });
                    for (const CellGroups::Face& face : groups.faces()) {
                        part.polygons.add(
                            std::span<const Label>(face.points.data(), face.points.size()));
                        part.region.push_back(face.region);
                    }
                }
                part.offsets.push_back(part.polygons.size() - before);
            }
        });
        BoundaryPolygons all;
        all.offsets.assign(1, 0);
        std::vector<Rows<Label>> rows;
        for (BoundaryPolygons& part : parts) {
            for (const Label count : part.offsets)
                all.offsets.push_back(all.offsets.back() + count);
            all.region.insert(all.region.end(), part.region.begin(), part.region.end());
            rows.push_back(std::move(part.polygons));
        }
        all.polygons = joined(rows);
        return all;
    }

    void reduceFaces() {
        Rows<Label> reduced;
        reduced.offsets.reserve(loops_.polygons.offsets.size());
        reduced.values.reserve(loops_.polygons.values.size());
        for (Label k = 0; k < loops_.polygons.size(); ++k) {
            for (const Label p : loops_.polygons[k])
                if (isKept(p)) reduced.values.push_back(p);
            reduced.offsets.push_back(toLabel(reduced.values.size()));
        }
        loops_.polygons = std::move(reduced);
    }

    CellInput input_;
    const std::vector<double>& cellSizes_;
    const Fidelity& fidelity_;
    std::array<Level, lastLevel + 1> levels_;
    FaceLoops& loops_;
    std::vector<std::uint8_t> level_;
    std::vector<std::uint8_t> isDirty_;
};

} // namespace

BoundaryPolygons simplify(const Probe& probe,
                          const CuttingSurface& cutter,
                          const Arrangement& arrangement,
                          const PointPositions& positions,
                          const CellPieces& pieces,
                          const std::vector<double>& cellSizes,
                          const Fidelity& fidelity,
                          FaceLoops& loops) {
    return Simplification(probe, cutter, arrangement, positions, pieces, cellSizes, fidelity, loops)
        .run();
}

} // namespace polymesh
