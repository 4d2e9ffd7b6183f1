// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/simplify.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/trim/cellGroups.h"
#include "libpolymesh/trim/chains.h"
#include "libpolymesh/trim/sharpness.h"

#include <algorithm>
#include <array>

namespace polymesh {

namespace {

/// From much to nothing. Where only features are kept at first, faces that bend more and more are
/// taken apart next: few faces for what the tolerance needs, however fine the triangles are.
std::array<JoinLevel, CellInput::lastLevel + 1> joinLevels(const Fidelity& fidelity) {
    constexpr double any = 4;
    constexpr JoinLevel everything{-2, any};
    if (fidelity.isExact) {
        constexpr JoinLevel flat{-0.5, any};
        return {flat, flat, flat, flat, flat, everything};
    }
    const double sharp = fidelity.featureAngle;
    return {JoinLevel{borderSharpness, any},
            JoinLevel{sharp, any},
            JoinLevel{sharp, 0.7},
            JoinLevel{sharp, 0.35},
            JoinLevel{sharp, 0.12},
            everything};
}

/// The state of the simplification of a whole mesh.
class Simplification {
public:
    Simplification(const Intersection& cut,
                   const PointPositions& positions,
                   const CellPieces& pieces,
                   const Fidelity& fidelity,
                   FaceLoops& loops)
        : input_{cut.probe,
                 cut.cutter,
                 cut.arrangement,
                 positions,
                 pieces,
                 fidelity.sharpness,
                 fidelity.isCorner,
                 joinLevels(fidelity),
                 edgeOfIntervals(cut.arrangement)},
          isExact_(fidelity.isExact),
          tolerances_(fidelity.tolerances),
          loops_(loops),
          kept_(cut.arrangement, loops.isNeeded),
          levels_(pieces.triangle.size(), CellInput::firstLevel),
          isDirty_(index(cut.probe.cellCount()), 1) {
        for (std::size_t c = 0; c < fidelity.isBlunt.size(); ++c)
            if (fidelity.isBlunt[c] != 0)
                std::fill(levels_.begin() + pieces.offsets[c],
                          levels_.begin() + pieces.offsets[c + 1],
                          CellInput::bluntLevel);
    }

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

    /// Raises levels in a cell until its groups are discs, and keeps the pierces that bound them.
    void raise(Label c) {
        if (!isCut(c)) return;
        CellGroups groups;
        do
            groups.build(input_, c, levels_);
        while (groups.raiseBad());
        for (const Label point : groups.endsOfBorders())
            if (input_.arrangement.isPierce(point)) kept_.keep(point);
    }

    /// How far a point that is not kept may be from its face or chord [m]; no matter when exact:
    /// what is free then lies between exactly coplanar triangles.
    double faceTolerance(Label c) const {
        if (isExact_) return Box::inf;
        return tolerances_[index(c)];
    }

    void keepOnFace(Label f) {
        double tolerance = Box::inf;
        for (const Label c : input_.probe.faceCells[index(f)])
            if (c >= 0) tolerance = std::min(tolerance, faceTolerance(c));
        for (Label k = loops_.offsets[index(f)]; k < loops_.offsets[index(f) + 1]; ++k) {
            const auto polygon = loops_.polygons[k];
            if (std::ranges::all_of(polygon, kept_)) continue;
            keepWithin(
                input_.positions,
                polygon,
                tolerance,
                [&](std::size_t i) { return kept_(polygon[i]); },
                [&](std::size_t i) { kept_.keep(polygon[i]); });
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
            if (!kept_(polygon[i]) || kept_(polygon[(i + 1) % n])) continue;
            std::size_t j = i + 1;
            while (!kept_(polygon[j % n]))
                ++j;
            const Label e = edgeOf(polygon[i]);
            if (e < 0 || e != edgeOf(polygon[j % n])) continue;
            double distance = 0;
            kept_.keep(polygon[detail::farthest(input_.positions, polygon, i, j, distance) % n]);
        }
    }

    /// Raises levels where a cell's faces are bad; true when there was something to raise.
    bool raiseBadFaces(Label c, CellGroups& groups) {
        groups.build(input_, c, levels_);
        groups.reduce(input_, tolerances_[index(c)], kept_);
        groups.checkFaces(input_, loops_, faceTolerance(c), kept_);
        return groups.raiseBad();
    }

    bool raiseBadCells() {
        std::vector<std::uint8_t> isRaised(index(cellCount()), 0);
        parallelFor(cellCount(), [&](Label c) {
            if (isDirty_[index(c)] == 0 || !isCut(c)) return;
            CellGroups groups;
            if (raiseBadFaces(c, groups)) isRaised[index(c)] = 1;
        });
        std::ranges::fill(isDirty_, std::uint8_t{0});
        bool isChanged = false;
        for (Label c = 0; c < cellCount(); ++c) {
            if (isRaised[index(c)] == 0) continue;
            isChanged = true;
            for (const Label f : input_.probe.cellFaces[c])
                for (const Label other : input_.probe.faceCells[index(f)])
                    if (other >= 0) isDirty_[index(other)] = 1;
        }
        parallelFor(cellCount(), [&](Label c) {
            if (isRaised[index(c)] != 0) raise(c);
        });
        return isChanged;
    }

    /// Adds the faces of a cell's groups; returns their number.
    Label collectCell(Label c, CellGroups& groups, BoundaryPolygons& part) {
        if (!isCut(c)) return 0;
        groups.build(input_, c, levels_);
        groups.reduce(input_, tolerances_[index(c)], kept_);
        for (const CellGroups::Face& face : groups.faces()) {
            part.polygons.add(std::span<const Label>(face.points.data(), face.points.size()));
            part.region.push_back(face.region);
        }
        return toLabel(groups.faces().size());
    }

    BoundaryPolygons collect() {
        constexpr Label block = 512;
        const Label blocks = (cellCount() + block - 1) / block;
        std::vector<BoundaryPolygons> parts(index(blocks));
        parallelBlocks(cellCount(), block, [&](Label b, Label first, Label last) {
            BoundaryPolygons& part = parts[index(b)];
            CellGroups groups;
            for (Label c = first; c < last; ++c)
                part.offsets.push_back(collectCell(c, groups, part));
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
                if (kept_(p)) reduced.values.push_back(p);
            reduced.offsets.push_back(toLabel(reduced.values.size()));
        }
        loops_.polygons = std::move(reduced);
    }

    CellInput input_;
    bool isExact_;
    std::span<const double> tolerances_;
    FaceLoops& loops_;
    KeptPoints kept_;
    std::vector<std::uint8_t> levels_;  // per piece
    std::vector<std::uint8_t> isDirty_; // per cell: its faces have changed since they were checked
};

} // namespace

BoundaryPolygons simplify(const Intersection& cut,
                          const PointPositions& positions,
                          const CellPieces& pieces,
                          const Fidelity& fidelity,
                          FaceLoops& loops) {
    return Simplification(cut, positions, pieces, fidelity, loops).run();
}

} // namespace polymesh
