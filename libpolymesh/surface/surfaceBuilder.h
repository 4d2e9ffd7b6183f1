// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/surface/triSurface.h"

#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace polymesh {

/// Puts a surface together from what files hold, so that TriSurface's laws are kept: equal points
/// (compared bit for bit, but -0 equals 0) become one, triangles with two equal corners are
/// dropped, regions of the same name become one.
class SurfaceBuilder {
public:
    /// The label of this point. Requires: finite coordinates. Throws InputError when labels run
    /// out.
    Label addPoint(const Vec3& point);

    /// The label of the region with this name, made a word first (see regions.h); "" is the region
    /// that finish() names.
    Label addRegion(std::string_view name);

    /// Adds the polygon as triangles: see polygonTriangles.h. Less than three corners add nothing.
    void addPolygon(std::span<const Label> corners, Label region);

    Label pointCount() const { return toLabel(surface_.points.size()); }

    /// The surface without unused points and empty regions, in the order in which they came; the
    /// builder is left empty. `defaultName` names the region of triangles that had none.
    TriSurface finish(std::string_view defaultName);

private:
    void growTable();
    void addTriangle(Label a, Label b, Label c, Label region);

    TriSurface surface_;
    std::unordered_map<std::string, Label> regionLabels_;
    std::vector<Label> table_; // open addressing: point labels, -1 = free; size a power of two
};

} // namespace polymesh
