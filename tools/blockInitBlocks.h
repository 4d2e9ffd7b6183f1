// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/toolMain.h"

#include <filesystem>

namespace polymesh::tools {

/// The blockMeshDict that blockInit should read: the one that -dict names, or that of the case when
/// neither options nor system/blockInitDict say what to mesh. Empty: none.
std::filesystem::path blockMeshDictOf(const ToolRun& tool);

/// Makes the mesh of a blockMeshDict and writes it.
ExitCode runBlocks(ToolRun& tool, const std::filesystem::path& dictionary);

} // namespace polymesh::tools
