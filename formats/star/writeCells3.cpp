// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/cellWriter.h"
#include "formats/star/cells3.h"
#include "formats/star/cells4.h"
#include "formats/star/fileSet.h"
#include "formats/star/numberText.h"
#include "formats/star/regionTypes.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/shapes/parentFit.h"
#include "libpolymesh/shapes/recognise.h"

#include <algorithm>

namespace polymesh::star {

namespace {

constexpr Label largestNumber = 999'999'999; // of nine columns

/// One line of a cell: I9, 6 blanks, 8 I9, I9, I5.
void appendLine(
    std::string& text, Label cell, std::span<const Label> labels, Label table, Label flag) {
    appendLabel(text, cell, 9);
    text.append(6, ' ');
    for (const Label label : labels)
        appendLabel(text, label, 9);
    appendLabel(text, table, 9);
    appendLabel(text, flag, 5);
    text += '\n';
}

void appendCell(std::string& text, Label number, Label table, const Recognition& cell) {
    constexpr std::size_t lineLabels = 8;
    const TrimmedForm* form = formOf(cell.base);
    if (form == nullptr) {
        std::array<Label, 8> slots = regularSlots(cell.base, cell.vertices());
        for (Label& p : slots)
            ++p;
        appendLine(text, number, slots, table, regularFlag);
        return;
    }
    std::array<Label, trimmedLabels> labels{};
    for (std::size_t v = 0; v < form->slots.size(); ++v)
        labels[form->slots[v]] = cell.points[v] + 1;
    labels[trimTypeSlot] = form->type;
    for (std::size_t line = 0; line < linesOfTrimmed; ++line)
        appendLine(text,
                   number,
                   std::span(labels).subspan(line * lineLabels, lineLabels),
                   table,
                   line == 0 ? trimmedFlag : continuedFlag);
}

std::optional<Recognition> recogniseCell(const MeshToWrite& mesh, Label cell) {
    return recognise(mesh.mesh, mesh.cellFaces[cell], cell);
}

/// The points of the only boundary face of a cell, which then is the one that was cut; empty for
/// cells that have none or more.
std::span<const Label> cutFace(const MeshToWrite& mesh, Label cell) {
    std::span<const Label> cut;
    for (const Label f : mesh.cellFaces[cell]) {
        if (mesh.mesh.isInternal(f)) continue;
        if (!cut.empty()) return {};
        cut = mesh.mesh.faces[f];
    }
    return cut;
}

/// Trimmed cells are stored as what is left of a hexahedron, so that is looked for.
Recognition fitted(const MeshToWrite& mesh, Label cell, const Recognition& found) {
    if (formOf(found.base) == nullptr) return found;
    return fitToParent(found, mesh.mesh.points, cutFace(mesh, cell));
}

void refuseUnknownCells(const MeshToWrite& mesh) {
    const Label unknown = parallelSum(mesh.mesh.cellCount, Label{0}, [&](Label c) {
        return recogniseCell(mesh, c) ? Label{0} : Label{1};
    });
    if (unknown > 0)
        throw WorkError(fmt::format("{} of {} cells are no shape that STAR-CD version 3 has; "
                                    "divide them with classifyCells -split, or write version 4 "
                                    "(-to star4)",
                                    unknown,
                                    mesh.mesh.cellCount));
}

/// Four of the corners of a face, which name it; the third twice for a triangle.
std::array<Label, 4> namingCorners(std::span<const Label> loop) {
    const std::size_t n = loop.size();
    if (n == 3) return {loop[0], loop[1], loop[2], loop[2]};
    return {loop[0], loop[n / 4], loop[n / 2], loop[3 * n / 4]};
}

} // namespace

void writeCells3(foam::OutputFile& file, const MeshToWrite& mesh) {
    if (std::max(mesh.mesh.pointCount(), mesh.mesh.cellCount) > largestNumber)
        throw WorkError("more than 999,999,999 points or cells do not fit into the columns of "
                        "version 3; write version 4 (-to star4)");
    refuseUnknownCells(mesh);
    writeElements(file, mesh.mesh.cellCount, [&](std::string& text, Label cell) {
        const auto recognised = recogniseCell(mesh, cell);
        appendCell(text, cell + 1, mesh.tables[index(cell)], fitted(mesh, cell, *recognised));
    });
    writeElements(file, toLabel(mesh.baffles.size()), [&](std::string& text, Label i) {
        std::array<Label, 8> labels{};
        std::ranges::transform(
            mesh.mesh.faces[mesh.baffles[index(i)]], labels.begin(), [](Label p) { return p + 1; });
        appendLine(text, mesh.mesh.cellCount + i + 1, labels, mesh.baffleTable, baffleCode);
    });
}

void writeBoundary3(foam::OutputFile& file, const MeshToWrite& mesh) {
    const PatchOfFace patchOf(mesh.mesh);
    const Label first = mesh.mesh.internalFaceCount();
    writeElements(file, mesh.mesh.faceCount() - first, [&](std::string& text, Label i) {
        const Label patch = patchOf(first + i);
        appendLabel(text, i + 1, 8);
        text.append(6, ' ');
        for (const Label p : namingCorners(mesh.mesh.faces[first + i]))
            appendLabel(text, p + 1, 9);
        appendLabel(text, patch + 1, 7);
        appendLabel(text, 0, 7);
        text.append(6, ' ').append(toUpper(mesh.starTypes[index(patch)])).append(1, '\n');
    });
}

} // namespace polymesh::star
