// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Runs the built programs as a user does, in a fresh case directory.

#include "tests/support/temporaryDirectory.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace polymesh::tools {

/// What a program printed and returned.
struct ProgramResult {
    int status = -1;
    std::string out;
    std::string err;
};

/// A case directory under the system's temporary folder, removed with the object.
class TemporaryCase {
public:
    const std::filesystem::path& dir() const { return dir_.path(); }

    /// Writes a file of the case, making its folders.
    void write(const std::filesystem::path& file, std::string_view text) const;

    std::string read(const std::filesystem::path& file) const;

    /// Runs a shell command in the case, with the built programs first on the path.
    ProgramResult run(const std::string& command) const;

private:
    test::TemporaryDirectory dir_;
};

} // namespace polymesh::tools
