// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/facePairs.h"

#include "formats/star/faceView.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/mesh/cellGeometry.h"

#include <algorithm>
#include <array>

namespace polymesh::star {

namespace {

/// The faces whose lowest point each point is.
Rows<Label> facesByLowestPoint(const Rows<Label>& faces, std::size_t pointCount) {
    std::vector<Label> lowest(index(faces.size()));
    parallelFor(faces.size(), [&](Label f) { lowest[index(f)] = std::ranges::min(faces[f]); });
    Rows<Label> rows;
    rows.offsets.assign(pointCount + 1, 0);
    for (const Label p : lowest)
        ++rows.offsets[index(p) + 1];
    for (std::size_t p = 0; p < pointCount; ++p)
        rows.offsets[p + 1] += rows.offsets[p];
    rows.values.resize(lowest.size());
    std::vector<Label> next(rows.offsets.begin(), rows.offsets.end() - 1);
    for (Label f = 0; f < faces.size(); ++f)
        rows.values[index(next[index(lowest[index(f)])]++)] = f;
    return rows;
}

constexpr Label shared = -2; // partner of a face that more than two cells have

/// Pairs the faces of one point; partner[] of no other face is touched.
void pairAtPoint(const Rows<Label>& faces,
                 std::span<const Label> candidates,
                 std::vector<FaceView>& views,
                 std::vector<Label>& partner) {
    views.clear();
    views.reserve(candidates.size());
    for (const Label f : candidates)
        views.emplace_back(faces[f], f);
    std::sort(views.begin(), views.end());
    for (std::size_t i = 0; i < views.size();) {
        std::size_t last = i + 1;
        while (last < views.size() && views[last].isSame(views[i]))
            ++last;
        if (last - i == 2) {
            partner[index(views[i].face())] = views[i + 1].face();
            partner[index(views[i + 1].face())] = views[i].face();
        }
        for (std::size_t j = i; last - i > 2 && j < last; ++j)
            partner[index(views[j].face())] = shared;
        i = last;
    }
}

std::vector<Label> partnersOf(const Rows<Label>& faces, std::size_t pointCount) {
    const Rows<Label> atPoint = facesByLowestPoint(faces, pointCount);
    std::vector<Label> partner(index(faces.size()), -1);
    constexpr Label blockSize = 1024;
    parallelBlocks(atPoint.size(), blockSize, [&](Label, Label first, Label last) {
        std::vector<FaceView> views;
        for (Label p = first; p < last; ++p)
            pairAtPoint(faces, atPoint[p], views, partner);
    });
    return partner;
}

std::vector<Label> cellsOfFaces(const CellRecords& cells) {
    std::vector<Label> cellOf(cells.faceTotal());
    parallelFor(cells.count(), [&](Label c) {
        std::fill(cellOf.begin() + cells.firstFaces[index(c)],
                  cellOf.begin() + cells.firstFaces[index(c) + 1],
                  c);
    });
    return cellOf;
}

double volumeOf(const std::vector<Vec3>& points, const CellRecords& cells, Label cell) {
    std::vector<FaceGeometry> faces;
    for (Label f = cells.firstFaces[index(cell)]; f < cells.firstFaces[index(cell) + 1]; ++f)
        faces.push_back(faceGeometry(points, cells.faces[f]));
    return cellGeometry(faces).volume;
}

void turn(CellRecords& cells, Label cell) {
    for (Label f = cells.firstFaces[index(cell)]; f < cells.firstFaces[index(cell) + 1]; ++f)
        std::reverse(cells.faces[f].begin(), cells.faces[f].end());
}

/// Works on the faces of cells that were paired.
class PairCheck {
public:
    PairCheck(const TextFile& file,
              const std::vector<Vec3>& points,
              CellRecords& cells,
              const FacePairs& pairs)
        : file_(file), points_(points), cells_(cells), pairs_(pairs) {}

    void refuseShared() const {
        for (Label f = 0; f < cells_.faces.size(); ++f) {
            const Label other = pairs_.partner[index(f)];
            if (other == shared) fail(f, "more than two cells have this face");
            if (other >= 0 && pairs_.cellOf[index(f)] == pairs_.cellOf[index(other)])
                fail(f, "it has this face twice");
        }
    }

    /// Turns the cells that lie on the wrong side of a face.
    void turnCells() {
        std::vector<Label> wrong;
        for (const Label f : facesOnOneSide())
            for (const Label cell : {pairs_.cellOf[index(f)], cellBehind(f)})
                if (volumeOf(points_, cells_, cell) < 0) wrong.push_back(cell);
        std::ranges::sort(wrong);
        wrong.erase(std::unique(wrong.begin(), wrong.end()), wrong.end());
        for (const Label cell : wrong)
            turn(cells_, cell);
        note(toLabel(wrong.size()));
        const std::vector<Label> left = facesOnOneSide();
        if (!left.empty())
            fail(left.front(),
                 fmt::format("cell {} lies on the same side of this face",
                             cells_.numbers[index(cellBehind(left.front()))]));
    }

    /// Turns all cells when the boundary holds a negative volume.
    void turnMesh() {
        const Vec3 apex = points_.empty() ? Vec3{} : points_.front();
        const double volume = parallelSum(cells_.faces.size(), 0.0, [&](Label f) {
            if (pairs_.partner[index(f)] >= 0) return 0.0;
            const FaceGeometry face = faceGeometry(points_, cells_.faces[f]);
            return dot(face.area, face.centre - apex) / 3;
        });
        if (!(volume < 0)) return;
        parallelFor(cells_.count(), [&](Label cell) { turn(cells_, cell); });
        note(cells_.count());
    }

private:
    Label cellBehind(Label face) const { return pairs_.cellOf[index(pairs_.partner[index(face)])]; }

    /// Faces that have the same sense as their partners, the lower face of each pair, ascending.
    std::vector<Label> facesOnOneSide() const {
        std::vector<char> isWrong(cells_.faceTotal(), 0);
        parallelFor(cells_.faces.size(), [&](Label f) {
            const Label other = pairs_.partner[index(f)];
            if (other <= f) return;
            const bool same = FaceView(cells_.faces[f], f).isForward() ==
                              FaceView(cells_.faces[other], other).isForward();
            isWrong[index(f)] = same ? 1 : 0;
        });
        std::vector<Label> wrong;
        for (auto f = std::ranges::find(isWrong, 1); f != isWrong.end();
             f = std::find(f + 1, isWrong.end(), 1))
            wrong.push_back(toLabel(static_cast<std::size_t>(f - isWrong.begin())));
        return wrong;
    }

    void note(Label turned) {
        if (turned > 0)
            cells_.notes.push_back(
                fmt::format("{} cells were inside out and have been turned", turned));
    }

    [[noreturn]] void fail(Label face, std::string_view message) const {
        const std::size_t cell = index(pairs_.cellOf[index(face)]);
        file_.fail(cells_.places[cell],
                   fmt::format("cell {}, face {}: {}",
                               cells_.numbers[cell],
                               cells_.faceNumbers[index(face)],
                               message));
    }

    const TextFile& file_;
    const std::vector<Vec3>& points_;
    CellRecords& cells_;
    const FacePairs& pairs_;
};

} // namespace

FacePairs pairFaces(const TextFile& file, const std::vector<Vec3>& points, CellRecords& cells) {
    FacePairs pairs{cellsOfFaces(cells), partnersOf(cells.faces, points.size())};
    PairCheck check(file, points, cells, pairs);
    check.refuseShared();
    check.turnCells();
    check.turnMesh();
    return pairs;
}

} // namespace polymesh::star
