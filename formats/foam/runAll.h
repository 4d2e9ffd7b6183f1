// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>

namespace polymesh::foam {

/// Runs independent tasks in parallel, begun in their order: let the longest come first. When some
/// throw, all others end and the exception of the first in order is thrown, so that the message
/// does not depend on chance.
void runAll(std::span<const std::function<void()>> tasks);

} // namespace polymesh::foam
