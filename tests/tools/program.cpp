// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tools/program.h"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <sys/wait.h>

namespace polymesh::tools {

namespace fs = std::filesystem;

TemporaryCase::TemporaryCase() {
    std::string name = (fs::temp_directory_path() / "polymeshTest.XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary directory");
    dir_ = name;
}

TemporaryCase::~TemporaryCase() {
    std::error_code ignored;
    fs::remove_all(dir_, ignored);
}

void TemporaryCase::write(const fs::path& file, std::string_view text) const {
    fs::create_directories((dir_ / file).parent_path());
    std::ofstream(dir_ / file, std::ios::binary) << text;
}

std::string TemporaryCase::read(const fs::path& file) const {
    std::ostringstream text;
    text << std::ifstream(dir_ / file, std::ios::binary).rdbuf();
    return text.str();
}

ProgramResult TemporaryCase::run(const std::string& command) const {
    const std::string script = "cd '" + dir_.string() +
                               "' && PATH='" POLYMESH_BIN "':\"$PATH\" && { " + command +
                               "; } > .out 2> .err < /dev/null";
    const int status = std::system(script.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(".out"), read(".err")};
}

} // namespace polymesh::tools
