// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/core.h>

#include <stdexcept>
#include <utility>

namespace polymesh {

/// The user's input cannot be processed: a file, a dictionary entry or an option is wrong.
/// The message names the file (and line, when known), what was found, what was expected and,
/// where it helps, what to do. Tools print it on one line and exit with status 2.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The input was accepted but the work could not be finished (a full disk, a cell that cannot be
/// built). Tools print it on one line and exit with status 1.
struct WorkError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Throws InputError with a formatted message unless `condition` holds.
template<class... Args>
void require(bool condition, fmt::format_string<Args...> message, Args&&... args) {
    if (!condition) throw InputError(fmt::format(message, std::forward<Args>(args)...));
}

} // namespace polymesh
