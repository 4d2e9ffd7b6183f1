// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/concaveFaces.h"

#include "libpolymesh/quality/cutCell.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace polymesh {

namespace {

/// A point in the plane of a face.
struct Planar {
    double x = 0;
    double y = 0;
};

double cross2(const Planar& o, const Planar& a, const Planar& b) {
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

/// The corners of a face seen against its normal: counter-clockwise.
std::vector<Planar> flattened(MeshEditor& editor, Label f) {
    const Vec3 area = editor.faceGeometry(f).area;
    const double length = norm(area);
    const auto& corners = editor.face(f).points;
    const Vec3 origin = editor.point(corners[0]);
    std::vector<Planar> flat;
    if (length <= 0) return flat;
    const Vec3 normal = area / length;
    const Vec3 least = std::abs(normal.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    Vec3 u = cross(least, normal);
    u = u / norm(u);
    const Vec3 v = cross(normal, u);
    for (const Label p : corners) {
        const Vec3 d = editor.point(p) - origin;
        flat.push_back({dot(d, u), dot(d, v)});
    }
    return flat;
}

/// The angle from the direction o-a, counter-clockwise, to o-b, in [0, 2 pi).
double angleFrom(const Planar& o, const Planar& a, const Planar& b) {
    const double angle =
        std::atan2(cross2(o, a, b), (a.x - o.x) * (b.x - o.x) + (a.y - o.y) * (b.y - o.y));
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

double insideAngle(const std::vector<Planar>& flat, std::size_t i) {
    const std::size_t n = flat.size();
    return angleFrom(flat[i], flat[(i + 1) % n], flat[(i + n - 1) % n]);
}

bool doCross(const Planar& a, const Planar& b, const Planar& c, const Planar& d) {
    return (cross2(a, b, c) > 0) != (cross2(a, b, d) > 0) &&
           (cross2(c, d, a) > 0) != (cross2(c, d, b) > 0);
}

/// True when the chord between the corners i and j runs inside the polygon.
bool isInside(const std::vector<Planar>& flat, std::size_t i, std::size_t j) {
    const std::size_t n = flat.size();
    for (const auto& [from, to] : {std::pair{i, j}, std::pair{j, i}})
        if (angleFrom(flat[from], flat[(from + 1) % n], flat[to]) >= insideAngle(flat, from))
            return false;
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t next = (k + 1) % n;
        if (k == i || k == j || next == i || next == j) continue;
        if (doCross(flat[i], flat[j], flat[k], flat[next])) return false;
    }
    return true;
}

bool isEdgeBeside(const MeshEditor& editor, Label f, Label a, Label b) {
    const EditFace& face = editor.face(f);
    return cellHasEdge(editor, face.owner, a, b) ||
           (face.neighbour >= 0 && cellHasEdge(editor, face.neighbour, a, b));
}

struct Chord {
    Label a = -1;
    Label b = -1;
    double excess = 0; // [rad] left at both ends
    double narrow = 0; // how narrow the narrowest angle is [rad]
};

/// The chord that leaves the least concavity at its ends, and of these the widest angles.
Chord bestChord(MeshEditor& editor, Label f, const std::vector<Planar>& flat, std::size_t from) {
    constexpr double pi = std::numbers::pi;
    const auto& corners = editor.face(f).points;
    const std::size_t n = flat.size();
    Chord best;
    for (std::size_t step = 2; step + 1 < n; ++step) {
        const std::size_t to = (from + step) % n;
        if (!isInside(flat, from, to)) continue;
        if (isEdgeBeside(editor, f, corners[from], corners[to])) continue;
        Chord chord{corners[from], corners[to], 0, 0};
        for (const auto& [p, q] : {std::pair{from, to}, std::pair{to, from}}) {
            const double first = angleFrom(flat[p], flat[(p + 1) % n], flat[q]);
            const double second = insideAngle(flat, p) - first;
            chord.excess += std::max(first - pi, 0.0) + std::max(second - pi, 0.0);
            chord.narrow = std::max(chord.narrow, pi - std::min(first, second));
        }
        if (best.a < 0 || chord.excess + 0.3 * chord.narrow < best.excess + 0.3 * best.narrow)
            best = chord;
    }
    return best;
}

} // namespace

double faceExcess(MeshEditor& editor, Label face) {
    const std::vector<Planar> flat = flattened(editor, face);
    double excess = -std::numbers::pi;
    for (std::size_t i = 0; i < flat.size(); ++i)
        excess = std::max(excess, insideAngle(flat, i) - std::numbers::pi);
    return excess;
}

Label splitConcaveFace(MeshEditor& editor, Label face, double tolerance) {
    std::vector<Label> parts{face};
    Label cuts = 0;
    while (!parts.empty()) {
        const Label f = parts.back();
        parts.pop_back();
        const std::vector<Planar> flat = flattened(editor, f);
        std::size_t worst = 0;
        for (std::size_t i = 1; i < flat.size(); ++i)
            if (insideAngle(flat, i) > insideAngle(flat, worst)) worst = i;
        if (flat.size() < 4 || insideAngle(flat, worst) - std::numbers::pi <= tolerance) continue;
        const Chord chord = bestChord(editor, f, flat, worst);
        if (chord.a < 0 || !splitFace(editor, f, chord.a, chord.b)) continue;
        ++cuts;
        parts.push_back(f);
        parts.push_back(editor.faceCount() - 1);
    }
    return cuts;
}

} // namespace polymesh
