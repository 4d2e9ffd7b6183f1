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

[[noreturn]] void failAt(const Vec3& p) {
    throw WorkError(
        fmt::format("the surface is not closed near ({} {} {}): inside and outside contradict each "
                    "other; repair the surface there",
                    p.x,
                    p.y,
                    p.z));
}

void joinEdges(const Probe& probe, const Arrangement& arrangement, WindingSets& sets) {
    for (Label e = 0; e < probe.edgeCount(); ++e) {
        int step = 0;
        for (const EdgeCrossing& crossing : arrangement.crossings[e])
            step += crossing.sign;
        const auto& [a, b] = probe.edges[index(e)];
        if (!sets.join(a, b, step)) failAt(probe.nodePoints[index(a)]);
    }
}

/// The cell outside the probe behind a probed face, or -1.
Label farCell(const PolyMesh& mesh, const Probe& probe, Label f) {
    const Label meshFace = probe.faces[index(f)];
    const auto& cells = probe.faceCells[index(f)];
    if (meshFace < 0 || (cells[0] >= 0 && cells[1] >= 0)) return -1;
    if (cells[0] < 0) return mesh.owner[index(meshFace)];
    return mesh.isInternal(meshFace) ? mesh.neighbour[index(meshFace)] : -1;
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

void windNodes(const Probe& probe,
               const CuttingSurface& cutter,
               int shift,
               Arrangement& arrangement) {
    WindingSets sets(index(probe.nodeCount()));
    joinEdges(probe, arrangement, sets);
    constexpr int notAsked = INT16_MIN;
    std::vector<int> rootWinding(index(probe.nodeCount()), notAsked);
    arrangement.winding.resize(index(probe.nodeCount()));
    for (Label n = 0; n < probe.nodeCount(); ++n) {
        const auto [root, number] = sets.find(n);
        int& atRoot = rootWinding[index(root)];
        if (atRoot == notAsked) atRoot = windingNumber(cutter, probe.nodePoints[index(n)]) - number;
        arrangement.winding[index(n)] = static_cast<std::int8_t>(atRoot + number + shift);
    }
}

void checkFarCells(const PolyMesh& mesh,
                   const Probe& probe,
                   const std::vector<std::int8_t>& cellWinding,
                   const Arrangement& arrangement) {
    for (Label f = 0; f < probe.faceCount(); ++f) {
        const Label cell = farCell(mesh, probe, f);
        const Label node = probe.faceNodes[f][0];
        if (cell >= 0 && cellWinding[index(cell)] != arrangement.winding[index(node)])
            failAt(probe.nodePoints[index(node)]);
    }
}

} // namespace polymesh
