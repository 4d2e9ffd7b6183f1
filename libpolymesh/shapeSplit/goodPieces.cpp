// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/shapeSplit/goodPieces.h"

#include "libpolymesh/quality/editQuality.h"
#include "libpolymesh/quality/starPoint.h"
#include "libpolymesh/shapeSplit/innerPoint.h"

#include <algorithm>
#include <array>

namespace polymesh {

namespace {

/// A point and what pyramids round it leave.
struct Apex {
    Vec3 at;
    Badness badness;
};

/// Compares pyramids of one cell round several points; changes nothing.
class ApexSearch {
public:
    ApexSearch(MeshEditor& editor, Label cell, const Apex& first)
        : editor_(editor), cell_(cell), best_(first) {}

    const Apex& best() const { return best_; }

    void tryAmong(const std::vector<Vec3>& points) {
        for (const Vec3& p : points)
            take(p);
    }

    /// Steps from the best point, shorter and shorter, as long as they lead to better ones.
    void tryAround() {
        constexpr double first = 0.12; // of the cell's size
        constexpr int halvings = 4;
        double step = first * editor_.cell(cell_).size;
        for (int i = 0; i < halvings && best_.badness.failures > 0; ++i, step /= 2)
            while (takesStep(step)) {
            }
    }

private:
    bool takesStep(double step) {
        const Vec3 from = best_.at;
        const std::array<Vec3, 6> ways{{{step, 0, 0},
                                        {-step, 0, 0},
                                        {0, step, 0},
                                        {0, -step, 0},
                                        {0, 0, step},
                                        {0, 0, -step}}};
        return std::ranges::any_of(
            ways, [&](const Vec3& way) { return seesAll(from + way) && take(from + way); });
    }

    bool seesAll(const Vec3& p) {
        return std::ranges::all_of(editor_.cell(cell_).faces,
                                   [&](Label f) { return isSeenFrom(editor_, cell_, f, p); });
    }

    bool take(const Vec3& p) {
        const MeshEditor::Mark mark = editor_.mark();
        const std::vector<Label> pyramids = makePyramids(editor_, cell_, p);
        const Badness badness = badnessOf(editor_, withNeighbours(editor_, pyramids));
        editor_.undoTo(mark);
        if (!isBetter(badness, best_.badness)) return false;
        best_ = {p, badness};
        return true;
    }

    MeshEditor& editor_;
    Label cell_;
    Apex best_;
};

/// Leaves the tetrahedra when they are better than that.
bool isBetterFilled(MeshEditor& editor,
                    Label cell,
                    const Tetrahedraliser& tetrahedralise,
                    const Badness& least) {
    if (!tetrahedralise) return false;
    const MeshEditor::Mark mark = editor.mark();
    const Filled filled = fillWithTetrahedra(editor, cell, tetrahedralise);
    if (!filled.pieces.empty() &&
        isBetter(badnessOf(editor, withNeighbours(editor, filled.pieces)), least))
        return true;
    editor.undoTo(mark);
    return false;
}

} // namespace

Pieces makeGoodPieces(MeshEditor& editor, Label cell, const Tetrahedraliser& tetrahedralise) {
    const auto first = innerPoint(editor, cell);
    if (!first) return Pieces::none;
    const MeshEditor::Mark mark = editor.mark();
    const std::vector<Label> pyramids = makePyramids(editor, cell, *first);
    const Badness badness = badnessOf(editor, withNeighbours(editor, pyramids));
    if (badness.failures == 0) return Pieces::pyramids;
    editor.undoTo(mark);
    ApexSearch search(editor, cell, {*first, badness});
    search.tryAmong(innerPoints(editor, cell));
    search.tryAround();
    const Apex& best = search.best();
    if (best.badness.failures > 0 && isBetterFilled(editor, cell, tetrahedralise, best.badness))
        return Pieces::tetrahedra;
    makePyramids(editor, cell, best.at);
    return Pieces::pyramids;
}

} // namespace polymesh
