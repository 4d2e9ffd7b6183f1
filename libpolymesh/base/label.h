// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace polymesh {

/// Index of a point, face, cell, patch or triangle; -1 means "none" where a function says so.
/// 32 bits unless the project is configured with POLYMESH_LABEL64 (more than 2^31 entities).
#ifdef POLYMESH_LABEL64
using Label = std::int64_t;
#else
using Label = std::int32_t;
#endif

/// A label as a subscript of standard containers.
constexpr std::size_t index(Label label) {
    return static_cast<std::size_t>(label);
}

/// A container size as a label. Requires: the size fits, which readers check at the door.
constexpr Label toLabel(std::size_t size) {
    return static_cast<Label>(size);
}

} // namespace polymesh
