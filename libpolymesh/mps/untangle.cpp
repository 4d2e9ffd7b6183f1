// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/untangle.h"

#include "libpolymesh/mps/pointWithin.h"
#include "libpolymesh/mps/searchCells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace polymesh {

namespace {

/// What must not move: everything on the boundary.
std::vector<char> fixedPoints(const PolyMesh& mesh, const SubdivisionPlan& plan) {
    std::vector<char> isFixed(plan.points.size(), 0);
    for (Label face = mesh.internalFaceCount(); face < mesh.faceCount(); ++face) {
        isFixed[index(plan.layout.firstFace + face)] = 1;
        for (Label i = mesh.faces.offsets[index(face)]; i < mesh.faces.offsets[index(face) + 1];
             ++i) {
            isFixed[index(mesh.faces.values[index(i)])] = 1;
            isFixed[index(plan.layout.firstEdge + plan.edges.ofCorner[index(i)])] = 1;
        }
    }
    return isFixed;
}

/// Moves points one after the other.
class Untangler {
public:
    Untangler(const PolyMesh& mesh, SubdivisionPlan& plan)
        : mesh_(mesh),
          plan_(plan),
          divided_{mesh, plan.edges, plan.cellFaces},
          pointCells_(pointCells(mesh)),
          isFixed_(fixedPoints(mesh, plan)) {}

    /// Tries the points of the inverted corners of a cell; true when the cell is right then.
    bool cure(Label cell) {
        for (const Label point : suspects(cell)) {
            if (isFixed_[index(point)] != 0 || !move(point, cell)) continue;
            ++moved_;
            if (suspects(cell).empty()) return true;
        }
        return suspects(cell).empty();
    }

    Label moved() const { return moved_; }

    /// Whether moving points could help: a node of valence 2 has two corners of opposite sense, a
    /// corner of fixed points stays what it is, and cells with many bad corners are concave.
    bool isCurable(Label cell) const {
        constexpr std::ptrdiff_t many = 8;
        CellCorners corners;
        corners.load(divided_, cell);
        std::vector<PartCorner> list;
        addPartCorners(plan_.parts(corners, cell), list);
        if (std::ranges::count_if(list, [&](const PartCorner& c) { return isBad(c); }) > many)
            return false;
        const auto isFixed = [&](Label p) { return isFixed_[index(p)] != 0; };
        return std::ranges::none_of(corners.nodes(),
                                    [](const auto& n) { return n.valence == 2; }) &&
               std::ranges::none_of(list, [&](const PartCorner& c) {
                   return isBad(c) && std::ranges::all_of(c, isFixed);
               });
    }

private:
    const Vec3& at(Label point) const { return plan_.points[index(point)]; }

    bool isBad(const PartCorner& c) const {
        return isInverted(at(c[1]) - at(c[0]), at(c[2]) - at(c[0]), at(c[3]) - at(c[0]));
    }

    /// Points of the inverted corners of a cell: those of the cell itself first, its nodes last.
    std::vector<Label> suspects(Label cell) {
        load(cell);
        std::vector<Label> points;
        for (const PartCorner& c : corners_)
            if (isBad(c)) points.insert(points.end(), c.begin(), c.end());
        std::ranges::sort(points, std::greater{});
        points.erase(std::unique(points.begin(), points.end()), points.end());
        return points;
    }

    void load(Label cell) {
        cell_.load(divided_, cell);
        corners_.clear();
        addPartCorners(plan_.parts(cell_, cell), corners_);
    }

    /// The cells that may have the point; `cell` is one of them.
    std::vector<Label> cellsOf(Label point, Label cell) const {
        const PointLayout& layout = plan_.layout;
        if (point >= layout.firstCell) return {cell};
        if (point >= layout.firstFace) {
            const Label face = point - layout.firstFace;
            return {mesh_.owner[index(face)], mesh_.neighbour[index(face)]};
        }
        const Label node = point >= layout.firstEdge
                               ? plan_.edges.points[index(point - layout.firstEdge)][0]
                               : point;
        return {pointCells_[node].begin(), pointCells_[node].end()};
    }

    bool move(Label point, Label cell) {
        constexpr Search search{.least = 7e-3};
        std::vector<HalfSpace> halfSpaces;
        double reach = std::numeric_limits<double>::max();
        for (const Label other : cellsOf(point, cell)) {
            load(other);
            for (const PartCorner& c : corners_)
                addCorner(c, point, halfSpaces, reach);
        }
        const auto place = pointWithin(halfSpaces, at(point), 0.25 * std::sqrt(reach), search);
        if (place) plan_.points[index(point)] = *place;
        return place.has_value();
    }

    /// Where the point keeps a corner that has it right; `reach`: least squared distance seen.
    void addCorner(const PartCorner& c,
                   Label point,
                   std::vector<HalfSpace>& halfSpaces,
                   double& reach) const {
        const auto found = std::ranges::find(c, point);
        if (found == c.end()) return;
        const auto k = static_cast<std::size_t>(found - c.begin());
        // The other three, so that their normal points to where the point belongs.
        constexpr std::array<std::array<std::size_t, 3>, 4> others{
            {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}}};
        const Vec3& a = at(c[others[k][0]]);
        const Vec3& b = at(c[others[k][1]]);
        const Vec3& d = at(c[others[k][2]]);
        addHalfSpace(b - a, d - a, a, halfSpaces);
        reach = std::min({reach,
                          squaredNorm(at(point) - a),
                          squaredNorm(at(point) - b),
                          squaredNorm(at(point) - d)});
    }

    const PolyMesh& mesh_;
    SubdivisionPlan& plan_;
    DividedMesh divided_;
    Rows<Label> pointCells_;
    std::vector<char> isFixed_;
    CellCorners cell_;
    std::vector<PartCorner> corners_;
    Label moved_ = 0;
};

} // namespace

Label untangle(const PolyMesh& mesh, SubdivisionPlan& plan) {
    if (plan.inverted.empty()) return 0;
    constexpr int sweeps = 2;
    Untangler untangler(mesh, plan);
    const auto curable =
        chosen(plan.inverted, [&](Label cell) { return untangler.isCurable(cell); });
    std::vector<Label> left = curable;
    for (int sweep = 0; sweep < sweeps && !left.empty(); ++sweep) {
        const std::size_t before = left.size();
        const Label moved = untangler.moved();
        std::erase_if(left, [&](Label cell) { return untangler.cure(cell); });
        if (left.size() == before && untangler.moved() == moved) break;
    }
    std::erase_if(plan.inverted, [&](Label cell) {
        return std::ranges::binary_search(curable, cell) && !std::ranges::binary_search(left, cell);
    });
    return untangler.moved();
}

} // namespace polymesh
