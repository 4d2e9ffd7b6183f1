// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/refine/processAddressing.h"

#include "libpolymesh/base/parallel.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace polymesh {
namespace {

/// A face to a cell of another process.
struct OuterFace {
    const FaceList* list = nullptr;
    std::size_t face = 0;
    Label label = -1; // in the mesh of all; -1: the other process says

    Label own() const { return list->owner[face]; }

    Label other() const { return list->neighbour[face]; }
};

using OuterFaces = std::vector<std::vector<OuterFace>>; // to each process

std::size_t rankOf(const std::vector<Label>& firstCells, Label cell) {
    const auto after = std::ranges::upper_bound(firstCells, cell);
    return static_cast<std::size_t>(after - firstCells.begin()) - 1;
}

OuterFaces outerFaces(const std::vector<InternalFaces>& internal,
                      const std::vector<Label>& firstCells,
                      Label firstFace) {
    OuterFaces faces(firstCells.size() - 1);
    for (const InternalFaces& block : internal) {
        for (std::size_t f = 0; f < block.toHigher.owner.size(); ++f)
            faces[rankOf(firstCells, block.toHigher.neighbour[f])].push_back(
                {&block.toHigher, f, firstFace + block.toHigher.place[f]});
        for (std::size_t f = 0; f < block.toLower.owner.size(); ++f)
            faces[rankOf(firstCells, block.toLower.neighbour[f])].push_back(
                {&block.toLower, f, -1});
        firstFace += block.count;
    }
    // Higher processes sort by their neighbours first, as the lower ones have the faces anyway.
    for (std::vector<OuterFace>& list : faces)
        if (!list.empty() && list.front().other() < list.front().own())
            std::ranges::stable_sort(
                list, {}, [](const OuterFace& f) { return std::pair(f.other(), f.own()); });
    return faces;
}

/// Those that have a lower cell here tell the others which faces they are.
void exchangeLabels(const Processes& processes, OuterFaces& faces) {
    std::vector<std::vector<Label>> told(faces.size());
    for (std::size_t r = 0; r < faces.size(); ++r)
        for (const OuterFace& face : faces[r])
            if (face.label >= 0) told[r].push_back(face.label);
    const std::vector<std::vector<Label>> heard = processes.exchange(told);
    for (std::size_t r = 0; r < faces.size(); ++r)
        for (std::size_t f = 0; f < heard[r].size(); ++f)
            faces[r][f].label = heard[r][f];
}

/// The faces of patches in the mesh of all follow its internal ones patch by patch, in each process
/// by process.
void addPatchFaces(const PolyMesh& mesh,
                   Label internalOfAll,
                   const Processes& processes,
                   ProcessAddressing& addressing) {
    std::vector<Label> sizes;
    for (const Patch& patch : mesh.patches)
        sizes.push_back(patch.size);
    const std::vector<Label> all = processes.gather(sizes);
    Label first = internalOfAll;
    for (std::size_t p = 0; p < sizes.size(); ++p)
        for (int r = 0; r < processes.count(); ++r) {
            const Label size = all[static_cast<std::size_t>(r) * sizes.size() + p];
            for (Label f = 0; f < size && r == processes.rank(); ++f)
                addressing.faces.push_back(first + f + 1);
            first += size;
        }
    for (std::size_t p = 0; p < sizes.size(); ++p)
        addressing.patches.push_back(toLabel(p));
}

void addPatch(int rank, std::size_t other, const std::vector<OuterFace>& faces, PolyMesh& mesh) {
    mesh.patches.push_back({fmt::format("procBoundary{}to{}", rank, other),
                            "processor",
                            mesh.faceCount(),
                            toLabel(faces.size()),
                            {{"inGroups", "1(processor)"},
                             {"matchTolerance", "0.0001"},
                             {"transform", "unknown"},
                             {"myProcNo", std::to_string(rank)},
                             {"neighbProcNo", std::to_string(other)}}});
    for (const OuterFace& face : faces) {
        mesh.faces.add(face.list->points[static_cast<Label>(face.face)]);
        mesh.owner.push_back(face.own());
    }
}

} // namespace

void addProcessPatches(const std::vector<InternalFaces>& internal,
                       const std::vector<Label>& firstCells,
                       const Processes& processes,
                       PolyMesh& mesh,
                       ProcessAddressing& addressing) {
    Label count = 0;
    for (const InternalFaces& block : internal)
        count += block.count;
    const std::vector<Label> counts = processes.gather(std::vector<Label>{count});
    const Label firstFace =
        std::accumulate(counts.begin(), counts.begin() + processes.rank(), Label{0});
    Label blockFirst = firstFace;
    for (const InternalFaces& block : internal) {
        for (const Label place : block.inner.place)
            addressing.faces.push_back(blockFirst + place + 1);
        blockFirst += block.count;
    }
    addPatchFaces(
        mesh, std::accumulate(counts.begin(), counts.end(), Label{0}), processes, addressing);
    OuterFaces faces = outerFaces(internal, firstCells, firstFace);
    exchangeLabels(processes, faces);
    for (std::size_t r = 0; r < faces.size(); ++r) {
        if (faces[r].empty()) continue;
        addPatch(processes.rank(), r, faces[r], mesh);
        addressing.patches.push_back(-1);
        for (const OuterFace& face : faces[r])
            addressing.faces.push_back(face.other() > face.own() ? face.label + 1
                                                                 : -face.label - 1);
    }
}

void useOwnLabels(Label firstCell, PolyMesh& mesh, ProcessAddressing& addressing) {
    addressing.points = mesh.faces.values;
    std::sort(addressing.points.begin(), addressing.points.end());
    addressing.points.erase(std::unique(addressing.points.begin(), addressing.points.end()),
                            addressing.points.end());
    parallelFor(toLabel(mesh.faces.values.size()), [&](Label i) {
        Label& p = mesh.faces.values[index(i)];
        p = static_cast<Label>(std::ranges::lower_bound(addressing.points, p) -
                               addressing.points.begin());
    });
    for (Label& cell : mesh.owner)
        cell -= firstCell;
    for (Label& cell : mesh.neighbour)
        cell -= firstCell;
    addressing.cells.resize(index(mesh.cellCount));
    std::iota(addressing.cells.begin(), addressing.cells.end(), firstCell);
}

} // namespace polymesh
