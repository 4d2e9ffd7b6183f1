// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "tools/toolMain.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace polymesh::tools {

/// What a mesh is stored as: an OpenFOAM case, or STAR-CD files with a common prefix.
enum class MeshForm : std::uint8_t { foam, star4, star3 };

/// "foam", "star4", "star3"
std::string_view nameOf(MeshForm form);

/// A mesh on disk.
struct MeshPlace {
    MeshForm form = MeshForm::foam;
    std::filesystem::path path; // case directory or prefix
    std::string region;         // of a case; empty for the only one

    std::filesystem::path polyMesh() const;
};

/// What convertMesh is asked to do.
struct Conversion {
    MeshPlace in;
    MeshPlace out;
    double scale = 1; // factor of coordinates
};

/// A mesh under way, and a line for everything that is left out.
struct ConvertedMesh {
    PolyMesh mesh;
    std::vector<std::string> notes;
};

/// Finds out what is to be converted into what. Throws InputError when that is not clear, and when
/// there is no mesh to read.
Conversion conversionOf(const ToolRun& tool);

/// Reads the mesh; coordinates already have the scale unless the output is STAR-CD and the input
/// is not.
ConvertedMesh readMesh(const Conversion& conversion);

/// Throws InputError when the mesh breaks laws of PolyMesh in a way that no other form can hold;
/// adds a note on what it holds wrongly but can be written.
void refuseUnwritable(const Conversion& conversion, ConvertedMesh& converted);

/// Writes the mesh and adds notes on what could not be.
void writeMesh(const ToolRun& tool, const Conversion& conversion, ConvertedMesh& converted);

} // namespace polymesh::tools
