// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapeSplit/pieceChanges.h"

#include "libpolymesh/quality/cellTopology.h"
#include "libpolymesh/quality/cutCell.h"
#include "libpolymesh/quality/movePoint.h"
#include "libpolymesh/shapeSplit/editedShape.h"
#include "libpolymesh/shapeSplit/faceCuts.h"
#include "libpolymesh/shapeSplit/goodPieces.h"
#include "libpolymesh/shapeSplit/splitTogether.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <span>
#include <utility>

namespace polymesh {

namespace {

void sortUnique(std::vector<Label>& labels) {
    std::ranges::sort(labels);
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
}

bool hasPoint(const EditFace& face, Label p) {
    return std::ranges::find(face.points, p) != face.points.end();
}

/// The one point of a cell that is on none of these faces of it; -1 when there are more.
Label apexOver(const MeshEditor& editor, Label cell, const std::vector<Label>& base) {
    Label apex = -1;
    for (const Label f : editor.cell(cell).faces)
        for (const Label p : editor.face(f).points) {
            const auto hasIt = [&](Label g) { return hasPoint(editor.face(g), p); };
            if (p == apex || std::ranges::any_of(base, hasIt)) continue;
            if (apex >= 0) return -1;
            apex = p;
        }
    return apex;
}

std::optional<std::pair<Label, Label>> commonEdge(const EditFace& f, const EditFace& g) {
    for (std::size_t i = 0; i < f.points.size(); ++i) {
        const Label next = f.points[(i + 1) % f.points.size()];
        if (hasPoint(g, f.points[i]) && hasPoint(g, next)) return std::pair(f.points[i], next);
    }
    return std::nullopt;
}

/// Cuts a cell along the triangle of three of its points, which edges join.
Label cutAlong(MeshEditor& editor, Label cell, const std::array<Label, 3>& triangle) {
    CellLoop loop;
    for (const Label p : triangle) {
        LoopCorner corner;
        corner.point = p;
        corner.position = editor.point(p);
        loop.push_back(corner);
    }
    return cutCell(editor, cell, loop);
}

/// Cuts a pyramid whose base is in several faces into the pyramids on these.
bool cutFromApex(MeshEditor& editor, Label cell, Label apex, const std::vector<Label>& base) {
    std::vector<Label> pieces{cell};
    const auto isOf = [&](Label f, Label c) {
        return editor.face(f).owner == c || editor.face(f).neighbour == c;
    };
    for (std::size_t i = 0; i < base.size(); ++i)
        for (std::size_t j = i + 1; j < base.size(); ++j) {
            const auto edge = commonEdge(editor.face(base[i]), editor.face(base[j]));
            if (!edge) continue;
            const auto piece = std::ranges::find_if(
                pieces, [&](Label c) { return isOf(base[i], c) && isOf(base[j], c); });
            if (piece == pieces.end()) return false;
            const Label added = cutAlong(editor, *piece, {edge->first, edge->second, apex});
            if (added < 0) return false;
            pieces.push_back(added);
        }
    return true;
}

/// The changes of one cell. They hold copies of this, which is small.
class Changer {
public:
    Changer(MeshEditor& editor, const MendMeans& means, Label cell)
        : editor_(&editor), means_(&means), cell_(cell) {}

    std::vector<PieceChange> changes() const {
        std::vector<PieceChange> list;
        for (const Label f : editor_->cell(cell_).faces) {
            const Label other = editor_->otherCell(f, cell_);
            if (other < 0) continue;
            list.push_back({{cell_, other}, [*this, other] { return unite(other); }});
            if (editor_->face(f).points.size() > 3) addCuts(f, list);
        }
        if (editor_->cell(cell_).faces.size() > 4)
            list.push_back({{cell_}, [*this] { return remake(cell_); }});
        for (const Label other : partners()) {
            list.push_back({{cell_, other}, [*this, other] { return uniteAndRemake(other); }});
            list.push_back({{cell_, other}, [*this, other] { return fillWith({other}); }});
        }
        return list;
    }

    std::vector<PieceChange> wideChanges() const {
        std::vector<PieceChange> list;
        const std::vector<Label> siblings = siblingsOf(cell_);
        addRemakes(siblings, list);
        for (const std::vector<Label>& family : neighboursOf(siblings))
            addRemakes(together({siblings, family}), list);
        const std::vector<Label> others = partners();
        for (std::size_t i = 0; i < others.size(); ++i)
            for (std::size_t j = i + 1; j < others.size(); ++j) {
                const std::vector<Label> two{others[i], others[j]};
                list.push_back({{cell_, two[0], two[1]}, [*this, two] { return fillWith(two); }});
            }
        return list;
    }

    std::vector<PieceChange> widestChanges() const {
        std::vector<PieceChange> list;
        const std::vector<Label> siblings = siblingsOf(cell_);
        const auto families = neighboursOf(siblings);
        for (std::size_t i = 0; i < families.size(); ++i)
            for (std::size_t j = i + 1; j < families.size(); ++j)
                addRemakes(together({siblings, families[i], families[j]}), list);
        return list;
    }

    std::vector<PieceChange> moves() const {
        std::vector<Label> points;
        for (const Label f : editor_->cell(cell_).faces)
            for (const Label p : editor_->face(f).points)
                if (p >= means_->firstNewPoint && editor_->rank(p) == PointRank::interior)
                    points.push_back(p);
        sortUnique(points);
        std::vector<PieceChange> list;
        for (const Label p : points)
            for (const double step : {0.2, 0.07, 0.02})
                addSteps(p, step * editor_->cell(cell_).size, list);
        return list;
    }

private:
    bool mayUnite(Label other) const { return mayUnite(cell_, other); }

    bool mayUnite(Label cell, Label other) const {
        return !editor_->isFrozen(cell) && !editor_->isFrozen(other) &&
               means_->mayUnite(cell, other);
    }

    /// The pieces of the same cell as this one that hang together with it, each with one before it.
    std::vector<Label> siblingsOf(Label cell) const {
        std::vector<Label> found{cell};
        for (std::size_t i = 0; i < found.size(); ++i)
            for (const Label f : editor_->cell(found[i]).faces) {
                const Label other = editor_->otherCell(f, found[i]);
                if (other >= 0 && editor_->cell(other).origin == editor_->cell(cell).origin &&
                    mayUnite(found[i], other) && std::ranges::find(found, other) == found.end())
                    found.push_back(other);
            }
        return found;
    }

    /// The same of each cell beside these; the first of each has a face with one of these.
    std::vector<std::vector<Label>> neighboursOf(const std::vector<Label>& cells) const {
        std::vector<std::vector<Label>> families;
        std::set<Label> taken(cells.begin(), cells.end());
        for (const Label cell : cells)
            for (const Label f : editor_->cell(cell).faces) {
                const Label other = editor_->otherCell(f, cell);
                if (other < 0 || taken.contains(other) || !mayUnite(cell, other)) continue;
                families.push_back(siblingsOf(other));
                taken.insert(families.back().begin(), families.back().end());
            }
        return families;
    }

    static std::vector<Label> together(const std::vector<std::vector<Label>>& families) {
        std::vector<Label> all;
        for (const std::vector<Label>& family : families)
            all.insert(all.end(), family.begin(), family.end());
        return all;
    }

    void addRemakes(const std::vector<Label>& cells, std::vector<PieceChange>& list) const {
        list.push_back({cells, [*this, cells] {
                            return remakeAll(cells, [this](Label c) { return remake(c); });
                        }});
        list.push_back({cells, [*this, cells] {
                            return remakeAll(cells, [this](Label c) { return fill(c); });
                        }});
    }

    /// Unites cells, each of which has a face with one before it, and makes pieces of them by
    /// `make`. Those that may not go stay, as one of these.
    template<class Make>
    bool remakeAll(const std::vector<Label>& cells, const Make& make) const {
        const Label cell = cells.front();
        const std::span<const Label> others = std::span(cells).subspan(1);
        const Label firstAdded = editor_->cellCount();
        if (!uniteCells(*editor_, cell, others, means_->firstNewPoint) || !make(cell)) return false;
        std::vector<Label> pieces{cell};
        for (Label c = firstAdded; c < editor_->cellCount(); ++c)
            pieces.push_back(c);
        std::vector<Label> lasting;
        for (const Label c : others)
            if (c < means_->firstNewCell) lasting.push_back(c);
        const std::size_t needed = lasting.size() + (cell < means_->firstNewCell ? 1 : 0);
        if (needed > pieces.size()) return false;
        nameAfterCells(*editor_, pieces, lasting);
        return true;
    }

    std::vector<Label> partners() const {
        std::vector<Label> found;
        for (const Label f : editor_->cell(cell_).faces)
            if (const Label other = editor_->otherCell(f, cell_); other >= 0 && mayUnite(other))
                found.push_back(other);
        sortUnique(found);
        return found;
    }

    /// One of the two cells goes, the one with a label that may.
    bool unite(Label other) const {
        const auto [stays, goes] = std::minmax(cell_, other);
        if (goes < means_->firstNewCell || !mayUnite(other)) return false;
        const std::array<Label, 1> one{goes};
        return uniteCells(*editor_, stays, one);
    }

    bool uniteAndRemake(Label other) const {
        const std::array<Label, 1> one{other};
        if (std::max(cell_, other) < means_->firstNewCell)
            return splitTogether(*editor_, cell_, one, false);
        return unite(other) && remake(std::min(cell_, other));
    }

    bool fillWith(const std::vector<Label>& others) const {
        const auto filled = fillTogether(*editor_, cell_, others, *means_->tetrahedralise);
        return filled && !filled->pieces.empty();
    }

    bool remake(Label cell) const {
        return makeGoodPieces(*editor_, cell, *means_->tetrahedralise) != Pieces::none ||
               fill(cell);
    }

    bool fill(Label cell) const {
        return !fillWithTetrahedra(*editor_, cell, *means_->tetrahedralise).pieces.empty();
    }

    /// All cuts of a face along one chord, and the one into triangles.
    void addCuts(Label f, std::vector<PieceChange>& list) const {
        const EditFace& face = editor_->face(f);
        const std::vector<Label> cells{face.owner, face.neighbour};
        list.push_back({cells, [*this, f] {
                            return cut(f, [this, f] { return cutByChords(*editor_, f, 3); });
                        }});
        const std::size_t n = face.points.size();
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = i + 2; j < n && (i > 0 || j + 1 < n); ++j) {
                const Label a = face.points[i];
                const Label b = face.points[j];
                list.push_back({cells, [*this, f, a, b] {
                                    return cut(f, [&] { return splitFace(*editor_, f, a, b); });
                                }});
            }
    }

    /// Cuts a face, and what is on both sides along the cuts.
    bool cut(Label f, const std::function<bool()>& cutFace) const {
        const EditFace before = editor_->face(f);
        const Label firstAdded = editor_->faceCount();
        if (editor_->isFrozenFace(f) || !cutFace()) return false;
        std::vector<Label> parts{f};
        for (Label g = firstAdded; g < editor_->faceCount(); ++g)
            parts.push_back(g);
        return follow(before.owner, parts) && follow(before.neighbour, parts);
    }

    /// Splits a cell of which a face has been cut into parts, if it has to be.
    bool follow(Label cell, const std::vector<Label>& parts) const {
        const Label apex = apexOver(*editor_, cell, parts);
        if (apex >= 0) return cutFromApex(*editor_, cell, apex, parts);
        return isAcceptable(*editor_, cell) || remake(cell);
    }

    /// Steps to the places round a point on a grid of three by three by three.
    void addSteps(Label p, double length, std::vector<PieceChange>& list) const {
        const std::vector<Label> cells = cellsOfPoint(*editor_, p);
        if (std::ranges::any_of(cells, [&](Label c) { return editor_->isFrozen(c); })) return;
        constexpr int places = 27;
        for (int i = 0; i < places; ++i) {
            if (i == places / 2) continue; // where it is
            const std::array<int, 3> place{i % 3, i / 3 % 3, i / 9};
            const Vec3 way{place[0] - 1.0, place[1] - 1.0, place[2] - 1.0};
            const Vec3 to = editor_->point(p) + (length / norm(way)) * way;
            list.push_back({cells, [*this, p, to] {
                                movePoint(*editor_, p, to, PointRank::interior);
                                return true;
                            }});
        }
    }

    MeshEditor* editor_;
    const MendMeans* means_;
    Label cell_;
};

} // namespace

std::vector<PieceChange> changesOfPiece(MeshEditor& editor, const MendMeans& means, Label cell) {
    return Changer(editor, means, cell).changes();
}

std::vector<PieceChange> movesOfPiece(MeshEditor& editor, const MendMeans& means, Label cell) {
    return Changer(editor, means, cell).moves();
}

std::vector<PieceChange> wideChanges(MeshEditor& editor, const MendMeans& means, Label cell) {
    return Changer(editor, means, cell).wideChanges();
}

std::vector<PieceChange> widestChanges(MeshEditor& editor, const MendMeans& means, Label cell) {
    return Changer(editor, means, cell).widestChanges();
}

} // namespace polymesh
