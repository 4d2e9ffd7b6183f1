// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/foam/outputFile.h"
#include "libpolymesh/base/rows.h"
#include "libpolymesh/mesh/polyMesh.h"

#include <string>
#include <vector>

namespace polymesh::star {

/// A mesh with what the writers of both versions ask of it.
struct MeshToWrite {
    const PolyMesh& mesh;
    Rows<Label> cellFaces;              // mesh/topology.h
    std::vector<Label> tables;          // cell table entry of each cell
    std::vector<std::string> starTypes; // of each patch, which is the region of its number + 1
    /// Boundary faces that have the points of another one, one of each two: without a baffle
    /// between them, the cells on both sides would be joined.
    std::vector<Label> baffles;
    Label baffleTable = 0; // cell table entry of the baffles
};

/// Cell and boundary files of version 4.
void writeCells4(foam::OutputFile& file, const MeshToWrite& mesh);
void writeBoundary4(foam::OutputFile& file, const MeshToWrite& mesh);

/// Baffles of version 3 have four vertices.
inline constexpr Label mostBaffleVertices = 4;

/// Cell and boundary files of version 3. Throws WorkError before it writes anything when a cell is
/// not in the catalogue of shapes or the mesh has more points or cells than nine digits can number.
void writeCells3(foam::OutputFile& file, const MeshToWrite& mesh);
void writeBoundary3(foam::OutputFile& file, const MeshToWrite& mesh);

/// The patch of a boundary face, looked up from one face to the next.
class PatchOfFace {
public:
    explicit PatchOfFace(const PolyMesh& mesh);

    Label operator()(Label face) const;

private:
    std::vector<Label> ends_; // the face after the last of each patch
};

} // namespace polymesh::star
