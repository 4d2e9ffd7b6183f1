// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/replaceDirectory.h"

#include "foamTestSupport.h"
#include "formats/foam/polyMeshIo.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <set>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace polymesh::foam {
namespace {

namespace fs = std::filesystem;
using test::readText;
using test::TemporaryDirectory;
using test::twoCubes;
using test::writeText;

std::set<std::string> namesIn(const fs::path& directory) {
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(directory))
        names.insert(entry.path().filename().string());
    return names;
}

/// A mesh that takes a while to write: many points that no face uses.
PolyMesh largeMesh(std::size_t pointCount) {
    PolyMesh mesh = twoCubes();
    mesh.points.resize(pointCount, {1, 2, 3});
    return mesh;
}

/// Runs `work` in a child process and returns its wait status.
template<class Work>
int statusOfChild(Work&& work) {
    const pid_t child = fork();
    if (child == 0) {
        work();
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return status;
}

TEST(ReplaceDirectory, replacesAsAWholeButKeepsDictionaries) {
    const TemporaryDirectory directory;
    const fs::path path = directory.path() / "constant/polyMesh";
    writeText(path / "sets/old", "x");
    writeText(path / "cellLevel", "x");
    writeText(path / "blockMeshDict", "the user's");
    writePolyMesh(twoCubes(), path, {});
    EXPECT_EQ(readText(path / "blockMeshDict"), "the user's");
    EXPECT_FALSE(fs::exists(path / "sets"));
    EXPECT_FALSE(fs::exists(path / "cellLevel"));
    EXPECT_EQ(namesIn(path.parent_path()), (std::set<std::string>{"polyMesh"}));
}

TEST(ReplaceDirectory, leavesTheOldOneWithoutCommit) {
    const TemporaryDirectory directory;
    const fs::path path = directory.path() / "polyMesh/";
    writeText(path / "points", "old");
    {
        const DirectoryReplacement replacement(path);
        writeText(replacement.temporary() / "points", "new");
    }
    EXPECT_EQ(readText(path / "points"), "old");
    EXPECT_EQ(namesIn(directory.path()), (std::set<std::string>{"polyMesh"}));
}

TEST(ReplaceDirectory, replacesALinkAndNotWhatItPointsTo) {
    const TemporaryDirectory directory;
    writeText(directory.path() / "other/points", "old");
    fs::create_directory_symlink("other", directory.path() / "polyMesh");
    DirectoryReplacement replacement(directory.path() / "polyMesh");
    writeText(replacement.temporary() / "points", "new");
    replacement.commit();
    EXPECT_EQ(readText(directory.path() / "polyMesh/points"), "new");
    EXPECT_EQ(readText(directory.path() / "other/points"), "old");
}

TEST(ReplaceDirectory, removesWhatDeadProcessesLeftAndOnlyThat) {
    const TemporaryDirectory directory;
    const int status = statusOfChild([&] {
        DirectoryReplacement replacement(directory.path() / "polyMesh");
        writeText(replacement.temporary() / "points", "half");
        raise(SIGKILL);
    });
    EXPECT_EQ(WTERMSIG(status), SIGKILL);
    ASSERT_EQ(namesIn(directory.path()).size(), 1U) << "the killed child left its directory";
    const std::string alive = ".polyMesh.new." + std::to_string(getppid());
    writeText(directory.path() / alive / "points", "at work");
    writeText(directory.path() / ".polyMesh.new.txt" / "x", "not ours");
    writePolyMesh(twoCubes(), directory.path() / "polyMesh", {});
    EXPECT_EQ(namesIn(directory.path()),
              (std::set<std::string>{"polyMesh", alive, ".polyMesh.new.txt"}));
}

TEST(ReplaceDirectory, isRecoveredWhenARunDiedBetweenTwoRenames) {
    const TemporaryDirectory directory;
    const fs::path path = directory.path() / "polyMesh";
    writePolyMesh(twoCubes(), path, {});
    fs::rename(path, directory.path() / ".polyMesh.old.999999999");
    EXPECT_EQ(readPolyMesh(path), twoCubes());
}

TEST(ReplaceDirectory, killAtAnyMomentLeavesOneWholeMesh) {
    const TemporaryDirectory directory;
    const fs::path path = directory.path() / "constant/polyMesh";
    const PolyMesh old = largeMesh(200000);
    const PolyMesh next = largeMesh(200001);
    writePolyMesh(old, path, {});
    for (int delay = 0; delay < 30; ++delay) {
        const pid_t child = fork();
        if (child == 0) {
            for (int i = 0;; ++i) // without commit or exit until it is killed
                writePolyMesh(i % 2 == 0 ? next : old, path, {});
        }
        std::this_thread::sleep_for(std::chrono::microseconds(500 * delay));
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        const PolyMesh now = readPolyMesh(path);
        ASSERT_TRUE(now == old || now == next) << "after " << delay;
    }
    writePolyMesh(old, path, {});
    EXPECT_EQ(namesIn(path.parent_path()), (std::set<std::string>{"polyMesh"}));
}

/// Writes in a child whose files may not grow beyond `bytes`; what the error said.
std::string writeWithLimit(const fs::path& path, const WriteFormat& format, rlim_t bytes) {
    const fs::path report = path.parent_path().parent_path() / "report";
    statusOfChild([&] {
        std::string message = "written";
        {
            const rlimit limit{bytes, RLIM_INFINITY};
            std::signal(SIGXFSZ, SIG_IGN);
            setrlimit(RLIMIT_FSIZE, &limit);
            try {
                writePolyMesh(largeMesh(100000), path, format);
            } catch (const WorkError& error) {
                message = error.what();
            }
        }
        writeText(report, message);
    });
    return readText(report);
}

TEST(ReplaceDirectory, fullDiskNamesTheFileAndLeavesTheOldMesh) {
    for (const WriteFormat& format : {WriteFormat{Format::binary, WriteFormat::exact, false},
                                      WriteFormat{Format::ascii, WriteFormat::exact, false},
                                      WriteFormat{Format::binary, WriteFormat::exact, true}}) {
        const TemporaryDirectory directory;
        const fs::path path = directory.path() / "constant/polyMesh";
        writePolyMesh(twoCubes(), path, format);
        const std::string message = writeWithLimit(path, format, 1000);
        const std::string file = (path / (format.compress ? "points.gz" : "points")).string();
        EXPECT_EQ(message, file + ": cannot be written: File too large");
        EXPECT_EQ(readPolyMesh(path), twoCubes());
        EXPECT_EQ(namesIn(path.parent_path()), (std::set<std::string>{"polyMesh"}));
    }
}

TEST(ReplaceDirectory, saysWhenTheDirectoryCannotBeMade) {
    const TemporaryDirectory directory;
    writeText(directory.path() / "constant", "a file");
    EXPECT_THROW(writePolyMesh(twoCubes(), directory.path() / "constant/polyMesh", {}), WorkError);
}

} // namespace
} // namespace polymesh::foam
