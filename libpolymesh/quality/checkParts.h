// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The parts of checkMesh (checks.h), which share what has been computed of the mesh.

#include "libpolymesh/base/parallel.h"
#include "libpolymesh/base/rows.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/quality/checks.h"

#include <algorithm>
#include <vector>

namespace polymesh {

/// The other side of faces on coupled patches: the cell that OpenFOAM sees through a cyclic patch.
struct Coupling {
    std::vector<char> isCoupled;     // one per boundary face
    std::vector<char> isMaster;      // on the first patch of its pair
    std::vector<Vec3> cellCentres;   // [m] moved to this side
    std::vector<double> cellVolumes; // [m^3]
    double averageMismatch = 0;      // [m] between the points of the two sides
};

/// Pairs `cyclic` patches with their neighbourPatch by translation. Other coupled types count as
/// boundary.
Coupling coupleFaces(const PolyMesh& mesh, const MeshGeometry& geometry);

/// What the parts read, and the report that they fill.
struct CheckContext {
    const PolyMesh& mesh;
    const Rows<Label>& facesOf; // of each cell
    const MeshGeometry& geometry;
    const Coupling& coupling;
    MeshReport& report;

    bool isCoupled(Label face) const {
        return coupling.isCoupled[index(face - mesh.internalFaceCount())] != 0;
    }

    /// Internal, or coupled to a cell through a patch.
    bool hasNeighbour(Label face) const { return mesh.isInternal(face) || isCoupled(face); }

    /// The same, but false for the second face of each coupled pair.
    bool isCounted(Label face) const {
        return mesh.isInternal(face) ||
               (isCoupled(face) && coupling.isMaster[index(face - mesh.internalFaceCount())] != 0);
    }

    FaceGeometry face(Label f) const {
        return {geometry.faceCentres[index(f)], geometry.faceAreas[index(f)]};
    }

    const Vec3& ownerCentre(Label f) const {
        return geometry.cellCentres[index(mesh.owner[index(f)])];
    }

    /// Requires hasNeighbour(f).
    const Vec3& neighbourCentre(Label f) const {
        return mesh.isInternal(f) ? geometry.cellCentres[index(mesh.neighbour[index(f)])]
                                  : coupling.cellCentres[index(f - mesh.internalFaceCount())];
    }

    double neighbourVolume(Label f) const {
        return mesh.isInternal(f) ? geometry.cellVolumes[index(mesh.neighbour[index(f)])]
                                  : coupling.cellVolumes[index(f - mesh.internalFaceCount())];
    }
};

/// metric(i) for i in [0, count), in parallel.
template<class Metric>
auto valuesOf(Label count, Metric&& metric) {
    std::vector<decltype(metric(Label{0}))> values(index(count));
    parallelFor(count, [&](Label i) { values[index(i)] = metric(i); });
    return values;
}

/// The indices for which `isBad` holds, ascending.
template<class IsBad>
std::vector<Label> gather(Label count, IsBad&& isBad) {
    std::vector<Label> result;
    for (Label i = 0; i < count; ++i)
        if (isBad(i)) result.push_back(i);
    return result;
}

/// Which way a metric is bad.
enum class Worse : std::uint8_t { high, low };

/// Stores a result: its offenders, and the worst of them by value(offender).
template<class Value>
void store(const CheckContext& context,
           CheckId id,
           std::vector<Label> offenders,
           Value&& value,
           Worse worse) {
    CheckResult& result = context.report[id];
    result.done = true;
    result.count = toLabel(offenders.size());
    result.offenders = std::move(offenders);
    std::vector<std::pair<double, Label>> ranked; // lowest first
    for (const Label element : result.offenders)
        ranked.emplace_back(worse == Worse::high ? -value(element) : value(element), element);
    const std::size_t kept = std::min(ranked.size(), context.report.options.worstCount);
    std::partial_sort(
        ranked.begin(), ranked.begin() + static_cast<std::ptrdiff_t>(kept), ranked.end());
    for (std::size_t i = 0; i < kept; ++i) {
        Offender offender;
        offender.element = ranked[i].second;
        offender.value = worse == Worse::high ? -ranked[i].first : ranked[i].first;
        result.worst.push_back(offender);
    }
}

/// Stores a result whose offenders have no metric: the first are shown.
void store(const CheckContext& context, CheckId id, std::vector<Label> offenders);

// The parts; each fills its results, figures and facts.
void checkAddressing(const CheckContext& context);     // checkAddressing.cpp
void checkConnectivity(const CheckContext& context);   // checkConnectivity.cpp
void checkRegions(const CheckContext& context);        // checkAddressing.cpp
void checkSurfaces(const CheckContext& context);       // checkAddressing.cpp
void checkFaceGeometry(const CheckContext& context);   // checkFaces.cpp
void checkFaceShapes(const CheckContext& context);     // checkFaces.cpp, allGeometry
void checkCellGeometry(const CheckContext& context);   // checkCells.cpp
void checkCellShapes(const CheckContext& context);     // checkCells.cpp, allGeometry
void checkPointDistances(const CheckContext& context); // checkPoints.cpp, allGeometry

} // namespace polymesh
