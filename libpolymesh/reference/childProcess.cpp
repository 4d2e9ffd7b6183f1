// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/reference/childProcess.h"

#include "libpolymesh/base/error.h"

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace polymesh {

namespace {

bool writeAll(int file, double value) {
    std::array<char, sizeof(double)> bytes{};
    std::memcpy(bytes.data(), &value, sizeof value);
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t n = write(file, bytes.data() + done, bytes.size() - done);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return false;
        done += static_cast<std::size_t>(n);
    }
    return true;
}

/// The next number, or none at the end of the stream.
std::optional<double> readNext(int file) {
    std::array<char, sizeof(double)> bytes{};
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t n = read(file, bytes.data() + done, bytes.size() - done);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return std::nullopt;
        done += static_cast<std::size_t>(n);
    }
    double value = 0;
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
}

/// Ends the child without running the parent's destructors and exit handlers twice.
[[noreturn]] void runChild(int out,
                           Label first,
                           Label count,
                           unsigned secondsEach,
                           const std::function<double(Label)>& task) {
    const int nowhere = open("/dev/null", O_WRONLY);
    if (nowhere >= 0) {
        dup2(nowhere, STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
    }
    const rlimit noCoreFile{0, 0};
    setrlimit(RLIMIT_CORE, &noCoreFile);
    for (Label i = first; i < count; ++i) {
        alarm(secondsEach);
        if (!writeAll(out, task(i))) _exit(2);
    }
    _exit(0);
}

} // namespace

std::vector<std::optional<double>>
inChildProcess(Label count, unsigned secondsEach, const std::function<double(Label)>& task) {
    std::vector<std::optional<double>> results;
    results.reserve(index(count));
    std::fflush(nullptr); // or the child would print what waits in the buffers again
    while (toLabel(results.size()) < count) {
        std::array<int, 2> ends{};
        if (pipe(ends.data()) != 0)
            throw WorkError(fmt::format("no pipe to a child process: {}", std::strerror(errno)));
        const pid_t child = fork();
        if (child < 0) {
            close(ends[0]);
            close(ends[1]);
            throw WorkError(fmt::format("no child process: {}", std::strerror(errno)));
        }
        if (child == 0) {
            close(ends[0]);
            runChild(ends[1], toLabel(results.size()), count, secondsEach, task);
        }
        close(ends[1]);
        while (const std::optional<double> value = readNext(ends[0]))
            results.push_back(std::isnan(*value) ? std::nullopt : value);
        close(ends[0]);
        int status = 0;
        while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
        }
        if (toLabel(results.size()) < count) results.emplace_back(); // the one that crashed
    }
    return results;
}

} // namespace polymesh
