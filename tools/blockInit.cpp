// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// blockInit: options and dictionary -> CartesianBox -> constant/polyMesh; blockMeshDict: see
// blockInitBlocks.

#include "formats/foam/polyMeshWriter.h"
#include "formats/surfaceIo.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/initial/cartesian.h"
#include "libpolymesh/initial/flatSides.h"
#include "tools/blockInitBlocks.h"
#include "tools/blockRefine.h"

#include <cmath>
#include <limits>

namespace polymesh::tools {

namespace {

const std::vector<Option> ownOptions{
    surfaceOption("put the box round this surface"),
    {"cellSize", "H", "edge length of the cells round the surface [m]"},
    {"margin",
     "M",
     "least distance of the box from the surface [m]; default: H/4, and then the box is "
     "shifted so that grid planes keep clear of flat sides of the surface"},
    {"box", "CORNERS", "two corners [m]: \"(x0 y0 z0) (x1 y1 z1)\""},
    {"cells", "COUNTS", "cells of the box in x, y and z: \"(nx ny nz)\""}};

std::vector<Option> allOptions() {
    std::vector<Option> options = ownOptions;
    options.insert(options.end(), refineOptions().begin(), refineOptions().end());
    return options;
}

/// Whether -surface and -cellSize, rather than -box and -cells, say what to mesh. The dictionary
/// may hold one pair and the command line the other, which then wins.
bool isRoundSurface(const Settings& settings) {
    const bool round = settings.has("surface") || settings.has("cellSize");
    const bool given = settings.has("box") || settings.has("cells");
    require(round || given,
            "nothing says what to mesh: give -surface FILE -cellSize H, or -box CORNERS -cells "
            "COUNTS, or the same in system/blockInitDict, or blocks in system/blockMeshDict");
    if (round != given) return round;
    const bool roundOption = settings.isOption("surface") || settings.isOption("cellSize");
    const bool givenOption = settings.isOption("box") || settings.isOption("cells");
    require(roundOption != givenOption,
            "{} and {} exclude each other",
            settings.place(settings.has("surface") ? "surface" : "cellSize"),
            settings.place(settings.has("box") ? "box" : "cells"));
    return roundOption;
}

/// The box round the surface, for cells that stay or are refined.
CartesianBox boxRoundSurface(ToolRun& tool, bool isRefined) {
    const Settings& settings = tool.settings;
    const auto file = tool.surfaceFile(settings.text("surface"));
    const double cellSize = settings.number("cellSize", std::numeric_limits<double>::min());
    const double margin = settings.numberOr(defaultMargin(cellSize), "margin", 0);
    tool.clock.start("read surface");
    const TriSurface surface = readSurface(file);
    tool.say("surface    {}, {} triangles", file.string(), surface.triangleCount());
    const Box bounds = boundingBox(surface.points);
    const CartesianBox box = boxAround(bounds, cellSize, margin);
    // A margin that the user gives places the planes; else they keep clear of flat sides.
    if (settings.has("margin")) return box;
    if (!isRefined) return clearOfFlatSides(box, bounds, margin, flatSides(surface, cellSize));
    constexpr int levels = 4; // planes of deeper ones are as far away or where nothing can be done
    return clearOfFlatSides(box, bounds, margin, flatSides(surface, cellSize / 4), levels);
}

CartesianBox boxGiven(const Settings& settings) {
    const std::vector<double> corners = settings.numbers("box", 6);
    const std::vector<double> counts = settings.numbers("cells", 3);
    CartesianBox box{{{corners[0], corners[1], corners[2]}, {corners[3], corners[4], corners[5]}},
                     {}};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double n = counts[axis];
        require(n >= 1 && n < static_cast<double>(std::numeric_limits<Label>::max()) &&
                    n == std::floor(n),
                "{}: {}: must be a whole number, at least 1",
                settings.place("cells"),
                n);
        box.cells[axis] = static_cast<Label>(n);
    }
    return box;
}

void writeFaces(const foam::PolyMeshWriter& writer, const CartesianMesh& mesh) {
    using Face = CartesianMesh::Face;
    const auto each = [&](Label first, std::size_t count, const auto& visit) {
        mesh.visitFaces(first, first + toLabel(count), visit);
    };
    writer.writeQuads([&](Label first, std::span<foam::Quad> block) {
        each(first, block.size(), [&](Label f, const Face& face) {
            block[index(f - first)] = face.points;
        });
    });
    writer.writeOwner([&](Label first, std::span<Label> block) {
        each(first, block.size(), [&](Label f, const Face& face) {
            block[index(f - first)] = face.owner;
        });
    });
    writer.writeNeighbour([&](Label first, std::span<Label> block) {
        each(first, block.size(), [&](Label f, const Face& face) {
            block[index(f - first)] = face.neighbour;
        });
    });
}

/// Writes block by block: the mesh is never in memory as a whole.
void write(const ToolRun& tool, const CartesianMesh& mesh) {
    foam::PolyMeshWriter writer(tool.meshDir(),
                                tool.writeFormat(),
                                {.points = mesh.pointCount(),
                                 .cells = mesh.cellCount(),
                                 .faces = mesh.faceCount(),
                                 .internalFaces = mesh.internalFaceCount()});
    writer.writePoints([&](Label first, std::span<Vec3> block) {
        for (std::size_t i = 0; i < block.size(); ++i)
            block[i] = mesh.point(first + toLabel(i));
    });
    writeFaces(writer, mesh);
    const std::vector<Patch> patches = mesh.patches();
    writer.writePatches(patches);
    writer.commit();
}

std::string shown(const Vec3& p) {
    return fmt::format("({:.7g} {:.7g} {:.7g})", p.x, p.y, p.z);
}

void report(ToolRun& tool, const CartesianBox& box, const CartesianMesh& mesh) {
    const auto& [min, max] = box.box;
    const std::uintmax_t bytes = bytesIn(tool.meshDir());
    tool.say("box        {} {} m", shown(min), shown(max));
    tool.say("cells      {} = {}", fmt::join(box.cells, " x "), mesh.cellCount());
    tool.say("faces      {} ({} internal)", mesh.faceCount(), mesh.internalFaceCount());
    tool.say("points     {}", mesh.pointCount());
    tool.say("written    {}, {:.1f} MB", tool.meshDir().string(), static_cast<double>(bytes) / 1e6);
    tool.report["cells"] = mesh.cellCount();
    tool.report["faces"] = mesh.faceCount();
    tool.report["points"] = mesh.pointCount();
    tool.report["box"] = {{min.x, min.y, min.z}, {max.x, max.y, max.z}};
    tool.report["divisions"] = box.cells;
    tool.report["bytes"] = bytes;
}

ExitCode run(ToolRun& tool) {
    const std::filesystem::path blocks = blockDictOf(tool);
    if (!blocks.empty()) return runBlocks(tool, blocks);
    const auto refinement = refinementOf(tool, {});
    const CartesianBox box = isRoundSurface(tool.settings)
                                 ? boxRoundSurface(tool, refinement.has_value())
                                 : boxGiven(tool.settings);
    if (refinement) return runRefine(tool, hexCells(box), *refinement);
    const CartesianMesh mesh(box);
    tool.clock.start("write mesh");
    write(tool, mesh);
    tool.clock.stop();
    report(tool, box, mesh);
    return ExitCode::success;
}

} // namespace

Tool thisTool() {
    return {
        "blockInit",
        "makes the initial mesh of hexahedra: a box divided into cubes or bricks; graded boxes, "
        "cylinders, spheres and extruded sheets, stitched where they touch (cartesian, cylinder, "
        "sphere, extrude and parts in system/blockInitDict); or the blocks of "
        "system/blockMeshDict, as OpenFOAM's blockMesh does; any of them refined where "
        "`refinement` or options say",
        allOptions(),
        run,
        {"cartesian", "cylinder", "extrude", "parts", "refinement", "sphere"},
        {},
        isBlockDict};
}

} // namespace polymesh::tools
