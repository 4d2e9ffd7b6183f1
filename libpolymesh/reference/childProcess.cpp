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
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace polymesh {

namespace {

/// False when the other side is gone; that is no signal to this process.
bool sendAll(int socket, const void* from, std::size_t size) {
    const char* bytes = static_cast<const char*>(from);
    for (std::size_t done = 0; done < size;) {
        const ssize_t n = send(socket, bytes + done, size - done, MSG_NOSIGNAL);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return false;
        done += static_cast<std::size_t>(n);
    }
    return true;
}

/// False when the stream ends before.
bool receiveAll(int socket, void* to, std::size_t size) {
    char* bytes = static_cast<char*>(to);
    for (std::size_t done = 0; done < size;) {
        const ssize_t n = read(socket, bytes + done, size - done);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return false;
        done += static_cast<std::size_t>(n);
    }
    return true;
}

bool sendNumbers(int socket, const Numbers& numbers) {
    const std::size_t count = numbers.size();
    return sendAll(socket, &count, sizeof count) &&
           sendAll(socket, numbers.data(), count * sizeof(double));
}

std::optional<Numbers> receiveNumbers(int socket) {
    std::size_t count = 0;
    if (!receiveAll(socket, &count, sizeof count)) return std::nullopt;
    Numbers numbers(count);
    if (!receiveAll(socket, numbers.data(), count * sizeof(double))) return std::nullopt;
    return numbers;
}

/// Answers until the other side is gone, and ends without running the parent's destructors and exit
/// handlers twice.
[[noreturn]] void answerAll(int socket, unsigned secondsEach, const ChildWorker::Task& task) {
    const int nowhere = open("/dev/null", O_WRONLY);
    if (nowhere >= 0) {
        dup2(nowhere, STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
    }
    const rlimit noCoreFile{0, 0};
    setrlimit(RLIMIT_CORE, &noCoreFile);
    while (const auto question = receiveNumbers(socket)) {
        alarm(secondsEach);
        const Numbers answer = task(*question);
        alarm(0);
        if (!sendNumbers(socket, answer)) _exit(2);
    }
    _exit(0);
}

} // namespace

ChildWorker::ChildWorker(unsigned secondsEach, Task task)
    : secondsEach_(secondsEach), task_(std::move(task)) {}

ChildWorker::~ChildWorker() {
    stop();
}

void ChildWorker::start() {
    std::fflush(nullptr); // or the child would print what waits in the buffers again
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0)
        throw WorkError(fmt::format("no socket to a child process: {}", std::strerror(errno)));
    child_ = fork();
    if (child_ < 0) {
        close(ends[0]);
        close(ends[1]);
        throw WorkError(fmt::format("no child process: {}", std::strerror(errno)));
    }
    if (child_ == 0) {
        close(ends[0]);
        answerAll(ends[1], secondsEach_, task_);
    }
    close(ends[1]);
    socket_ = ends[0];
}

void ChildWorker::stop() {
    if (socket_ < 0) return;
    close(socket_); // the child ends when it sees this
    socket_ = -1;
    int status = 0;
    while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
}

std::optional<Numbers> ChildWorker::ask(const Numbers& question) {
    if (socket_ < 0) start();
    std::optional<Numbers> answer;
    if (sendNumbers(socket_, question)) answer = receiveNumbers(socket_);
    if (!answer) stop();
    return answer;
}

std::vector<std::optional<double>>
inChildProcess(Label count, unsigned secondsEach, const std::function<double(Label)>& task) {
    ChildWorker worker(secondsEach, [&](const Numbers& question) {
        return Numbers{task(static_cast<Label>(question.front()))};
    });
    std::vector<std::optional<double>> results(index(count));
    for (Label i = 0; i < count; ++i) {
        const auto answer = worker.ask({static_cast<double>(i)});
        if (answer && !std::isnan(answer->front())) results[index(i)] = answer->front();
    }
    return results;
}

} // namespace polymesh
