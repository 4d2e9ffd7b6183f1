// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/cellRecords.h"
#include "formats/star/cells4.h"
#include "libpolymesh/base/error.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace polymesh::star {

namespace {

constexpr Label mostLabel = std::numeric_limits<Label>::max();

struct Record {
    Label number = 0;
    Label shape = 0;
    Label labelCount = 0;
    Label table = 0;
    Label material = 0;
    std::size_t place = 0;
};

std::optional<BaseShape> regularShape(Label code) {
    switch (code) {
    case hexahedronCode:
        return BaseShape::hexahedron;
    case prismCode:
        return BaseShape::prism;
    case tetrahedronCode:
        return BaseShape::tetrahedron;
    case pyramidCode:
        return BaseShape::pyramid;
    default:
        return std::nullopt;
    }
}

/// Reads the file record by record.
class CellReader {
public:
    CellReader(const TextFile& file, const Vertices& vertices)
        : file_(file),
          vertices_(vertices),
          reader_(file, skipHeader(file, "PROSTAR_CELL")),
          builder_(file) {}

    CellRecords read() {
        while (reader_.findWord()) {
            readRecord();
            if (record_.shape == shellCode && record_.material == baffleCode)
                addBaffle();
            else if (record_.shape <= shellCode)
                builder_.records().otherNumbers.push_back(record_.number);
            else
                addCell();
        }
        return std::move(builder_.records());
    }

private:
    void readRecord() {
        record_.place = reader_.place();
        record_.number = reader_.label("the number of a cell", 1, mostLabel);
        record_.shape = reader_.label("the shape of a cell", 0, mostLabel);
        checkShape();
        record_.labelCount = reader_.label("the number of labels of a cell", 1, mostLabel);
        record_.table = reader_.label("the cell table number", 0, mostLabel);
        record_.material = reader_.label("the type of a cell", 0, mostLabel);
        labels_.clear();
        for (Label i = 0; i < record_.labelCount; ++i) {
            if (i % labelsPerLine == 0) readLineStart();
            labels_.push_back(reader_.label("a label of a cell", 0, mostLabel));
        }
        builder_.begin({record_.number, record_.table, record_.place});
    }

    void checkShape() const {
        const Label shape = record_.shape;
        const bool isKnown = (shape >= pointCode && shape <= shellCode) || regularShape(shape) ||
                             shape == polyhedronCode;
        if (!isKnown)
            file_.fail(record_.place,
                       fmt::format("cell {}: unknown shape {}; known are 1 to 3 (point, line, "
                                   "shell), 11 to 14 (hexahedron, prism, tetrahedron, pyramid) "
                                   "and 255 (polyhedron)",
                                   record_.number,
                                   shape));
    }

    void readLineStart() {
        reader_.findWord();
        const std::size_t place = reader_.place();
        const Label number = reader_.label("the number of a cell", 1, mostLabel);
        if (number != record_.number)
            file_.fail(place,
                       fmt::format("expected a line with labels of cell {}, found one of cell {}",
                                   record_.number,
                                   number));
    }

    Label pointOf(Label number) const {
        const Label point = vertices_.numbers.find(number);
        if (point < 0)
            builder_.fail(fmt::format("there is no vertex {} in {}", number, vertices_.fileName));
        return point;
    }

    /// Replaces the labels from `first` on by points.
    void findPoints(std::size_t first) {
        for (std::size_t i = first; i < labels_.size(); ++i)
            labels_[i] = pointOf(labels_[i]);
    }

    void addBaffle() {
        findPoints(0);
        CellRecords& records = builder_.records();
        if (labels_.size() < 3) builder_.fail("a baffle needs 3 vertices or more");
        records.baffles.add(labels_);
        records.baffleNumbers.push_back(record_.number);
        records.baffleTables.push_back(record_.table);
        records.bafflePlaces.push_back(record_.place);
    }

    void addCell() {
        if (record_.material == solidCode) ++builder_.records().solidCells;
        if (const auto shape = regularShape(record_.shape))
            addRegular(*shape);
        else
            addPolyhedron();
    }

    void addRegular(BaseShape shape) {
        const std::size_t wanted = tableOf(shape).pointCount;
        if (labels_.size() != wanted)
            builder_.fail(fmt::format(
                "a {} has {} vertices, not {}", tableOf(shape).name, wanted, labels_.size()));
        findPoints(0);
        builder_.addShape(shape, labels_, regularFaceNumbers(shape));
        builder_.end();
    }

    /// The labels are an index of where each face begins, and where the last ends, then vertices.
    void addPolyhedron() {
        const Label count = toLabel(labels_.size());
        const Label faceCount = labels_[0] - 1;
        if (faceCount < 4 || faceCount >= count)
            builder_.fail(fmt::format(
                "{} faces, by the first of its {} labels: expected 4 or more", faceCount, count));
        const auto offsets = std::span(labels_).first(index(faceCount) + 1);
        const bool isAscending = std::ranges::is_sorted(offsets);
        if (!isAscending || offsets.back() != count)
            builder_.fail(
                fmt::format("its index of faces must ascend to the number of labels, {}", count));
        findPoints(offsets.size());
        for (std::size_t f = 0; f + 1 < offsets.size(); ++f)
            builder_.addFace(
                std::span(labels_).subspan(index(offsets[f]), index(offsets[f + 1] - offsets[f])),
                toLabel(f + 1));
        builder_.endPolyhedron();
    }

    const TextFile& file_;
    const Vertices& vertices_;
    NumberReader reader_;
    CellBuilder builder_;
    Record record_;
    std::vector<Label> labels_; // of the record
};

} // namespace

CellRecords readCells4(const TextFile& file, const Vertices& vertices) {
    return CellReader(file, vertices).read();
}

} // namespace polymesh::star
