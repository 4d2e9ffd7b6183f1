// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace polymesh {

/// The content of a gzip file of one or more members (RFC 1952), from all of its bytes; whatever
/// follows the last member is ignored, as gzip does. `fileName` is for messages.
/// Throws InputError when the bytes are not gzip's, damaged or cut short.
std::string gunzip(std::string_view packed, const std::string& fileName);

} // namespace polymesh
