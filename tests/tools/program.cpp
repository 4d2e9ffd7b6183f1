// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tools/program.h"

#include <cstdlib>
#include <sys/wait.h>

namespace polymesh::tools {

namespace fs = std::filesystem;

void TemporaryCase::write(const fs::path& file, std::string_view text) const {
    test::writeText(dir_ / file, text);
}

std::string TemporaryCase::read(const fs::path& file) const {
    return test::readText(dir_ / file);
}

ProgramResult TemporaryCase::run(const std::string& command) const {
    const std::string script = "cd '" + dir().string() +
                               "' && PATH='" POLYMESH_BIN "':\"$PATH\" && { " + command +
                               "; } > .out 2> .err < /dev/null";
    const int status = std::system(script.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(".out"), read(".err")};
}

} // namespace polymesh::tools
