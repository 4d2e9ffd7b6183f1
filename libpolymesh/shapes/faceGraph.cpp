// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapes/faceGraph.h"

namespace polymesh {

std::uint8_t FaceGraph::localNumber(Label point) {
    for (std::size_t i = 0; i < pointCount_; ++i)
        if (labels_[i] == point) return static_cast<std::uint8_t>(i);
    if (pointCount_ == maxShapePoints) return none;
    labels_[pointCount_] = point;
    return static_cast<std::uint8_t>(pointCount_++);
}

bool FaceGraph::addFace(std::span<const Label> points, bool reversed) {
    const std::size_t size = points.size();
    if (size < 3 || size > maxShapeFacePoints || faceCount_ == maxShapeFaces ||
        dartCount_ + size > maxDarts)
        return false;
    ++faceCount_;
    const std::size_t first = dartCount_;
    for (std::size_t i = 0; i < size; ++i) {
        const std::uint8_t point = localNumber(points[reversed ? size - 1 - i : i]);
        if (point == none) return false;
        origin_[first + i] = point;
    }
    dartCount_ += size;
    for (std::size_t d = first; d < dartCount_; ++d) {
        const std::size_t after = d + 1 < dartCount_ ? d + 1 : first;
        next_[d] = static_cast<std::uint8_t>(after);
        target_[d] = origin_[after];
        std::uint8_t& slot = dartOf_[origin_[d] * std::size_t{16} + target_[d]];
        if (slot != 0) return false;
        slot = static_cast<std::uint8_t>(d + 1);
    }
    return true;
}

bool FaceGraph::close() {
    if (pointCount_ + faceCount_ != dartCount_ / 2 + 2) return false;
    for (std::size_t d = 0; d < dartCount_; ++d) {
        const std::uint8_t twin = dartOf_[target_[d] * std::size_t{16} + origin_[d]];
        if (twin == 0) return false;
        turned_[d] = next_[twin - std::size_t{1}];
    }
    return true;
}

FaceGraph::Walk FaceGraph::walk(std::size_t root) const {
    Walk found;
    std::array<std::uint8_t, maxShapePoints> number;
    number.fill(none);
    std::array<std::uint8_t, maxShapePoints> entry{};
    number[origin_[root]] = 0;
    found.points[0] = origin_[root];
    entry[0] = static_cast<std::uint8_t>(root);
    std::size_t met = 1;
    std::size_t written = 0; // at most 36 darts and 12 ends: 48 entries of 4 bits
    const auto write = [&](std::uint64_t value) {
        found.code.words[written / 16] |= value << (written % 16 * 4);
        ++written;
    };
    for (std::size_t k = 0; k < met; ++k) {
        std::uint8_t d = entry[k];
        do {
            const std::uint8_t to = target_[d];
            if (number[to] == none) {
                number[to] = static_cast<std::uint8_t>(met);
                found.points[met] = to;
                entry[met] = dartOf_[to * std::size_t{16} + origin_[d]];
                --entry[met++];
            }
            write(number[to]);
            d = turned_[d];
        } while (d != entry[k]);
        write(0xf);
    }
    found.complete = met == pointCount_ && written == dartCount_ + pointCount_;
    return found;
}

} // namespace polymesh
