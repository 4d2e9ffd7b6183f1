// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/listReader.h"
#include "formats/foam/polyMeshIo.h"
#include "libpolymesh/mesh/validate.h"
#include "tests/tools/program.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace polymesh::tools {

namespace {

constexpr const char* balls =
    "box ((0 0 0) (4 5 6)); cells (4 5 6);\n"
    "refinement { regions { a { type sphere; centre (2 2.4 2.9); radius 0.7; level 2; }\n"
    "                       b { type sphere; centre (0 5 3); radius 0.2; level 4; } } }\n";
constexpr const char* cylinder =
    "cylinder { point1 (0 0 0); point2 (0 0 3); radius 1; cells (2 16 6); }\n"
    "refinement { regions { a { type sphere; centre (1 0 1.6); radius 0.2; level 3; } } }\n";

constexpr const char* zones =
    "parts (\n"
    "cylinder { point1 (0 0 0); point2 (0 0 2); radius 1; cells (2 8 4); zone low;\n"
    "           patches { bottom inlet; side pipe; } }\n"
    "cylinder { point1 (0 0 2); point2 (0 0 3); radius 1; cells (2 8 2); zone high;\n"
    "           patches { side pipe; top outlet; } } );\n"
    "refinement { regions { a { type sphere; centre (0.5 0 2); radius 0.2; level 2; } } }\n";

std::string mpirun(int processes) {
    return fmt::format("OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
                       "mpirun --oversubscribe -np {} ",
                       processes);
}

/// What one process wrote.
struct Part {
    PolyMesh mesh;
    std::vector<Label> cells;
    std::vector<Label> faces;
    std::vector<Label> points;
    std::vector<Label> patches;

    explicit Part(const std::filesystem::path& directory)
        : mesh(foam::readPolyMesh(directory)),
          cells(addressing(directory, "cell")),
          faces(addressing(directory, "face")),
          points(addressing(directory, "point")),
          patches(addressing(directory, "boundary")) {}

    static std::vector<Label> addressing(const std::filesystem::path& directory, const char* of) {
        foam::FoamReader reader(directory / (std::string(of) + "ProcAddressing"));
        return foam::readLabelText(reader, 1);
    }

    /// A face by the labels of the mesh of all, turned as it is there.
    std::vector<Label> faceOfAll(Label face) const {
        std::vector<Label> loop;
        for (const Label p : mesh.faces[face])
            loop.push_back(points[index(p)]);
        if (faces[index(face)] < 0) std::reverse(loop.begin() + 1, loop.end());
        return loop;
    }
};

/// Whether the part is what its addressing says of the mesh of all; counts the faces of all.
void expectPartOf(const PolyMesh& all, const Part& part, std::vector<int>& uses) {
    const PolyMesh& mesh = part.mesh;
    ASSERT_EQ(part.cells.size(), index(mesh.cellCount));
    ASSERT_EQ(part.faces.size(), index(mesh.faceCount()));
    ASSERT_EQ(part.points.size(), mesh.points.size());
    ASSERT_EQ(part.patches.size(), mesh.patches.size());
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
        EXPECT_EQ(mesh.points[p], all.points[index(part.points[p])]);
    for (Label f = 0; f < mesh.faceCount(); ++f) {
        const Label g = std::abs(part.faces[index(f)]) - 1;
        ++uses[index(g)];
        const std::vector<Label> expected(all.faces[g].begin(), all.faces[g].end());
        EXPECT_EQ(part.faceOfAll(f), expected) << "face " << f;
        const Label cell = part.cells[index(mesh.owner[index(f)])];
        if (part.faces[index(f)] > 0) {
            EXPECT_EQ(cell, all.owner[index(g)]);
        } else {
            EXPECT_EQ(cell, all.neighbour[index(g)]);
        }
        if (mesh.isInternal(f)) {
            EXPECT_EQ(part.cells[index(mesh.neighbour[index(f)])], all.neighbour[index(g)]);
        }
    }
    for (std::size_t p = 0; p < mesh.patches.size(); ++p) {
        if (part.patches[p] < 0)
            EXPECT_EQ(mesh.patches[p].type, "processor");
        else
            EXPECT_EQ(mesh.patches[p].name, all.patches[index(part.patches[p])].name);
    }
    for (const Zone& zone : mesh.cellZones) {
        const auto whole = std::ranges::find(all.cellZones, zone.name, &Zone::name);
        ASSERT_NE(whole, all.cellZones.end()) << zone.name;
        std::vector<Label> expected; // those of its cells that are here
        for (const Label cell : whole->labels)
            if (cell >= part.cells.front() && cell <= part.cells.back()) expected.push_back(cell);
        std::vector<Label> found;
        for (const Label cell : zone.labels)
            found.push_back(part.cells[index(cell)]);
        EXPECT_EQ(found, expected) << zone.name;
    }
    EXPECT_EQ(mesh.cellZones.size(), all.cellZones.size());
    EXPECT_TRUE(validate(mesh).empty()) << validate(mesh).front().message;
}

/// The faces between two parts come in one order, each from the same point round the other way.
void expectMatching(const Part& lower, int rank, const Part& upper, int other) {
    const auto find = [](const Part& part, const std::string& name) {
        const auto patch = std::ranges::find(part.mesh.patches, name, &Patch::name);
        return patch == part.mesh.patches.end() ? Patch{} : *patch;
    };
    const Patch a = find(lower, fmt::format("procBoundary{}to{}", rank, other));
    const Patch b = find(upper, fmt::format("procBoundary{}to{}", other, rank));
    EXPECT_EQ(a.size, b.size);
    for (Label f = 0; f < std::min(a.size, b.size); ++f) {
        EXPECT_EQ(lower.faceOfAll(a.start + f), upper.faceOfAll(b.start + f));
        EXPECT_GT(lower.faces[index(a.start + f)], 0);
        EXPECT_LT(upper.faces[index(b.start + f)], 0);
    }
}

void expectAsSerial(const char* dictionary, int processes) {
    const TemporaryCase box;
    box.write("system/blockInitDict", dictionary);
    ASSERT_EQ(box.run("blockInit -format ascii").status, 0);
    const PolyMesh all = foam::readPolyMesh(box.dir() / "constant/polyMesh");
    const ProgramResult made = box.run(mpirun(processes) + "blockInit -parallel -format ascii");
    ASSERT_EQ(made.status, 0) << made.err;
    std::vector<Part> parts;
    std::vector<int> uses(all.owner.size(), 0);
    Label cells = 0;
    for (int r = 0; r < processes; ++r) {
        parts.emplace_back(box.dir() / fmt::format("processor{}/constant/polyMesh", r));
        expectPartOf(all, parts.back(), uses);
        EXPECT_EQ(parts.back().cells.front(), cells) << "consecutive";
        cells += parts.back().mesh.cellCount;
    }
    EXPECT_EQ(cells, all.cellCount);
    EXPECT_EQ(std::ranges::count(uses, 0), 0) << "each face is in a part";
    for (int r = 0; r < processes; ++r)
        for (int other = r + 1; other < processes; ++other)
            expectMatching(parts[static_cast<std::size_t>(r)],
                           r,
                           parts[static_cast<std::size_t>(other)],
                           other);
}

} // namespace

TEST(BlockInitParallel, twoProcessesMakeTheMeshOfOne) {
    expectAsSerial(balls, 2);
}

TEST(BlockInitParallel, fiveProcessesMakeTheMeshOfOne) {
    expectAsSerial(balls, 5);
}

TEST(BlockInitParallel, threeProcessesMakeTheRoundMeshOfOne) {
    expectAsSerial(cylinder, 3);
}

TEST(BlockInitParallel, fourProcessesMakeTheZonesAndPatchesOfOne) {
    expectAsSerial(zones, 4);
}

TEST(BlockInitParallel, collapsedBlocksAreForOneProcess) {
    const TemporaryCase box;
    box.write("system/blockInitDict",
              "cylinder { point1 (0 0 0); point2 (0 0 1); radius 1; cells (2 4 2); angle 90; }\n");
    ASSERT_EQ(box.run("blockInit").status, 0);
    const ProgramResult result = box.run(mpirun(2) + "blockInit -parallel");
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("-parallel: blocks with collapsed edges"), std::string::npos)
        << result.err;
}

TEST(BlockInitParallel, openFoamAcceptsTheParts) {
    const TemporaryCase box;
    const std::string header =
        "FoamFile { version 2.0; format ascii; class dictionary; object x; }\n";
    box.write("system/blockInitDict", balls);
    box.write("system/controlDict",
              header + "application none; startFrom startTime; startTime 0; stopAt endTime; "
                       "endTime 1; deltaT 1; writeControl timeStep; writeInterval 1;\n");
    std::string schemes = header;
    for (const char* name : {"ddt", "grad", "div", "laplacian", "interpolation", "snGrad"})
        schemes += fmt::format("{}Schemes {{}}\n", name);
    box.write("system/fvSchemes", schemes);
    box.write("system/fvSolution", header);
    box.write("system/decomposeParDict", header + "numberOfSubdomains 2; method none;\n");
    ASSERT_EQ(box.run(mpirun(2) + "blockInit -parallel").status, 0);
    const ProgramResult checked = box.run("WM_PROJECT_DIR=/usr/share/openfoam " + mpirun(2) +
                                          "/usr/bin/checkMesh -parallel -allTopology");
    EXPECT_NE(checked.out.find("Mesh OK"), std::string::npos) << checked.out << checked.err;
}

TEST(BlockInitParallel, oneProcessIsToldHowToStartMore) {
    const TemporaryCase box;
    const ProgramResult result =
        box.run("blockInit -box '(0 0 0) (1 1 1)' -cells '(2 2 2)' -parallel");
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("mpirun -np 2"), std::string::npos) << result.err;
}

} // namespace polymesh::tools
