// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/foam/outputFile.h"

#include <filesystem>
#include <functional>

namespace polymesh::foam {

/// Writes a plain file beside `path` and renames it into place, so that a run that fails or is
/// killed leaves the old one; makes the folders above. Throws WorkError.
void replaceFile(const std::filesystem::path& path, const std::function<void(OutputFile&)>& write);

} // namespace polymesh::foam
