// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/rows.h"
#include "libpolymesh/geometry/box.h"
#include "libpolymesh/surface/triSurface.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace polymesh {

/// A regular grid of bins over a surface: which triangles may come near a place.
/// Laws: (1) a bin lists every triangle that meets its closed box (and perhaps some that only come
/// near it); (2) binOf is monotonous in each coordinate, so that a range of bins covers a box.
class TriangleBins {
public:
    /// One number for each direction, and one without meaning: a vector of GCC and Clang, so that
    /// ranges, of which each face of the mesh makes several, are made in one operation.
    using Index [[gnu::vector_size(8)]] = std::int16_t;

    /// A box of bins, both ends included.
    struct Range {
        Index first{INT16_MAX, INT16_MAX, INT16_MAX, INT16_MAX};
        Index last{INT16_MIN, INT16_MIN, INT16_MIN, INT16_MIN};

        void add(const Index& i) {
            first = i < first ? i : first;
            last = i > last ? i : last;
        }

        void add(const Range& r) {
            add(r.first);
            add(r.last);
        }
    };

    /// `binSize` [m] is a wish: at most some 10^6 bins are made. Cost: O(triangles + pairs).
    TriangleBins(const TriSurface& surface, double binSize);

    /// The bin of a point; -1 or the bin count of the axis where it lies outside the surface's box.
    Index binOf(const Vec3& p) const;

    /// Whether any bin of the range holds a triangle. O(1).
    bool isOccupied(const Range& range) const;

    /// Appends the triangles of the range's bins to `found`, ascending, each once.
    void collect(const Range& range, std::vector<Label>& found) const;

private:
    struct Pair {
        Label bin;
        Label triangle;
    };

    std::size_t position(int i, int j, int k) const;
    void divide(double binSize);
    std::array<int, 2> rangeOf(std::span<const Vec3> polygon, int axis) const;
    template<class Polygon, class Visit>
    void forSlabs(const Polygon& polygon, int axis, Visit&& visit) const;
    void addPairs(const TriSurface& surface, Label t, std::vector<Pair>& pairs) const;
    std::vector<std::vector<Pair>> pairsOf(const TriSurface& surface) const;
    void listTriangles(const std::vector<std::vector<Pair>>& pairs);
    void countOccupied();

    Box box_;
    Vec3 size_;
    double slack_ = 0; // [m] clipping rounds: slabs are wider by more than it can err
    std::array<int, 3> count_{1, 1, 1};
    Rows<Label> triangles_;       // one row per bin
    std::vector<Label> sumTable_; // occupied bins in [0, i) x [0, j) x [0, k)
};

} // namespace polymesh
