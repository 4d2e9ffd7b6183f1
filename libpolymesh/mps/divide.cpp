// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/mps/dividedZones.h"
#include "libpolymesh/mps/midPointSubdivision.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace polymesh {

namespace {

constexpr Label cellsPerBlock = 1024;
using Corner = CellCorners::Corner;

/// An internal face of the divided mesh; its normal leaves the owner.
struct PartFace {
    Label owner;
    Label neighbour;
    std::array<Label, 4> points;
    std::int8_t size;
    Label source; // corner of the divided face, in mesh.faces.values; -1 within a cell
};

/// Where the faces that the parts of each cell own begin, and their points.
struct FaceStarts {
    std::vector<Label> face;
    std::vector<Label> value;
};

/// Collects the internal faces that the parts of one cell own.
class CellDivider {
public:
    CellDivider(const PolyMesh& mesh, const SubdivisionPlan& plan)
        : mesh_(mesh), plan_(plan), divided_{mesh, plan.edges, plan.cellFaces} {}

    /// The faces, sorted by owner and neighbour.
    std::span<const PartFace> facesOf(Label cell) {
        corners_.load(divided_, cell);
        firstPart_ = plan_.firstPart[index(cell)];
        centre_ = plan_.layout.firstCell + cell;
        faces_.clear();
        for (const Corner& c : corners_.corners())
            if (mesh_.isInternal(c.face) && mesh_.owner[index(c.face)] == cell) addOuter(c);
        for (const auto& [a, b] : corners_.edgePairs())
            addInner(corners_.corner(corners_.corner(a).next),
                     corners_.corner(corners_.corner(b).next));
        addPyramidSides(cell);
        std::ranges::sort(faces_, [](const PartFace& a, const PartFace& b) {
            if (a.owner != b.owner) return a.owner < b.owner;
            return a.neighbour != b.neighbour ? a.neighbour < b.neighbour : a.points < b.points;
        });
        return faces_;
    }

private:
    Label middle(Label edge) const { return plan_.layout.firstEdge + edge; }

    Label ofFace(Label face) const { return plan_.layout.firstFace + face; }

    /// Adds a face whose normal leaves part a of the cell into part b of the cell.
    void addBetween(int a, int b, std::array<Label, 4> points, int size) {
        if (a > b) {
            std::swap(a, b);
            std::reverse(points.begin(), points.begin() + size);
        }
        faces_.push_back(
            {firstPart_ + a, firstPart_ + b, points, static_cast<std::int8_t>(size), -1});
    }

    void addOuter(const Corner& c) {
        const Label neighbour = mesh_.neighbour[index(c.face)];
        const Label across =
            plan_.firstPart[index(neighbour)] + plan_.partAcross[index(c.position)];
        faces_.push_back({firstPart_ + c.facePart,
                          across,
                          {c.point, middle(c.outEdge), ofFace(c.face), middle(c.inEdge)},
                          4,
                          c.position});
    }

    /// The face between the parts at the two ends of an edge; here and there are the corners at its
    /// ends whose in edge it is.
    void addInner(const Corner& here, const Corner& there) {
        addBetween(here.edgePart,
                   there.edgePart,
                   {middle(here.inEdge), ofFace(here.face), centre_, ofFace(there.face)},
                   4);
    }

    /// The triangles between the pyramids of each node of other valence than 3.
    void addPyramidSides(Label cell) {
        Label apex = plan_.layout.firstApex + plan_.firstApex[index(cell)];
        for (const CellCorners::Node& node : corners_.nodes()) {
            if (node.valence == 3) continue;
            int i = node.firstCorner;
            int before = i;
            while (corners_.corner(before).across != i)
                before = corners_.corner(before).across;
            for (int k = 0; k < node.valence; ++k) {
                addSidesAt(corners_.corner(i), corners_.corner(before), apex);
                before = i;
                i = corners_.corner(i).across;
            }
            ++apex;
        }
    }

    /// `before` is the corner across the out edge.
    void addSidesAt(const Corner& c, const Corner& before, Label apex) {
        const Label face = ofFace(c.face);
        const Label in = middle(c.inEdge);
        const Label out = middle(c.outEdge);
        addBetween(c.facePart, corners_.corner(c.across).facePart, {c.point, in, apex, -1}, 3);
        addBetween(c.facePart, c.edgePart, {in, face, apex, -1}, 3);
        addBetween(c.facePart, before.edgePart, {face, out, apex, -1}, 3);
        addBetween(c.edgePart, before.edgePart, {centre_, face, apex, -1}, 3);
    }

    const PolyMesh& mesh_;
    const SubdivisionPlan& plan_;
    DividedMesh divided_;
    CellCorners corners_;
    std::vector<PartFace> faces_;
    Label firstPart_ = 0;
    Label centre_ = 0;
};

/// Counts the internal faces that the parts of each cell own, without making them: a quadrilateral
/// for each corner of its own internal faces and for each edge, 4v triangles for a node of valence
/// v other than 3.
FaceStarts countFaces(const PolyMesh& mesh, const SubdivisionPlan& plan) {
    FaceStarts starts;
    starts.face.assign(index(mesh.cellCount) + 1, 0);
    starts.value.assign(index(mesh.cellCount) + 1, 0);
    parallelFor(mesh.cellCount, [&](Label cell) {
        Label corners = 0;
        Label quads = 0;
        for (const Label face : plan.cellFaces[cell]) {
            const Label size = mesh.faces.rowSize(face);
            corners += size;
            if (mesh.isInternal(face) && mesh.owner[index(face)] == cell) quads += size;
        }
        quads += corners / 2; // edges
        const Label parts = plan.firstPart[index(cell) + 1] - plan.firstPart[index(cell)];
        // With h hexahedra, parts = h + 2 (corners - 3 h); triangles are 4 (corners - 3 h).
        const Label hexahedra = (2 * corners - parts) / 5;
        const Label triangles = 4 * (corners - 3 * hexahedra);
        starts.face[index(cell) + 1] = quads + triangles;
        starts.value[index(cell) + 1] = 4 * quads + 3 * triangles;
    });
    std::partial_sum(starts.face.begin(), starts.face.end(), starts.face.begin());
    std::partial_sum(starts.value.begin(), starts.value.end(), starts.value.begin());
    return starts;
}

/// Where the children of each corner of a face are: needed for zones of faces.
using ChildFaces = std::vector<Label>;

void fillInternal(const PolyMesh& mesh,
                  const SubdivisionPlan& plan,
                  const FaceStarts& starts,
                  PolyMesh& result,
                  ChildFaces& children) {
    parallelBlocks(mesh.cellCount, cellsPerBlock, [&](Label, Label first, Label last) {
        CellDivider divider(mesh, plan);
        for (Label cell = first; cell < last; ++cell) {
            Label face = starts.face[index(cell)];
            Label value = starts.value[index(cell)];
            for (const PartFace& part : divider.facesOf(cell)) {
                result.owner[index(face)] = part.owner;
                result.neighbour[index(face)] = part.neighbour;
                std::copy_n(part.points.begin(), part.size, result.faces.values.begin() + value);
                value += part.size;
                if (part.source >= 0 && !children.empty()) children[index(part.source)] = face;
                result.faces.offsets[index(++face)] = value;
            }
        }
    });
}

/// The quadrilaterals of the boundary faces, in the order of their corners. On the second patch of
/// a cyclic pair, whose faces run the other way round, in the reverse one, so that the two agree.
void fillBoundary(const PolyMesh& mesh,
                  const SubdivisionPlan& plan,
                  PolyMesh& result,
                  ChildFaces& children,
                  const std::vector<char>& isReversed) {
    const Label internal = mesh.internalFaceCount();
    const Label firstCorner = mesh.faces.offsets[index(internal)];
    const Label firstFace = result.internalFaceCount();
    const Label firstValue = result.faces.offsets[index(firstFace)];
    parallelFor(mesh.faceCount() - internal, [&](Label i) {
        const Label face = internal + i;
        const Label start = mesh.faces.offsets[index(face)];
        const Label size = mesh.faces.rowSize(face);
        const Label cell = mesh.owner[index(face)];
        for (Label k = 0; k < size; ++k) {
            const Label at = start + k;
            const Label before = k > 0 ? at - 1 : start + size - 1;
            const Label place = isReversed[index(i)] != 0 && k > 0 ? size - k : k;
            const Label child = start - firstCorner + place;
            const auto out = index(firstValue + 4 * child);
            result.faces.values[out] = mesh.faces.values[index(at)];
            result.faces.values[out + 1] = plan.layout.firstEdge + plan.edges.ofCorner[index(at)];
            result.faces.values[out + 2] = plan.layout.firstFace + face;
            result.faces.values[out + 3] =
                plan.layout.firstEdge + plan.edges.ofCorner[index(before)];
            result.faces.offsets[index(firstFace + child + 1)] = firstValue + 4 * (child + 1);
            result.owner[index(firstFace + child)] =
                plan.firstPart[index(cell)] + plan.partAcross[index(at)];
            if (!children.empty()) children[index(at)] = firstFace + child;
        }
    });
}

/// Marks the boundary faces, from the first, that belong to the second patch of a cyclic pair.
std::vector<char> reversedFaces(const PolyMesh& mesh) {
    std::vector<char> isReversed(index(mesh.faceCount() - mesh.internalFaceCount()), 0);
    for (std::size_t p = 0; p < mesh.patches.size(); ++p) {
        const Patch& patch = mesh.patches[p];
        if (!patch.type.starts_with("cyclic")) continue;
        for (std::size_t q = 0; q < p; ++q)
            for (const auto& [key, value] : patch.entries)
                if (key == "neighbourPatch" && value == mesh.patches[q].name)
                    std::fill_n(isReversed.begin() + (patch.start - mesh.internalFaceCount()),
                                patch.size,
                                char{1});
    }
    return isReversed;
}

void dividePatches(const PolyMesh& mesh, PolyMesh& result) {
    const Label firstCorner = mesh.faces.offsets[index(mesh.internalFaceCount())];
    result.patches = mesh.patches;
    for (Patch& patch : result.patches) {
        const Label first = mesh.faces.offsets[index(patch.start)];
        const Label last = mesh.faces.offsets[index(patch.start + patch.size)];
        patch.start = result.internalFaceCount() + first - firstCorner;
        patch.size = last - first;
    }
}

} // namespace

PolyMesh divide(const PolyMesh& mesh, SubdivisionPlan&& plan) {
    const FaceStarts starts = countFaces(mesh, plan);
    const Label internalFaces = starts.face.back();
    const Label boundaryQuads =
        toLabel(mesh.faces.values.size()) - mesh.faces.offsets[index(mesh.internalFaceCount())];
    PolyMesh result;
    result.cellCount = plan.firstPart.back();
    result.owner.resize(index(internalFaces + boundaryQuads));
    result.neighbour.resize(index(internalFaces));
    result.faces.offsets.resize(index(internalFaces + boundaryQuads) + 1);
    result.faces.values.resize(index(starts.value.back() + 4 * boundaryQuads));
    result.faces.offsets[index(internalFaces)] = starts.value.back();
    ChildFaces children(mesh.faceZones.empty() ? 0 : mesh.faces.values.size());
    fillInternal(mesh, plan, starts, result, children);
    fillBoundary(mesh, plan, result, children, reversedFaces(mesh));
    dividePatches(mesh, result);
    divideZones(mesh, plan, children, result);
    result.points = std::move(plan.points);
    return result;
}

} // namespace polymesh
