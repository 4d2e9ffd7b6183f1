// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/couples.h"

#include "formats/star/cells3.h"
#include "libpolymesh/base/error.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>

namespace polymesh::star {

namespace {

constexpr Label mostLabel = std::numeric_limits<Label>::max();
constexpr Label integralFlag = 1;

using Loop = std::vector<Label>;
using Edge = std::pair<Label, Label>;

/// Turns the edge round.
Edge turned(const Edge& edge) {
    return {edge.second, edge.first};
}

/// The outline of loops that tile a surface: the directed edges of which none is the other way
/// round of another; from each point the next one. None when it is not one closed curve.
std::optional<Loop> outlineOf(const std::vector<Loop>& tiles) {
    std::set<Edge> edges;
    for (const Loop& tile : tiles)
        for (std::size_t i = 0; i < tile.size(); ++i)
            if (!edges.emplace(tile[i], tile[(i + 1) % tile.size()]).second) return std::nullopt;
    std::map<Label, Label> next;
    for (const Edge& edge : edges)
        if (!edges.contains(turned(edge)) && !next.insert(edge).second) return std::nullopt;
    if (next.empty()) return std::nullopt;
    Loop outline{next.begin()->first};
    while (outline.size() < next.size()) {
        const auto step = next.find(outline.back());
        if (step == next.end()) return std::nullopt;
        outline.push_back(step->second);
    }
    const auto last = next.find(outline.back());
    const bool isClosed = last != next.end() && last->second == outline.front();
    return isClosed ? std::optional(std::move(outline)) : std::nullopt;
}

/// The points of `outline` from corner to corner of `face`, one list for each edge of the face,
/// without the corners; none when the corners are not on the outline in this order.
std::optional<std::vector<Loop>> sidesOf(std::span<const Label> face, const Loop& outline) {
    const auto start = std::ranges::find(outline, face[0]);
    if (start == outline.end()) return std::nullopt;
    Loop around(start, outline.end());
    around.insert(around.end(), outline.begin(), start);
    std::vector<Loop> sides(1);
    for (std::size_t i = 1; i < around.size(); ++i) {
        if (sides.size() < face.size() && around[i] == face[sides.size()])
            sides.emplace_back();
        else
            sides.back().push_back(around[i]);
    }
    return sides.size() == face.size() ? std::optional(std::move(sides)) : std::nullopt;
}

/// Reads couples and applies them.
class CoupleJoiner {
public:
    CoupleJoiner(const TextFile& file, CellRecords& cells)
        : file_(file), cells_(cells), reader_(file, 0), numbers_(cells.numbers) {}

    void join() {
        while (reader_.findWord())
            readCouple();
        if (!tiles_.empty()) rebuild();
        if (left_ > 0)
            cells_.notes.push_back(
                fmt::format("{}: {} couples are not integral and are left out; their faces stay "
                            "boundary faces",
                            file_.name,
                            left_));
    }

private:
    void readCouple() {
        place_ = reader_.place();
        number_ = reader_.label("the number of a couple", 0, mostLabel);
        const Label entries = reader_.label("the number of entries of a couple", 1, mostLabel);
        const Label flag =
            reader_.label("the type of a couple", std::numeric_limits<Label>::min(), mostLabel);
        const Label master = readFace();
        std::vector<Loop> tiles;
        for (Label i = 1; i < entries; ++i) {
            const auto loop = cells_.faces[readFace()];
            tiles.emplace_back(loop.rbegin(), loop.rend()); // as the master sees it
        }
        const bool isJoined = flag == integralFlag && addTiles(master, std::move(tiles));
        left_ += isJoined ? 0 : 1;
    }

    Label readFace() {
        const std::size_t place = reader_.place();
        const Label cellNumber = reader_.label("the number of a cell", 1, mostLabel);
        const Label faceNumber = reader_.label("the number of a face", 1, mostLabel);
        const Label cell = numbers_.find(cellNumber);
        if (cell < 0) file_.fail(place_, fmt::format("there is no cell {}", cellNumber));
        const Label wanted = unrotated(cell, faceNumber);
        const Label first = cells_.firstFaces[index(cell)];
        const Label last = cells_.firstFaces[index(cell) + 1];
        for (Label f = first; f < last; ++f)
            if (cells_.faceNumbers[index(f)] == wanted) return f;
        file_.fail(place, fmt::format("cell {} has no face {}", cellNumber, faceNumber));
    }

    /// Faces 1 to 6 of a rotated cell are numbered by what they are after the rotation.
    Label unrotated(Label cell, Label faceNumber) const {
        const auto found =
            std::ranges::lower_bound(cells_.rotations, cell, {}, &std::pair<Label, Label>::first);
        const bool isRotated = found != cells_.rotations.end() && found->first == cell;
        return isRotated && faceNumber <= 6 ? unrotatedFace(found->second, faceNumber) : faceNumber;
    }

    /// False when the tiles do not cover the face.
    bool addTiles(Label master, std::vector<Loop> tiles) {
        const std::optional<Loop> outline = outlineOf(tiles);
        if (!outline) return false;
        const auto face = cells_.faces[master];
        const std::optional<std::vector<Loop>> sides = sidesOf(face, *outline);
        if (!sides) return false;
        for (std::size_t i = 0; i < face.size(); ++i)
            if (!(*sides)[i].empty())
                addSide({face[i], face[i + 1 == face.size() ? 0 : i + 1]}, (*sides)[i]);
        if (!tiles_.emplace(master, std::move(tiles)).second)
            fail("another couple replaces the same face");
        places_[master] = place_;
        return true;
    }

    /// Points on an edge, kept for the direction in which its ends ascend.
    void addSide(const Edge& edge, Loop points) {
        const bool ascends = edge.first < edge.second;
        if (!ascends) std::ranges::reverse(points);
        const auto [side, isNew] = pointsOn_.emplace(ascends ? edge : turned(edge), points);
        if (!isNew && side->second != points)
            fail("another couple has other vertices on the same edge");
    }

    [[noreturn]] void fail(std::string_view message) const {
        file_.fail(place_, fmt::format("couple {}: {}", number_, message));
    }

    /// The loop with the points that are on its edges.
    Loop divided(std::span<const Label> loop) const {
        Loop result;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Edge edge{loop[i], loop[i + 1 == loop.size() ? 0 : i + 1]};
            const bool ascends = edge.first < edge.second;
            result.push_back(edge.first);
            const auto found = pointsOn_.find(ascends ? edge : turned(edge));
            if (found == pointsOn_.end()) continue;
            const Loop& points = found->second;
            if (ascends)
                result.insert(result.end(), points.begin(), points.end());
            else
                result.insert(result.end(), points.rbegin(), points.rend());
        }
        return result;
    }

    void addFace(CellBuilder& builder, std::span<const Label> loop, Label faceNumber) const {
        Loop whole = divided(loop);
        // Points on an edge may end edges that have points themselves; a chain that has no end
        // names a point twice, which the builder refuses.
        for (std::size_t size = loop.size(); whole.size() > size && size < mostCorners;) {
            size = whole.size();
            whole = divided(whole);
        }
        builder.addFace(whole, faceNumber);
    }

    void addCellFaces(CellBuilder& builder, Label cell) const {
        for (Label f = cells_.firstFaces[index(cell)]; f < cells_.firstFaces[index(cell) + 1];
             ++f) {
            const Label number = cells_.faceNumbers[index(f)];
            const auto found = tiles_.find(f);
            if (found == tiles_.end())
                addFace(builder, cells_.faces[f], number);
            else
                for (const Loop& tile : found->second)
                    addFace(builder, tile, number);
        }
    }

    void rebuild() {
        CellBuilder builder(file_);
        for (Label c = 0; c < cells_.count(); ++c) {
            const auto master = tiles_.lower_bound(cells_.firstFaces[index(c)]);
            const bool isMaster =
                master != tiles_.end() && master->first < cells_.firstFaces[index(c) + 1];
            const std::size_t place = isMaster ? places_.at(master->first) : 0;
            builder.begin({cells_.numbers[index(c)], cells_.tables[index(c)], place});
            addCellFaces(builder, c);
            builder.endPolyhedron();
        }
        cells_.faces = std::move(builder.records().faces);
        cells_.faceNumbers = std::move(builder.records().faceNumbers);
        cells_.firstFaces = std::move(builder.records().firstFaces);
    }

    static constexpr std::size_t mostCorners = 4096;

    const TextFile& file_;
    CellRecords& cells_;
    NumberReader reader_;
    NumberMap numbers_;
    std::map<Label, std::vector<Loop>> tiles_; // of the faces that are replaced
    std::map<Label, std::size_t> places_;      // of the couples of these faces
    std::map<Edge, Loop> pointsOn_;            // points on edges
    std::size_t place_ = 0;
    Label number_ = 0;
    Label left_ = 0;
};

} // namespace

void joinCouples(const TextFile& file, CellRecords& cells) {
    CoupleJoiner(file, cells).join();
}

} // namespace polymesh::star
