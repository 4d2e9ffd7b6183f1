// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/dropOutside.h"

#include "libpolymesh/base/freshList.h"
#include "libpolymesh/base/kept.h"
#include "libpolymesh/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace polymesh {

namespace {

class Drop {
public:
    Drop(PolyMesh& mesh, Probe& probe, const std::vector<Label>& cellNumber)
        : mesh_(mesh), probe_(probe), cellNumber_(cellNumber) {}

    void run(Label cellCount) {
        dropFaces();
        dropPoints();
        dropCellLabels();
        mesh_.cellCount = cellCount;
    }

private:
    Label numberOf(Label cell) const { return cellNumber_[index(cell)]; }

    /// Replaces each list of the mesh in turn, the small ones first: the old one goes before the
    /// next new one comes.
    void dropFaces() {
        const Label oldInternal = mesh_.internalFaceCount();
        const Kept faces(mesh_.faceCount(), [&](Label f) {
            return numberOf(mesh_.owner[index(f)]) >= 0 &&
                   (f >= oldInternal || numberOf(mesh_.neighbour[index(f)]) >= 0);
        });
        renumberPatches(faces);
        renumberProbe(faces);
        const auto newCells = [&](const std::vector<Label>& cells, Label oldCount) {
            std::vector<Label> kept = freshList<Label>(index(faces.countBefore(oldCount)));
            faces.forEach([&](Label f, Label to) {
                if (f < oldCount) kept[index(to)] = numberOf(cells[index(f)]);
            });
            return kept;
        };
        mesh_.neighbour = newCells(mesh_.neighbour, oldInternal);
        mesh_.owner = newCells(mesh_.owner, mesh_.faceCount());
        mesh_.faces = rowsOf(faces);
    }

    Rows<Label> rowsOf(const Kept& faces) {
        const Rows<Label>& old = mesh_.faces;
        Rows<Label> rows;
        rows.offsets = freshList<Label>(index(faces.count()) + 1);
        faces.forEach([&](Label f, Label to) { rows.offsets[index(to) + 1] = old.rowSize(f); });
        for (std::size_t f = 1; f < rows.offsets.size(); ++f)
            rows.offsets[f] += rows.offsets[f - 1];
        rows.values = freshList<Label>(index(rows.offsets.back()));
        faces.forEach([&](Label f, Label to) { std::ranges::copy(old[f], rows[to].begin()); });
        return rows;
    }

    void renumberPatches(const Kept& faces) {
        for (Patch& patch : mesh_.patches) {
            const Label end = faces.countBefore(patch.start + patch.size);
            patch.start = faces.countBefore(patch.start);
            patch.size = end - patch.start;
        }
    }

    /// The probe's faces become -1 where they go.
    void renumberProbe(const Kept& faces) {
        parallelFor(probe_.faceCount(), [&](Label i) {
            Label& f = probe_.faces[index(i)];
            f = faces.isKept(f) ? faces.countBefore(f) : -1;
        });
    }

    void dropPoints() {
        std::vector<std::uint8_t> used = freshList<std::uint8_t>(mesh_.points.size());
        parallelFor(toLabel(mesh_.faces.values.size()), [&](Label i) {
            std::atomic_ref<std::uint8_t>(used[index(mesh_.faces.values[index(i)])])
                .store(1, std::memory_order_relaxed);
        });
        const Kept kept(mesh_.pointCount(), [&](Label p) { return used[index(p)] != 0; });
        std::vector<Label> number = freshList<Label>(mesh_.points.size(), -1);
        std::vector<Vec3> points = freshList<Vec3>(index(kept.count()));
        kept.forEach([&](Label p, Label to) {
            number[index(p)] = to;
            points[index(to)] = mesh_.points[index(p)];
        });
        mesh_.points = std::move(points);
        const auto renumber = [&](std::vector<Label>& labels) {
            parallelFor(toLabel(labels.size()),
                        [&](Label i) { labels[index(i)] = number[index(labels[index(i)])]; });
        };
        renumber(mesh_.faces.values);
        renumber(probe_.nodes);
    }

    void dropCellLabels() {
        std::vector<Label> localCell;
        for (std::size_t c = 0; c < cellNumber_.size(); ++c)
            if (cellNumber_[c] >= 0) localCell.push_back(probe_.localCell[c]);
        probe_.localCell = std::move(localCell);
        for (Label& c : probe_.cells)
            c = numberOf(c);
        for (Zone& zone : mesh_.cellZones) {
            std::vector<Label> kept;
            for (const Label c : zone.labels)
                if (numberOf(c) >= 0) kept.push_back(numberOf(c));
            zone.labels = std::move(kept);
        }
    }

    PolyMesh& mesh_;
    Probe& probe_;
    const std::vector<Label>& cellNumber_;
};

} // namespace

void dropOutside(PolyMesh& mesh, Probe& probe, std::vector<std::int8_t>& cellWinding) {
    const Kept cells(mesh.cellCount, [&](Label c) {
        return probe.localCell[index(c)] >= 0 || cellWinding[index(c)] >= 1;
    });
    if (cells.count() > mesh.cellCount - mesh.cellCount / 5) return;
    std::vector<Label> number = freshList<Label>(index(mesh.cellCount), -1);
    std::vector<std::int8_t> kept(index(cells.count()));
    cells.forEach([&](Label c, Label to) {
        number[index(c)] = to;
        kept[index(to)] = cellWinding[index(c)];
    });
    Drop(mesh, probe, number).run(cells.count());
    cellWinding = std::move(kept);
}

} // namespace polymesh
