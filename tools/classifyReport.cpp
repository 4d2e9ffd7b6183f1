// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/classifyReport.h"

#include "formats/foam/cellField.h"
#include "formats/foam/sets.h"
#include "libpolymesh/reference/tetgen.h"
#include "libpolymesh/shapes/obstacle.h"

#include <cmath>

namespace polymesh::tools {

namespace {

constexpr const char* unrecognisedSet = "unrecognisedCells";

std::string joined(const std::vector<std::size_t>& numbers) {
    std::string text;
    for (const std::size_t number : numbers)
        text += fmt::format("{}{}", text.empty() ? "" : " ", number);
    return text;
}

} // namespace

void listShapes(ToolRun& tool) {
    const Catalogue& catalogue = Catalogue::instance();
    for (const CatalogueShape& shape : catalogue.shapes())
        tool.say("{:<36} {:>2} points  {} faces: {}",
                 shape.name,
                 shape.pointCount,
                 shape.faceSizes.size(),
                 joined(shape.faceSizes));
    for (const BaseShape base : allBaseShapes())
        tool.say("variants of {:<24} {}", tableOf(base).name, catalogue.variantCount(base));
    tool.say("total {}", catalogue.shapes().size());
    for (const BaseShape base : allBaseShapes())
        tool.report["variants"][std::string(tableOf(base).name)] = catalogue.variantCount(base);
    tool.report["total"] = catalogue.shapes().size();
}

void reportSplit(ToolRun& tool,
                 const ShapeSplitCounts& counts,
                 double volumeBefore,
                 double volumeAfter) {
    const double error = volumeAfter / volumeBefore - 1;
    tool.say("split {} cells: {} more cells, {} more points; volume {:.9g} m^3, {:.2g} of it off",
             counts.splitCells,
             counts.newCells,
             counts.newPoints,
             volumeAfter,
             std::abs(error));
    tool.say(
        "  {} large faces cut; {} cells split together with a neighbour, {} cut first, {} made "
        "tetrahedra, {} split though a warped face is folded; {} changes mended pieces",
        counts.splitFaces,
        counts.unitedCells,
        counts.cutCells,
        counts.filledCells,
        counts.foldedCells,
        counts.mends);
    if (!counts.remaining.empty())
        tool.warn("{} cells are left as they were: no way to divide them was found; {}",
                  counts.remaining.size(),
                  hasTetgen() ? "finer cells there help, or a larger -deviation of trimSurface"
                              : "this program was built without TetGen, which fills such cells "
                                "with tetrahedra (-DPOLYMESH_TETGEN=ON)");
    tool.report["splitCells"] = counts.splitCells;
    tool.report["newCells"] = counts.newCells;
    tool.report["newPoints"] = counts.newPoints;
    tool.report["splitFaces"] = counts.splitFaces;
    tool.report["unitedCells"] = counts.unitedCells;
    tool.report["cutCells"] = counts.cutCells;
    tool.report["filledCells"] = counts.filledCells;
    tool.report["foldedCells"] = counts.foldedCells;
    tool.report["mends"] = counts.mends;
    tool.report["volume"] = volumeAfter;
    tool.report["volumeError"] = error;
}

Label reportShapes(ToolRun& tool, const std::vector<CellShape>& shapes) {
    const ShapeCensus counted = census(shapes);
    tool.report["shapes"] = nlohmann::ordered_json::object();
    for (const auto& [shape, count] : counted.counts) {
        tool.say("{} {}", nameOf(shape), count);
        tool.report["shapes"][nameOf(shape)] = count;
    }
    tool.say("unrecognised {}", counted.unrecognised);
    tool.report["cells"] = shapes.size();
    tool.report["unrecognised"] = counted.unrecognised;
    return counted.unrecognised;
}

void reportObstacles(ToolRun& tool,
                     const PolyMesh& mesh,
                     const Rows<Label>& cellFaces,
                     const std::vector<CellShape>& shapes) {
    std::vector<Label> cells;
    for (std::size_t c = 0; c < shapes.size(); ++c)
        if (!shapes[c].isRecognised()) cells.push_back(toLabel(c));
    const auto counts = countObstacles(mesh, cellFaces, cells);
    tool.report["obstacles"] = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] == 0) continue;
        const std::string name(nameOf(static_cast<Obstacle>(i)));
        tool.say("  {} {}", name, counts[i]);
        tool.report["obstacles"][name] = counts[i];
    }
}

void writeShapes(const ToolRun& tool, const PolyMesh& mesh, const std::vector<CellShape>& shapes) {
    std::vector<double> shape(shapes.size(), -1);
    std::vector<double> base(shapes.size(), -1);
    std::vector<Label> unrecognised;
    for (std::size_t c = 0; c < shapes.size(); ++c) {
        if (!shapes[c].isRecognised()) {
            unrecognised.push_back(toLabel(c));
            continue;
        }
        shape[c] = shapes[c].shape;
        base[c] = static_cast<double>(shapes[c].base);
    }
    const std::filesystem::path time = tool.caseDir / "0" / tool.caseDirectory().region;
    const foam::WriteFormat format = tool.writeFormat();
    foam::writeCellField(time, "cellShape", mesh, shape, format);
    foam::writeCellField(time, "cellBaseShape", mesh, base, format);
    foam::writeSet(tool.meshDir(), foam::SetKind::cell, unrecognisedSet, unrecognised);
}

} // namespace polymesh::tools
