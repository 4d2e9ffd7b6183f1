// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/cellShells.h"

#include <algorithm>

namespace polymesh {

void CellShells::clear() {
    uses_.clear();
    shells_.reset(0);
    openPoint_ = -1;
    isSimple_ = true;
}

void CellShells::add(std::span<const Label> polygon, bool isTurned) {
    const Label number = polygonCount();
    shells_.add();
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Label a = polygon[k];
        const Label b = polygon[(k + 1) % polygon.size()];
        uses_.push_back({std::min(a, b), std::max(a, b), number, (a < b) != isTurned});
    }
}

void CellShells::join() {
    std::ranges::sort(uses_, [](const EdgeUse& a, const EdgeUse& b) {
        if (a.low != b.low) return a.low < b.low;
        if (a.high != b.high) return a.high < b.high;
        return a.polygon < b.polygon;
    });
    for (auto first = uses_.begin(); first != uses_.end();) {
        const auto last = std::find_if(first, uses_.end(), [&](const EdgeUse& use) {
            return use.low != first->low || use.high != first->high;
        });
        int balance = 0;
        for (auto use = first; use != last; ++use) {
            balance += use->isForward ? 1 : -1;
            shells_.join(first->polygon, use->polygon);
        }
        if (balance != 0) openPoint_ = first->low;
        if (last - first != 2) isSimple_ = false;
        first = last;
    }
}

} // namespace polymesh
