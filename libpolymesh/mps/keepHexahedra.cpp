// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/mps/keepHexahedra.h"

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/mps/halvedFaces.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace polymesh {

namespace {

/// A face of the result, from its owner to its neighbour.
struct ResultFace {
    HalvedPiece points;
    Label owner = -1;
    Label neighbour = -1;  // -1: boundary
    Label source = -1;     // the undivided mesh's face that it is a piece of; -1: inside a cell
    bool isTurned = false; // against that
};

class Partial {
public:
    Partial(const Divisible& divisible, const std::vector<Fate>& fates, const PolyMesh& divided)
        : mesh_(divisible.mesh),
          plan_(divisible.plan),
          fates_(fates),
          divided_(divided),
          halved_(divisible.mesh, divisible.plan, fates) {}

    PartlyDivided make() {
        numberCells();
        addDividedFaces();
        addOtherFaces();
        for (Label c = 0; c < mesh_.cellCount; ++c)
            if (fates_[index(c)] == Fate::layer) addInside(c);
        sortFaces();
        fillMesh();
        fillZones();
        return {std::move(result_), std::move(first_)};
    }

private:
    bool isDivided(Label cell) const { return fates_[index(cell)] == Fate::divided; }

    Label cellsOf(Label cell) const {
        const std::size_t c = index(cell);
        if (fates_[c] == Fate::whole) return 1;
        if (fates_[c] == Fate::divided) return plan_.firstPart[c + 1] - plan_.firstPart[c];
        Label pieces = 0;
        for (const Label f : plan_.cellFaces[cell])
            pieces += toLabel(halved_.piecesOf(f).size());
        return pieces;
    }

    void numberCells() {
        first_.assign(index(mesh_.cellCount) + 1, 0);
        parallelFor(mesh_.cellCount, [&](Label c) { first_[index(c) + 1] = cellsOf(c); });
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        sourceOfPart_.resize(index(divided_.cellCount));
        parallelFor(mesh_.cellCount, [&](Label c) {
            std::fill(sourceOfPart_.begin() + plan_.firstPart[index(c)],
                      sourceOfPart_.begin() + plan_.firstPart[index(c) + 1],
                      c);
        });
    }

    /// The result cell at a piece of a face of a cell that is not divided.
    Label cellAt(Label cell, Label face, Label piece) const {
        Label at = first_[index(cell)];
        if (fates_[index(cell)] == Fate::whole) return at;
        for (const Label f : plan_.cellFaces[cell]) {
            if (f == face) break;
            at += toLabel(halved_.piecesOf(f).size());
        }
        return at + piece;
    }

    Label cellOfPart(Label part) const {
        const Label source = sourceOfPart_[index(part)];
        return first_[index(source)] + part - plan_.firstPart[index(source)];
    }

    /// Adds a face that runs from `from` to `to`, or to the boundary.
    void add(HalvedPiece points, Label from, Label to, Label source) {
        const bool isTurned = to >= 0 && to < from;
        if (isTurned) {
            std::reverse(points.begin() + 1, points.end());
            std::swap(from, to);
        }
        faces_.push_back({std::move(points), from, to, source, isTurned});
    }

    /// The undivided face and the place of its corner that a face of the divided mesh belongs to.
    std::pair<Label, Label> cornerOf(std::span<const Label> points) const {
        const auto& layout = plan_.layout;
        const auto centre = std::ranges::find_if(
            points, [&](Label p) { return p >= layout.firstFace && p < layout.firstCell; });
        const auto node =
            std::ranges::find_if(points, [&](Label p) { return p < layout.firstEdge; });
        if (centre == points.end() || node == points.end()) return {-1, -1};
        const Label face = *centre - layout.firstFace;
        const auto corners = mesh_.faces[face];
        return {face, static_cast<Label>(std::ranges::find(corners, *node) - corners.begin())};
    }

    /// The faces of divided cells, from the divided mesh.
    void addDividedFaces() {
        for (Label f = 0; f < divided_.faceCount(); ++f) {
            const Label owner = divided_.owner[index(f)];
            const Label other = divided_.isInternal(f) ? divided_.neighbour[index(f)] : -1;
            const Label a = sourceOfPart_[index(owner)];
            const Label b = other >= 0 ? sourceOfPart_[index(other)] : -1;
            const bool isBehind = b >= 0 && isDivided(b);
            if (!isDivided(a) && !isBehind) continue;
            const auto points = divided_.faces[f];
            const auto [face, corner] = a == b ? std::pair<Label, Label>(-1, -1) : cornerOf(points);
            const Label from = isDivided(a) ? cellOfPart(owner) : cellAt(a, face, corner);
            const Label to = b < 0 ? -1 : isBehind ? cellOfPart(other) : cellAt(b, face, corner);
            add(HalvedPiece(points.begin(), points.end()), from, to, face);
        }
    }

    /// The faces that no divided cell has.
    void addOtherFaces() {
        for (Label f = 0; f < mesh_.faceCount(); ++f) {
            const Label a = mesh_.owner[index(f)];
            const Label b = mesh_.isInternal(f) ? mesh_.neighbour[index(f)] : -1;
            if (isDivided(a) || (b >= 0 && isDivided(b))) continue;
            const HalvedPieces pieces = halved_.piecesOf(f);
            for (std::size_t i = 0; i < pieces.size(); ++i)
                add(pieces[i], cellAt(a, f, toLabel(i)), b >= 0 ? cellAt(b, f, toLabel(i)) : -1, f);
        }
    }

    /// The triangles between the cones of a cell of the layer: one at each edge of its pieces.
    void addInside(Label cell) {
        struct Use {
            Label low;
            Label high;
            Label cone;
            bool isForward; // seen from outside
        };

        std::vector<Use> uses;
        Label cone = first_[index(cell)];
        for (const Label f : plan_.cellFaces[cell]) {
            const bool isOwner = mesh_.owner[index(f)] == cell;
            for (const HalvedPiece& piece : halved_.piecesOf(f)) {
                for (std::size_t i = 0; i < piece.size(); ++i) {
                    const Label a = piece[i];
                    const Label b = piece[(i + 1) % piece.size()];
                    uses.push_back({std::min(a, b), std::max(a, b), cone, (a < b) == isOwner});
                }
                ++cone;
            }
        }
        std::ranges::sort(uses, [](const Use& a, const Use& b) {
            return std::tie(a.low, a.high, a.isForward) < std::tie(b.low, b.high, b.isForward);
        });
        const Label centre = plan_.layout.firstCell + cell;
        for (std::size_t i = 0; i < uses.size(); i += 2) // backward, then forward
            add({uses[i].low, uses[i].high, centre}, uses[i].cone, uses[i + 1].cone, -1);
    }

    std::size_t patchOf(Label source) const {
        const auto above = std::ranges::upper_bound(mesh_.patches, source, {}, &Patch::start);
        return static_cast<std::size_t>(above - mesh_.patches.begin()) - 1;
    }

    /// Internal faces by their cells, then those of the patches by the faces they come of.
    void sortFaces() {
        std::ranges::stable_sort(faces_, [](const ResultFace& a, const ResultFace& b) {
            const bool isA = a.neighbour < 0;
            const bool isB = b.neighbour < 0;
            if (isA != isB) return isB;
            if (isA) return a.source < b.source;
            return std::tie(a.owner, a.neighbour) < std::tie(b.owner, b.neighbour);
        });
    }

    void fillMesh() {
        std::vector<std::uint8_t> isUsed(divided_.points.size(), 0);
        for (const ResultFace& face : faces_)
            for (const Label p : face.points)
                isUsed[index(p)] = 1;
        pointLabels_.assign(divided_.points.size(), -1);
        for (std::size_t p = 0; p < isUsed.size(); ++p)
            if (isUsed[p] != 0) {
                pointLabels_[p] = toLabel(result_.points.size());
                result_.points.push_back(divided_.points[p]);
            }
        result_.cellCount = first_.back();
        result_.patches = mesh_.patches;
        for (Patch& patch : result_.patches)
            patch.size = 0;
        for (const ResultFace& face : faces_) {
            HalvedPiece points = face.points;
            for (Label& p : points)
                p = pointLabels_[index(p)];
            result_.faces.add(std::span<const Label>(points.data(), points.size()));
            result_.owner.push_back(face.owner);
            if (face.neighbour >= 0) result_.neighbour.push_back(face.neighbour);
            if (face.neighbour < 0) ++result_.patches[patchOf(face.source)].size;
        }
        Label start = result_.internalFaceCount();
        for (Patch& patch : result_.patches) {
            patch.start = start;
            start += patch.size;
        }
    }

    void fillZones() {
        for (Zone zone : mesh_.cellZones) {
            const std::vector<Label> cells = std::exchange(zone.labels, {});
            for (const Label c : cells)
                for (Label r = first_[index(c)]; r < first_[index(c) + 1]; ++r)
                    zone.labels.push_back(r);
            result_.cellZones.push_back(std::move(zone));
        }
        for (Zone zone : divided_.pointZones) {
            std::erase_if(zone.labels, [&](Label p) { return pointLabels_[index(p)] < 0; });
            for (Label& p : zone.labels)
                p = pointLabels_[index(p)];
            result_.pointZones.push_back(std::move(zone));
        }
        for (const Zone& zone : mesh_.faceZones)
            result_.faceZones.push_back(piecesOf(zone));
    }

    /// The zone of what has become of a zone's faces.
    Zone piecesOf(const Zone& zone) const {
        enum : std::uint8_t { out, in, flipped };

        std::vector<std::uint8_t> state(index(mesh_.faceCount()), out);
        for (std::size_t i = 0; i < zone.labels.size(); ++i)
            state[index(zone.labels[i])] = !zone.flip.empty() && zone.flip[i] ? flipped : in;
        Zone pieces{zone.name, {}, {}};
        for (Label f = 0; f < toLabel(faces_.size()); ++f) {
            const ResultFace& face = faces_[index(f)];
            if (face.source < 0 || state[index(face.source)] == out) continue;
            pieces.labels.push_back(f);
            pieces.flip.push_back((state[index(face.source)] == flipped) != face.isTurned);
        }
        return pieces;
    }

    const PolyMesh& mesh_;
    const SubdivisionPlan& plan_;
    const std::vector<Fate>& fates_;
    const PolyMesh& divided_;
    const HalvedFaces halved_;
    std::vector<Label> first_;
    std::vector<Label> sourceOfPart_; // the undivided cell of each cell of the divided mesh
    std::vector<ResultFace> faces_;
    std::vector<Label> pointLabels_;
    PolyMesh result_;
};

} // namespace

PartlyDivided
keepHexahedra(const Divisible& divisible, const std::vector<Fate>& fates, const PolyMesh& divided) {
    return Partial(divisible, fates, divided).make();
}

} // namespace polymesh
