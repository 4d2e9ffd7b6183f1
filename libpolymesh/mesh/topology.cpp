// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mesh/topology.h"

#include "libpolymesh/base/disjointSets.h"
#include "libpolymesh/base/freshList.h"
#include "libpolymesh/base/parallel.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace polymesh {

namespace {

/// Turns row sizes, counted into offsets[i + 1], into offsets and reserves the values.
void finishCounting(Rows<Label>& rows) {
    std::partial_sum(rows.offsets.begin(), rows.offsets.end(), rows.offsets.begin());
    rows.values = freshList<Label>(index(rows.offsets.back()));
}

Rows<Label> countedRows(Label rowCount) {
    Rows<Label> rows;
    rows.offsets = freshList<Label>(index(rowCount) + 1);
    return rows;
}

/// Sorts each row and drops what occurs twice.
Rows<Label> uniqueRows(Rows<Label> rows) {
    std::vector<Label> sizes(index(rows.size()));
    parallelFor(rows.size(), [&](Label row) {
        const std::span<Label> values = rows[row];
        std::sort(values.begin(), values.end());
        sizes[index(row)] = toLabel(
            static_cast<std::size_t>(std::unique(values.begin(), values.end()) - values.begin()));
    });
    Label out = 0;
    for (Label row = 0; row < rows.size(); ++row) {
        const auto from = rows.values.begin() + rows.offsets[index(row)];
        rows.offsets[index(row)] = out;
        std::copy(from, from + sizes[index(row)], rows.values.begin() + out);
        out += sizes[index(row)];
    }
    rows.offsets.back() = out;
    rows.values.resize(index(out));
    return rows;
}

} // namespace

Rows<Label> cellFaces(const PolyMesh& mesh) {
    Rows<Label> rows = countedRows(mesh.cellCount);
    for (const Label cell : mesh.owner)
        ++rows.offsets[index(cell) + 1];
    for (const Label cell : mesh.neighbour)
        ++rows.offsets[index(cell) + 1];
    finishCounting(rows);
    std::vector<Label> next(rows.offsets.begin(), rows.offsets.end() - 1);
    for (Label face = 0; face < toLabel(mesh.owner.size()); ++face)
        rows.values[index(next[index(mesh.owner[index(face)])]++)] = face;
    for (Label face = 0; face < mesh.internalFaceCount(); ++face)
        rows.values[index(next[index(mesh.neighbour[index(face)])]++)] = face;
    return rows;
}

Rows<Label> pointFaces(const PolyMesh& mesh) {
    Rows<Label> rows = countedRows(mesh.pointCount());
    for (const Label point : mesh.faces.values)
        ++rows.offsets[index(point) + 1];
    finishCounting(rows);
    std::vector<Label> next(rows.offsets.begin(), rows.offsets.end() - 1);
    for (Label face = 0; face < mesh.faceCount(); ++face)
        for (const Label point : mesh.faces[face])
            rows.values[index(next[index(point)]++)] = face;
    return rows;
}

Rows<Label> pointCells(const PolyMesh& mesh) {
    Rows<Label> rows = countedRows(mesh.pointCount());
    for (Label face = 0; face < mesh.faceCount(); ++face)
        for (const Label point : mesh.faces[face])
            rows.offsets[index(point) + 1] += mesh.isInternal(face) ? 2 : 1;
    finishCounting(rows);
    std::vector<Label> next(rows.offsets.begin(), rows.offsets.end() - 1);
    for (Label face = 0; face < mesh.faceCount(); ++face)
        for (const Label point : mesh.faces[face]) {
            rows.values[index(next[index(point)]++)] = mesh.owner[index(face)];
            if (mesh.isInternal(face))
                rows.values[index(next[index(point)]++)] = mesh.neighbour[index(face)];
        }
    return uniqueRows(std::move(rows));
}

Rows<Label> cellPoints(const PolyMesh& mesh, const Rows<Label>& cellFaces) {
    Rows<Label> rows = countedRows(cellFaces.size());
    for (Label cell = 0; cell < cellFaces.size(); ++cell)
        for (const Label face : cellFaces[cell])
            rows.offsets[index(cell) + 1] += mesh.faces.rowSize(face);
    finishCounting(rows);
    parallelFor(cellFaces.size(), [&](Label cell) {
        auto out = rows[cell].begin();
        for (const Label face : cellFaces[cell])
            out = std::copy(mesh.faces[face].begin(), mesh.faces[face].end(), out);
    });
    return uniqueRows(std::move(rows));
}

std::vector<Edge> edges(const PolyMesh& mesh) {
    Rows<Label> higher = countedRows(mesh.pointCount()); // other ends with a higher label
    const auto forEachEdge = [&](auto&& use) {
        for (Label face = 0; face < mesh.faceCount(); ++face) {
            const std::span<const Label> points = mesh.faces[face];
            for (std::size_t i = 0; i < points.size(); ++i) {
                const Label a = points[i];
                const Label b = points[i + 1 == points.size() ? 0 : i + 1];
                use(std::min(a, b), std::max(a, b));
            }
        }
    };
    forEachEdge([&](Label low, Label) { ++higher.offsets[index(low) + 1]; });
    finishCounting(higher);
    std::vector<Label> next(higher.offsets.begin(), higher.offsets.end() - 1);
    forEachEdge([&](Label low, Label high) { higher.values[index(next[index(low)]++)] = high; });
    higher = uniqueRows(std::move(higher));

    std::vector<Edge> result;
    result.reserve(higher.values.size());
    for (Label low = 0; low < higher.size(); ++low)
        for (const Label high : higher[low])
            result.push_back({low, high});
    return result;
}

std::vector<Label> cellRegions(const PolyMesh& mesh) {
    DisjointSets regions(mesh.cellCount);
    for (Label face = 0; face < mesh.internalFaceCount(); ++face)
        regions.join(mesh.owner[index(face)], mesh.neighbour[index(face)]);
    return std::move(regions).numbers().of;
}

bool isCoupledType(const std::string& patchType) {
    return patchType.starts_with("cyclic") || patchType.starts_with("processor");
}

} // namespace polymesh
