// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mesh/valences.h"

#include "libpolymesh/base/kept.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/base/rows.h"

#include <algorithm>
#include <vector>

namespace polymesh {

namespace {

/// Cells with a face on the boundary from `first` on, numbered; -1 for the others.
std::vector<Label> numberCells(const PolyMesh& mesh, Label first) {
    std::vector<Label> numbers(index(mesh.cellCount), -1);
    Label count = 0;
    for (Label f = std::max(first, mesh.internalFaceCount()); f < mesh.faceCount(); ++f) {
        Label& number = numbers[index(mesh.owner[index(f)])];
        if (number < 0) number = count++;
    }
    return numbers;
}

/// The faces of numbered cells.
std::vector<Label> facesOfCells(const PolyMesh& mesh, std::span<const Label> numbers) {
    const auto isNumbered = [&](Label c) { return numbers[index(c)] >= 0; };
    const Kept kept(mesh.faceCount(), [&](Label f) {
        return isNumbered(mesh.owner[index(f)]) ||
               (mesh.isInternal(f) && isNumbered(mesh.neighbour[index(f)]));
    });
    std::vector<Label> faces(index(kept.count()));
    kept.forEach([&](Label f, Label to) { faces[index(to)] = f; });
    return faces;
}

/// Calls `body(number, face)` for each of the faces and each numbered cell that has it.
template<class Body>
void forCellsOf(std::span<const Label> faces,
                const PolyMesh& mesh,
                std::span<const Label> numbers,
                Body&& body) {
    for (const Label f : faces) {
        if (const Label c = numbers[index(mesh.owner[index(f)])]; c >= 0) body(c, f);
        if (!mesh.isInternal(f)) continue;
        if (const Label c = numbers[index(mesh.neighbour[index(f)])]; c >= 0) body(c, f);
    }
}

/// The points of each numbered cell, each once for each of its faces there: as many as edges.
Rows<Label> pointsOfFaces(const PolyMesh& mesh, std::span<const Label> numbers) {
    const Label count = numbers.empty() ? 0 : std::ranges::max(numbers) + 1;
    Rows<Label> rows;
    rows.offsets.assign(index(count) + 1, 0);
    const std::vector<Label> faces = facesOfCells(mesh, numbers);
    forCellsOf(faces, mesh, numbers, [&](Label c, Label f) {
        rows.offsets[index(c) + 1] += mesh.faces.rowSize(f);
    });
    for (std::size_t c = 1; c < rows.offsets.size(); ++c)
        rows.offsets[c] += rows.offsets[c - 1];
    rows.values.resize(index(rows.offsets.back()));
    std::vector<Label> next(rows.offsets.begin(), rows.offsets.end() - 1);
    forCellsOf(faces, mesh, numbers, [&](Label c, Label f) {
        const auto points = mesh.faces[f];
        std::ranges::copy(points, rows.values.begin() + next[index(c)]);
        next[index(c)] += toLabel(points.size());
    });
    return rows;
}

/// Adds the nodes of one cell; its points are sorted.
void countNodes(std::span<Label> points, ValenceCounts& counts) {
    std::ranges::sort(points);
    for (std::size_t i = 0; i < points.size();) {
        std::size_t end = i + 1;
        while (end < points.size() && points[end] == points[i])
            ++end;
        ++(end - i == 2 ? counts.bends : end - i == 3 ? counts.trivalent : counts.more);
        i = end;
    }
}

} // namespace

ValenceCounts countValences(const PolyMesh& mesh, Label first) {
    constexpr Label blockSize = 2048;
    Rows<Label> points = pointsOfFaces(mesh, numberCells(mesh, first));
    std::vector<ValenceCounts> counts(index(points.size() / blockSize + 1));
    parallelBlocks(points.size(), blockSize, [&](Label block, Label begin, Label end) {
        for (Label c = begin; c < end; ++c)
            countNodes(points[c], counts[index(block)]);
    });
    ValenceCounts sum;
    for (const ValenceCounts& part : counts) {
        sum.bends += part.bends;
        sum.trivalent += part.trivalent;
        sum.more += part.more;
    }
    return sum;
}

} // namespace polymesh
