// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/trim/dropOutside.h"

#include <algorithm>

namespace polymesh {

namespace {

/// New labels of the cells that stay, -1 for the others.
std::vector<Label>
numberKept(const Probe& probe, const std::vector<std::int8_t>& cellWinding, Label& count) {
    std::vector<Label> number(cellWinding.size(), -1);
    for (std::size_t c = 0; c < number.size(); ++c)
        if (probe.localCell[c] >= 0 || cellWinding[c] >= 1) number[c] = count++;
    return number;
}

template<class T>
void shrink(std::vector<T>& values, std::size_t size) {
    values.resize(size);
    values.shrink_to_fit();
}

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

    /// Moves the kept faces to the front, patch by patch.
    void dropFaces() {
        const Label oldInternal = mesh_.internalFaceCount();
        Label face = 0;
        Label corner = 0;
        std::size_t patch = 0;
        Label newInternal = 0;
        std::vector<Label> starts;
        auto probed = probe_.faces.begin();
        for (Label f = 0; f < mesh_.faceCount(); ++f) {
            if (f == oldInternal) newInternal = face;
            for (; patch < mesh_.patches.size() && f == mesh_.patches[patch].start; ++patch)
                starts.push_back(face);
            const bool isInternal = f < oldInternal;
            const Label own = numberOf(mesh_.owner[index(f)]);
            const Label other = isInternal ? numberOf(mesh_.neighbour[index(f)]) : own;
            const bool isKept = own >= 0 && other >= 0;
            if (probed != probe_.faces.end() && *probed == f) *probed++ = isKept ? face : -1;
            if (!isKept) continue;
            mesh_.owner[index(face)] = own;
            if (isInternal) mesh_.neighbour[index(face)] = other;
            const Label first = mesh_.faces.offsets[index(f)];
            const Label last = mesh_.faces.offsets[index(f) + 1];
            // offsets[face] still belongs to the new faces: the old ones are read ahead of it.
            for (Label i = first; i < last; ++i)
                mesh_.faces.values[index(corner++)] = mesh_.faces.values[index(i)];
            mesh_.faces.offsets[index(++face)] = corner;
        }
        if (oldInternal == mesh_.faceCount()) newInternal = face;
        finishFaces(face, corner, newInternal, starts);
    }

    void finishFaces(Label faces, Label corners, Label internal, std::vector<Label>& starts) {
        starts.resize(mesh_.patches.size(), faces);
        for (std::size_t p = 0; p < starts.size(); ++p) {
            mesh_.patches[p].start = starts[p];
            mesh_.patches[p].size = (p + 1 < starts.size() ? starts[p + 1] : faces) - starts[p];
        }
        // The small ones first: shrinking holds the old and the new array for a moment.
        shrink(mesh_.faces.offsets, index(faces) + 1);
        shrink(mesh_.owner, index(faces));
        shrink(mesh_.neighbour, index(internal));
        shrink(mesh_.faces.values, index(corners));
    }

    void dropPoints() {
        std::vector<Label> number(mesh_.points.size(), -1);
        for (const Label p : mesh_.faces.values)
            number[index(p)] = 0;
        Label count = 0;
        for (std::size_t p = 0; p < number.size(); ++p)
            if (number[p] == 0) {
                mesh_.points[index(count)] = mesh_.points[p];
                number[p] = count++;
            }
        shrink(mesh_.points, index(count));
        for (Label& p : mesh_.faces.values)
            p = number[index(p)];
        for (Label& p : probe_.nodes)
            p = number[index(p)];
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
    Label count = 0;
    const std::vector<Label> number = numberKept(probe, cellWinding, count);
    if (count > mesh.cellCount - mesh.cellCount / 5) return;
    Drop(mesh, probe, number).run(count);
    std::vector<std::int8_t> kept;
    for (std::size_t c = 0; c < number.size(); ++c)
        if (number[c] >= 0) kept.push_back(cellWinding[c]);
    cellWinding = std::move(kept);
}

} // namespace polymesh
