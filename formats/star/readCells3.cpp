// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/cellRecords.h"
#include "formats/star/cells3.h"
#include "formats/star/cells4.h"
#include "formats/star/textFields.h"
#include "formats/textScanner.h"
#include "libpolymesh/base/error.h"

#include <algorithm>
#include <array>

namespace polymesh::star {

namespace {

constexpr std::size_t cornerCount = 8;

/// One line: cell number, eight labels, cell table entry, type flag.
using Line = std::array<Label, 11>;
constexpr std::size_t tableField = 9;
constexpr std::size_t flagField = 10;
constexpr std::array<Field, 11> columns{{{0, 9},
                                         {15, 9},
                                         {24, 9},
                                         {33, 9},
                                         {42, 9},
                                         {51, 9},
                                         {60, 9},
                                         {69, 9},
                                         {78, 9},
                                         {87, 9},
                                         {96, 5}}};

class CellReader {
public:
    CellReader(const TextFile& file, const Vertices& vertices)
        : file_(file), vertices_(vertices), reader_(file, skipHeader(file, "")), builder_(file) {}

    CellRecords read() {
        while (reader_.findWord()) {
            const std::size_t place = reader_.place();
            const Line line = readLine();
            if (line[0] < 1) file_.fail(place, "the number of a cell must be positive");
            builder_.begin({line[0], line[tableField], place});
            if (line[flagField] == trimmedFlag)
                addTrimmed(line);
            else if (line[flagField] > 0)
                addRegular(line);
            else
                builder_.fail(fmt::format("type flag {} begins no cell: expected -1 for the first "
                                          "line of a trimmed cell, or a positive one",
                                          line[flagField]));
        }
        return std::move(builder_.records());
    }

private:
    Line readLine() {
        const std::size_t place = reader_.place();
        Line line{};
        if (!readNumbers(file_, reader_, columns, line))
            file_.fail(place,
                       "expected 11 whole numbers: cell, 8 vertices, cell table entry, type flag");
        return line;
    }

    Label pointOf(Label number) const {
        const Label point = vertices_.numbers.find(number);
        if (point < 0)
            builder_.fail(fmt::format("there is no vertex {} in {}", number, vertices_.fileName));
        return point;
    }

    void addRegular(const Line& line) {
        const auto labels = std::span(line).subspan(1, cornerCount);
        if (std::ranges::count(labels, 0) > 0) {
            addFlat(line);
            return;
        }
        std::array<Label, cornerCount> points{};
        std::ranges::transform(labels, points.begin(), [&](Label n) { return pointOf(n); });
        if (line[flagField] == solidCode) ++builder_.records().solidCells;
        builder_.addShape(BaseShape::hexahedron, points, regularFaceNumbers(BaseShape::hexahedron));
        builder_.end();
    }

    /// A record with fewer than eight vertices: a baffle, or what is no part of a mesh.
    void addFlat(const Line& line) {
        std::vector<Label> points;
        for (const Label number : std::span(line).subspan(1, cornerCount)) {
            if (number == 0) break;
            points.push_back(pointOf(number));
            if (points.size() > 1 && points.back() == points[points.size() - 2]) points.pop_back();
        }
        CellRecords& records = builder_.records();
        if (line[flagField] != baffleCode) {
            if (line[flagField] < baffleCode || line[flagField] > mostMaterialCode)
                builder_.fail("one of its eight vertices is 0");
            records.otherNumbers.push_back(line[0]);
            return;
        }
        if (points.size() < 3) builder_.fail("a baffle needs 3 vertices or more");
        records.baffles.add(points);
        records.baffleNumbers.push_back(line[0]);
        records.baffleTables.push_back(line[tableField]);
        records.bafflePlaces.push_back(builder_.head().place);
    }

    void addTrimmed(const Line& first) {
        std::array<Label, trimmedLabels> labels{};
        std::copy_n(first.begin() + 1, cornerCount, labels.begin());
        for (std::size_t i = 1; i < linesOfTrimmed; ++i) {
            const Line line = readContinuation(first[0]);
            std::copy_n(line.begin() + 1, cornerCount, labels.begin() + i * cornerCount);
        }
        const Label type = labels[trimTypeSlot];
        const TrimmedForm* form = formOfType(type, labels[0] != 0);
        if (form == nullptr)
            builder_.fail(fmt::format(
                "unknown type {} of a trimmed cell; known are 1, 2, 7, 8 and 85", type));
        const Label rotation = labels[rotationSlot];
        if (rotation < 0 || rotation >= rotationCount)
            builder_.fail(fmt::format("rotation {}: expected one in [0, 23]", rotation));
        if (rotation > 0)
            builder_.records().rotations.emplace_back(builder_.records().count(), rotation);
        addForm(*form, labels);
    }

    Line readContinuation(Label cell) {
        if (!reader_.findWord())
            reader_.fail(
                fmt::format("the file ends within the three lines of trimmed cell {}", cell));
        const std::size_t place = reader_.place();
        const Line line = readLine();
        if (line[0] != cell || line[flagField] != continuedFlag)
            file_.fail(
                place,
                fmt::format("expected a line of trimmed cell {} with type flag 0, found cell "
                            "{} with flag {}{}",
                            cell,
                            line[0],
                            line[flagField],
                            line[0] == cell ? "; cells with masks of removed corners in place of "
                                              "types are not read: write them from pro-STAR as "
                                              "version 4"
                                            : ""));
        return line;
    }

    void addForm(const TrimmedForm& form, std::span<const Label> labels) {
        std::array<Label, maxShapePoints> points{};
        for (std::size_t v = 0; v < form.slots.size(); ++v) {
            const Label number = labels[form.slots[v]];
            if (number == 0)
                builder_.fail(fmt::format("label {} is 0, where a trimmed cell of type {} has a "
                                          "vertex",
                                          form.slots[v] + 1,
                                          form.type));
            points[v] = pointOf(number);
        }
        builder_.addShape(form.base, std::span(points).first(form.slots.size()), form.faceNumbers);
        builder_.end();
    }

    const TextFile& file_;
    const Vertices& vertices_;
    NumberReader reader_;
    CellBuilder builder_;
};

} // namespace

CellRecords readCells3(const TextFile& file, const Vertices& vertices) {
    return CellReader(file, vertices).read();
}

} // namespace polymesh::star
