// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace polymesh {

/// The simple loops of edges through one of them, up to a length.
class EdgeLoops {
public:
    explicit EdgeLoops(std::size_t longest = 5) : longest_(longest) {}

    void add(Label a, Label b) {
        steps_.emplace_back(a, b);
        steps_.emplace_back(b, a);
    }

    /// To be called when all edges have been added.
    void sort() {
        std::ranges::sort(steps_);
        steps_.erase(std::unique(steps_.begin(), steps_.end()), steps_.end());
    }

    /// Calls use(loop) for the loops that begin with this edge; ends after `most` steps.
    template<class Use>
    void through(Label from, Label to, Use&& use, std::size_t most = 20000) {
        path_ = {from, to};
        extend(use, most);
    }

private:
    template<class Use>
    void extend(Use& use, std::size_t& most) {
        const Label at = path_.back();
        auto step = std::ranges::lower_bound(steps_, at, {}, &std::pair<Label, Label>::first);
        for (; step != steps_.end() && step->first == at && most > 0; ++step, --most) {
            const Label next = step->second;
            if (next == path_.front() && path_.size() > 2) use(path_);
            if (path_.size() == longest_ || std::ranges::find(path_, next) != path_.end()) continue;
            path_.push_back(next);
            extend(use, most);
            path_.pop_back();
        }
    }

    std::size_t longest_;
    std::vector<std::pair<Label, Label>> steps_;
    std::vector<Label> path_;
};

} // namespace polymesh
