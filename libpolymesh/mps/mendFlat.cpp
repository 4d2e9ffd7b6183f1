// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/mendFlat.h"

#include "libpolymesh/mps/pointWithin.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace polymesh {

namespace {

using Tetrahedron = std::array<Label, 4>;
using Side = std::array<Label, 3>; // seen from outside

std::array<Side, 4> sidesOf(const Tetrahedron& t) {
    const auto& [a, b, c, d] = t;
    return {{{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}}};
}

bool has(const Tetrahedron& t, Label p) {
    return std::ranges::find(t, p) != t.end();
}

class Mender {
public:
    Mender(std::vector<Vec3>& points, TetMesh& mesh) : points_(points), mesh_(mesh) {}

    /// Mends the first flat tetrahedron that can be; false when there is none.
    bool mendOne() {
        for (const Tetrahedron& t : mesh_.tetrahedra) {
            const double quality = qualityOf(t);
            if (quality > flat) continue;
            const auto best = bestMend(t, quality);
            if (!best) continue;
            apply(*best);
            return true;
        }
        return false;
    }

private:
    static constexpr double flat = 1e-6; // of the product of the edges' lengths

    struct Mend {
        Label a = -1; // the tetrahedra round the edge between a and b
        Label b = -1; // the same: round a point
        Vec3 at;
        double quality = 0;
    };

    const Vec3& at(Label p) const { return points_[index(p)]; }

    /// The least scaled Jacobian at the corners.
    double qualityOf(const Tetrahedron& t) const {
        const Vec3 ab = at(t[1]) - at(t[0]);
        const Vec3 ac = at(t[2]) - at(t[0]);
        const Vec3 ad = at(t[3]) - at(t[0]);
        const double volume = dot(cross(ab, ac), ad);
        double product = 0;
        for (const Label p : t) {
            double own = 1;
            for (const Label q : t)
                own *= q == p ? 1 : norm(at(q) - at(p));
            product = std::max(product, own);
        }
        return product > 0 ? volume / product : 0;
    }

    /// The sides of the tetrahedra with both points that are not between two of them.
    std::vector<Side> outsideOf(Label a, Label b) const {
        std::vector<std::pair<Side, Side>> sides; // sorted, as it is
        for (const Tetrahedron& t : mesh_.tetrahedra) {
            if (!has(t, a) || !has(t, b)) continue;
            for (const Side& side : sidesOf(t)) {
                Side key = side;
                std::ranges::sort(key);
                sides.emplace_back(key, side);
            }
        }
        std::ranges::sort(sides);
        std::vector<Side> outside;
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const bool isPair = i + 1 < sides.size() && sides[i].first == sides[i + 1].first;
            if (isPair)
                ++i;
            else
                outside.push_back(sides[i].second);
        }
        return outside;
    }

    std::optional<Mend> mendRound(Label a, Label b) const {
        const std::vector<Side> outside = outsideOf(a, b);
        std::vector<HalfSpace> planes;
        Vec3 mean;
        for (const auto& [p, q, r] : outside) {
            addHalfSpace(at(r) - at(p), at(q) - at(p), at(p), planes);
            mean += (at(p) + at(q) + at(r)) / 3;
        }
        mean = mean / static_cast<double>(outside.size());
        double reach = 0;
        for (const Side& side : outside)
            for (const Label p : side)
                reach = std::max(reach, norm(at(p) - mean));
        const auto within = pointWithin(planes, mean, reach);
        if (!within) return std::nullopt;
        Mend mend{a, b, *within, 1};
        points_.push_back(*within);
        for (const auto& [p, q, r] : outside)
            mend.quality =
                std::min(mend.quality, qualityOf({p, r, q, toLabel(points_.size()) - 1}));
        points_.pop_back();
        return mend;
    }

    /// The mend that leaves the best; none that does not leave all better than this.
    std::optional<Mend> bestMend(const Tetrahedron& t, double quality) const {
        std::optional<Mend> best;
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = i; j < 4; ++j) {
                const auto mend = mendRound(t[i], t[j]);
                if (!mend || mend->quality <= std::max(2 * quality, flat)) continue;
                if (!best || mend->quality > best->quality) best = mend;
            }
        return best;
    }

    void apply(const Mend& mend) {
        const std::vector<Side> outside = outsideOf(mend.a, mend.b);
        std::erase_if(mesh_.tetrahedra,
                      [&](const Tetrahedron& t) { return has(t, mend.a) && has(t, mend.b); });
        for (const auto& [p, q, r] : outside)
            mesh_.tetrahedra.push_back({p, r, q, toLabel(points_.size())});
        points_.push_back(mend.at);
        mesh_.newPoints.push_back(mend.at);
    }

    std::vector<Vec3>& points_;
    TetMesh& mesh_;
};

} // namespace

void mendFlat(std::vector<Vec3>& points, TetMesh& mesh) {
    constexpr int most = 100;
    Mender mender(points, mesh);
    for (int i = 0; i < most && mender.mendOne(); ++i) {
    }
}

} // namespace polymesh
