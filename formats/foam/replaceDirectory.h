// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace polymesh::foam {

/// Builds a directory beside `target` and puts it in place of `target` in one step. A failure or a
/// kill at any moment leaves either the old directory or the new one, whole, under the name (on a
/// file system that cannot swap two directories: or the old one beside it, which recoverDirectory
/// puts back). What earlier killed runs left behind is removed. The data are not forced to the
/// disk: the promise is about programs that die, not about power that fails.
class DirectoryReplacement {
public:
    /// Makes the temporary directory and those above it. Throws WorkError.
    explicit DirectoryReplacement(const std::filesystem::path& target);

    /// Removes the temporary directory.
    ~DirectoryReplacement();
    DirectoryReplacement(const DirectoryReplacement&) = delete;
    DirectoryReplacement& operator=(const DirectoryReplacement&) = delete;

    /// Where the new files go.
    const std::filesystem::path& temporary() const { return temporary_; }

    const std::filesystem::path& target() const { return target_; }

    /// Puts the new directory in place and removes the old one. Throws WorkError.
    void commit();

private:
    std::filesystem::path target_;
    std::filesystem::path temporary_;
};

/// Puts the old directory back when a run was killed between two renames; does nothing when
/// `target` exists.
void recoverDirectory(const std::filesystem::path& target);

} // namespace polymesh::foam
