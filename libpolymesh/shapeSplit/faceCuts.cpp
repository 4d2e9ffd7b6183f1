// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapeSplit/faceCuts.h"

#include "libpolymesh/quality/cutCell.h"
#include "libpolymesh/shapeSplit/innerPoint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace polymesh {

namespace {

Polygon slice(const Polygon& points, std::size_t from, std::size_t to) {
    Polygon part;
    for (std::size_t k = from;; k = (k + 1) % points.size()) {
        part.push_back(points[k]);
        if (k == to) return part;
    }
}

FaceGeometry geometryOf(const MeshEditor& editor, const Polygon& points) {
    return faceGeometry(editor.mesh().points, {points.data(), points.size()});
}

/// Area over squared perimeter: the larger, the rounder. Negative where the polygon looks against
/// the normal.
double roundness(const std::vector<Vec3>& corners, const Vec3& normal) {
    double perimeter = 0;
    Vec3 area; // twice
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3& next = corners[(i + 1) % corners.size()];
        perimeter += norm(next - corners[i]);
        area += cross(corners[i] - corners[0], next - corners[0]);
    }
    return dot(area, normal) / (perimeter * perimeter);
}

double roundness(const MeshEditor& editor, const Polygon& points, const Vec3& normal) {
    std::vector<Vec3> corners;
    for (const Label p : points)
        corners.push_back(editor.point(p));
    return roundness(corners, normal);
}

/// True when b, c, a lie anticlockwise round o as seen against the normal, b strictly between.
bool liesInCorner(const MeshEditor& editor,
                  const Polygon& points,
                  std::size_t corner,
                  std::size_t other,
                  const Vec3& normal) {
    const std::size_t n = points.size();
    const Vec3& o = editor.point(points[corner]);
    const Vec3 out = editor.point(points[(corner + 1) % n]) - o;
    const Vec3 in = editor.point(points[(corner + n - 1) % n]) - o;
    const Vec3 chord = editor.point(points[other]) - o;
    const auto isLeft = [&](const Vec3& a, const Vec3& b) { return dot(cross(a, b), normal) > 0; };
    return isLeft(out, in) ? isLeft(out, chord) && isLeft(chord, in)
                           : isLeft(out, chord) || isLeft(chord, in);
}

bool isChordInside(const MeshEditor& editor,
                   const Polygon& points,
                   std::size_t i,
                   std::size_t j,
                   const Vec3& normal) {
    const std::size_t n = points.size();
    if (!liesInCorner(editor, points, i, j, normal) || !liesInCorner(editor, points, j, i, normal))
        return false;
    const auto side = [&](std::size_t a, std::size_t b, std::size_t c) {
        const Vec3& o = editor.point(points[a]);
        return dot(cross(editor.point(points[b]) - o, editor.point(points[c]) - o), normal) > 0;
    };
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t l = (k + 1) % n;
        if (k == i || k == j || l == i || l == j) continue;
        if (side(i, j, k) != side(i, j, l) && side(k, l, i) != side(k, l, j)) return false;
    }
    return true;
}

bool isEdgeOfCells(const MeshEditor& editor, Label f, Label a, Label b) {
    const EditFace& face = editor.face(f);
    return cellHasEdge(editor, face.owner, a, b) ||
           (face.neighbour >= 0 && cellHasEdge(editor, face.neighbour, a, b));
}

constexpr double leastRoundness = 1e-5; // a part with less is corners in one line

struct Chord {
    Label a = -1;
    Label b = -1;
};

std::optional<Chord> roundestChord(const MeshEditor& editor, Label f, std::size_t most) {
    const Polygon& points = editor.face(f).points;
    const std::size_t n = points.size();
    const Vec3 area = geometryOf(editor, points).area;
    const Vec3 normal = area / std::max(norm(area), std::numeric_limits<double>::min());
    std::optional<Chord> best;
    double bestRoundness = leastRoundness;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 2; j < n && (i > 0 || j + 1 < n); ++j) {
            // One cut is to be enough where it can be; else it takes off as much as is allowed.
            const std::size_t smaller = std::min(j - i + 1, n - (j - i) + 1);
            const std::size_t larger = n + 2 - smaller;
            if (smaller > most || (larger > most && smaller + 1 < most)) continue;
            if (!isChordInside(editor, points, i, j, normal) ||
                isEdgeOfCells(editor, f, points[i], points[j]))
                continue;
            const double round = std::min(roundness(editor, slice(points, i, j), normal),
                                          roundness(editor, slice(points, j, i), normal));
            if (round <= bestRoundness) continue;
            best = Chord{points[i], points[j]};
            bestRoundness = round;
        }
    return best;
}

/// The polygons of a face that meet in its middle.
std::vector<Polygon> partsFromMiddle(const Polygon& points, std::size_t parts, Label middle) {
    std::vector<Polygon> polygons;
    for (std::size_t k = 0; k < parts; ++k) {
        const std::size_t from = k * points.size() / parts;
        const std::size_t to = (k + 1) * points.size() / parts % points.size();
        polygons.push_back(slice(points, from, to));
        polygons.back().push_back(middle);
    }
    return polygons;
}

/// The volume [m^3], from `from`, over the polygons of a face that meet in `middle`.
double volumeOver(const MeshEditor& editor,
                  const std::vector<Polygon>& polygons,
                  Label middle,
                  const Vec3& position,
                  const Vec3& from) {
    double volume = 0;
    std::vector<Vec3> corners;
    std::vector<Label> order;
    for (const Polygon& polygon : polygons) {
        corners.clear();
        order.clear();
        for (const Label p : polygon) {
            order.push_back(toLabel(corners.size()));
            corners.push_back(p == middle ? position : editor.point(p));
        }
        const FaceGeometry geometry = faceGeometry(corners, order);
        volume += dot(geometry.area, geometry.centre - from) / 3;
    }
    return volume;
}

/// The place of the middle on the line through the face's centre along its normal at which the
/// parts bound `more` volume [m^3] than the face: by secants, since it is all but linear.
std::optional<Vec3> middleOfVolume(const MeshEditor& editor,
                                   const Polygon& points,
                                   std::size_t parts,
                                   double more = 0) {
    const FaceGeometry face = geometryOf(editor, points);
    const double area = norm(face.area);
    if (area <= 0) return std::nullopt;
    const Vec3 normal = face.area / area;
    constexpr Label middle = -1;
    const std::vector<Polygon> polygons = partsFromMiddle(points, parts, middle);
    // Seen from the centre of the whole its own volume is zero.
    const auto excess = [&](double height) {
        const Vec3 place = face.centre + height * normal;
        return volumeOver(editor, polygons, middle, place, face.centre) - more;
    };
    const double size = std::sqrt(area);
    double h0 = 0;
    double v0 = excess(h0);
    double h1 = -3 * v0 / area;
    constexpr int steps = 20;
    for (int step = 0; step < steps && std::abs(v0) > 1e-17 * size * area; ++step) {
        const double v1 = excess(h1);
        if (v1 == v0) break;
        const double h2 = h1 - v1 * (h1 - h0) / (v1 - v0);
        h0 = h1;
        v0 = v1;
        h1 = h2;
    }
    if (!(std::abs(h0) < 0.5 * size) || !(std::abs(v0) < 1e-14 * size * area)) return std::nullopt;
    return face.centre + h0 * normal;
}

/// The corners begun where the parts that meet in the middle are the roundest.
Polygon begunForRoundParts(const MeshEditor& editor, const Polygon& points, std::size_t parts) {
    const FaceGeometry face = geometryOf(editor, points);
    const auto leastOf = [&](const Polygon& corners) {
        double least = std::numeric_limits<double>::max();
        for (std::size_t k = 0; k < parts; ++k) {
            const Polygon part = slice(corners,
                                       k * corners.size() / parts,
                                       (k + 1) * corners.size() / parts % corners.size());
            std::vector<Vec3> positions{face.centre};
            for (const Label p : part)
                positions.push_back(editor.point(p));
            least = std::min(least, roundness(positions, face.area));
        }
        return least;
    };
    Polygon best = points;
    Polygon turned = points;
    for (std::size_t i = 1; i < points.size() && parts < points.size(); ++i) {
        std::rotate(turned.begin(), turned.begin() + 1, turned.end());
        if (leastOf(turned) > leastOf(best)) best = turned;
    }
    return best;
}

void replaceByParts(MeshEditor& editor, Label f, const std::vector<Polygon>& polygons) {
    EditFace face = editor.face(f);
    editor.setFacePoints(f, polygons[0]);
    for (std::size_t k = 1; k < polygons.size(); ++k) {
        face.points = polygons[k];
        editor.addFace(face);
    }
}

/// True when none of the parts that meet in the middle crosses itself, seen against the normal of
/// the whole.
bool arePartsSimple(const MeshEditor& editor,
                    const Polygon& points,
                    std::size_t parts,
                    const Vec3& place) {
    constexpr Label middle = -1;
    const FaceGeometry whole = geometryOf(editor, points);
    const double area = norm(whole.area);
    const Vec3 far = whole.centre + (10 / std::sqrt(area)) * whole.area;
    return std::ranges::all_of(partsFromMiddle(points, parts, middle), [&](const Polygon& polygon) {
        std::vector<Vec3> corners;
        for (const Label p : polygon)
            corners.push_back(p == middle ? place : editor.point(p));
        return isSimpleSeenFrom(corners, far);
    });
}

/// True when a point is not so far from the face that it would make a spike of it.
bool isLow(const MeshEditor& editor, const Polygon& points, const Vec3& place) {
    const FaceGeometry face = geometryOf(editor, points);
    return squaredNorm(place - face.centre) < 0.03 * norm(face.area);
}

/// Cuts a face into triangles round a point that is low over it such that they bound `more` volume
/// [m^3]; false where there is none.
bool raiseMiddle(MeshEditor& editor, Label f, double more) {
    const Polygon points = editor.face(f).points;
    const auto place = middleOfVolume(editor, points, points.size(), more);
    if (!place || !isLow(editor, points, *place) ||
        !arePartsSimple(editor, points, points.size(), *place))
        return false;
    const Label middle = editor.addPoint(*place, PointRank::surface);
    replaceByParts(editor, f, partsFromMiddle(points, points.size(), middle));
    return true;
}

} // namespace

bool isPlane(const MeshEditor& editor, Label f) {
    constexpr double rounding = 1e-12;
    const Polygon& points = editor.face(f).points;
    const FaceGeometry face = geometryOf(editor, points);
    const double area = norm(face.area);
    return std::ranges::all_of(points, [&](Label p) {
        return std::abs(dot(face.area, editor.point(p) - face.centre)) <=
               rounding * area * std::sqrt(area);
    });
}

bool isStarShaped(const MeshEditor& editor, Label f) {
    constexpr double rounding = 1e-6; // edges in line with the centre are as bad
    const Polygon& points = editor.face(f).points;
    const FaceGeometry face = geometryOf(editor, points);
    const double least = rounding * squaredNorm(face.area);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3& a = editor.point(points[i]);
        const Vec3& b = editor.point(points[(i + 1) % points.size()]);
        if (dot(cross(b - a, face.centre - a), face.area) <= least) return false;
    }
    return true;
}

bool cutByChords(MeshEditor& editor, Label f, std::size_t most) {
    if (editor.face(f).points.size() <= most) return true;
    const auto chord = roundestChord(editor, f, most);
    if (!chord || !splitFace(editor, f, chord->a, chord->b)) return false;
    const Label added = editor.faceCount() - 1;
    return cutByChords(editor, f, most) && cutByChords(editor, added, most);
}

bool cutFromCorner(MeshEditor& editor, Label f, std::size_t corner) {
    const Polygon points = editor.face(f).points; // a copy: cutting changes it
    const std::size_t n = points.size();
    const Label from = points[corner % n];
    if (n <= 3 || editor.isFrozenFace(f)) return false;
    for (std::size_t k = 2; k + 1 < n; ++k)
        if (isEdgeOfCells(editor, f, from, points[(corner + k) % n])) return false;
    const Vec3 area = geometryOf(editor, points).area;
    for (std::size_t k = 1; k + 1 < n; ++k)
        if (roundness(editor,
                      Polygon{from, points[(corner + k) % n], points[(corner + k + 1) % n]},
                      area / norm(area)) < leastRoundness)
            return false;
    Label rest = f;
    for (std::size_t k = 2; k + 1 < n; ++k) {
        splitFace(editor, rest, from, points[(corner + k) % n]);
        rest = editor.faceCount() - 1;
    }
    return true;
}

bool cutFromMiddle(MeshEditor& editor, Label f, std::size_t count, Parts parts) {
    if (editor.face(f).points.size() < count || editor.isFrozenFace(f)) return false;
    const Polygon points = begunForRoundParts(editor, editor.face(f).points, count);
    const auto place = middleOfVolume(editor, points, count);
    if (!place || (parts == Parts::simple && !arePartsSimple(editor, points, count, *place)))
        return false;
    const Label middle = editor.addPoint(*place, PointRank::surface);
    replaceByParts(editor, f, partsFromMiddle(points, count, middle));
    return true;
}

bool cutByChordsKeepingVolume(MeshEditor& editor, Label f, std::size_t most) {
    const MeshEditor::Mark mark = editor.mark();
    const FaceGeometry whole = geometryOf(editor, editor.face(f).points);
    const Label firstAdded = editor.faceCount();
    if (cutByChords(editor, f, most)) {
        std::vector<Label> pieces{f};
        for (Label added = firstAdded; added < editor.faceCount(); ++added)
            pieces.push_back(added);
        double gained = 0;
        for (const Label piece : pieces) {
            const FaceGeometry geometry = geometryOf(editor, editor.face(piece).points);
            gained += dot(geometry.area, geometry.centre - whole.centre) / 3;
        }
        std::ranges::stable_sort(pieces, std::ranges::greater{}, [&](Label piece) {
            return squaredNorm(geometryOf(editor, editor.face(piece).points).area);
        });
        for (const Label piece : pieces)
            if (raiseMiddle(editor, piece, -gained)) return true;
    }
    editor.undoTo(mark);
    return false;
}

} // namespace polymesh
