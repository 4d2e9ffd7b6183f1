// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/pointStar.h"

#include "libpolymesh/mesh/topology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace polymesh {

namespace {

/// What moves aim at, by the limits: clear of them by more than the digits that checkMesh prints.
constexpr double aim = 0.97;
/// Leans above this one count as beyond the limit.
constexpr double leanAim = 1 - 1e-6;
/// Edges from a point may become as short as this by the longest.
constexpr double even = 0.03;

void sortUnique(std::vector<Label>& labels) {
    std::ranges::sort(labels);
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
}

/// A corner of an outward loop.
struct Turn {
    Label before;
    Label point;
    Label behind;
};

std::vector<Turn> turnsOf(const PolyMesh& mesh, std::span<const Label> faces, Label cell) {
    std::vector<Turn> turns;
    for (const Label face : faces) {
        const auto loop = mesh.faces[face];
        const bool isOwned = mesh.owner[index(face)] == cell;
        for (std::size_t i = 0, n = loop.size(); i < n; ++i) {
            const Label before = loop[(i + n - 1) % n];
            const Label behind = loop[(i + 1) % n];
            turns.push_back(isOwned ? Turn{before, loop[i], behind}
                                    : Turn{behind, loop[i], before});
        }
    }
    std::ranges::sort(turns, {}, [](const Turn& t) { return std::pair(t.point, t.before); });
    return turns;
}

double scaledJacobian(const std::vector<Vec3>& points, const PartCorner& corner) {
    const Vec3& at = points[index(corner[0])];
    const Vec3 a = points[index(corner[1])] - at;
    const Vec3 b = points[index(corner[2])] - at;
    const Vec3 c = points[index(corner[3])] - at;
    const double lengths = norm(a) * norm(b) * norm(c);
    return lengths > 0 ? dot(cross(a, b), c) / lengths : 0;
}

const Patch& patchOf(const PolyMesh& mesh, Label face) {
    return *std::ranges::find_if(
        mesh.patches, [&](const Patch& patch) { return face < patch.start + patch.size; });
}

} // namespace

PointStar::PointStar(MovingMesh& moving, Label point, std::span<const Label> pointFaces)
    : moving_(moving), point_(point), start_(place()), faces_(pointFaces) {
    const PolyMesh& mesh = moving_.mesh();
    const auto isInternal = [&](Label face) { return mesh.isInternal(face); };
    boundaryFaces_ = faces_.subspan(static_cast<std::size_t>(
        std::ranges::partition_point(faces_, isInternal) - faces_.begin()));
    for (const Label face : faces_) {
        cells_.push_back(mesh.owner[index(face)]);
        if (mesh.isInternal(face)) cells_.push_back(mesh.neighbour[index(face)]);
    }
    sortUnique(cells_);
    for (const Label cell : cells_) {
        moving_.measure(cell);
        const auto faces = moving_.facesOf(cell);
        allFaces_.insert(allFaces_.end(), faces.begin(), faces.end());
    }
    sortUnique(allFaces_);
    findAxes();
    held_ = held();
}

void PointStar::remember() {
    corners_.clear();
    for (const Label cell : cells_)
        findCorners(cell);
    remembered_ = measures();
}

/// The corners at points of three edges; the apex of a pyramid has no Jacobian.
void PointStar::findCorners(Label cell) {
    const std::vector<Turn> turns = turnsOf(moving_.mesh(), moving_.facesOf(cell), cell);
    for (std::size_t i = 0; i < turns.size();) {
        std::size_t end = i;
        while (end < turns.size() && turns[end].point == turns[i].point)
            ++end;
        if (end - i == 3) {
            const Turn& t = turns[i];
            const Turn& other = turns[i + 1].before == t.behind ? turns[i + 2] : turns[i + 1];
            const PartCorner corner{t.point, t.before, t.behind, other.before};
            if (std::ranges::find(corner, point_) != corner.end()) corners_.push_back(corner);
        }
        i = end;
    }
}

void PointStar::findAxes() {
    constexpr double flat = 0.985; // cosine of 10 degrees
    if (boundaryFaces_.empty()) {
        axes_ = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        return;
    }
    const PolyMesh& mesh = moving_.mesh();
    for (const Label face : boundaryFaces_)
        boundaryArea_ += moving_.face(face).area;
    const double area = norm(boundaryArea_);
    const bool isFlat = std::ranges::all_of(boundaryFaces_, [&](Label face) {
        const Vec3& own = moving_.face(face).area;
        return dot(own, boundaryArea_) > flat * norm(own) * area;
    });
    const Patch& patch = patchOf(mesh, boundaryFaces_.front());
    if (!isFlat || &patch != &patchOf(mesh, boundaryFaces_.back()) || isCoupledType(patch.type))
        return;
    const Vec3 normal = boundaryArea_ / area;
    const Vec3 along = cross(normal, std::abs(normal.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0});
    const Vec3 first = along / norm(along);
    axes_ = {first, cross(normal, first)};
}

std::vector<Label> PointStar::others() const {
    std::vector<Label> others;
    for (const Label face : faces_) {
        const auto loop = moving_.mesh().faces[face];
        const auto i = static_cast<std::size_t>(std::ranges::find(loop, point_) - loop.begin());
        others.push_back(loop[(i + 1) % loop.size()]);
        others.push_back(loop[(i + loop.size() - 1) % loop.size()]);
    }
    sortUnique(others);
    return others;
}

double PointStar::reach() const {
    double least = std::numeric_limits<double>::max();
    for (const Label other : others())
        least = std::min(least, squaredNorm(moving_.mesh().points[index(other)] - place()));
    return std::sqrt(least);
}

double PointStar::evenness() const {
    double least = std::numeric_limits<double>::max();
    double most = 0;
    for (const Label other : others()) {
        const double length2 = squaredNorm(moving_.mesh().points[index(other)] - place());
        least = std::min(least, length2);
        most = std::max(most, length2);
    }
    return std::sqrt(least / most);
}

double PointStar::held() const {
    double sum = 0;
    for (const Label face : boundaryFaces_)
        sum += dot(moving_.face(face).area, moving_.face(face).centre - start_);
    return sum;
}

void PointStar::move(const Vec3& to) {
    if (boundaryFaces_.empty()) {
        put(to);
        return;
    }
    constexpr int steps = 6;
    const double area = norm(boundaryArea_);
    const double rounding = 1e-15 * area * std::sqrt(area);
    const Vec3 normal = boundaryArea_ / area;
    put(to - dot(normal, to - start_) * normal);
    double slope = area;
    double excess = held() - held_;
    for (int i = 0; i < steps && std::abs(excess) > rounding; ++i) {
        const double by = -excess / slope;
        put(place() + by * normal);
        const double now = held() - held_;
        const double measured = (now - excess) / by;
        if (measured > 0.1 * area) slope = measured;
        excess = now;
    }
}

double PointStar::excess() const {
    double sum = 0;
    const auto add = [&](double byLimit, double aimed) {
        if (byLimit > aimed) sum += std::log(byLimit / aimed);
    };
    for (const Label cell : cells_)
        add(moving_.largeStretch(cell), aim);
    for (const Label face : allFaces_)
        if (const double skewness = moving_.largeSkewness(face); skewness > 0) {
            add(skewness, aim);
            add(moving_.lean(face), leanAim);
        }
    return sum;
}

PointStar::Measures PointStar::measures() const {
    Measures result;
    for (const Label cell : cells_)
        result.byLimit.push_back(moving_.largeStretch(cell));
    for (const Label face : allFaces_) {
        result.byLimit.push_back(moving_.largeSkewness(face));
        result.leans.push_back(moving_.lean(face));
    }
    for (const PartCorner& corner : corners_)
        result.jacobian = std::min(result.jacobian, scaledJacobian(moving_.mesh().points, corner));
    result.evenness = evenness();
    return result;
}

bool PointStar::isNoWorse(double least) const {
    const Measures now = measures();
    const auto keeps =
        [](const std::vector<double>& are, const std::vector<double>& were, double enough) {
            for (std::size_t i = 0; i < are.size(); ++i)
                if (!(are[i] <= enough) && !(were[i] > 1) && !(are[i] <= were[i])) return false;
            return true;
        };
    return now.jacobian >= std::min(remembered_.jacobian, least) &&
           now.evenness >= std::min(remembered_.evenness, even) &&
           keeps(now.byLimit, remembered_.byLimit, 1) &&
           keeps(now.leans, remembered_.leans, 1 - least);
}

} // namespace polymesh
