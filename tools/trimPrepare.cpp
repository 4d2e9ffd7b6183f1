// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/trimPrepare.h"

#include "formats/foam/dictionary.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/base/nearestWord.h"
#include "libpolymesh/surface/check.h"
#include "libpolymesh/surface/triangleBoxes.h"
#include "tools/repairSurface.h"
#include "tools/turnedText.h"

#include <algorithm>
#include <cmath>

namespace polymesh::tools {

namespace {

constexpr Label placesShown = 3;

std::string text(const Vec3& p) {
    return fmt::format("({:.6g} {:.6g} {:.6g})", p.x, p.y, p.z);
}

std::string text(const Box& box) {
    return text(box.min) + " " + text(box.max);
}

nlohmann::ordered_json toJson(const Vec3& p) {
    return {p.x, p.y, p.z};
}

nlohmann::ordered_json toJson(const Box& box) {
    return {toJson(box.min), toJson(box.max)};
}

/// The types that need neither further entries nor a mesh of a special kind.
std::string checkedType(const std::string& type, const std::string& place) {
    static const std::vector<std::string> types{"wall", "patch", "symmetry", "symmetryPlane"};
    require(std::ranges::find(types, type) != types.end(),
            "{}: '{}': expected one of {}; nearest: {}",
            place,
            type,
            fmt::join(types, ", "),
            nearestWord(type, types));
    return type;
}

/// A place near which two triangles meet: the middle of what their boxes share.
Vec3 meetingPlace(const TriSurface& surface, const std::array<Label, 2>& pair) {
    const Box a = triangleBox(surface, pair[0]);
    const Box b = triangleBox(surface, pair[1]);
    Vec3 middle;
    for (int axis = 0; axis < 3; ++axis)
        middle[axis] =
            0.5 * (std::max(a.min[axis], b.min[axis]) + std::min(a.max[axis], b.max[axis]));
    return middle;
}

/// Unites what overlaps, and says so.
void mendSelfIntersections(ToolRun& tool, const std::string& file, TriSurface& surface) {
    const SelfIntersections found = findSelfIntersections(surface, placesShown);
    auto& report = tool.report["surface"]["selfIntersections"];
    report = {{"pairs", found.count}, {"places", nlohmann::ordered_json::array()}};
    if (found.count == 0) return;
    std::string places;
    for (const auto& pair : found.first) {
        const Vec3 place = meetingPlace(surface, pair);
        report["places"].push_back(toJson(place));
        places += (places.empty() ? "" : ", ") + text(place);
    }
    const std::string done = uniteParts(tool, surface);
    tool.warn("{}: the surface intersects itself: {} pairs of triangles, near {}; {}",
              file,
              found.count,
              places,
              done.empty() ? "they could not be united, so that cells at these places, and their "
                             "volume, can be wrong; better unite the parts that overlap"
                           : done);
}

/// What is unusual but does no harm.
void mention(ToolRun& tool, const SurfaceDefects& defects) {
    auto& report = tool.report["surface"];
    report["duplicateTriangles"] = defects.duplicateTriangles.count;
    report["zeroAreaTriangles"] = defects.zeroAreaTriangles.count;
    report["nonManifoldEdges"] = defects.nonManifoldEdges.count;
    std::string list;
    const auto add = [&](const Finding& finding, const char* what) {
        if (finding.count > 0)
            list += fmt::format("{}{} {}, one at {}",
                                list.empty() ? "" : "; ",
                                finding.count,
                                what,
                                text(finding.first));
    };
    add(defects.duplicateTriangles, "triangles that are there twice");
    add(defects.zeroAreaTriangles, "triangles without area");
    add(defects.nonManifoldEdges, "edges of more than two triangles");
    if (!list.empty()) tool.say("unusual    {}", list);
}

/// True when triangles were turned.
bool turnOutward(ToolRun& tool, TriSurface& surface) {
    const OrientationReport turned = orientSurface(surface);
    tool.report["surface"]["turnedTriangles"] = turned.turnedTriangles;
    if (turned.turnedTriangles > 0) tool.say("turned     {}", turnedText(turned));
    return turned.turnedTriangles > 0;
}

void requireOriented(const std::string& file, const Finding& misoriented) {
    require(
        misoriented.count == 0,
        "{}: {} edges are used twice in the same direction, one at {}, and turning triangles "
        "does not help: the surface crosses itself there like a Moebius band, or sheets hang on "
        "it; remove them in a surface editor and try again",
        file,
        misoriented.count,
        text(misoriented.first));
}

} // namespace

std::vector<std::string> patchTypes(const ToolRun& tool, const TriSurface& surface) {
    const std::string all =
        checkedType(tool.settings.text("patchType", "wall"), tool.settings.place("patchType"));
    std::vector<std::string> types(surface.regionNames.size(), all);
    if (tool.dictionary.empty()) return types;
    const foam::Dictionary dictionary = foam::readDictionary(tool.dictionary);
    if (!dictionary.has("patchTypes")) return types;
    const bool isOverruled = tool.settings.isOption("patchType");
    for (const foam::Entry& entry : dictionary.dictionary("patchTypes").entries()) {
        const std::string place = fmt::format("{}: {}", entry.place.text(), entry.key);
        const auto region = std::ranges::find(surface.regionNames, entry.key);
        require(region != surface.regionNames.end(),
                "{}: the surface has no region of this name; the nearest is {}",
                place,
                nearestWord(entry.key, surface.regionNames));
        const std::string type = checkedType(entry.value().word(entry.key), place);
        if (!isOverruled)
            types[static_cast<std::size_t>(region - surface.regionNames.begin())] = type;
    }
    return types;
}

void prepareSurface(ToolRun& tool, const std::string& file, TriSurface& surface) {
    tool.report["surface"]["file"] = file;
    tool.report["surface"]["triangles"] = surface.triangleCount();
    SurfaceDefects defects = checkSurface(surface);
    if (defects.openEdges.count > 0)
        if (const std::string done = closeCracks(tool, surface); !done.empty()) {
            tool.warn("{}: {}", file, done);
            defects = checkSurface(surface);
        }
    require(defects.openEdges.count == 0,
            "{}: the surface is open: {} edges without a partner, one at {}; close the gaps (or "
            "join points that should be one) and try again",
            file,
            defects.openEdges.count,
            text(defects.openEdges.first));
    mention(tool, defects);
    if (turnOutward(tool, surface) || !defects.isClosed())
        requireOriented(file, checkSurface(surface).misorientedEdges);
    tool.clock.start("self-intersections");
    mendSelfIntersections(tool, file, surface);
}

bool checkPlace(ToolRun& tool,
                const std::string& file,
                const TriSurface& surface,
                const Box& domain) {
    const Vec3 size = domain.size();
    require(std::isfinite(squaredNorm(size)) && std::isfinite(size.x * size.y * size.z),
            "{}: the mesh spans {} [m]: coordinates so large have no volume; find the points that "
            "are out of place",
            tool.meshDir().string(),
            text(domain));
    const Box part = boundingBox(surface.points);
    tool.report["surface"]["box"] = toJson(part);
    tool.report["meshBox"] = toJson(domain);
    require(overlaps(part, domain),
            "{}: the surface is outside the mesh: it spans {}, the mesh {} [m]; check its unit and "
            "place",
            file,
            text(part),
            text(domain));
    const bool isWithin = domain.contains(part.min) && domain.contains(part.max);
    if (!isWithin)
        tool.warn(
            "{}: the surface is partly outside the mesh: it spans {}, the mesh {} [m]; where it "
            "leaves the mesh, the mesh's own patches close the domain",
            file,
            text(part),
            text(domain));
    return isWithin;
}

} // namespace polymesh::tools
