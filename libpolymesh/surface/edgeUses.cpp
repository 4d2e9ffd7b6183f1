// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/surface/edgeUses.h"

#include "libpolymesh/base/parallel.h"

#include <algorithm>
#include <numeric>

namespace polymesh {

namespace {

template<class Body>
void forEachSide(const TriSurface& surface, Body&& body) {
    for (Label t = 0; t < surface.triangleCount(); ++t) {
        const auto& corners = surface.triangles[index(t)];
        for (std::size_t i = 0; i < 3; ++i)
            body(corners[i], corners[i == 2 ? 0 : i + 1], t, static_cast<std::int8_t>(i));
    }
}

} // namespace

Rows<SurfaceEdgeUse> collectEdgeUses(const TriSurface& surface) {
    Rows<SurfaceEdgeUse> uses;
    uses.offsets.assign(surface.points.size() + 1, 0);
    forEachSide(surface, [&](Label from, Label to, Label, std::int8_t) {
        ++uses.offsets[index(std::min(from, to)) + 1];
    });
    std::partial_sum(uses.offsets.begin(), uses.offsets.end(), uses.offsets.begin());
    uses.values.resize(3 * surface.triangles.size());

    std::vector<Label> next(uses.offsets.begin(), uses.offsets.end() - 1);
    forEachSide(surface, [&](Label from, Label to, Label t, std::int8_t corner) {
        const Label slot = next[index(std::min(from, to))]++;
        uses.values[index(slot)] = {std::max(from, to), t, corner, from < to};
    });
    parallelFor(uses.size(), [&](Label point) {
        std::ranges::sort(uses[point], [](const SurfaceEdgeUse& a, const SurfaceEdgeUse& b) {
            return a.upper != b.upper ? a.upper < b.upper : a.triangle < b.triangle;
        });
    });
    return uses;
}

} // namespace polymesh
