// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/cellRecords.h"
#include "formats/star/cellWriter.h"
#include "formats/star/cells4.h"
#include "formats/star/fileSet.h"
#include "formats/star/numberText.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/shapes/recognise.h"

#include <algorithm>
#include <optional>

namespace polymesh::star {

namespace {

constexpr const char* cellHeader = "PROSTAR_CELL\n4000 0 0 0 0 0 0 0\n";
constexpr const char* boundaryHeader = "PROSTAR_BOUNDARY\n4000 0 0 0 0 0 0 0\n";

Label shapeCode(BaseShape shape) {
    switch (shape) {
    case BaseShape::tetrahedron:
        return tetrahedronCode;
    case BaseShape::pyramid:
        return pyramidCode;
    case BaseShape::prism:
        return prismCode;
    case BaseShape::hexahedron:
        return hexahedronCode;
    default:
        return polyhedronCode;
    }
}

/// The cell as a regular shape none of whose edges has collapsed; none for any other cell.
std::optional<Recognition> regularCell(const MeshToWrite& mesh, Label cell) {
    const auto faces = mesh.cellFaces[cell];
    if (faces.size() > 6) return std::nullopt; // no need to look
    std::optional<Recognition> found = recognise(mesh.mesh, faces, cell);
    const bool isRegular = found && shapeCode(found->base) != polyhedronCode &&
                           Catalogue::instance()[found->shape].collapsed.empty();
    return isRegular ? found : std::nullopt;
}

/// Writes the record of one cell, at most 8 labels a line.
class CellText {
public:
    CellText(std::string& text, Label number) : text_(text), number_(number) {}

    void begin(Label shape, Label labelCount, Label table, Label material = fluidCode) {
        appendLabel(text_, number_);
        for (const Label value : {shape, labelCount, table, material}) {
            text_ += ' ';
            appendLabel(text_, value);
        }
    }

    void add(Label label) {
        if (count_ % labelsPerLine == 0) {
            text_ += "\n  ";
            appendLabel(text_, number_);
        }
        text_ += ' ';
        appendLabel(text_, label);
        ++count_;
    }

    void end() { text_ += '\n'; }

private:
    std::string& text_;
    Label number_;
    Label count_ = 0;
};

void appendPolyhedron(CellText& text, const MeshToWrite& mesh, Label cell) {
    const auto faces = mesh.cellFaces[cell];
    const PolyMesh& poly = mesh.mesh;
    const Label faceCount = toLabel(faces.size());
    Label labelCount = faceCount + 1;
    for (const Label f : faces)
        labelCount += poly.faces.rowSize(f);
    text.begin(polyhedronCode, labelCount, mesh.tables[index(cell)]);
    Label offset = faceCount + 1;
    for (const Label f : faces) {
        text.add(offset);
        offset += poly.faces.rowSize(f);
    }
    text.add(offset);
    for (const Label f : faces) {
        const auto loop = poly.faces[f];
        const bool isOutward = poly.owner[index(f)] == cell;
        for (std::size_t i = 0; i < loop.size(); ++i)
            text.add(loop[isOutward ? i : loop.size() - 1 - i] + 1);
    }
}

/// The number of the face of a regular cell that has these points.
Label regularFace(const Recognition& cell, std::span<const Label> loop) {
    const auto faces = tableOf(cell.base).faces;
    const auto hasCorners = [&](ShapeFace face) {
        // Two faces of a regular cell have no more than two points in common.
        return std::ranges::all_of(loop.first(3), [&](Label p) {
            return std::ranges::any_of(face, [&](ShapeVertex v) { return cell.points[v] == p; });
        });
    };
    const auto found = std::ranges::find_if(faces, hasCorners);
    const auto position = static_cast<std::size_t>(found - faces.begin());
    return regularFaceNumbers(cell.base)[position];
}

Label faceNumber(const MeshToWrite& mesh, Label face) {
    const Label cell = mesh.mesh.owner[index(face)];
    if (const auto regular = regularCell(mesh, cell))
        return regularFace(*regular, mesh.mesh.faces[face]);
    const auto faces = mesh.cellFaces[cell];
    const auto found = std::ranges::find(faces, face);
    return toLabel(static_cast<std::size_t>(found - faces.begin())) + 1;
}

} // namespace

void writeCells4(foam::OutputFile& file, const MeshToWrite& mesh) {
    file.write(cellHeader);
    writeElements(file, mesh.mesh.cellCount, [&](std::string& text, Label cell) {
        CellText cellText(text, cell + 1);
        if (const auto regular = regularCell(mesh, cell)) {
            const auto vertices = regular->vertices();
            cellText.begin(
                shapeCode(regular->base), toLabel(vertices.size()), mesh.tables[index(cell)]);
            for (const Label p : vertices)
                cellText.add(p + 1);
        } else {
            appendPolyhedron(cellText, mesh, cell);
        }
        cellText.end();
    });
    writeElements(file, toLabel(mesh.baffles.size()), [&](std::string& text, Label i) {
        CellText baffle(text, mesh.mesh.cellCount + i + 1);
        const auto loop = mesh.mesh.faces[mesh.baffles[index(i)]];
        baffle.begin(shellCode, toLabel(loop.size()), mesh.baffleTable, baffleCode);
        for (const Label p : loop)
            baffle.add(p + 1);
        baffle.end();
    });
}

void writeBoundary4(foam::OutputFile& file, const MeshToWrite& mesh) {
    file.write(boundaryHeader);
    const PatchOfFace patchOf(mesh.mesh);
    const Label first = mesh.mesh.internalFaceCount();
    writeElements(file, mesh.mesh.faceCount() - first, [&](std::string& text, Label i) {
        const Label face = first + i;
        const Label patch = patchOf(face);
        appendLabel(text, i + 1);
        for (const Label value :
             {mesh.mesh.owner[index(face)] + 1, faceNumber(mesh, face), patch + 1, Label{0}}) {
            text += ' ';
            appendLabel(text, value);
        }
        text.append(1, ' ').append(mesh.starTypes[index(patch)]).append(1, '\n');
    });
}

} // namespace polymesh::star
