// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/fileSet.h"

#include "libpolymesh/base/error.h"

#include <system_error>
#include <unistd.h>

namespace polymesh::star {

namespace fs = std::filesystem;

FileSet::~FileSet() {
    std::error_code ignored;
    for (const std::string& ending : endings_)
        fs::remove(temporaryPath(ending), ignored);
}

fs::path FileSet::finalPath(const std::string& ending) const {
    fs::path path = prefix_;
    path += ending;
    return path;
}

fs::path FileSet::temporaryPath(const std::string& ending) const {
    const fs::path path = finalPath(ending);
    return path.parent_path() / fmt::format(".{}.new.{}", path.filename().string(), ::getpid());
}

void FileSet::commit() {
    for (const std::string& ending : endings_) {
        std::error_code why;
        fs::rename(temporaryPath(ending), finalPath(ending), why);
        if (why)
            throw WorkError(fmt::format(
                "{}: cannot be put in place: {}", finalPath(ending).string(), why.message()));
    }
    endings_.clear();
}

} // namespace polymesh::star
