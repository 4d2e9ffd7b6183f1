// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/repairSurface.h"

#include "libpolymesh/surface/measure.h"
#include "libpolymesh/surfaceRepair/joinCracks.h"
#include "libpolymesh/surfaceRepair/uniteSurface.h"

#include <utility>

namespace polymesh::tools {

std::string closeCracks(ToolRun& tool, TriSurface& surface) {
    const auto joined = joinCracks(surface);
    if (!joined) return "";
    tool.report["surface"]["joinedCracks"] = {{"openEdges", joined->openEdges},
                                              {"points", joined->points},
                                              {"largestMove", joined->largestMove},
                                              {"limit", joined->limit}};
    return fmt::format("{} open edges, closed by joining {} points that differ by rounding: by at "
                       "most {:.3g} m, where the file's precision explains {:.3g} m",
                       joined->openEdges,
                       joined->points,
                       joined->largestMove,
                       joined->limit);
}

std::string uniteParts(ToolRun& tool, TriSurface& surface) {
    auto united = uniteSurface(surface);
    if (!united) return "";
    const double before = measure(surface).volume;
    const double after = measure(united->surface).volume;
    tool.report["surface"]["united"] = {{"dividedTriangles", united->divided},
                                        {"triangles", united->surface.triangleCount()},
                                        {"pairsLeft", united->pairsLeft},
                                        {"rounds", united->rounds},
                                        {"largestMove", united->largestMove},
                                        {"volumeBefore", before},
                                        {"volume", after}};
    const Label count = surface.triangleCount();
    surface = std::move(united->surface);
    const std::string left =
        united->pairsLeft == 0
            ? ""
            : fmt::format(
                  "; {} pairs are left that intersect by rounding, where cells can be wrong",
                  united->pairsLeft);
    return fmt::format("{} of {} triangles divided along the lines where they meet, what is inside "
                       "(winding number 1 or more) united: {} triangles, volume {:.9g} (before: "
                       "{:.9g}) m^3, points within {:.2g} m of their exact places{}",
                       united->divided,
                       count,
                       surface.triangleCount(),
                       after,
                       before,
                       united->largestMove,
                       left);
}

} // namespace polymesh::tools
