// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/foam/dictionary.h"
#include "libpolymesh/refine/refine.h"
#include "libpolymesh/surface/triSurface.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace polymesh::tools {

/// How the names in a dictionary become what they mean.
struct RefineFiles {
    std::function<TriSurface(const std::string& name)> surface;
    std::function<std::vector<Label>(const std::string& name)> cellSet;
};

/// Reads `refinement { ... }`: see docs/refinement.md. Throws InputError that begins with file and
/// line.
RefineOptions readRefinement(const foam::Dictionary& refinement, const RefineFiles& files);

} // namespace polymesh::tools
