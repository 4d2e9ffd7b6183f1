// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/blockInitBlocks.h"

#include "formats/foam/polyMeshIo.h"
#include "libpolymesh/initial/blockHexCells.h"
#include "tools/blockMeshDict.h"
#include "tools/blockRefine.h"
#include "tools/blockShorthands.h"

namespace polymesh::tools {

namespace {

namespace fs = std::filesystem;

/// Beside constant/triSurface, OpenFOAM keeps surfaces in constant/geometry.
fs::path findSurface(const ToolRun& tool, const std::string& name) {
    std::error_code ignored;
    const fs::path inGeometry = tool.caseDir / "constant" / "geometry" / name;
    const fs::path found = tool.surfaceFile(name);
    const bool isThere = fs::exists(found, ignored) || fs::exists(found.string() + ".gz", ignored);
    const bool isInGeometry =
        fs::exists(inGeometry, ignored) || fs::exists(inGeometry.string() + ".gz", ignored);
    return !isThere && isInGeometry ? inGeometry : found;
}

void report(ToolRun& tool, std::size_t blocks, const PolyMesh& mesh) {
    const std::uintmax_t bytes = bytesIn(tool.meshDir());
    tool.say("blocks     {}", blocks);
    tool.say("cells      {}", mesh.cellCount);
    tool.say("faces      {} ({} internal)", mesh.faceCount(), mesh.internalFaceCount());
    tool.say("points     {}", mesh.pointCount());
    for (const Patch& patch : mesh.patches)
        tool.say("patch      {} {}, {} faces", patch.type, patch.name, patch.size);
    tool.say("written    {}, {:.1f} MB", tool.meshDir().string(), static_cast<double>(bytes) / 1e6);
    tool.report["blocks"] = blocks;
    tool.report["cells"] = mesh.cellCount;
    tool.report["faces"] = mesh.faceCount();
    tool.report["points"] = mesh.pointCount();
    tool.report["bytes"] = bytes;
}

} // namespace

bool isBlockDict(const foam::Dictionary& dictionary) {
    return isShorthand(dictionary) || isBlockMeshDict(dictionary);
}

fs::path blockDictOf(const ToolRun& tool) {
    std::error_code ignored;
    for (const char* option : {"surface", "cellSize", "box", "cells"})
        if (tool.settings.has(option)) return {};
    // A blockInitDict that says nothing of blocks may say how those of blockMeshDict are refined.
    if (!tool.dictionary.empty() && isBlockDict(foam::readDictionary(tool.dictionary)))
        return tool.dictionary;
    for (const fs::path& path : {tool.caseDirectory().system("blockMeshDict"),
                                 tool.caseDirectory().polyMesh() / "blockMeshDict"})
        if (fs::is_regular_file(path, ignored)) return path;
    return {};
}

ExitCode runBlocks(ToolRun& tool, const fs::path& dictionary) {
    tool.clock.start("read dictionary");
    const foam::Dictionary entries = foam::readDictionary(dictionary);
    const auto find = [&](const std::string& name) { return findSurface(tool, name); };
    const BlockMeshDescription description = isShorthand(entries)
                                                 ? readShorthands(entries, {find, tool.meshDir()})
                                                 : readBlockMeshDict(entries, find);
    tool.say("dictionary {}", dictionary.string());
    tool.clock.start("make mesh");
    const PolyMesh mesh = blockMesh(description);
    if (const auto refinement = refinementOf(tool, dictionary))
        return runRefine(tool, hexCells(description, mesh), *refinement);
    tool.clock.start("write mesh");
    foam::writePolyMesh(mesh, tool.meshDir(), tool.writeFormat());
    tool.clock.stop();
    report(tool, description.blocks.size(), mesh);
    return ExitCode::success;
}

} // namespace polymesh::tools
