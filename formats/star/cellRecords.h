// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/star/textFile.h"
#include "formats/star/vertices.h"
#include "libpolymesh/base/rows.h"
#include "libpolymesh/shapes/baseShapes.h"

#include <string>
#include <utility>
#include <vector>

namespace polymesh::star {

/// What the cell files of both versions come down to: polyhedra and baffles, made of points.
/// Faces of a cell are loops, outward as the file has it, all cells' one after the other.
struct CellRecords {
    Rows<Label> faces;
    std::vector<Label> faceNumbers;   // STAR's number of each face within its cell
    std::vector<Label> firstFaces{0}; // of each cell, and the end
    std::vector<Label> numbers;       // of the cells in the file
    std::vector<Label> tables;        // cell table entry of each cell
    std::vector<std::size_t> places;  // byte at which the record of each cell begins

    Rows<Label> baffles; // their points
    std::vector<Label> baffleNumbers;
    std::vector<Label> baffleTables;
    std::vector<std::size_t> bafflePlaces;

    std::vector<std::pair<Label, Label>> rotations; // of trimmed cells: cell, 1 to 23; ascending

    std::vector<Label> otherNumbers; // of shells, lines and points, which are no part of a mesh
    Label solidCells = 0;
    std::vector<std::string> notes;

    Label count() const { return toLabel(numbers.size()); }

    std::size_t faceTotal() const { return faceNumbers.size(); }
};

/// Puts cells together face by face, and checks them.
class CellBuilder {
public:
    explicit CellBuilder(const TextFile& file) : file_(file) {}

    /// What a record says of a cell.
    struct Head {
        Label number = 0;
        Label table = 0;
        std::size_t place = 0;
    };

    void begin(const Head& head) { head_ = head; }

    const Head& head() const { return head_; }

    /// Adds a face of the cell. A corner that is equal to the one before it belongs to an edge
    /// that has collapsed: it is dropped, and so is a face with fewer than three left.
    /// Throws InputError for corners that are equal otherwise.
    void addFace(std::span<const Label> corners, Label faceNumber);

    /// Adds the faces of a base shape with these vertices, any of which may be equal.
    void addShape(BaseShape shape,
                  std::span<const Label> vertices,
                  std::span<const std::uint8_t> faceNumbers);

    /// Ends the cell. Throws InputError when it has fewer than four faces.
    void end();

    /// Ends a cell of arbitrary faces. Throws InputError also when it is not closed.
    void endPolyhedron();

    CellRecords& records() { return records_; }

    /// Throws InputError "file:line: cell N: message".
    [[noreturn]] void fail(std::string_view message) const;

private:
    const TextFile& file_;
    CellRecords records_;
    Head head_;
    std::vector<std::pair<Label, Label>> edges_; // of the cell, as each face directs them
};

/// STAR's numbers of the faces of a regular cell in the order of the base shape's table: a
/// tetrahedron, pyramid or prism has those of the hexahedron of which it is a collapsed form.
std::span<const std::uint8_t> regularFaceNumbers(BaseShape shape);

/// Reads the cells of a file of version 4 or 3. Throws InputError with the line.
/// Cost: linear, some 200 MB/s.
CellRecords readCells4(const TextFile& file, const Vertices& vertices);
CellRecords readCells3(const TextFile& file, const Vertices& vertices);

} // namespace polymesh::star
