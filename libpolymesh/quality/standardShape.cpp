// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/quality/standardShape.h"

#include "libpolymesh/base/parallel.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace polymesh {

namespace {

constexpr std::size_t most = 6; // faces of the shapes looked at here; quadrilaterals at most

/// The faces of a small cell as outward loops.
class Loops {
public:
    Loops(const PolyMesh& mesh, Label cell, std::span<const Label> faces) : count_(faces.size()) {
        for (std::size_t f = 0; f < count_; ++f) {
            const std::span<const Label> points = mesh.faces[faces[f]];
            sizes_[f] = points.size();
            std::copy(points.begin(), points.end(), loops_[f].begin());
            if (mesh.owner[index(faces[f])] != cell)
                std::reverse(loops_[f].begin(), loops_[f].begin() + points.size());
        }
    }

    std::size_t size(std::size_t face) const { return sizes_[face]; }

    Label point(std::size_t face, std::size_t i) const { return loops_[face][i % sizes_[face]]; }

    std::size_t firstTriangle() const {
        return static_cast<std::size_t>(std::find(sizes_.begin(), sizes_.end(), 3U) -
                                        sizes_.begin());
    }

    std::size_t pointCount() const {
        std::vector<Label> points;
        for (std::size_t f = 0; f < count_; ++f)
            points.insert(points.end(), loops_[f].begin(), loops_[f].begin() + sizes_[f]);
        std::sort(points.begin(), points.end());
        return static_cast<std::size_t>(std::unique(points.begin(), points.end()) - points.begin());
    }

    /// The other face on edge a b, and the corner of that face from which the edge starts.
    struct Across {
        std::size_t face;
        std::size_t corner;
    };

    std::optional<Across> across(std::size_t face, Label a, Label b) const {
        for (std::size_t f = 0; f < count_; ++f)
            for (std::size_t i = 0; f != face && i < sizes_[f]; ++i)
                if ((point(f, i) == a && point(f, i + 1) == b) ||
                    (point(f, i) == b && point(f, i + 1) == a))
                    return Across{f, i};
        return std::nullopt;
    }

private:
    std::size_t count_;
    std::array<std::size_t, most> sizes_{};
    std::array<std::array<Label, 4>, most> loops_{};
};

/// Two triangles and three quadrilaterals: a prism when the quadrilateral before the first corner
/// of the first triangle has the other triangle on its opposite edge.
bool isPrism(const Loops& loops) {
    if (loops.pointCount() != 6) return false;
    const std::size_t triangle = loops.firstTriangle();
    const auto side = loops.across(triangle, loops.point(triangle, 0), loops.point(triangle, 2));
    if (!side || loops.size(side->face) != 4) return false;
    const auto end = loops.across(side->face,
                                  loops.point(side->face, side->corner + 2),
                                  loops.point(side->face, side->corner + 3));
    return end && loops.size(end->face) == 3;
}

/// Two triangles and four quadrilaterals: a wedge when the first triangle meets a quadrilateral.
bool isWedge(const Loops& loops) {
    if (loops.pointCount() != 7) return false;
    const std::size_t triangle = loops.firstTriangle();
    for (std::size_t i = 0; i < 3; ++i) {
        const auto side =
            loops.across(triangle, loops.point(triangle, i), loops.point(triangle, i + 1));
        if (side && loops.size(side->face) == 4) return true;
    }
    return false;
}

} // namespace

std::string_view pluralName(StandardShape shape) {
    constexpr std::array<std::string_view, standardShapeCount> names{
        "hexahedra", "prisms", "wedges", "pyramids", "tetWedges", "tetrahedra", "polyhedra"};
    return names[static_cast<std::size_t>(shape)];
}

StandardShape standardShape(const PolyMesh& mesh, Label cell, const Rows<Label>& cellFaces) {
    const std::span<const Label> faces = cellFaces[cell];
    std::size_t triangles = 0;
    std::size_t quadrilaterals = 0;
    for (const Label face : faces) {
        triangles += mesh.faces.rowSize(face) == 3 ? 1U : 0U;
        quadrilaterals += mesh.faces.rowSize(face) == 4 ? 1U : 0U;
    }
    if (triangles + quadrilaterals != faces.size()) return StandardShape::polyhedron;
    const auto has = [&](std::size_t t, std::size_t q) {
        return triangles == t && quadrilaterals == q;
    };
    if (has(0, 6)) return StandardShape::hexahedron;
    if (has(4, 0)) return StandardShape::tetrahedron;
    if (has(4, 1)) return StandardShape::pyramid;
    if (has(2, 2)) return StandardShape::tetWedge;
    if (has(2, 3) && isPrism(Loops(mesh, cell, faces))) return StandardShape::prism;
    if (has(2, 4) && isWedge(Loops(mesh, cell, faces))) return StandardShape::wedge;
    return StandardShape::polyhedron;
}

ShapeCounts countShapes(const PolyMesh& mesh, const Rows<Label>& cellFaces) {
    std::vector<StandardShape> shapes(index(mesh.cellCount));
    parallelFor(mesh.cellCount,
                [&](Label cell) { shapes[index(cell)] = standardShape(mesh, cell, cellFaces); });
    ShapeCounts counts;
    for (Label cell = 0; cell < mesh.cellCount; ++cell) {
        ++counts.cells[static_cast<std::size_t>(shapes[index(cell)])];
        if (shapes[index(cell)] == StandardShape::polyhedron)
            ++counts.polyhedraByFaceCount[cellFaces.rowSize(cell)];
    }
    return counts;
}

} // namespace polymesh
