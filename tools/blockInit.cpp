// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// blockInit: options and dictionary -> CartesianBox -> constant/polyMesh; blockMeshDict: see
// blockInitBlocks.

#include "formats/foam/polyMeshIo.h"
#include "formats/foam/polyMeshWriter.h"
#include "formats/surfaceIo.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/initial/cartesian.h"
#include "libpolymesh/initial/flatSides.h"
#include "libpolymesh/initial/outsideCells.h"
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
    {"inside",
     "",
     "with -surface: leave out the cells that are outside the surface and away from it, which "
     "trimSurface -keep inside would; fewer to write and to read"},
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
            "{} and {} exclude each other; leave one of them out",
            settings.place(settings.has("surface") ? "surface" : "cellSize"),
            settings.place(settings.has("box") ? "box" : "cells"));
    return roundOption;
}

TriSurface surfaceToMesh(ToolRun& tool) {
    const auto file = tool.surfaceFile(tool.settings.text("surface"));
    tool.clock.start("read surface");
    TriSurface surface = readSurface(file);
    tool.say("surface    {}, {} triangles", file.string(), surface.triangleCount());
    return surface;
}

/// The box round the surface, for cells that stay or are refined.
CartesianBox boxRound(const TriSurface& surface, const Settings& settings, bool isRefined) {
    const double cellSize = settings.number("cellSize", std::numeric_limits<double>::min());
    const double margin = settings.numberOr(defaultMargin(cellSize), "margin", 0);
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
void write(const ToolRun& tool, const CartesianMesh& mesh, const foam::MeshCounts& counts) {
    foam::PolyMeshWriter writer(tool.meshDir(), tool.writeFormat(), counts);
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

void report(ToolRun& tool, const CartesianBox& box, const foam::MeshCounts& counts) {
    const auto& [min, max] = box.box;
    const std::uintmax_t bytes = bytesIn(tool.meshDir());
    const Label inBox = CartesianMesh(box).cellCount();
    const Label leftOut = inBox - counts.cells;
    tool.say("box        {} {} m", shown(min), shown(max));
    tool.say("cells      {} = {}", fmt::join(box.cells, " x "), inBox);
    if (leftOut > 0)
        tool.say("left out   {} cells outside the surface, {} are left", leftOut, counts.cells);
    tool.say("faces      {} ({} internal)", counts.faces, counts.internalFaces);
    tool.say("points     {}", counts.points);
    tool.say("written    {}, {:.1f} MB", tool.meshDir().string(), static_cast<double>(bytes) / 1e6);
    tool.report["cells"] = counts.cells;
    tool.report["leftOut"] = leftOut;
    tool.report["faces"] = counts.faces;
    tool.report["points"] = counts.points;
    tool.report["box"] = {{min.x, min.y, min.z}, {max.x, max.y, max.z}};
    tool.report["divisions"] = box.cells;
    tool.report["bytes"] = bytes;
}

ExitCode runBox(ToolRun& tool, const CartesianBox& box) {
    const CartesianMesh mesh(box);
    const foam::MeshCounts counts{
        mesh.pointCount(), mesh.cellCount(), mesh.faceCount(), mesh.internalFaceCount()};
    tool.clock.start("write mesh");
    write(tool, mesh, counts);
    tool.clock.stop();
    report(tool, box, counts);
    return ExitCode::success;
}

/// The cells of the box that are inside the surface or near it.
ExitCode runInside(ToolRun& tool, const CartesianBox& box, const TriSurface& surface) {
    tool.clock.start("leave out cells");
    const PolyMesh mesh = cartesianMeshWithout(box, outsideCells(box, surface));
    tool.clock.start("write mesh");
    foam::writePolyMesh(mesh, tool.meshDir(), tool.writeFormat());
    tool.clock.stop();
    report(
        tool, box, {mesh.pointCount(), mesh.cellCount, mesh.faceCount(), mesh.internalFaceCount()});
    return ExitCode::success;
}

/// Refuses -inside where there is no surface, or cells that are not of one size.
void checkInside(const Settings& settings, bool isPossible) {
    require(!settings.isOn("inside") || isPossible,
            "{}: is for a box of equal cells round a surface; leave it out, or give -surface and "
            "-cellSize and no refinement",
            settings.place("inside"));
}

ExitCode run(ToolRun& tool) {
    const Settings& settings = tool.settings;
    const std::filesystem::path blocks = blockDictOf(tool);
    if (!blocks.empty()) {
        checkInside(settings, false);
        return runBlocks(tool, blocks);
    }
    const bool isRound = isRoundSurface(settings);
    const auto refinement = refinementOf(tool, {});
    checkInside(settings, isRound && !refinement);
    const TriSurface surface = isRound ? surfaceToMesh(tool) : TriSurface{};
    const CartesianBox box =
        isRound ? boxRound(surface, settings, refinement.has_value()) : boxGiven(settings);
    if (refinement) return runRefine(tool, hexCells(box), *refinement);
    return settings.isOn("inside") ? runInside(tool, box, surface) : runBox(tool, box);
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
