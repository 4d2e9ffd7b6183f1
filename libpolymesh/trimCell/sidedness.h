// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/surface/boxTree.h"
#include "libpolymesh/trim/arrangement.h"

#include <cstdint>
#include <vector>

namespace polymesh {

/// The surface with a tree of its triangles' boxes.
class SearchedSurface {
public:
    explicit SearchedSurface(const CuttingSurface& cutter)
        : cutter_(cutter), tree_(cutter.triangleBoxes), box_(boundingBox(cutter.surface->points)) {}

    const CuttingSurface& cutter() const { return cutter_; }

    /// The triangles whose boxes overlap a box, ascending. Cost: logarithmic, and what is found.
    void findNear(const Box& box, std::vector<Label>& triangles) const;

    /// The winding number of the moved surface round a mesh point: what rays along x, y and z
    /// cross, by majority. Source: the paper, section 2.1.
    int windingOf(const Vec3& meshPoint) const;

private:
    int windingAlong(const Vec3& from, int axis) const;

    const CuttingSurface& cutter_;
    BoxTree tree_;
    Box box_;
};

/// The winding number round each cell that is not in the probe, plus `shift`, by rays from one of
/// its nodes; 0 for probed cells. Nothing is taken over from cell to cell. Cost: three rays a cell.
std::vector<std::int8_t> windCellsOneByOne(const PolyMesh& mesh,
                                           const Probe& probe,
                                           const SearchedSurface& surface,
                                           int shift);

} // namespace polymesh
