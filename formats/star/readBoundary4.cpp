// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/star/boundaryRecords.h"
#include "formats/textScanner.h"
#include "libpolymesh/base/error.h"

#include <algorithm>
#include <limits>

namespace polymesh::star {

namespace {

constexpr Label mostLabel = std::numeric_limits<Label>::max();

class BoundaryReader {
public:
    BoundaryReader(const TextFile& file, const CellMesh& mesh)
        : file_(file),
          mesh_(mesh),
          reader_(file, skipHeader(file, "PROSTAR_BOUNDARY")),
          cells_(mesh.cells.numbers),
          baffles_(mesh.cells.baffleNumbers),
          others_(mesh.cells.otherNumbers),
          isListed_(mesh.cells.faceTotal(), 0) {}

    BoundaryRecords read() {
        while (reader_.findWord())
            readRecord();
        noteLeftOut(records_, file_, internal_, "lie between two cells");
        noteLeftOut(records_, file_, repeated_, "name a face that an earlier one names");
        noteLeftOut(records_, file_, onOthers_, "belong to shells, lines or points");
        return std::move(records_);
    }

private:
    void readRecord() {
        place_ = reader_.place();
        reader_.label("the number of a boundary", 0, mostLabel);
        const Label cell = reader_.label("the number of a cell", 1, mostLabel);
        const Label face = reader_.label("the number of a face", 0, mostLabel);
        region_ = reader_.label("the number of a region", 0, mostLabel);
        reader_.label(
            "the fifth number of a boundary", std::numeric_limits<Label>::min(), mostLabel);
        const std::string_view type = reader_.wordInLine();
        reader_.restOfLine();
        if (region_ == 0) return;
        records_.types.try_emplace(region_, type);
        if (const Label known = cells_.find(cell); known >= 0) {
            add(faceOf(known, face));
        } else if (const Label baffle = baffles_.find(cell); baffle >= 0) {
            for (const Label side : mesh_.baffles[index(baffle)])
                if (isListed_[index(side)] == 0) add(side); // a baffle may have a record a side
        } else if (others_.find(cell) >= 0) {
            ++onOthers_;
        } else {
            file_.fail(place_, fmt::format("there is no cell {}", cell));
        }
    }

    Label faceOf(Label cell, Label number) const {
        const CellRecords& cells = mesh_.cells;
        const Label first = cells.firstFaces[index(cell)];
        const Label last = cells.firstFaces[index(cell) + 1];
        const auto isIt = [&](Label f) {
            return f >= first && f < last && cells.faceNumbers[index(f)] == number;
        };
        // Faces of polyhedra are numbered as they stand, unless one of them has collapsed.
        if (number < last - first + 1 && isIt(first + number - 1)) return first + number - 1;
        for (Label f = first; f < last; ++f)
            if (isIt(f)) return f;
        file_.fail(place_,
                   fmt::format("cell {} has no face {}", cells.numbers[index(cell)], number));
    }

    void add(Label face) {
        if (mesh_.pairs.partner[index(face)] >= 0) {
            ++internal_;
        } else if (isListed_[index(face)] != 0) {
            ++repeated_;
        } else {
            isListed_[index(face)] = 1;
            records_.faces.push_back(face);
            records_.regions.push_back(region_);
        }
    }

    const TextFile& file_;
    const CellMesh& mesh_;
    NumberReader reader_;
    NumberMap cells_;
    NumberMap baffles_;
    NumberMap others_;
    std::vector<char> isListed_;
    BoundaryRecords records_;
    std::size_t place_ = 0;
    Label region_ = 0;
    Label internal_ = 0;
    Label repeated_ = 0;
    Label onOthers_ = 0;
};

} // namespace

BoundaryRecords readBoundary4(const TextFile& file, const CellMesh& mesh) {
    return BoundaryReader(file, mesh).read();
}

} // namespace polymesh::star
