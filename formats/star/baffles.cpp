// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/boundaryRecords.h"
#include "formats/star/faceView.h"
#include "libpolymesh/base/error.h"

namespace polymesh::star {

namespace {

std::vector<FaceView> sortedViews(const Rows<Label>& loops) {
    std::vector<FaceView> views;
    views.reserve(index(loops.size()));
    for (Label i = 0; i < loops.size(); ++i)
        views.emplace_back(loops[i], i);
    std::sort(views.begin(), views.end());
    return views;
}

[[noreturn]] void
failAt(const TextFile& file, const CellRecords& cells, Label baffle, std::string_view message) {
    file.fail(cells.bafflePlaces[index(baffle)],
              fmt::format("baffle {}: {}", cells.baffleNumbers[index(baffle)], message));
}

} // namespace

BaffleSides openBaffles(const TextFile& file, const CellRecords& cells, FacePairs& pairs) {
    BaffleSides sides(index(cells.baffles.size()), {-1, -1});
    if (sides.empty()) return sides;
    const std::vector<FaceView> views = sortedViews(cells.baffles);
    for (std::size_t i = 1; i < views.size(); ++i)
        if (views[i].isSame(views[i - 1]))
            failAt(file, cells, views[i].face(), "another baffle has the same vertices");
    for (Label f = 0; f < cells.faces.size(); ++f) {
        const Label other = pairs.partner[index(f)];
        if (other <= f) continue;
        const FaceView view(cells.faces[f], f);
        const auto found = std::lower_bound(
            views.begin(), views.end(), view, [](const FaceView& a, const FaceView& b) {
                return !a.isSame(b) && a < b;
            });
        if (found == views.end() || !found->isSame(view)) continue;
        sides[index(found->face())] = {f, other};
        pairs.partner[index(f)] = -1;
        pairs.partner[index(other)] = -1;
    }
    for (std::size_t i = 0; i < sides.size(); ++i)
        if (sides[i][0] < 0)
            failAt(file,
                   cells,
                   toLabel(i),
                   "no two cells have the face between them that its vertices make");
    return sides;
}

} // namespace polymesh::star
