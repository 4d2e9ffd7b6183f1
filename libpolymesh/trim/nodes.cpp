// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/nodes.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/geometry/predicates.h"

#include <algorithm>
#include <utility>

namespace polymesh {

namespace {

/// Sets of elements, each knowing its winding number relative to the root of its set.
class WindingSets {
public:
    explicit WindingSets(std::size_t count) : parent_(count), offset_(count, 0) {
        for (std::size_t i = 0; i < count; ++i)
            parent_[i] = toLabel(i);
    }

    /// The root of an element's set and the element's number relative to it.
    std::pair<Label, int> find(Label element) {
        Label root = element;
        int sum = 0;
        while (parent_[index(root)] != root) {
            sum += offset_[index(root)];
            root = parent_[index(root)];
        }
        int rest = sum;
        while (parent_[index(element)] != root && element != root) {
            const Label next = std::exchange(parent_[index(element)], root);
            const int step = std::exchange(offset_[index(element)], rest);
            rest -= step;
            element = next;
        }
        return {root, sum};
    }

    /// States that b's number is a's plus `step`. False where that contradicts what is known.
    bool join(Label a, Label b, int step) {
        const auto [rootA, numberA] = find(a);
        const auto [rootB, numberB] = find(b);
        if (rootA == rootB) return numberB == numberA + step;
        parent_[index(rootB)] = rootA;
        offset_[index(rootB)] = numberA + step - numberB;
        return true;
    }

private:
    std::vector<Label> parent_;
    std::vector<int> offset_;
};

/// Change of the winding number from `from` to a far point in direction `axis`, times -1.
int rayWinding(const CuttingSurface& cutter, const Vec3& from, int axis, double far) {
    Vec3 to = from;
    to[axis] = far;
    Box box;
    box.add(from);
    box.add(to);
    int winding = 0;
    for (Label t = 0; t < cutter.surface->triangleCount(); ++t) {
        if (!overlaps(cutter.triangleBoxes[index(t)], box)) continue;
        const std::array<Vec3, 3> triangle = cutter.triangle(t);
        const int start = sideOfTriangle(triangle, from).sign;
        if (start == sideOfTriangle(triangle, to).sign) continue;
        const int side = passingSide(from, to, triangle[0], triangle[1]).sign;
        if (passingSide(from, to, triangle[1], triangle[2]).sign == side &&
            passingSide(from, to, triangle[2], triangle[0]).sign == side)
            winding -= start; // out of the domain: the start was on the negative side
    }
    return winding;
}

void joinEdges(const Probe& probe, const Arrangement& arrangement, WindingSets& sets) {
    for (Label e = 0; e < probe.edgeCount(); ++e) {
        int step = 0;
        for (const EdgeCrossing& crossing : arrangement.crossings[e])
            step += crossing.sign;
        const auto& [a, b] = probe.edges[index(e)];
        const Vec3& p = probe.nodePoints[index(a)];
        if (!sets.join(a, b, step))
            throw WorkError(fmt::format(
                "the surface is not closed near ({} {} {}): inside and outside contradict each "
                "other; repair the surface there",
                p.x,
                p.y,
                p.z));
    }
}

void joinCells(const PolyMesh& mesh, const Probe& probe, WindingSets& sets) {
    const Label firstCell = probe.nodeCount();
    Label local = 0; // walks along probe.faces
    for (Label f = 0; f < mesh.faceCount(); ++f) {
        if (local < probe.faceCount() && probe.faces[index(local)] == f) {
            const auto& cells = probe.faceCells[index(local)];
            const Label node = probe.faceNodes[local][0];
            if (cells[0] < 0) sets.join(firstCell + mesh.owner[index(f)], node, 0);
            if (cells[1] < 0 && mesh.isInternal(f))
                sets.join(firstCell + mesh.neighbour[index(f)], node, 0);
            ++local;
        } else if (mesh.isInternal(f)) {
            sets.join(firstCell + mesh.owner[index(f)], firstCell + mesh.neighbour[index(f)], 0);
        }
    }
}

/// A mesh point of each cell that is not probed, for rays.
std::vector<Label> samplePoints(const PolyMesh& mesh) {
    std::vector<Label> sample(index(mesh.cellCount), 0);
    for (Label f = mesh.faceCount() - 1; f >= 0; --f)
        sample[index(mesh.owner[index(f)])] = mesh.faces[f][0];
    return sample;
}

} // namespace

int windingNumber(const CuttingSurface& cutter, const Vec3& meshPoint) {
    const Box box = boundingBox(cutter.surface->points);
    std::array<int, 3> found{};
    for (int axis = 0; axis < 3; ++axis) {
        const double far = std::max(box.max[axis], meshPoint[axis]) + box.size()[axis] + 1e-300;
        found[static_cast<std::size_t>(axis)] = rayWinding(cutter, meshPoint, axis, far);
    }
    return found[1] == found[2] ? found[1] : found[0];
}

std::vector<std::int8_t> windNodes(const PolyMesh& mesh,
                                   const Probe& probe,
                                   const CuttingSurface& cutter,
                                   int shift,
                                   Arrangement& arrangement) {
    const Label nodeCount = probe.nodeCount();
    WindingSets sets(index(nodeCount) + index(mesh.cellCount));
    joinEdges(probe, arrangement, sets);
    joinCells(mesh, probe, sets);

    constexpr int unknown = INT16_MIN;
    std::vector<int> rootWinding(index(nodeCount) + index(mesh.cellCount), unknown);
    std::vector<Label> sample;
    const auto windingOf = [&](Label element) {
        const auto [root, number] = sets.find(element);
        int& atRoot = rootWinding[index(root)];
        if (atRoot == unknown) {
            if (element >= nodeCount && sample.empty()) sample = samplePoints(mesh);
            const Vec3& p = element < nodeCount
                                ? probe.nodePoints[index(element)]
                                : mesh.points[index(sample[index(element - nodeCount)])];
            atRoot = windingNumber(cutter, p) - number;
        }
        return static_cast<std::int8_t>(atRoot + number + shift);
    };
    arrangement.winding.resize(index(nodeCount));
    for (Label n = 0; n < nodeCount; ++n)
        arrangement.winding[index(n)] = windingOf(n);
    std::vector<std::int8_t> cellWinding(index(mesh.cellCount), 0);
    for (Label c = 0; c < mesh.cellCount; ++c)
        if (probe.localCell[index(c)] < 0) cellWinding[index(c)] = windingOf(nodeCount + c);
    return cellWinding;
}

} // namespace polymesh
