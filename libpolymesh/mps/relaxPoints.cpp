// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/relaxPoints.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/geometry/box.h"
#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/mps/movingMesh.h"
#include "libpolymesh/mps/pointStar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace polymesh {

namespace {

void sortUnique(std::vector<Label>& labels) {
    std::ranges::sort(labels);
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
}

/// The labels below `count` for which is(label) is true, ascending; in parallel.
template<class Is>
std::vector<Label> labelsWhere(Label count, Is&& is) {
    std::vector<char> isIn(index(count), 0);
    parallelFor(count, [&](Label i) { isIn[index(i)] = is(i) ? 1 : 0; });
    std::vector<Label> found;
    for (Label i = 0; i < count; ++i)
        if (isIn[index(i)] != 0) found.push_back(i);
    return found;
}

/// The cells and faces beyond a limit, ascending.
struct Offenders {
    std::vector<Label> cells;
    std::vector<Label> faces;

    Label size() const { return toLabel(cells.size() + faces.size()); }
};

/// Some points (ascending) with the faces that have them.
struct PointFaces {
    std::vector<Label> points;
    Rows<Label> faces;
};

/// Where points may be moved for offenders, and what is allowed: the cells round them, and the
/// Jacobians and cosines of leans down to which parts may become worse.
struct Trial {
    int rings;
    double least;
};

/// Whether a cell is a hexahedron with all points of its parts in three planes each way.
bool isBox(const PolyMesh& mesh, const SubdivisionPlan& plan, Label cell) {
    constexpr double off = 1e-6;
    constexpr double longest = 10;
    const std::span<const Label> faces = plan.cellFaces[cell];
    if (faces.size() != 6) return false;
    Box box;
    for (const Label face : faces) {
        if (mesh.faces.rowSize(face) != 4) return false;
        for (const Label point : mesh.faces[face])
            box.add(mesh.points[index(point)]);
    }
    const Vec3 size = box.size();
    const double least = std::min({size.x, size.y, size.z});
    const double most = std::max({size.x, size.y, size.z});
    if (!(least * longest >= most) || !(least > 0)) return false;
    const Vec3 middle = box.centre();
    const auto isPlaced = [&](const Vec3& p) {
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::min(std::abs(p[axis] - middle[axis]),
                           std::abs(std::abs(p[axis] - middle[axis]) - 0.5 * size[axis])) <=
                  off * least))
                return false;
        return true;
    };
    if (!isPlaced(plan.points[index(plan.layout.firstCell + cell)])) return false;
    return std::ranges::all_of(faces, [&](Label face) {
        for (Label i = mesh.faces.offsets[index(face)]; i < mesh.faces.offsets[index(face) + 1];
             ++i)
            if (!isPlaced(mesh.points[index(mesh.faces.values[index(i)])]) ||
                !isPlaced(
                    plan.points[index(plan.layout.firstEdge + plan.edges.ofCorner[index(i)])]))
                return false;
        return isPlaced(plan.points[index(plan.layout.firstFace + face)]);
    });
}

class Relaxer {
public:
    Relaxer(PolyMesh& mesh, Label firstNew, const Rows<Label>& cellFaces)
        : mesh_(mesh), firstNew_(firstNew), moving_(mesh, cellFaces) {}

    Offenders find(std::span<const char> isGood) {
        std::vector<char> isWatched(index(mesh_.cellCount), 1);
        std::ranges::transform(
            isGood, isWatched.begin(), [](char good) { return static_cast<char>(good == 0); });
        moving_.measure(isWatched);
        const auto isIn = [&](Label cell) { return isWatched[index(cell)] != 0; };
        return {labelsWhere(mesh_.cellCount,
                            [&](Label cell) { return isIn(cell) && moving_.isStretched(cell); }),
                labelsWhere(mesh_.faceCount(), [&](Label face) {
                    return (isIn(mesh_.owner[index(face)]) ||
                            (mesh_.isInternal(face) && isIn(mesh_.neighbour[index(face)]))) &&
                           moving_.isSkewOrTurned(face);
                })};
    }

    /// Those of them that still are beyond a limit.
    Offenders left(Offenders offenders) const {
        std::erase_if(offenders.cells, [&](Label cell) { return !moving_.isStretched(cell); });
        std::erase_if(offenders.faces, [&](Label face) { return !moving_.isSkewOrTurned(face); });
        return offenders;
    }

    void relax(const Offenders& offenders, const Trial& trial) {
        constexpr int rounds = 20;
        const PointFaces round = pointsAt(offenders, trial.rings);
        bool isChanged = true;
        for (int i = 0; i < rounds && isChanged && left(offenders).size() > 0; ++i) {
            isChanged = false;
            for (Label k = 0; k < round.faces.size(); ++k)
                isChanged =
                    improve(round.points[index(k)], round.faces[k], trial.least) || isChanged;
        }
    }

    Label movedCount() {
        sortUnique(moved_);
        return toLabel(moved_.size());
    }

private:
    /// The new points of the cells at offenders and of `rings` rings of cells round them.
    PointFaces pointsAt(const Offenders& offenders, int rings) const {
        std::vector<Label> cells = offenders.cells;
        const auto addCellsOf = [&](std::span<const Label> faces) {
            for (const Label face : faces) {
                cells.push_back(mesh_.owner[index(face)]);
                if (mesh_.isInternal(face)) cells.push_back(mesh_.neighbour[index(face)]);
            }
        };
        addCellsOf(offenders.faces);
        PointFaces result = pointsOf(cells);
        for (int ring = 0; ring < rings; ++ring) {
            addCellsOf(result.faces.values);
            sortUnique(cells);
            result = pointsOf(cells);
        }
        return result;
    }

    PointFaces pointsOf(std::span<const Label> cells) const {
        PointFaces result;
        for (const Label cell : cells)
            for (const Label face : moving_.facesOf(cell))
                for (const Label point : std::as_const(mesh_.faces)[face])
                    if (point >= firstNew_) result.points.push_back(point);
        sortUnique(result.points);
        std::vector<char> isWanted(mesh_.points.size(), 0);
        for (const Label point : result.points)
            isWanted[index(point)] = 1;
        const auto isIn = [&](Label point) { return isWanted[index(point)] != 0; };
        std::vector<std::pair<Label, Label>> uses;
        for (const Label face : labelsWhere(mesh_.faceCount(), [&](Label f) {
                 return std::ranges::any_of(std::as_const(mesh_.faces)[f], isIn);
             }))
            for (const Label point : std::as_const(mesh_.faces)[face])
                if (isIn(point)) uses.emplace_back(point, face);
        std::ranges::sort(uses);
        for (auto use = uses.begin(); use != uses.end();) {
            const Label point = use->first;
            for (; use != uses.end() && use->first == point; ++use)
                result.faces.values.push_back(use->second);
            result.faces.offsets.push_back(toLabel(result.faces.values.size()));
        }
        return result;
    }

    /// Moves a point if that helps: down the slope of the excess, else towards another point.
    bool improve(Label point, std::span<const Label> faces, double least) {
        constexpr int halvings = 8;
        constexpr std::array ways{0.5, 0.25, 0.1, 0.03};
        PointStar star(moving_, point, faces);
        const double before = star.excess();
        if (!(before > 0) || !star.isFree()) return false;
        star.remember();
        const Vec3 from = star.place();
        const auto helps = [&](const Vec3& to) {
            star.move(to);
            return star.excess() < before && star.isNoWorse(least);
        };
        const auto moves = [&] {
            const Vec3 slope = slopeOf(star);
            const double steepness = norm(slope);
            if (!(steepness > 0)) return false;
            double step = std::min(star.reach(), 2 * before / steepness);
            for (int i = 0; i < halvings; ++i, step *= 0.5)
                if (helps(from - (step / steepness) * slope)) return true;
            for (const Label other : star.others()) {
                const Vec3 way = mesh_.points[index(other)] - from;
                if (!(dot(slope, way) < 0)) continue;
                if (std::ranges::any_of(ways,
                                        [&](double part) { return helps(from + part * way); }))
                    return true;
            }
            return false;
        };
        if (moves()) {
            moved_.push_back(point);
            return true;
        }
        star.restore();
        return false;
    }

    /// How the excess rises with the place of the point.
    static Vec3 slopeOf(PointStar& star) {
        constexpr double little = 1e-4;
        const double step = little * star.reach();
        const Vec3 from = star.place();
        const double before = star.excess();
        Vec3 slope;
        for (const Vec3& axis : star.axes()) {
            star.move(from + step * axis);
            slope += (star.excess() - before) / step * axis;
        }
        star.restore();
        return slope;
    }

    PolyMesh& mesh_;
    Label firstNew_;
    MovingMesh moving_;
    std::vector<Label> moved_;
};

} // namespace

std::vector<char> partsOfBoxes(const PolyMesh& mesh, const SubdivisionPlan& plan) {
    std::vector<char> isPart(index(plan.firstPart.back()), 0);
    parallelFor(mesh.cellCount, [&](Label cell) {
        const bool is = isBox(mesh, plan, cell);
        for (Label p = plan.firstPart[index(cell)]; p < plan.firstPart[index(cell) + 1]; ++p)
            isPart[index(p)] = is ? 1 : 0;
    });
    return isPart;
}

RelaxCounts relaxPoints(PolyMesh& mesh, Label firstNew, std::span<const char> isGood) {
    constexpr std::array<Trial, 3> trials{{{0, 1e-2}, {0, 1e-4}, {1, 1e-6}}};
    if (std::ranges::count(isGood, 1) == mesh.cellCount) return {};
    const Rows<Label> faces = cellFaces(mesh);
    Relaxer relaxer(mesh, firstNew, faces);
    Offenders offenders = relaxer.find(isGood);
    RelaxCounts counts{offenders.size(), offenders.size(), 0};
    for (const Trial& trial : trials) {
        if (offenders.size() == 0) break;
        relaxer.relax(offenders, trial);
        offenders = relaxer.left(std::move(offenders));
    }
    counts.left = offenders.size();
    counts.moved = relaxer.movedCount();
    return counts;
}

} // namespace polymesh
