// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapeSplit/fillWithTetrahedra.h"

#include "libpolymesh/geometry/predicates.h"
#include "libpolymesh/quality/editQuality.h"
#include "libpolymesh/shapeSplit/editedShape.h"
#include "libpolymesh/shapeSplit/faceCuts.h"
#include "libpolymesh/shapeSplit/faceTriangles.h"
#include "libpolymesh/shapeSplit/innerPoint.h"
#include "libpolymesh/shapes/baseShapes.h"
#include "libpolymesh/surface/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace polymesh {

namespace {

using Triple = std::array<Label, 3>;

Triple sorted(Triple points) {
    std::ranges::sort(points);
    return points;
}

/// A triangle round what the tetrahedra fill: a face of the cell, or a side of a pyramid.
struct Wall {
    Triple key{};    // local points, ascending
    Label face = -1; // -1: a side of a pyramid
    std::size_t pyramid = 0;
};

/// A side of a tetrahedron.
struct Side {
    Triple key{};    // local points, ascending
    Triple points{}; // outward
    std::size_t tetrahedron = 0;
};

/// A face that stays as it is, and the pyramid under it.
struct Pyramid {
    Label face = -1;
    std::size_t place = 0; // of the face among those of the cell
};

/// The surface that tetrahedra have to fill, in local numbers of points, and what they make of the
/// cell. Pyramids come first in the lists of pieces, then tetrahedra.
class Filling {
public:
    Filling(MeshEditor& editor, Label cell) : editor_(editor), cell_(cell) {}

    /// Gives each face of the cell of more than three points a pyramid, of the given height over
    /// the root of its area, more where it is warped. Returns the faces that cannot have one, which
    /// are left out: those that no point under them sees, or that are too large.
    std::vector<Label> enclose(const std::vector<double>& heights) {
        std::vector<Label> leftOut;
        const auto& faces = editor_.cell(cell_).faces;
        for (std::size_t i = 0; i < faces.size(); ++i) {
            const Polygon& points = editor_.face(faces[i]).points;
            if (points.size() == 3)
                addWall({localOf(points[0]), localOf(points[1]), localOf(points[2])}, faces[i], 0);
            else if (points.size() > maxShapeFacePoints || !addPyramid(i, heights[i]))
                leftOut.push_back(faces[i]);
        }
        return leftOut;
    }

    /// The place, among the faces of the cell, of the face over the pyramid that a triangle of the
    /// surface is a side of; none for a face of the cell.
    std::optional<std::size_t> faceOver(Label triangle) const {
        const Wall& wall = walls_[index(triangle)];
        if (wall.face >= 0) return std::nullopt;
        return pyramids_[wall.pyramid].place;
    }

    /// The face of the cell that a triangle of the surface is; -1 for the side of a pyramid.
    Label faceOf(Label triangle) const { return walls_[index(triangle)].face; }

    const TriSurface& surface() const { return surface_; }

    /// Makes the pieces; none, and nothing is changed, when the tetrahedra do not fit the surface.
    std::vector<Label> apply(TetMesh tets) {
        points_ = surface_.points;
        points_.insert(points_.end(), tets.newPoints.begin(), tets.newPoints.end());
        const auto exists = [&](Label p) { return p >= 0 && index(p) < points_.size(); };
        for (const auto& t : tets.tetrahedra)
            if (!std::ranges::all_of(t, exists)) return {};
        for (auto& t : tets.tetrahedra)
            if (orient3d(at(t[0]), at(t[1]), at(t[2]), at(t[3])) < 0) std::swap(t[0], t[1]);
        const std::vector<Side> sides = sidesOf(tets);
        std::ranges::sort(walls_, {}, &Wall::key);
        if (!fits(sides)) return {};
        makePieces(tets.tetrahedra.size());
        joinSides(sides);
        return pieces_;
    }

private:
    const Vec3& at(Label local) const { return points_[index(local)]; }

    Label localOf(Label p) {
        const auto [found, isNew] = local_.try_emplace(p, surface_.pointCount());
        if (isNew) {
            surface_.points.push_back(editor_.point(p));
            labels_.push_back(p);
        }
        return found->second;
    }

    /// `outward`: local points, anticlockwise seen from outside, or from inside: no matter here.
    void addWall(const Triple& outward, Label face, std::size_t pyramid) {
        surface_.triangles.push_back(outward);
        walls_.push_back({sorted(outward), face, pyramid});
    }

    bool addPyramid(std::size_t place, double height) {
        const Label f = editor_.cell(cell_).faces[place];
        const auto apex = apexUnder(f, height);
        if (!apex) return false;
        const Label local = surface_.pointCount();
        surface_.points.push_back(*apex);
        labels_.push_back(-1);
        const Polygon points = editor_.face(f).points;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Label next = points[(i + 1) % points.size()];
            const Label from = localOf(points[i]);
            addWall({from, localOf(next), local}, -1, pyramids_.size());
        }
        pyramids_.push_back({f, place});
        return true;
    }

    std::optional<Vec3> apexUnder(Label f, double height) {
        const FaceGeometry face = editor_.faceGeometry(f);
        const double area = norm(face.area);
        if (area <= 0) return std::nullopt;
        const double inward = editor_.face(f).owner == cell_ ? -1 : 1;
        for (double h = height; h < 1; h *= 2) {
            const Vec3 apex = face.centre + (inward * h / std::sqrt(area)) * face.area;
            if (isSeenFrom(editor_, cell_, f, apex)) return apex;
        }
        return std::nullopt;
    }

    static std::vector<Side> sidesOf(const TetMesh& tets) {
        std::vector<Side> sides;
        for (std::size_t t = 0; t < tets.tetrahedra.size(); ++t) {
            const auto& [a, b, c, d] = tets.tetrahedra[t];
            for (const Triple& outward :
                 {Triple{a, c, b}, Triple{a, b, d}, Triple{b, c, d}, Triple{c, a, d}})
                sides.push_back({sorted(outward), outward, t});
        }
        std::ranges::sort(sides, [](const Side& s, const Side& t) {
            return std::pair(s.key, s.tetrahedron) < std::pair(t.key, t.tetrahedron);
        });
        return sides;
    }

    const Wall* wallOf(const Triple& key) const {
        const auto found = std::ranges::lower_bound(walls_, key, {}, &Wall::key);
        return found != walls_.end() && found->key == key ? &*found : nullptr;
    }

    /// True when every wall is one side, and every other side is one of two.
    bool fits(const std::vector<Side>& sides) const {
        std::size_t wallsMet = 0;
        for (std::size_t i = 0; i < sides.size();) {
            std::size_t count = 1;
            while (i + count < sides.size() && sides[i + count].key == sides[i].key)
                ++count;
            const bool isWall = wallOf(sides[i].key) != nullptr;
            if (count != (isWall ? 1U : 2U)) return false;
            wallsMet += isWall ? 1 : 0;
            i += count;
        }
        return wallsMet == walls_.size();
    }

    void makePieces(std::size_t tetrahedra) {
        for (std::size_t p = 0; p < points_.size(); ++p)
            if (p >= labels_.size())
                labels_.push_back(editor_.addPoint(points_[p], PointRank::interior));
            else if (labels_[p] < 0)
                labels_[p] = editor_.addPoint(points_[p], PointRank::interior);
        pieces_.assign(1, cell_);
        while (pieces_.size() < pyramids_.size() + tetrahedra)
            pieces_.push_back(editor_.addPartOf(cell_));
    }

    /// New faces first, so that the cell has one at all times.
    void joinSides(const std::vector<Side>& sides) {
        std::vector<std::pair<Label, Label>> taken; // face, piece
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const Side& side = sides[i];
            const Label piece = pieces_[pyramids_.size() + side.tetrahedron];
            const Wall* wall = wallOf(side.key);
            if (wall && wall->face >= 0) {
                taken.emplace_back(wall->face, piece);
                continue;
            }
            const std::size_t beyond =
                wall ? wall->pyramid : pyramids_.size() + sides[++i].tetrahedron;
            EditFace face;
            for (const Label p : side.points)
                face.points.push_back(labels_[index(p)]);
            face.owner = piece;
            face.neighbour = pieces_[beyond];
            editor_.addFace(face);
        }
        for (std::size_t p = 0; p < pyramids_.size(); ++p)
            taken.emplace_back(pyramids_[p].face, pieces_[p]);
        for (const auto& [face, piece] : taken)
            if (piece != cell_) editor_.giveFace(face, cell_, piece);
    }

    MeshEditor& editor_;
    Label cell_;
    TriSurface surface_;
    std::map<Label, Label> local_; // local numbers of the cell's points
    std::vector<Label> labels_;    // [local point] label; -1: not made yet
    std::vector<Vec3> points_;     // [local point]
    std::vector<Wall> walls_;
    std::vector<Pyramid> pyramids_;
    std::vector<Label> pieces_;
};

/// Cuts the boundary faces into triangles that bound the same volume, where that can be done.
void makeBoundaryTriangles(MeshEditor& editor, Label cell) {
    const auto faces = editor.cell(cell).faces; // a copy: cutting changes the list
    for (const Label f : faces) {
        if (!editor.face(f).isBoundary() || editor.isFrozenFace(f)) continue;
        const MeshEditor::Mark mark = editor.mark();
        const std::size_t size = editor.face(f).points.size();
        const bool done = isPlane(editor, f) ? cutByChords(editor, f, 3)
                                             : cutFromMiddle(editor, f, size) ||
                                                   cutByChordsKeepingVolume(editor, f, 3);
        if (!done) editor.undoTo(mark);
    }
}

/// Lowers the pyramids that cross something. Returns the faces that are in the way: those of
/// pyramids that are too low now, and of the cell that cross each other.
std::vector<Label> lowerCrossing(const SelfIntersections& crossing,
                                 const Filling& filling,
                                 std::span<const Label> faces,
                                 std::vector<double>& heights) {
    constexpr double least = 2e-3;
    std::vector<Label> inTheWay;
    std::set<std::size_t> tooHigh; // places of faces
    for (const auto& pair : crossing.first) {
        const bool isFixed = !filling.faceOver(pair[0]) && !filling.faceOver(pair[1]);
        for (const Label triangle : pair)
            if (const auto place = filling.faceOver(triangle))
                tooHigh.insert(*place);
            else if (isFixed)
                inTheWay.push_back(filling.faceOf(triangle));
    }
    for (const std::size_t place : tooHigh)
        if ((heights[place] /= 3) < least) inTheWay.push_back(faces[place]);
    return inTheWay;
}

/// Pyramids as high as they can be without crossing each other or the faces, `height` or less.
/// None, with what is `inTheWay`, where even low ones cross, or faces do.
std::optional<Filling>
enclosed(MeshEditor& editor, Label cell, double height, std::vector<Label>& inTheWay) {
    constexpr Label all = 10000;
    const auto& faces = editor.cell(cell).faces;
    std::vector<double> heights(faces.size(), height);
    while (true) {
        Filling filling(editor, cell);
        const std::vector<Label> leftOut = filling.enclose(heights);
        const SelfIntersections crossing = findSelfIntersections(filling.surface(), all);
        if (crossing.count == 0 && leftOut.empty()) return filling;
        inTheWay = lowerCrossing(crossing, filling, {faces.data(), faces.size()}, heights);
        inTheWay.insert(inTheWay.end(), leftOut.begin(), leftOut.end());
        std::ranges::sort(inTheWay);
        inTheWay.erase(std::unique(inTheWay.begin(), inTheWay.end()), inTheWay.end());
        if (!inTheWay.empty()) return std::nullopt;
    }
}

/// Puts triangles in place of a boundary face that is in the way such that none of them is; false,
/// and nothing is changed, when there are no such among the best.
bool clear(MeshEditor& editor, Label cell, Label face, double height) {
    constexpr std::size_t most = 12;
    std::vector<FaceTriangles> ways = trianglesKeepingVolume(editor, face);
    if (ways.size() > most) ways.resize(most);
    const MeshEditor::Mark mark = editor.mark();
    return std::ranges::any_of(ways, [&](const FaceTriangles& way) {
        const Label firstAdded = editor.faceCount();
        replaceByTriangles(editor, face, way);
        std::vector<Label> inTheWay;
        enclosed(editor, cell, height, inTheWay);
        const bool isClear =
            std::ranges::none_of(inTheWay, [&](Label f) { return f == face || f >= firstAdded; });
        if (!isClear) editor.undoTo(mark);
        return isClear;
    });
}

/// The same for the boundary faces that are in the way, a few at most; what is in the way after
/// that.
std::vector<Label> clearBoundary(MeshEditor& editor, Label cell, double height) {
    constexpr int most = 3;
    std::vector<Label> inTheWay;
    enclosed(editor, cell, height, inTheWay);
    for (int i = 0; i < most; ++i) {
        const bool isCleared = std::ranges::any_of(inTheWay, [&](Label f) {
            return editor.face(f).isBoundary() && editor.face(f).points.size() > 3 &&
                   clear(editor, cell, f, height);
        });
        if (!isCleared) break;
        inTheWay.clear();
        enclosed(editor, cell, height, inTheWay);
    }
    return inTheWay;
}

/// Of the fillings the one that leaves the least badness, made; none where none is sound.
std::vector<Label> bestOf(MeshEditor& editor,
                          const std::vector<Filling>& fillings,
                          const std::vector<std::optional<TetMesh>>& meshes) {
    const MeshEditor::Mark mark = editor.mark();
    std::optional<std::size_t> best;
    Badness least;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        if (!meshes[i]) continue;
        const std::vector<Label> pieces = Filling(fillings[i]).apply(*meshes[i]);
        const Badness badness = badnessOf(editor, withNeighbours(editor, pieces));
        if (!pieces.empty() && areSound(editor, mark) && (!best || isBetter(badness, least))) {
            best = i;
            least = badness;
        }
        editor.undoTo(mark);
    }
    return best ? Filling(fillings[*best]).apply(*meshes[*best]) : std::vector<Label>{};
}

/// Fills the cell as its faces are now.
Filled fillAsItIs(MeshEditor& editor, Label cell, const Tetrahedraliser& tetrahedralise) {
    Filled result;
    std::vector<Filling> fillings;
    std::vector<std::optional<TetMesh>> meshes;
    for (const double height : {0.4, 0.1}) {
        auto filling = enclosed(editor, cell, height, result.inTheWay);
        if (!filling) return result; // lower ones would cross too
        meshes.push_back(tetrahedralise(filling->surface()));
        fillings.push_back(std::move(*filling));
    }
    result.pieces = bestOf(editor, fillings, meshes);
    return result;
}

} // namespace

std::vector<Label> facesInTheWay(MeshEditor& editor, Label cell) {
    constexpr double low = 0.05;
    std::vector<Label> inTheWay;
    enclosed(editor, cell, low, inTheWay);
    return inTheWay;
}

Filled fillWithTetrahedra(MeshEditor& editor, Label cell, const Tetrahedraliser& tetrahedralise) {
    if (!tetrahedralise) return {};
    const MeshEditor::Mark mark = editor.mark();
    makeBoundaryTriangles(editor, cell);
    Filled filled = fillAsItIs(editor, cell, tetrahedralise);
    if (!filled.pieces.empty()) return filled;
    editor.undoTo(mark);
    constexpr double height = 0.4;
    filled.inTheWay = clearBoundary(editor, cell, height);
    if (filled.inTheWay.empty()) filled = fillAsItIs(editor, cell, tetrahedralise);
    if (!filled.pieces.empty()) return filled;
    editor.undoTo(mark);
    // Triangles that were tried are gone.
    std::erase_if(filled.inTheWay, [&](Label f) { return f >= editor.faceCount(); });
    return filled;
}

} // namespace polymesh
