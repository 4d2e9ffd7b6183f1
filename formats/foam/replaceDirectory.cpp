// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/replaceDirectory.h"

#include "libpolymesh/base/error.h"

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace polymesh::foam {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view newMark = ".new.";
constexpr std::string_view oldMark = ".old.";

/// The name without a slash at its end, so that it has a parent and a sibling.
fs::path plainPath(const fs::path& path) {
    fs::path plain = path.lexically_normal();
    if (plain.filename().empty() && plain.has_relative_path()) plain = plain.parent_path();
    if (plain.filename() == "." || plain.filename() == "..")
        plain = fs::absolute(plain).lexically_normal();
    return plain;
}

fs::path parentOf(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

fs::path siblingOf(const fs::path& target, std::string_view mark) {
    return parentOf(target) / fmt::format(".{}{}{}", target.filename().string(), mark, ::getpid());
}

/// The process whose sibling of `target` the name is.
std::optional<pid_t> ownerOf(const fs::path& name, const fs::path& target, std::string_view mark) {
    const std::string text = name.string();
    const std::string start = fmt::format(".{}{}", target.filename().string(), mark);
    if (!text.starts_with(start)) return std::nullopt;
    pid_t process = 0;
    const char* end = text.data() + text.size();
    const auto [stop, problem] = std::from_chars(text.data() + start.size(), end, process);
    if (problem != std::errc{} || stop != end || process <= 0) return std::nullopt;
    return process;
}

bool isAtWork(pid_t process) {
    return process != ::getpid() && (::kill(process, 0) == 0 || errno == EPERM);
}

/// The siblings of `target` that processes left behind which are no longer there.
std::vector<fs::path> leftovers(const fs::path& target, std::string_view mark) {
    std::vector<fs::path> found;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(parentOf(target), ignored)) {
        const auto process = ownerOf(entry.path().filename(), target, mark);
        if (process && !isAtWork(*process)) found.push_back(entry.path());
    }
    return found;
}

[[noreturn]] void failAt(const fs::path& path, std::string_view what, const std::error_code& why) {
    throw WorkError(fmt::format("{}: {}: {}", path.string(), what, why.message()));
}

std::error_code lastError() {
    return {errno, std::generic_category()};
}

/// Dictionaries are the user's input, which old cases keep beside the mesh.
void keepDictionaries(const fs::path& from, const fs::path& to) {
    std::error_code why;
    for (const fs::directory_entry& entry : fs::directory_iterator(from, why)) {
        const std::string name = entry.path().filename().string();
        if (!name.ends_with("Dict") || !entry.is_regular_file(why)) continue;
        fs::copy_file(entry.path(), to / name, why);
        if (why) failAt(entry.path(), "cannot be kept in the new directory", why);
    }
}

/// Swaps two directories in one step; false where the file system cannot.
bool exchange(const fs::path& a, const fs::path& b) {
    return ::renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
}

} // namespace

DirectoryReplacement::DirectoryReplacement(const fs::path& target)
    : target_(plainPath(target)), temporary_(siblingOf(target_, newMark)) {
    recoverDirectory(target_);
    std::error_code why;
    for (const std::string_view mark : {newMark, oldMark})
        for (const fs::path& path : leftovers(target_, mark))
            fs::remove_all(path, why);
    fs::create_directories(temporary_, why);
    if (why) failAt(temporary_, "cannot be made", why);
}

DirectoryReplacement::~DirectoryReplacement() {
    std::error_code ignored;
    fs::remove_all(temporary_, ignored);
}

void DirectoryReplacement::commit() {
    std::error_code why;
    const bool replaces = fs::exists(fs::symlink_status(target_, why));
    if (!replaces) {
        fs::rename(temporary_, target_, why);
        if (why) failAt(target_, "cannot be put in place", why);
        return;
    }
    keepDictionaries(target_, temporary_);
    if (exchange(temporary_, target_)) return; // the destructor removes the old one
    const std::error_code reason = lastError();
    if (reason != std::errc::invalid_argument && reason != std::errc::function_not_supported)
        failAt(target_, "cannot be replaced", reason);
    const fs::path old = siblingOf(target_, oldMark);
    fs::rename(target_, old, why);
    if (why) failAt(target_, "cannot be replaced", why);
    fs::rename(temporary_, target_, why);
    if (why) {
        std::error_code ignored;
        fs::rename(old, target_, ignored);
        failAt(target_, "cannot be put in place", why);
    }
    fs::remove_all(old, why);
}

void recoverDirectory(const fs::path& target) {
    const fs::path plain = plainPath(target);
    std::error_code ignored;
    if (fs::exists(fs::symlink_status(plain, ignored))) return;
    const std::vector<fs::path> old = leftovers(plain, oldMark);
    if (!old.empty()) fs::rename(old.front(), plain, ignored);
}

} // namespace polymesh::foam
