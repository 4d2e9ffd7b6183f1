// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/replaceFile.h"

#include "libpolymesh/base/error.h"

#include <system_error>
#include <unistd.h>

namespace polymesh::foam {

void replaceFile(const std::filesystem::path& path, const std::function<void(OutputFile&)>& write) {
    const std::filesystem::path temporary =
        path.parent_path() / fmt::format(".{}.new.{}", path.filename().string(), ::getpid());
    std::error_code why;
    std::filesystem::create_directories(path.parent_path(), why);
    try {
        OutputFile file(temporary, path, false);
        write(file);
        file.close();
        std::filesystem::rename(temporary, path, why);
        if (why)
            throw WorkError(fmt::format("{}: cannot be written: {}", path.string(), why.message()));
    } catch (...) {
        std::filesystem::remove(temporary, why);
        throw;
    }
}

} // namespace polymesh::foam
