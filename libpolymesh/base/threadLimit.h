// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

namespace polymesh {

/// Limits the number of threads of all parallel loops for the lifetime of the object.
class ThreadLimit {
public:
    explicit ThreadLimit(std::size_t threadCount);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
    struct Control;
    std::unique_ptr<Control> control_;
};

} // namespace polymesh
