// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/base/error.h"
#include "libpolymesh/base/freshList.h"
#include "libpolymesh/base/kept.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/initial/outsideCells.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace polymesh {

namespace {

using Face = CartesianMesh::Face;

constexpr Label blockSize = 1 << 15; // faces

/// The new labels of what stays; -1 for the rest.
std::vector<Label> newLabels(const Kept& kept, Label count) {
    std::vector<Label> labels = freshList<Label>(index(count), -1);
    kept.forEach([&](Label i, Label to) { labels[index(i)] = to; });
    return labels;
}

/// Makes the mesh of some cells of a box. Its faces: those between two of them, then the sides of
/// the box, then those on which a cell is left out.
class Part {
public:
    Part(const CartesianBox& box, const std::vector<std::uint8_t>& isOut)
        : box_(box),
          isOut_(isOut),
          cells_(box_.cellCount(), [&](Label c) { return isOut[index(c)] == 0; }),
          cellLabels_(newLabels(cells_, box_.cellCount())) {}

    PolyMesh make() {
        mesh_.cellCount = cells_.count();
        require(mesh_.cellCount > 0,
                "all cells of the box are outside the surface; choose smaller cells or leave out "
                "-inside");
        used_ = freshList<std::uint8_t>(index(box_.pointCount()));
        countInternal();
        countSides();
        makeLists();
        fillInternal();
        fillSides();
        return std::move(mesh_);
    }

private:
    /// How many faces of a block stay between two cells, or become boundary.
    struct Counts {
        Label internal = 0;
        Label cut = 0;
    };

    bool isIn(Label cell) const { return isOut_[index(cell)] == 0; }

    template<class Visit>
    void forInternalBlocks(Visit&& visit) const {
        parallelBlocks(box_.internalFaceCount(), blockSize, visit);
    }

    void use(const Face& face) {
        for (const Label p : face.points)
            std::atomic_ref<std::uint8_t>(used_[index(p)]).store(1, std::memory_order_relaxed);
    }

    void countInternal() {
        before_.resize(index((box_.internalFaceCount() + blockSize - 1) / blockSize) + 1);
        forInternalBlocks([&](Label block, Label first, Label last) {
            Counts& counts = before_[index(block) + 1];
            box_.visitFaces(first, last, [&](Label, const Face& face) {
                const int in = int{isIn(face.owner)} + int{isIn(face.neighbour)};
                if (in == 0) return;
                ++(in == 2 ? counts.internal : counts.cut);
                use(face);
            });
        });
        for (std::size_t b = 1; b < before_.size(); ++b) {
            before_[b].internal += before_[b - 1].internal;
            before_[b].cut += before_[b - 1].cut;
        }
    }

    void countSides() {
        Label start = before_.back().internal;
        for (const Patch& side : box_.patches()) {
            Patch patch = side;
            patch.start = start;
            box_.visitFaces(side.start, side.start + side.size, [&](Label, const Face& face) {
                if (!isIn(face.owner)) return;
                ++start;
                use(face);
            });
            patch.size = start - patch.start;
            if (patch.size > 0) mesh_.patches.push_back(patch);
        }
        firstCut_ = start;
        Patch cut;
        cut.name = "outside";
        cut.start = start;
        cut.size = before_.back().cut;
        if (cut.size > 0) mesh_.patches.push_back(cut);
    }

    void makeLists() {
        const Label faces = firstCut_ + before_.back().cut;
        mesh_.owner = freshList<Label>(index(faces));
        mesh_.neighbour = freshList<Label>(index(before_.back().internal));
        mesh_.faces.offsets = freshList<Label>(index(faces) + 1);
        mesh_.faces.values = freshList<Label>(4 * index(faces));
        const Kept points(box_.pointCount(), [&](Label p) { return used_[index(p)] != 0; });
        pointLabels_ = newLabels(points, box_.pointCount());
        mesh_.points = freshList<Vec3>(index(points.count()));
        points.forEach([&](Label p, Label to) { mesh_.points[index(to)] = box_.point(p); });
    }

    void set(Label f, const Face& face, bool isReversed) {
        mesh_.faces.offsets[index(f) + 1] = 4 * (f + 1);
        const auto to = mesh_.faces.values.begin() + std::ptrdiff_t{4} * f;
        std::ranges::transform(face.points, to, [&](Label p) { return pointLabels_[index(p)]; });
        if (isReversed) std::reverse(to + 1, to + 4); // still from the same point
        mesh_.owner[index(f)] = cellLabels_[index(isReversed ? face.neighbour : face.owner)];
    }

    void fillInternal() {
        forInternalBlocks([&](Label block, Label first, Label last) {
            Counts next = before_[index(block)];
            box_.visitFaces(first, last, [&](Label, const Face& face) {
                const bool isOwnerIn = isIn(face.owner);
                const bool isNeighbourIn = isIn(face.neighbour);
                if (isOwnerIn && isNeighbourIn) {
                    mesh_.neighbour[index(next.internal)] = cellLabels_[index(face.neighbour)];
                    set(next.internal++, face, false);
                } else if (isOwnerIn || isNeighbourIn) {
                    set(firstCut_ + next.cut++, face, isNeighbourIn);
                }
            });
        });
    }

    void fillSides() {
        Label at = before_.back().internal;
        for (const Patch& side : box_.patches())
            box_.visitFaces(side.start, side.start + side.size, [&](Label, const Face& face) {
                if (isIn(face.owner)) set(at++, face, false);
            });
    }

    const CartesianMesh box_;
    const std::vector<std::uint8_t>& isOut_;
    const Kept cells_;
    const std::vector<Label> cellLabels_;
    std::vector<Label> pointLabels_;
    std::vector<std::uint8_t> used_; // points
    std::vector<Counts> before_;     // each block of internal faces
    Label firstCut_ = 0;
    PolyMesh mesh_;
};

} // namespace

PolyMesh cartesianMeshWithout(const CartesianBox& box, const std::vector<std::uint8_t>& flags) {
    return Part(box, flags).make();
}

} // namespace polymesh
