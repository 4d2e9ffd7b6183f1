// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace polymesh {

/// Starts MPI, once; it ends with the program. A program that mpirun did not start is alone.
void startMpi();

} // namespace polymesh
