// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace polymesh {

/// The whole content of a file, unpacked when its name ends in .gz.
/// Throws InputError when the file is missing, unreadable, not gzip or cut short.
std::string readBytes(const std::filesystem::path& file);

/// Writes the file, packed when its name ends in .gz. The content goes to a temporary sibling that
/// is then renamed, so that an old file stays whole until the new one is complete.
/// Throws WorkError when that fails (no such folder, a full disk).
void writeBytes(const std::filesystem::path& file, std::string_view bytes);

} // namespace polymesh
