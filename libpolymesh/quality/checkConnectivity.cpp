// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mesh/topology.h"
#include "libpolymesh/quality/checkParts.h"

#include <array>

namespace polymesh {

namespace {

// Zip-up: how often the faces of a cell use its edges --------------------------------------------

struct EdgeUsage {
    bool hasSingle = false; // some edge is used by one face only: the cell is open
    bool isRegular = true;  // every edge is used twice
};

EdgeUsage edgeUsage(const CheckContext& context, Label cell, std::vector<Edge>& buffer) {
    buffer.clear();
    for (const Label face : context.facesOf[cell]) {
        const std::span<const Label> points = context.mesh.faces[face];
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Label next = points[i + 1 == points.size() ? 0 : i + 1];
            buffer.push_back({std::min(points[i], next), std::max(points[i], next)});
        }
    }
    std::sort(buffer.begin(), buffer.end());
    EdgeUsage usage;
    for (std::size_t first = 0, last = 0; first < buffer.size(); first = last) {
        while (last < buffer.size() && buffer[last] == buffer[first])
            ++last;
        usage.hasSingle = usage.hasSingle || last - first == 1;
        usage.isRegular = usage.isRegular && last - first == 2;
    }
    return usage;
}

void checkZipUp(const CheckContext& context) {
    std::vector<EdgeUsage> usage(index(context.mesh.cellCount));
    parallelBlocks(context.mesh.cellCount, 1024, [&](Label, Label first, Label last) {
        std::vector<Edge> buffer;
        for (Label cell = first; cell < last; ++cell)
            usage[index(cell)] = edgeUsage(context, cell, buffer);
    });
    store(context, CheckId::zipUp, gather(context.mesh.cellCount, [&](Label cell) {
              return !usage[index(cell)].isRegular;
          }));
    CheckResult& result = context.report[CheckId::zipUp];
    result.count = toLabel(static_cast<std::size_t>(
        std::count_if(usage.begin(), usage.end(), [](const auto& u) { return u.hasSingle; })));
    result.failed = result.count > 0;
}

// Faces that share points ------------------------------------------------------------------------

std::size_t step(std::size_t at, bool forward, std::size_t size) {
    if (forward) return at + 1 == size ? 0 : at + 1;
    return at == 0 ? size - 1 : at - 1;
}

/// Walks two faces side by side.
struct Walk {
    std::span<const Label> a;
    std::span<const Label> b;
    std::size_t i;
    std::size_t j;
    bool forwardA;
    bool forwardB;

    void advance() {
        i = step(i, forwardA, a.size());
        j = step(j, forwardB, b.size());
    }

    bool isEqual() const { return a[i] == b[j]; }

    void turn() {
        forwardA = !forwardA;
        forwardB = !forwardB;
    }
};

/// A walk from a shared corner in the direction in which both faces go on alike.
Walk alongShared(std::span<const Label> a, std::span<const Label> b, std::size_t i, std::size_t j) {
    const Label nextA = a[step(i, true, a.size())];
    const Label previousA = a[step(i, false, a.size())];
    const Label nextB = b[step(j, true, b.size())];
    const Label previousB = b[step(j, false, b.size())];
    Walk walk{a, b, i, j, true, false};
    if (nextB == nextA)
        walk.forwardB = true;
    else if (nextB == previousA)
        walk.forwardA = false, walk.forwardB = true;
    else if (previousB == previousA)
        walk.forwardA = false;
    return walk;
}

/// True when the `common` points that two faces share follow each other on both.
bool areConsecutive(std::span<const Label> a, std::span<const Label> b, std::size_t common) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        const auto found = std::find(b.begin(), b.end(), a[i]);
        if (found == b.end()) continue;
        Walk walk = alongShared(a, b, i, static_cast<std::size_t>(found - b.begin()));
        // To the end of the shared part; bounded, for faces that list points twice.
        std::size_t steps = 0;
        do
            walk.advance();
        while (walk.isEqual() && ++steps < a.size() + b.size());
        walk.turn();
        for (std::size_t n = 0; n < common; ++n) {
            walk.advance();
            if (!walk.isEqual()) return false;
        }
        return true;
    }
    return true;
}

/// What one face finds among the later faces that share points with it.
struct FaceSharing {
    Label baffles = 0;
    bool isDuplicate = false;
    bool isOutOfOrder = false;
    std::vector<Label> marked;
};

void compare(const CheckContext& context, Label face, Label other, Label common, FaceSharing& out) {
    const std::span<const Label> a = context.mesh.faces[face];
    const std::span<const Label> b = context.mesh.faces[other];
    const auto shared = index(common);
    if (shared == a.size() || shared == b.size()) {
        if (a.size() == b.size())
            ++out.baffles;
        else
            out.isDuplicate = true;
        out.marked.insert(out.marked.end(), {face, other});
    } else if (shared >= 2 && !areConsecutive(a, b, shared)) {
        out.isOutOfOrder = true;
        out.marked.insert(out.marked.end(), {face, other});
    }
}

FaceSharing faceSharing(const CheckContext& context,
                        const Rows<Label>& facesOfPoint,
                        Label face,
                        std::vector<Label>& buffer) {
    buffer.clear();
    for (const Label point : context.mesh.faces[face])
        for (const Label other : facesOfPoint[point])
            if (face < other) buffer.push_back(other);
    std::sort(buffer.begin(), buffer.end());
    FaceSharing result;
    for (std::size_t first = 0, last = 0; first < buffer.size(); first = last) {
        while (last < buffer.size() && buffer[last] == buffer[first])
            ++last;
        compare(context, face, buffer[first], toLabel(last - first), result);
    }
    return result;
}

void checkFaceFaces(const CheckContext& context) {
    constexpr Label blockSize = 4096;
    const Label faces = context.mesh.faceCount();
    const Rows<Label> facesOfPoint = pointFaces(context.mesh);

    struct Sum {
        Label baffles = 0, duplicates = 0, outOfOrder = 0;
        std::vector<Label> marked;
    };

    std::vector<Sum> sums(index((faces + blockSize - 1) / blockSize));
    parallelBlocks(faces, blockSize, [&](Label block, Label first, Label last) {
        std::vector<Label> buffer;
        Sum& sum = sums[index(block)];
        for (Label face = first; face < last; ++face) {
            const FaceSharing own = faceSharing(context, facesOfPoint, face, buffer);
            sum.baffles += own.baffles;
            sum.duplicates += own.isDuplicate ? 1 : 0;
            sum.outOfOrder += own.isOutOfOrder ? 1 : 0;
            sum.marked.insert(sum.marked.end(), own.marked.begin(), own.marked.end());
        }
    });
    TopologyFacts& facts = context.report.topology;
    std::vector<Label> marked;
    for (const Sum& sum : sums) {
        facts.baffleFaces += sum.baffles;
        facts.duplicateFaces += sum.duplicates;
        facts.nonConsecutiveFaces += sum.outOfOrder;
        marked.insert(marked.end(), sum.marked.begin(), sum.marked.end());
    }
    std::sort(marked.begin(), marked.end());
    marked.erase(std::unique(marked.begin(), marked.end()), marked.end());
    store(context, CheckId::faceConnectivity, std::move(marked));
}

void checkNeighbourCounts(const CheckContext& context) {
    std::vector<Label> neighbours(index(context.mesh.cellCount), 0);
    for (Label face = 0; face < context.mesh.faceCount(); ++face) {
        if (!context.hasNeighbour(face)) continue;
        ++neighbours[index(context.mesh.owner[index(face)])];
        if (context.mesh.isInternal(face)) ++neighbours[index(context.mesh.neighbour[index(face)])];
    }
    const auto cellsWith = [&](Label least, Label most) {
        return gather(context.mesh.cellCount, [&](Label cell) {
            return neighbours[index(cell)] >= least && neighbours[index(cell)] <= most;
        });
    };
    store(context, CheckId::oneInternalFace, cellsWith(0, 1));
    store(context, CheckId::twoInternalFaces, cellsWith(2, 2));
}

} // namespace

void checkConnectivity(const CheckContext& context) {
    checkZipUp(context);
    checkFaceFaces(context);
    checkNeighbourCounts(context);
}

} // namespace polymesh
