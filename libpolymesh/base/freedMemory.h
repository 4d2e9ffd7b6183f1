// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace polymesh {

/// Gives memory that has been freed back to the system, where the allocator can: after a stage that
/// has freed much, so that it does not count towards the next one's peak.
/// Cost: some 10 to 20 ms for 100 MB.
void giveBackFreedMemory();

} // namespace polymesh
