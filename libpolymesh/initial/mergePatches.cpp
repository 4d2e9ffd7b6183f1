// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/initial/mergePatches.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/initial/joinFaces.h"
#include "libpolymesh/surface/boxTree.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace polymesh {
namespace {

const Patch& findPatch(const PolyMesh& mesh, const std::string& name, const std::string& where) {
    const auto found = std::ranges::find(mesh.patches, name, &Patch::name);
    std::vector<std::string> names;
    if (found == mesh.patches.end())
        for (const Patch& patch : mesh.patches)
            names.push_back(patch.name);
    require(found != mesh.patches.end(),
            "{}: there is no patch {}; expected one of: {}",
            where,
            name,
            fmt::join(names, ", "));
    return *found;
}

std::vector<Label> pointsOf(const PolyMesh& mesh, const Patch& patch) {
    std::vector<Label> points;
    for (Label f = patch.start; f < patch.start + patch.size; ++f)
        points.insert(points.end(), mesh.faces[f].begin(), mesh.faces[f].end());
    std::ranges::sort(points);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

/// A tenth of the shortest edge of a patch.
double tolerance(const PolyMesh& mesh, const Patch& patch) {
    double least2 = std::numeric_limits<double>::infinity();
    for (Label f = patch.start; f < patch.start + patch.size; ++f) {
        const std::span<const Label> face = mesh.faces[f];
        for (std::size_t i = 0; i < face.size(); ++i)
            least2 = std::min(least2,
                              squaredNorm(mesh.points[index(face[i])] -
                                          mesh.points[index(face[(i + 1) % face.size()])]));
    }
    return 0.1 * std::sqrt(least2);
}

/// For each point of the mesh the one that takes its place: those of the slave become points of
/// the master where they lie on one.
std::vector<Label> mergedPoints(const PolyMesh& mesh, const Patch& master, const Patch& slave) {
    std::vector<Label> merged(mesh.points.size());
    std::iota(merged.begin(), merged.end(), Label{0});
    const std::vector<Label> targets = pointsOf(mesh, master);
    std::vector<Box> boxes;
    boxes.reserve(targets.size());
    for (const Label p : targets)
        boxes.push_back({mesh.points[index(p)], mesh.points[index(p)]});
    const BoxTree tree(boxes);
    const double reach = std::min(tolerance(mesh, master), tolerance(mesh, slave));
    for (const Label p : pointsOf(mesh, slave)) {
        double best = reach * reach;
        tree.searchNearest(mesh.points[index(p)], [&](Label item) {
            const Label target = targets[index(item)];
            const double distance2 =
                squaredNorm(mesh.points[index(target)] - mesh.points[index(p)]);
            if (distance2 < best) {
                best = distance2;
                merged[index(p)] = target;
            }
            return distance2;
        });
    }
    return merged;
}

std::vector<Label>
sortedPoints(const PolyMesh& mesh, Label face, const std::vector<Label>& merged) {
    std::vector<Label> points;
    for (const Label p : mesh.faces[face])
        points.push_back(merged[index(p)]);
    std::ranges::sort(points);
    return points;
}

/// The faces of master and slave that are one, in pairs.
std::vector<FacePair> matchingFaces(const PolyMesh& mesh,
                                    const Patch& master,
                                    const PatchPair& pair,
                                    const std::vector<Label>& merged) {
    const Patch& slave = findPatch(mesh, pair.slave, pair.where);
    std::map<std::vector<Label>, Label> masterFaces;
    for (Label f = master.start; f < master.start + master.size; ++f)
        masterFaces[sortedPoints(mesh, f, merged)] = f;
    std::vector<FacePair> result;
    for (Label f = slave.start; f < slave.start + slave.size; ++f) {
        const auto found = masterFaces.find(sortedPoints(mesh, f, merged));
        if (found == masterFaces.end()) continue;
        result.push_back({found->second, f});
        masterFaces.erase(found);
    }
    require(toLabel(result.size()) == std::min(master.size, slave.size),
            "{}: mergePatchPairs ({} {}): merging patches is not supported when faces of both are "
            "left over; give the blocks the same cells where they touch",
            pair.where,
            pair.master,
            pair.slave);
    return result;
}

} // namespace

void mergePatches(PolyMesh& mesh, const PatchPair& pair) {
    const Patch& master = findPatch(mesh, pair.master, pair.where);
    const Patch& slave = findPatch(mesh, pair.slave, pair.where);
    require(&master != &slave,
            "{}: patch {} is paired with itself; name two patches that touch",
            pair.where,
            pair.master);
    std::vector<Label> merged = mergedPoints(mesh, master, slave);
    const std::vector<FacePair> matching = matchingFaces(mesh, master, pair, merged);
    joinFaces(mesh, std::move(merged), matching);
}

} // namespace polymesh
