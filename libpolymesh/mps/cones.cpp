// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/cones.h"

#include "libpolymesh/mps/cellLoops.h"
#include "libpolymesh/mps/looseFaces.h"
#include "libpolymesh/mps/pointWithin.h"
#include "libpolymesh/mps/searchCells.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

namespace polymesh {

namespace {

/// Parts of a possible cell: how many, and whether one is inverted.
struct Trial {
    bool isGood = false;
    std::int64_t cost = 0;
};

/// Tries groups of the faces of one cell.
class ConeSearch {
public:
    ConeSearch(const PolyMesh& mesh, const Bends& bends, const SubdivisionPlan& plan, Label cell)
        : mesh_(mesh),
          bends_(bends),
          plan_(plan),
          cell_(cell),
          loops_(outwardLoops(mesh, plan.cellFaces, cell)),
          edges_(edgesOf(loops_)) {}

    /// A point that sees all faces.
    std::optional<Vec3> centre() const {
        constexpr Search deep{.least = 1e-6};
        const Vec3 start = plan_.points[index(plan_.layout.firstCell + cell_)];
        return pointWithin(halfSpaces(), start, reach(start), deep);
    }

    std::optional<CellCones> find() {
        const auto centre = this->centre();
        if (!centre) return std::nullopt;
        centre_ = *centre;
        groupOf_.resize(loops_.size());
        std::iota(groupOf_.begin(), groupOf_.end(), 0);
        for (std::size_t g = 0; g < loops_.size(); ++g)
            trials_.push_back(tried({static_cast<int>(g)}));
        while (joinBest()) {
        }
        return result();
    }

private:
    /// Where the point sees every corner and every fan triangle of the faces from within.
    std::vector<HalfSpace> halfSpaces() const {
        std::vector<HalfSpace> list;
        for (std::size_t f = 0; f < loops_.size(); ++f) {
            const Polygon& loop = loops_[f];
            const Label face = plan_.cellFaces[cell_][f];
            const Vec3& middle = plan_.points[index(plan_.layout.firstFace + face)];
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Vec3& at = point(loop[i]);
                const Label next = loop[(i + 1) % loop.size()];
                const Vec3 before = towards(loop[i], loop[(i + loop.size() - 1) % loop.size()]);
                const Vec3 after = towards(loop[i], next);
                addHalfSpace(before - at, after - at, at, list);
                addHalfSpace(middle - at, after - at, at, list);
                if (findBend(bends_, loop[i], next) != nullptr)
                    addHalfSpace(middle - after, point(next) - after, after, list);
            }
        }
        return list;
    }

    double reach(const Vec3& from) const {
        double most = 0;
        for (const Polygon& loop : loops_)
            for (const Label p : loop)
                most = std::max(most, norm(point(p) - from));
        return most;
    }

    const Vec3& point(Label p) const { return mesh_.points[index(p)]; }

    /// Where the edge from one point to another goes first.
    const Vec3& towards(Label from, Label to) const {
        const Bend* bend = findBend(bends_, from, to);
        return bend != nullptr ? bend->at : point(to);
    }

    /// The faces of the cell over some faces of this one.
    std::vector<Polygon> coneLoops(const std::vector<int>& faces) const {
        std::vector<Polygon> loops;
        loops.reserve(faces.size());
        const auto isIn = [&](int f) { return std::ranges::find(faces, f) != faces.end(); };
        for (const int f : faces)
            loops.push_back(loops_[static_cast<std::size_t>(f)]);
        for (const CellEdge& e : edges_) {
            if (isIn(e.left) == isIn(e.right)) continue;
            const Label from = isIn(e.left) ? e.b : e.a;
            loops.push_back({from, isIn(e.left) ? e.a : e.b, -1});
        }
        return loops;
    }

    Trial tried(const std::vector<int>& faces) const {
        // A group whose rim meets itself at a point gives no cone.
        const std::vector<Polygon> loops = coneLoops(faces);
        if (!isClosed(loops)) return {};
        const LoneCell cone = loneCell(mesh_, bends_, loops, centre_);
        const SubdivisionPlan plan = planSubdivision(cone.mesh, cone.bends);
        return {plan.inverted.empty(), plan.hexahedra + 2 * plan.pyramids};
    }

    std::vector<int> facesOf(int group) const {
        std::vector<int> faces;
        for (std::size_t f = 0; f < groupOf_.size(); ++f)
            if (groupOf_[f] == group) faces.push_back(static_cast<int>(f));
        return faces;
    }

    /// What joining two groups gives, kept until one of them changes.
    const Trial& joined(int g, int h) {
        const auto [at, isNew] = pairs_.try_emplace({std::min(g, h), std::max(g, h)});
        if (isNew) {
            std::vector<int> faces = facesOf(g);
            const std::vector<int> others = facesOf(h);
            faces.insert(faces.end(), others.begin(), others.end());
            at->second = tried(faces);
        }
        return at->second;
    }

    /// Joins the two groups that save most parts, or heal; false when none do.
    bool joinBest() {
        std::tuple<int, std::int64_t> best{0, 0}; // groups healed, parts saved
        std::pair<int, int> chosen{-1, -1};
        for (const CellEdge& e : edges_) {
            const int g = groupOf_[static_cast<std::size_t>(e.left)];
            const int h = groupOf_[static_cast<std::size_t>(e.right)];
            if (g == h) continue;
            const Trial& trial = joined(g, h);
            if (!trial.isGood) continue;
            const Trial& a = trials_[static_cast<std::size_t>(g)];
            const Trial& b = trials_[static_cast<std::size_t>(h)];
            const std::tuple gain{(a.isGood ? 0 : 1) + (b.isGood ? 0 : 1),
                                  a.cost + b.cost - trial.cost};
            if (gain <= best) continue;
            best = gain;
            chosen = std::minmax(g, h);
        }
        if (chosen.first < 0) return false;
        join(chosen.first, chosen.second);
        return true;
    }

    void join(int g, int h) {
        trials_[static_cast<std::size_t>(g)] = joined(g, h);
        std::ranges::replace(groupOf_, h, g);
        std::erase_if(pairs_, [&](const auto& entry) {
            const auto [a, b] = entry.first;
            return a == g || b == g || a == h || b == h;
        });
    }

    /// Numbers the groups from 0; none when one is bad.
    std::optional<CellCones> result() const {
        CellCones cones{cell_, {centre_}, std::vector<int>(groupOf_.size(), -1), 0, {}};
        std::map<int, int> number;
        for (std::size_t f = 0; f < groupOf_.size(); ++f) {
            if (!trials_[static_cast<std::size_t>(groupOf_[f])].isGood) return std::nullopt;
            const auto [at, isNew] = number.try_emplace(groupOf_[f], cones.groupCount);
            cones.groupCount += isNew ? 1 : 0;
            cones.groupOf[f] = at->second;
        }
        return cones;
    }

    const PolyMesh& mesh_;
    const Bends& bends_;
    const SubdivisionPlan& plan_;
    Label cell_;
    std::vector<Polygon> loops_;
    std::vector<CellEdge> edges_;
    Vec3 centre_;
    std::vector<int> groupOf_;
    std::vector<Trial> trials_; // by group, which has the number of one of its faces
    std::map<std::pair<int, int>, Trial> pairs_;
};

void extendZones(std::vector<Zone>& zones, std::span<const CellCones> cones, Label firstNew) {
    for (Zone& zone : zones) {
        Label next = firstNew;
        const std::size_t oldSize = zone.labels.size();
        for (const CellCones& c : cones) {
            const auto end = zone.labels.begin() + static_cast<std::ptrdiff_t>(oldSize);
            const bool isIn = std::binary_search(zone.labels.begin(), end, c.cell);
            for (int g = 1; g < c.groupCount; ++g, ++next)
                if (isIn) zone.labels.push_back(next);
        }
    }
}

/// Adds the points, the cells and the triangles of one cell's cones, and gives its faces to them:
/// in mesh.owner where the cell owns them, else in `loose`.
void cutCell(PolyMesh& mesh,
             const Rows<Label>& cellFaces,
             const CellCones& c,
             std::vector<LooseFace>& loose) {
    const Label firstPoint = mesh.pointCount();
    const auto cellOf = [&](int group) { return group == 0 ? c.cell : mesh.cellCount + group - 1; };
    const auto add = [&](int left, int right, Polygon loop) {
        const Label inside = cellOf(left);
        const Label outside = cellOf(right);
        if (inside > outside) std::ranges::reverse(loop);
        if (inside != outside)
            loose.push_back(
                {std::min(inside, outside), std::max(inside, outside), std::move(loop), -1});
    };
    for (const CellWall& wall : c.walls) {
        std::vector<Label> loop = wall.loop;
        for (Label& p : loop)
            p = p < 0 ? firstPoint - 1 - p : p;
        add(wall.inside, wall.outside, std::move(loop));
    }
    // The triangle b, a, centre leaves the cell on the left.
    if (c.walls.empty())
        for (const CellEdge& e : edgesOf(outwardLoops(mesh, cellFaces, c.cell)))
            add(c.groupOf[static_cast<std::size_t>(e.left)],
                c.groupOf[static_cast<std::size_t>(e.right)],
                {e.b, e.a, firstPoint});
    for (std::size_t f = 0; f < c.groupOf.size(); ++f) {
        const Label face = cellFaces[c.cell][f];
        const bool isOwned = mesh.owner[index(face)] == c.cell;
        (isOwned ? mesh.owner[index(face)] : loose[index(face)].neighbour) = cellOf(c.groupOf[f]);
    }
    mesh.points.insert(mesh.points.end(), c.points.begin(), c.points.end());
    mesh.cellCount += c.groupCount - 1;
}

} // namespace

std::vector<CellCones> conesOf(const PolyMesh& mesh,
                               const Bends& bends,
                               const SubdivisionPlan& plan,
                               std::span<const Label> cells) {
    return searchCells(cells,
                       [&](Label cell) { return ConeSearch(mesh, bends, plan, cell).find(); });
}

PolyMesh withCones(PolyMesh mesh, const Rows<Label>& cellFaces, std::span<const CellCones> cones) {
    if (cones.empty()) return mesh;
    std::vector<LooseFace> loose = internalFaces(mesh);
    const Label firstNew = mesh.cellCount;
    for (const CellCones& c : cones)
        cutCell(mesh, cellFaces, c, loose);
    for (Label face = 0; face < mesh.internalFaceCount(); ++face) {
        LooseFace& f = loose[index(face)];
        f.owner = mesh.owner[index(face)];
        if (f.owner < f.neighbour) continue;
        std::swap(f.owner, f.neighbour);
        std::ranges::reverse(f.loop);
        f.isTurned = true;
    }
    setInternalFaces(mesh, loose);
    extendZones(mesh.cellZones, cones, firstNew);
    return mesh;
}

} // namespace polymesh
