// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/refine/processes.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#include <p4est_base.h>
#pragma GCC diagnostic pop

#include <cstdlib>
#include <numeric>

#ifdef __SANITIZE_ADDRESS__
/// Asked by the leak checker at the end. Open MPI keeps some of what it allocates, and its threads
/// make the checker itself crash at times.
extern "C" int __lsan_is_turned_off() { // NOLINT(bugprone-reserved-identifier)
    int isStarted = 0;
    MPI_Initialized(&isStarted);
    return isStarted;
}
#endif

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
    setenv("OMPI_MCA_orte_create_session_dirs", "0", keepWhatTheUserSays);
}

// MPI's constants cast as C does, wherever they are used.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"

const MPI_Comm everyone = MPI_COMM_WORLD;
const MPI_Datatype intType = MPI_INT;
const MPI_Datatype byteType = MPI_BYTE;

#pragma GCC diagnostic pop

/// Where each list begins when they stand one after the other, and the end of the last.
std::vector<int> startsOf(const std::vector<int>& sizes) {
    std::vector<int> starts{0};
    std::partial_sum(sizes.begin(), sizes.end(), std::back_inserter(starts));
    return starts;
}

MPI_Datatype typeOf(std::size_t bytes) {
    MPI_Datatype type = byteType;
    MPI_Type_contiguous(static_cast<int>(bytes), byteType, &type);
    MPI_Type_commit(&type);
    return type;
}

template<class T>
std::vector<T> gatherAll(const std::vector<T>& own, int count) {
    if (count == 1) return own;
    const int size = static_cast<int>(own.size());
    std::vector<int> sizes(static_cast<std::size_t>(count));
    MPI_Allgather(&size, 1, intType, sizes.data(), 1, intType, everyone);
    const std::vector<int> starts = startsOf(sizes);
    std::vector<T> all(static_cast<std::size_t>(starts.back()));
    MPI_Datatype type = typeOf(sizeof(T));
    MPI_Allgatherv(own.data(), size, type, all.data(), sizes.data(), starts.data(), type, everyone);
    MPI_Type_free(&type);
    return all;
}

} // namespace

void startMpi() {
    int isStarted = 0;
    MPI_Initialized(&isStarted);
    if (isStarted != 0) return;
    stayAlone();
    MPI_Init(nullptr, nullptr);
    std::atexit([] { MPI_Finalize(); });
    sc_init(everyone, 0, 0, nullptr, SC_LP_ERROR);
    p4est_init(nullptr, SC_LP_ERROR);
}

Processes Processes::ofMpirun() {
    startMpi();
    Processes result;
    MPI_Comm_rank(everyone, &result.rank_);
    MPI_Comm_size(everyone, &result.count_);
    return result;
}

std::vector<std::uint64_t> Processes::gather(const std::vector<std::uint64_t>& own) const {
    return gatherAll(own, count_);
}

std::vector<Label> Processes::gather(const std::vector<Label>& own) const {
    return gatherAll(own, count_);
}

std::vector<std::vector<Label>>
Processes::exchange(const std::vector<std::vector<Label>>& lists) const {
    if (count_ == 1) return lists;
    std::vector<int> sizes;
    std::vector<Label> sent;
    for (const std::vector<Label>& list : lists) {
        sizes.push_back(static_cast<int>(list.size()));
        sent.insert(sent.end(), list.begin(), list.end());
    }
    std::vector<int> otherSizes(sizes.size());
    MPI_Alltoall(sizes.data(), 1, intType, otherSizes.data(), 1, intType, everyone);
    const std::vector<int> starts = startsOf(sizes);
    const std::vector<int> otherStarts = startsOf(otherSizes);
    std::vector<Label> received(static_cast<std::size_t>(otherStarts.back()));
    MPI_Datatype type = typeOf(sizeof(Label));
    MPI_Alltoallv(sent.data(),
                  sizes.data(),
                  starts.data(),
                  type,
                  received.data(),
                  otherSizes.data(),
                  otherStarts.data(),
                  type,
                  everyone);
    MPI_Type_free(&type);
    std::vector<std::vector<Label>> result;
    for (std::size_t r = 0; r < otherSizes.size(); ++r)
        result.emplace_back(received.begin() + otherStarts[r],
                            received.begin() + otherStarts[r + 1]);
    return result;
}

void Processes::abort(int status) {
    MPI_Abort(everyone, status);
    std::abort();
}

} // namespace polymesh
