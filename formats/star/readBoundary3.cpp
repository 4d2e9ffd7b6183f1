// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/boundaryRecords.h"
#include "formats/star/textFields.h"
#include "libpolymesh/base/error.h"

#include <algorithm>
#include <optional>

namespace polymesh::star {

namespace {

/// One record: its number, four vertices, region, a number without use; then a word, the type.
using Numbers = std::array<Label, 7>;
constexpr std::array<Field, 7> columns{
    {{0, 8}, {14, 9}, {23, 9}, {32, 9}, {41, 9}, {50, 7}, {57, 7}}};
constexpr std::size_t regionField = 5;

/// The boundary faces at each point.
Rows<Label> boundaryFacesAt(const CellMesh& mesh) {
    Rows<Label> rows;
    rows.offsets.assign(mesh.vertices.points.size() + 1, 0);
    const Rows<Label>& faces = mesh.cells.faces;
    const auto forBoundary = [&](auto&& body) {
        for (Label f = 0; f < faces.size(); ++f)
            if (mesh.pairs.partner[index(f)] < 0)
                for (const Label p : faces[f])
                    body(f, p);
    };
    forBoundary([&](Label, Label p) { ++rows.offsets[index(p) + 1]; });
    for (std::size_t p = 1; p < rows.offsets.size(); ++p)
        rows.offsets[p] += rows.offsets[p - 1];
    rows.values.resize(index(rows.offsets.back()));
    std::vector<Label> next(rows.offsets.begin(), rows.offsets.end() - 1);
    forBoundary([&](Label f, Label p) { rows.values[index(next[index(p)]++)] = f; });
    return rows;
}

class BoundaryReader {
public:
    BoundaryReader(const TextFile& file, const CellMesh& mesh)
        : file_(file),
          mesh_(mesh),
          reader_(file, skipHeader(file, "")),
          facesAt_(boundaryFacesAt(mesh)),
          isListed_(mesh.cells.faceTotal(), 0) {}

    BoundaryRecords read() {
        while (reader_.findWord())
            readRecord();
        noteLeftOut(records_, file_, unmatched_, "fit no boundary face");
        noteLeftOut(records_, file_, repeated_, "name a face that an earlier one names");
        return std::move(records_);
    }

private:
    void readRecord() {
        const std::size_t place = reader_.place();
        Numbers numbers{};
        std::string_view type;
        if (!readNumbers(file_, reader_, columns, numbers, &type))
            file_.fail(place, "expected 7 whole numbers: boundary, 4 vertices, region, patch");
        const Label region = numbers[regionField];
        if (region < 0) file_.fail(place, fmt::format("region {} is negative", region));
        findPoints(place, std::span(numbers).subspan(1, 4));
        if (region == 0) return;
        records_.types.try_emplace(region, type.substr(0, type.find_first_of(" \t")));
        const std::optional<Label> face = findFace();
        if (!face) {
            ++unmatched_;
        } else if (isListed_[index(*face)] != 0) {
            ++repeated_;
        } else {
            isListed_[index(*face)] = 1;
            records_.faces.push_back(*face);
            records_.regions.push_back(region);
        }
    }

    /// A triangle repeats its last vertex, or has 0 as its fourth.
    void findPoints(std::size_t place, std::span<const Label> numbers) {
        corners_.clear();
        for (const Label number : numbers) {
            if (number == 0 && corners_.size() == 3) continue;
            const Label point = mesh_.vertices.numbers.find(number);
            if (point < 0)
                file_.fail(
                    place,
                    fmt::format("there is no vertex {} in {}", number, mesh_.vertices.fileName));
            if (std::ranges::find(corners_, point) == corners_.end()) corners_.push_back(point);
        }
        if (corners_.size() < 3) file_.fail(place, "fewer than three different vertices");
    }

    /// How well a face fits, less is better; none when it lacks a corner.
    std::optional<std::array<Label, 4>> fit(Label face) const {
        const auto loop = mesh_.cells.faces[face];
        std::array<std::size_t, 4> places{};
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            const auto found = std::ranges::find(loop, corners_[i]);
            if (found == loop.end()) return std::nullopt;
            places[i] = static_cast<std::size_t>(found - loop.begin());
        }
        const auto step = [&](std::size_t i) {
            return (places[i + 1] + loop.size() - places[i]) % loop.size();
        };
        const bool isSameWay = step(0) + step(1) < loop.size();
        return std::array<Label, 4>{
            toLabel(loop.size()), isListed_[index(face)], isSameWay ? 0 : 1, face};
    }

    std::optional<Label> findFace() const {
        const Label rarest =
            *std::ranges::min_element(corners_, {}, [&](Label p) { return facesAt_.rowSize(p); });
        std::optional<std::array<Label, 4>> best;
        for (const Label face : facesAt_[rarest])
            if (const auto found = fit(face); found && (!best || *found < *best)) best = found;
        return best ? std::optional((*best)[3]) : std::nullopt;
    }

    const TextFile& file_;
    const CellMesh& mesh_;
    NumberReader reader_;
    Rows<Label> facesAt_;
    std::vector<char> isListed_;
    std::vector<Label> corners_; // points of the record
    BoundaryRecords records_;
    Label unmatched_ = 0;
    Label repeated_ = 0;
};

} // namespace

BoundaryRecords readBoundary3(const TextFile& file, const CellMesh& mesh) {
    return BoundaryReader(file, mesh).read();
}

} // namespace polymesh::star
