// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/toolMain.h"

#include <filesystem>

namespace polymesh::tools {

/// Whether a dictionary is about blocks: a shorthand or a blockMeshDict.
bool isBlockDict(const foam::Dictionary& dictionary);

/// The dictionary of blocks that blockInit should read: the one that -dict names,
/// system/blockInitDict, or, when that is not there, the blockMeshDict of the case. Empty: none, or
/// options say what to mesh.
std::filesystem::path blockDictOf(const ToolRun& tool);

/// Makes the mesh of a dictionary of blocks and writes it.
ExitCode runBlocks(ToolRun& tool, const std::filesystem::path& dictionary);

} // namespace polymesh::tools
