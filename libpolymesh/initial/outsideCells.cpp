// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/outsideCells.h"

#include "libpolymesh/base/disjointSets.h"
#include "libpolymesh/base/freshList.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/surface/triangleBins.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace polymesh {

namespace {

using Counts = std::array<Label, 3>;

/// Consecutive flagged cells [first, last) of a row along x.
struct Run {
    Label first;
    Label last;
    bool isAtSide; // of the box
};

/// The bins of the grid planes, in each direction.
std::array<std::vector<TriangleBins::Index>, 3> binsOfPlanes(const CartesianBox& box,
                                                             const TriangleBins& bins) {
    const CartesianMesh mesh(box);
    const auto& [nx, ny, nz] = box.cells;
    const Counts stride{1, nx + 1, (nx + 1) * (ny + 1)}; // of point labels
    std::array<std::vector<TriangleBins::Index>, 3> planes;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (Label i = 0; i <= box.cells[axis]; ++i)
            planes[axis].push_back(bins.binOf(mesh.point(i * stride[axis])));
    return planes;
}

/// Flags the cells that have no triangle in their bins nor in those of the cells round them.
std::vector<std::uint8_t> farCells(const CartesianBox& box, const TriSurface& surface) {
    const Label nx = box.cells[0];
    const Label ny = box.cells[1];
    const Label nz = box.cells[2];
    const Vec3 size = box.box.size();
    const TriangleBins bins(surface, size.x / static_cast<double>(nx));
    const auto planes = binsOfPlanes(box, bins);
    std::vector<std::uint8_t> isFar = freshList<std::uint8_t>(index(nx * ny * nz));
    const auto setRange = [&](TriangleBins::Range& range, int axis, Label i) {
        const auto& ofAxis = planes[static_cast<std::size_t>(axis)];
        const Label end = toLabel(ofAxis.size()) - 1;
        range.first[axis] = ofAxis[index(std::max(i - 1, Label{0}))][axis];
        range.last[axis] = ofAxis[index(std::min(i + 2, end))][axis];
    };
    parallelBlocks(ny * nz, 8, [&](Label, Label firstRow, Label lastRow) {
        for (Label row = firstRow; row < lastRow; ++row) {
            TriangleBins::Range range;
            setRange(range, 1, row % ny);
            setRange(range, 2, row / ny);
            for (Label i = 0; i < nx; ++i) {
                setRange(range, 0, i);
                isFar[index(row * nx + i)] = bins.isOccupied(range) ? 0 : 1;
            }
        }
    });
    return isFar;
}

/// The regions of flagged cells that hang together by faces.
class Regions {
public:
    Regions(const Counts& cells, const std::vector<std::uint8_t>& flags) : cells_(cells) {
        const auto& [nx, ny, nz] = cells;
        for (Label row = 0; row < ny * nz; ++row) {
            firstRun_.push_back(toLabel(runs_.size()));
            addRuns(flags, row);
            if (row % ny > 0) joinRows(row, row - 1);
            if (row >= ny) joinRows(row, row - ny);
        }
        firstRun_.push_back(toLabel(runs_.size()));
    }

    /// Takes the flags from all cells but those of regions that reach the sides of the box.
    void keepOutermost(std::vector<std::uint8_t>& flags) {
        const std::vector<std::uint8_t> isAtSide = regionsAtSide();
        for (Label row = 0; row + 1 < toLabel(firstRun_.size()); ++row)
            for (Label r = firstRun_[index(row)]; r < firstRun_[index(row) + 1]; ++r) {
                if (isAtSide[index(regions_.lowest(r))] != 0) continue;
                const Run& run = runs_[index(r)];
                const auto begin = flags.begin() + std::ptrdiff_t{row} * cells_[0];
                std::fill(begin + run.first, begin + run.last, std::uint8_t{0});
            }
    }

private:
    void addRuns(const std::vector<std::uint8_t>& flags, Label row) {
        const auto& [nx, ny, nz] = cells_;
        const Label j = row % ny;
        const Label k = row / ny;
        const bool isSideRow = j == 0 || j + 1 == ny || k == 0 || k + 1 == nz;
        const auto begin = flags.begin() + std::ptrdiff_t{row} * nx;
        const auto end = begin + nx;
        for (auto at = std::find(begin, end, std::uint8_t{1}); at != end;) {
            const auto stop = std::find(at, end, std::uint8_t{0});
            runs_.push_back({static_cast<Label>(at - begin),
                             static_cast<Label>(stop - begin),
                             isSideRow || at == begin || stop == end});
            regions_.add();
            at = std::find(stop, end, std::uint8_t{1});
        }
    }

    /// Joins the runs of the last row with those of one before that they touch.
    void joinRows(Label row, Label before) {
        const Label end = toLabel(runs_.size());
        const Label endBefore = firstRun_[index(before) + 1];
        Label a = firstRun_[index(row)];
        Label b = firstRun_[index(before)];
        while (a < end && b < endBefore) {
            const Run& one = runs_[index(a)];
            const Run& other = runs_[index(b)];
            const bool isOneFirst = one.last < other.last;
            if (one.first < other.last && other.first < one.last) regions_.join(a, b);
            ++(isOneFirst ? a : b);
        }
    }

    /// Flags the lowest runs of the regions that reach the sides of the box.
    std::vector<std::uint8_t> regionsAtSide() {
        std::vector<std::uint8_t> isAtSide(runs_.size(), 0);
        for (Label r = 0; r < regions_.count(); ++r)
            if (runs_[index(r)].isAtSide) isAtSide[index(regions_.lowest(r))] = 1;
        return isAtSide;
    }

    Counts cells_;
    std::vector<Run> runs_;
    DisjointSets regions_;        // of runs
    std::vector<Label> firstRun_; // of each row
};

} // namespace

std::vector<std::uint8_t> outsideCells(const CartesianBox& box, const TriSurface& surface) {
    std::vector<std::uint8_t> flags = farCells(box, surface);
    Regions(box.cells, flags).keepOutermost(flags);
    return flags;
}

} // namespace polymesh
