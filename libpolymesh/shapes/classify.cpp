// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapes/classify.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/shapes/parentFit.h"
#include "libpolymesh/shapes/recognise.h"

#include <map>

namespace polymesh {

namespace {

bool isTrim1Or3(const Recognition& found) {
    return found.base == BaseShape::sammTrim1 &&
           Catalogue::instance()[found.shape].collapsed.empty();
}

CellShape classify(const PolyMesh& mesh, std::span<const Label> cellFaces, Label cell) {
    const auto found = recognise(mesh, cellFaces, cell);
    if (!found) return {};
    if (isTrim1Or3(*found)) return {found->shape, fitToParent(*found, mesh.points).base};
    return {found->shape, found->base};
}

} // namespace

std::string nameOf(const CellShape& shape) {
    const CatalogueShape& entry = Catalogue::instance()[shape.shape];
    return shape.base == entry.base ? entry.name : std::string(tableOf(shape.base).name);
}

std::vector<CellShape> classifyCells(const PolyMesh& mesh, const Rows<Label>& cellFaces) {
    std::vector<CellShape> shapes(index(mesh.cellCount));
    parallelFor(mesh.cellCount,
                [&](Label c) { shapes[index(c)] = classify(mesh, cellFaces[c], c); });
    return shapes;
}

ShapeCensus census(const std::vector<CellShape>& shapes) {
    std::map<CellShape, Label> counts;
    for (const CellShape& shape : shapes)
        ++counts[shape];
    ShapeCensus result;
    for (const auto& [shape, count] : counts)
        if (shape.isRecognised())
            result.counts.emplace_back(shape, count);
        else
            result.unrecognised += count;
    return result;
}

} // namespace polymesh
