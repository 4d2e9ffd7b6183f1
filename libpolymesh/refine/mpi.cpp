// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/refine/mpi.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#include <p4est_base.h>
#pragma GCC diagnostic pop

#include <cstdlib>

namespace polymesh {

namespace {

/// Without mpirun Open MPI starts a helper process and looks for networks, which takes a third of a
/// second; a program that is alone needs neither.
void stayAlone() {
    if (std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr) return;
    constexpr int keepWhatTheUserSays = 0;
    setenv("OMPI_MCA_ess_singleton_isolated", "1", keepWhatTheUserSays);
    setenv("OMPI_MCA_pml", "ob1", keepWhatTheUserSays);
    setenv("OMPI_MCA_btl", "self", keepWhatTheUserSays);
    setenv("OMPI_MCA_osc", "^ucx", keepWhatTheUserSays);
}

} // namespace

void startMpi() {
    int isStarted = 0;
    MPI_Initialized(&isStarted);
    if (isStarted != 0) return;
    stayAlone();
    MPI_Init(nullptr, nullptr);
    std::atexit([] { MPI_Finalize(); });
    sc_init(MPI_COMM_WORLD, 0, 0, nullptr, SC_LP_ERROR);
    p4est_init(nullptr, SC_LP_ERROR);
}

} // namespace polymesh
