// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/label.h"
#include "libpolymesh/geometry/box.h"
#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/quality/directions.h"
#include "libpolymesh/quality/patchTopology.h"
#include "libpolymesh/quality/standardShape.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polymesh {

// The checks of OpenFOAM's checkMesh (version 1912): same definitions, limits, counts and names of
// sets. metrics.h has the definitions.

/// OpenFOAM's limits.
namespace limits {
inline constexpr double nonOrthogonality = 70; // [deg]
inline constexpr double skewness = 4;
inline constexpr double aspectRatio = 1000;
inline constexpr double openness = 1e-6;
inline constexpr double area = 1e-300;          // [m^2]
inline constexpr double volume = 1e-300;        // [m^3]
inline constexpr double pyramidVolume = -1e-15; // [m^3]
inline constexpr double tetQuality = 1e-30;
inline constexpr double edgeLength = 1e-6; // of the diagonal of the bounding box
inline constexpr double concaveAngle = 10; // [deg]
inline constexpr double flatness = 0.8;
inline constexpr double determinant = 1e-3;
inline constexpr double faceWeight = 0.05;
inline constexpr double volumeRatio = 0.01;
} // namespace limits

/// What can be checked, in OpenFOAM's order.
enum class CheckId : std::uint8_t {
    cellFaces, // cells with fewer than 4 faces
    unusedPoints,
    faceOrder,        // internal faces not in upper triangular order
    faceVertices,     // faces that list a point twice
    zipUp,            // cells with edges that are not used twice
    faceConnectivity, // duplicate faces, shared points that are not consecutive
    oneInternalFace,
    twoInternalFaces,
    multiRegionPoints,
    nonManifoldPoints, // of patches and face zones
    edgeAlignment,     // in meshes with `empty` or `wedge` patches
    boundaryOpenness,
    cellOpenness,
    aspectRatio,
    faceArea,
    cellVolume,
    nonOrthogonality,
    facePyramids,
    skewness,
    coupledPoints,
    faceTets,
    shortEdges,
    nearPoints,
    concaveFaces,
    warpedFaces,
    determinant,
    concaveCells,
    faceWeight,
    volumeRatio
};

inline constexpr std::size_t checkCount = 29;

enum class ElementKind : std::uint8_t { point, face, cell };

/// The check's name (as `failed` lists it), the name of OpenFOAM's set of offenders, and what they
/// are.
struct CheckInfo {
    std::string_view name;
    std::string_view setName;
    ElementKind kind;
};

const CheckInfo& infoOf(CheckId id);

/// One of the worst elements that a check found.
struct Offender {
    Label element = -1;
    double value = 0; // of the check's metric; 0 when it has none
    Vec3 position;    // [m] the point, or the centre of the face or cell
    Label cell = -1;  // the cell itself, or a cell that has the element
};

/// What one check found.
struct CheckResult {
    bool done = false;            // the options asked for it
    bool failed = false;          // counts in "Failed N mesh checks."
    Label count = 0;              // as OpenFOAM counts; may count an element twice
    std::vector<Label> offenders; // ascending; OpenFOAM's set
    std::vector<Offender> worst;  // a few, the worst first
};

struct MinMax {
    double min = 0;
    double max = 0;
};

/// Figures of the whole mesh. Those of checks that were not done are not set.
struct MeshFigures {
    Box bounds;
    double volume = 0;       // [m^3]
    double boundaryArea = 0; // [m^2]
    Vec3 boundaryOpenness;
    double maxCellOpenness = 0;
    double maxAspectRatio = 0;
    MinMax faceArea;                           // [m^2]
    MinMax cellVolume;                         // [m^3]
    std::optional<double> maxNonOrthogonality; // [deg] none without internal faces
    double averageNonOrthogonality = 0;        // [deg]
    Label severeNonOrthogonality = 0;          // faces above 70 degrees, below 90
    double maxSkewness = 0;
    double coupledMismatch = 0;        // [m] average
    MinMax edgeLength;                 // [m]
    double maxConcaveAngle = 0;        // [deg] within a face, above limits::concaveAngle
    std::optional<double> minFlatness; // none when all faces are triangles
    double averageFlatness = 0;
    double minDeterminant = 0;
    double averageDeterminant = 0;
    std::optional<double> minFaceWeight;
    double averageFaceWeight = 0;
    std::optional<double> minVolumeRatio;
    double averageVolumeRatio = 0;
};

/// A cell zone's extent.
struct CellZoneFacts {
    std::string name;
    Label cells = 0;
    Label points = 0;
    double volume = 0; // [m^3]
    Box box;
};

/// Facts about the addressing that are reported, not judged.
struct TopologyFacts {
    /// Points that no boundary face uses, when those of internal faces come first; else none.
    std::optional<Label> internalPoints;
    Label edges = 0; // with internalPoints and allTopology only
    Label internalEdges = 0;
    Label internalEdgesWithOneBoundaryPoint = 0;
    Label internalEdgesWithTwoBoundaryPoints = 0;
    bool boundaryDefinitionOk = true;
    bool emptyFacesDivisible = true; // number of faces on `empty` patches by number of cells
    Label multipleFaceCells = 0;     // cells that share several faces with one neighbour
    Label duplicateFaces = 0;        // of two faces one has all points of the other, and fewer
    Label baffleFaces = 0;           // faces with equal points
    Label nonConsecutiveFaces = 0;
    std::vector<Label> cellRegion; // one per cell
    std::vector<Label> regionSizes;
    std::vector<bool> regionTouchesOther; // at points; with allTopology
    std::vector<PatchTopology> patches;
    std::vector<PatchTopology> faceZones;
    std::vector<CellZoneFacts> cellZones;
};

struct CheckOptions {
    bool allTopology = false;
    bool allGeometry = false;
    std::size_t worstCount = 5;
};

/// All that checkMesh knows of a mesh.
struct MeshReport {
    CheckOptions options;
    ShapeCounts shapes;
    TopologyFacts topology;
    MeshDirections directions;
    EdgeAlignment alignment;
    MeshFigures figures;
    std::array<CheckResult, checkCount> results;

    const CheckResult& operator[](CheckId id) const {
        return results[static_cast<std::size_t>(id)];
    }

    CheckResult& operator[](CheckId id) { return results[static_cast<std::size_t>(id)]; }

    /// Names of the failing checks, in OpenFOAM's order.
    std::vector<std::string> failed() const;

    bool isOk() const { return failed().empty(); }
};

/// Checks a mesh. Sums are taken in OpenFOAM's order, so figures agree to the last digit and do not
/// depend on the number of threads.
/// Throws InputError when array sizes or labels are out of range (law 0 of validate.h).
/// Cost: O(face corners); about 1 s for a million hexahedra on 2 cores, 3 s with everything.
MeshReport checkMesh(const PolyMesh& mesh, const CheckOptions& options);

} // namespace polymesh
