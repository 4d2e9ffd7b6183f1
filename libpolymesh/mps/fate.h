// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace polymesh {

/// What becomes of a cell when hexahedra are left alone (keepHexahedra.h).
enum class Fate : std::uint8_t { whole, layer, divided };

} // namespace polymesh
