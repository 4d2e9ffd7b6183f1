// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/checkReport.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string_view>
#include <utility>

namespace polymesh::tools {

namespace {

/// What OpenFOAM calls the members of its sets.
constexpr std::array<std::string_view, checkCount> setContents{
    "illegal cells",
    "unused points",
    "unordered faces",
    "faces with out-of-range or duplicate vertices",
    "cells with over used edges",
    "faces with non-standard edge connectivity",
    "cells with zero or one non-boundary face",
    "cells with two non-boundary faces",
    "points that are in multiple regions",
    "conflicting points",
    "points on non-aligned edges",
    "",
    "non closed cells",
    "cells with high aspect ratio",
    "zero area faces",
    "zero volume cells",
    "non-orthogonal faces",
    "faces with incorrect orientation",
    "skew faces",
    "faces with incorrectly matched 0th (or consecutive) vertex",
    "faces with low quality or negative volume decomposition tets",
    "points on short edges",
    "", // with the distance
    "faces with concave angles",
    "warped faces",
    "under-determined cells",
    "concave cells",
    "faces with low interpolation weights",
    "faces with low volume ratio cells"};

class Writer {
public:
    Writer(const PolyMesh& mesh, const MeshReport& report, int precision)
        : mesh_(mesh), report_(report), precision_(precision) {}

    std::string text();

private:
    template<class... Args>
    void line(fmt::format_string<Args...> format, Args&&... args) {
        fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
        out_ += '\n';
    }

    std::string num(double value) const { return fmt::format("{:.{}g}", value, precision_); }

    std::string vec(const Vec3& v) const {
        return fmt::format("({} {} {})", num(v.x), num(v.y), num(v.z));
    }

    const CheckResult& result(CheckId id) const { return report_[id]; }

    void stats();
    void shapes();
    void addressing();
    void connectivity();
    void regions();
    void surfaces(const std::vector<PatchTopology>& list, std::string_view heading);
    void patches();
    void cellZones();
    void domain();
    void alignment();
    void closedness();
    void sizes();
    void orthogonality();
    void faces();
    void tetsAndEdges();
    void faceShapes();
    void cellShapes();
    void interpolation();

    void set(CheckId id);
    void set(CheckId id, const std::string& contents);
    void worst(CheckId id);

    const PolyMesh& mesh_;
    const MeshReport& report_;
    int precision_;
    std::string out_;
};

/// Names the set of a check's offenders, and where the worst of a failing check are.
void Writer::set(CheckId id) {
    set(id, std::string(setContents[static_cast<std::size_t>(id)]));
}

void Writer::set(CheckId id, const std::string& contents) {
    if (!result(id).offenders.empty())
        line("  <<Writing {} {} to set {}",
             result(id).offenders.size(),
             contents,
             infoOf(id).setName);
    if (result(id).failed) worst(id);
}

void Writer::worst(CheckId id) {
    constexpr std::array<std::string_view, 3> kinds{"point", "face", "cell"};
    const ElementKind kind = infoOf(id).kind;
    for (const Offender& offender : result(id).worst) {
        std::string where =
            fmt::format("{} {}", kinds[static_cast<std::size_t>(kind)], offender.element);
        if (kind == ElementKind::face) where += fmt::format(" of cell {}", offender.cell);
        if (offender.value != 0) where += fmt::format(", {}", num(offender.value));
        line("    worst: {} at {}", where, vec(offender.position));
    }
}

void Writer::stats() {
    const TopologyFacts& facts = report_.topology;
    const auto facesPerCell = static_cast<double>(mesh_.faceCount() + mesh_.internalFaceCount()) /
                              std::max(Label{1}, mesh_.cellCount);
    line("Mesh stats ");
    line("    points:           {}", mesh_.pointCount());
    if (facts.internalPoints) {
        line("    internal points:  {}", *facts.internalPoints);
        if (report_.options.allTopology) {
            line("    edges:            {}", facts.edges);
            line("    internal edges:   {}", facts.internalEdges);
            line("    internal edges using one boundary point:   {}",
                 facts.internalEdgesWithOneBoundaryPoint);
            line("    internal edges using two boundary points:  {}",
                 facts.internalEdgesWithTwoBoundaryPoints);
        }
    }
    line("    faces:            {}", mesh_.faceCount());
    line("    internal faces:   {}", mesh_.internalFaceCount());
    line("    cells:            {}", mesh_.cellCount);
    line("    faces per cell:   {}", num(facesPerCell));
    line("    boundary patches: {}", mesh_.patches.size());
    line("    point zones:      {}", mesh_.pointZones.size());
    line("    face zones:       {}", mesh_.faceZones.size());
    line("    cell zones:       {}\n", mesh_.cellZones.size());
}

void Writer::shapes() {
    const ShapeCounts& counts = report_.shapes;
    line("Overall number of cells of each type:");
    line("    hexahedra:     {}", counts[StandardShape::hexahedron]);
    line("    prisms:        {}", counts[StandardShape::prism]);
    line("    wedges:        {}", counts[StandardShape::wedge]);
    line("    pyramids:      {}", counts[StandardShape::pyramid]);
    line("    tet wedges:    {}", counts[StandardShape::tetWedge]);
    line("    tetrahedra:    {}", counts[StandardShape::tetrahedron]);
    line("    polyhedra:     {}", counts[StandardShape::polyhedron]);
    if (!counts.polyhedraByFaceCount.empty()) {
        line("    Breakdown of polyhedra by number of faces:");
        line("        faces   number of cells");
        for (const auto& [faces, cells] : counts.polyhedraByFaceCount)
            line("{:>13}   {}", faces, cells);
    }
    out_ += '\n';
}

void Writer::addressing() {
    const TopologyFacts& facts = report_.topology;
    line("Checking topology...");
    line("{}",
         facts.boundaryDefinitionOk ? "    Boundary definition OK."
                                    : " ***Boundary definition is in error.");
    if (!facts.emptyFacesDivisible)
        line(" ***Total number of faces on empty patches is not divisible by the number of cells "
             "in the mesh. Hence this mesh is not 1D or 2D.");
    if (result(CheckId::cellFaces).failed)
        line("    Illegal cells (less than 4 faces or out of range faces) found,  number of cells: "
             "{}",
             result(CheckId::cellFaces).count);
    else
        line("    Cell to face addressing OK.");
    set(CheckId::cellFaces);
    if (result(CheckId::unusedPoints).failed)
        line(" ***Unused points found in the mesh, number unused by faces: {0} number unused by "
             "cells: {0}",
             result(CheckId::unusedPoints).count);
    else
        line("    Point usage OK.");
    set(CheckId::unusedPoints);
    if (facts.multipleFaceCells > 0)
        line("  <<Found {} neighbouring cells with multiple inbetween faces.",
             facts.multipleFaceCells);
    line("{}",
         result(CheckId::faceOrder).failed ? " ***Faces not in upper triangular order."
                                           : "    Upper triangular ordering OK.");
    set(CheckId::faceOrder);
    if (result(CheckId::faceVertices).failed)
        line("    Faces with invalid vertex labels found,  number of faces: {}",
             result(CheckId::faceVertices).count);
    else
        line("    Face vertices OK.");
    set(CheckId::faceVertices);
}

void Writer::connectivity() {
    if (!report_.options.allTopology) return;
    const TopologyFacts& facts = report_.topology;
    if (result(CheckId::zipUp).failed) {
        line(" ***Open cells found, number of cells: {}. This problem may be fixable using the "
             "zipUpMesh utility.",
             result(CheckId::zipUp).count);
        set(CheckId::zipUp);
    } else {
        line("    Topological cell zip-up check OK.");
    }
    if (facts.baffleFaces > 0)
        line("    Number of identical duplicate faces (baffle faces): {}", facts.baffleFaces);
    if (facts.duplicateFaces > 0)
        line("  <<Number of duplicate (not baffle) faces found: {}. This might indicate a problem.",
             facts.duplicateFaces);
    if (facts.nonConsecutiveFaces > 0)
        line("  <<Number of faces with non-consecutive shared points: {}. This might indicate a "
             "problem.",
             facts.nonConsecutiveFaces);
    if (facts.duplicateFaces == 0 && facts.nonConsecutiveFaces == 0)
        line("    Face-face connectivity OK.");
    set(CheckId::faceConnectivity);
    set(CheckId::oneInternalFace);
    set(CheckId::twoInternalFaces);
}

void Writer::regions() {
    const TopologyFacts& facts = report_.topology;
    if (facts.regionSizes.size() <= 1) {
        line("    Number of regions: {} (OK).", facts.regionSizes.size());
        return;
    }
    line("   *Number of regions: {}", facts.regionSizes.size());
    line("    The mesh has multiple regions which are not connected by any face.");
    for (std::size_t i = 0; i < facts.regionSizes.size(); ++i) {
        std::string_view contact;
        if (!facts.regionTouchesOther.empty())
            contact = facts.regionTouchesOther[i] ? " (point connected)" : " (fully disconnected)";
        line("  <<Writing region {0}{1} with {2} cells to cellSet region{0}",
             i,
             contact,
             facts.regionSizes[i]);
    }
    set(CheckId::multiRegionPoints);
}

void Writer::surfaces(const std::vector<PatchTopology>& list, std::string_view heading) {
    const bool boxes = report_.options.allGeometry;
    line("    {:<20}{:<9}{:<9}{:<34}{}",
         heading,
         "Faces",
         "Points",
         "Surface topology",
         boxes ? " Bounding box" : "");
    for (const PatchTopology& surface : list) {
        std::string box;
        if (boxes && surface.faces > 0)
            box = fmt::format(" {} {}", vec(surface.box.min), vec(surface.box.max));
        line("    {:<20}{:<9}{:<9}{:<34}{}",
             surface.name,
             surface.faces,
             surface.points,
             describe(surface.kind),
             box);
    }
}

void Writer::patches() {
    line("\nChecking patch topology for multiply connected surfaces...");
    surfaces(report_.topology.patches, "Patch");
    line("\nChecking faceZone topology for multiply connected surfaces...");
    if (report_.topology.faceZones.empty())
        line("    No faceZones found.");
    else
        surfaces(report_.topology.faceZones, "FaceZone");
    set(CheckId::nonManifoldPoints);
}

void Writer::cellZones() {
    line("\nChecking basic cellZone addressing...");
    if (report_.topology.cellZones.empty())
        line("    No cellZones found.");
    else
        line("    {:<20}{:<13}{:<13}{:<13}{}",
             "CellZone",
             "Cells",
             "Points",
             "Volume",
             "BoundingBox");
    for (const CellZoneFacts& zone : report_.topology.cellZones) {
        const bool isEmpty = zone.box.isEmpty();
        line("    {:<19} {:<12} {:<12} {:<12} {}",
             zone.name,
             zone.cells,
             zone.points,
             num(zone.volume),
             isEmpty ? "(empty)" : vec(zone.box.min) + " " + vec(zone.box.max));
    }
}

void Writer::domain() {
    const auto directions = [](const Directions& d) {
        return fmt::format("({} {} {})", int{d[0]}, int{d[1]}, int{d[2]});
    };
    const auto count = [](const Directions& d) { return int{d[0]} + int{d[1]} + int{d[2]}; };
    const MeshDirections& d = report_.directions;
    line("\nChecking geometry...");
    line("    Overall domain bounding box {} {}",
         vec(report_.figures.bounds.min),
         vec(report_.figures.bounds.max));
    line("    Mesh has {} geometric (non-empty/wedge) directions {}",
         count(d.geometric),
         directions(d.geometric));
    line("    Mesh has {} solution (non-empty) directions {}",
         count(d.solution),
         directions(d.solution));
}

void Writer::alignment() {
    if (!result(CheckId::edgeAlignment).done) return;
    const EdgeAlignment& alignment = report_.alignment;
    for (const Wedge& wedge : alignment.wedges)
        line("    Wedge {} with angle {} degrees",
             wedge.name,
             num(wedge.angle * 180.0 / std::numbers::pi));
    if (!alignment.wedgeFault.empty())
        line(" ***{}", alignment.wedgeFault);
    else if (alignment.edgeCount > 0)
        line(" ***Number of edges not aligned with or perpendicular to non-empty directions: {}",
             alignment.edgeCount);
    else
        line("    All edges aligned with or perpendicular to non-empty directions.");
    set(CheckId::edgeAlignment);
}

void Writer::closedness() {
    const MeshFigures& figures = report_.figures;
    if (result(CheckId::boundaryOpenness).failed)
        line(" ***Boundary openness {} possible hole in boundary description.",
             vec(figures.boundaryOpenness));
    else
        line("    Boundary openness {} OK.", vec(figures.boundaryOpenness));
    if (result(CheckId::cellOpenness).failed) {
        line(" ***Open cells found, max cell openness: {}, number of open cells {}",
             num(figures.maxCellOpenness),
             result(CheckId::cellOpenness).count);
    } else if (result(CheckId::aspectRatio).failed) {
        line(" ***High aspect ratio cells found, Max aspect ratio: {}, number of cells {}",
             num(figures.maxAspectRatio),
             result(CheckId::aspectRatio).count);
    } else {
        line("    Max cell openness = {} OK.", num(figures.maxCellOpenness));
        line("    Max aspect ratio = {} OK.", num(figures.maxAspectRatio));
    }
    set(CheckId::cellOpenness);
    set(CheckId::aspectRatio);
}

void Writer::sizes() {
    const MeshFigures& figures = report_.figures;
    if (result(CheckId::faceArea).failed)
        line(" ***Zero or negative face area detected.  Minimum area: {}",
             num(figures.faceArea.min));
    else
        line("    Minimum face area = {}. Maximum face area = {}.  Face area magnitudes OK.",
             num(figures.faceArea.min),
             num(figures.faceArea.max));
    set(CheckId::faceArea);
    if (result(CheckId::cellVolume).failed)
        line(" ***Zero or negative cell volume detected.  Minimum negative volume: {}, Number of "
             "negative volume cells: {}",
             num(figures.cellVolume.min),
             result(CheckId::cellVolume).count);
    else
        line("    Min volume = {}. Max volume = {}.  Total volume = {}.  Cell volumes OK.",
             num(figures.cellVolume.min),
             num(figures.cellVolume.max),
             num(figures.volume));
    set(CheckId::cellVolume);
}

void Writer::orthogonality() {
    const MeshFigures& figures = report_.figures;
    if (figures.maxNonOrthogonality)
        line("    Mesh non-orthogonality Max: {} average: {}",
             num(*figures.maxNonOrthogonality),
             num(figures.averageNonOrthogonality));
    if (figures.severeNonOrthogonality > 0)
        line("   *Number of severely non-orthogonal (> {} degrees) faces: {}.",
             num(limits::nonOrthogonality),
             figures.severeNonOrthogonality);
    if (result(CheckId::nonOrthogonality).failed)
        line(" ***Number of non-orthogonality errors: {}.",
             result(CheckId::nonOrthogonality).count);
    else
        line("    Non-orthogonality check OK.");
    set(CheckId::nonOrthogonality);
}

void Writer::faces() {
    const MeshFigures& figures = report_.figures;
    if (result(CheckId::facePyramids).failed)
        line(" ***Error in face pyramids: {} faces are incorrectly oriented.",
             result(CheckId::facePyramids).count);
    else
        line("    Face pyramids OK.");
    set(CheckId::facePyramids);
    if (result(CheckId::skewness).failed)
        line(" ***Max skewness = {}, {} highly skew faces detected which may impair the quality of "
             "the results",
             num(figures.maxSkewness),
             result(CheckId::skewness).count);
    else
        line("    Max skewness = {} OK.", num(figures.maxSkewness));
    set(CheckId::skewness);
    line("    Coupled point location match (average {}) OK.", num(figures.coupledMismatch));
}

void Writer::tetsAndEdges() {
    const MeshFigures& figures = report_.figures;
    if (result(CheckId::faceTets).failed)
        line(" ***Error in face tets: {} faces with low quality or negative volume decomposition "
             "tets.",
             result(CheckId::faceTets).count);
    else
        line("    Face tets OK.");
    set(CheckId::faceTets);
    const std::string lengths =
        fmt::format("{} {}", num(figures.edgeLength.min), num(figures.edgeLength.max));
    if (result(CheckId::shortEdges).count > 0)
        line("   *Edges too small, min/max edge length = {}, number too small: {}",
             lengths,
             result(CheckId::shortEdges).count);
    else
        line("    Min/max edge length = {} OK.", lengths);
    set(CheckId::shortEdges);
    const double near = norm(limits::edgeLength * figures.bounds.size());
    set(CheckId::nearPoints, fmt::format("near (closer than {} apart) points", num(near)));
}

void Writer::faceShapes() {
    const MeshFigures& figures = report_.figures;
    if (result(CheckId::concaveFaces).count > 0)
        line("   *There are {} faces with concave angles between consecutive edges. Max concave "
             "angle = {} degrees.",
             result(CheckId::concaveFaces).count,
             num(figures.maxConcaveAngle));
    else
        line("    All angles in faces OK.");
    set(CheckId::concaveFaces);
    if (figures.minFlatness)
        line("    Face flatness (1 = flat, 0 = butterfly) : min = {}  average = {}",
             num(*figures.minFlatness),
             num(figures.averageFlatness));
    if (result(CheckId::warpedFaces).count > 0) {
        line("   *There are {} faces with ratio between projected and actual area < {}",
             result(CheckId::warpedFaces).count,
             num(limits::flatness));
        line("    Minimum ratio (minimum flatness, maximum warpage) = {}",
             num(*figures.minFlatness));
    } else {
        line("    All face flatness OK.");
    }
    set(CheckId::warpedFaces);
}

void Writer::cellShapes() {
    const MeshFigures& figures = report_.figures;
    if (mesh_.cellCount > 0)
        line("    Cell determinant (wellposedness) : minimum: {} average: {}",
             num(figures.minDeterminant),
             num(figures.averageDeterminant));
    if (result(CheckId::determinant).failed)
        line(" ***Cells with small determinant (< {}) found, number of cells: {}",
             num(limits::determinant),
             result(CheckId::determinant).count);
    else
        line("    Cell determinant check OK.");
    set(CheckId::determinant);
    if (result(CheckId::concaveCells).failed)
        line(" ***Concave cells (using face planes) found, number of cells: {}",
             result(CheckId::concaveCells).count);
    else
        line("    Concave cell check OK.");
    set(CheckId::concaveCells);
}

void Writer::interpolation() {
    const MeshFigures& figures = report_.figures;
    if (figures.minFaceWeight)
        line("    Face interpolation weight : minimum: {} average: {}",
             num(*figures.minFaceWeight),
             num(figures.averageFaceWeight));
    if (result(CheckId::faceWeight).failed)
        line(" ***Faces with small interpolation weight (< {}) found, number of faces: {}",
             num(limits::faceWeight),
             result(CheckId::faceWeight).count);
    else
        line("    Face interpolation weight check OK.");
    set(CheckId::faceWeight);
    if (figures.minVolumeRatio)
        line("    Face volume ratio : minimum: {} average: {}",
             num(*figures.minVolumeRatio),
             num(figures.averageVolumeRatio));
    if (result(CheckId::volumeRatio).failed)
        line(" ***Faces with small volume ratio (< {}) found, number of faces: {}",
             num(limits::volumeRatio),
             result(CheckId::volumeRatio).count);
    else
        line("    Face volume ratio check OK.");
    set(CheckId::volumeRatio);
}

std::string Writer::text() {
    stats();
    shapes();
    addressing();
    connectivity();
    regions();
    patches();
    cellZones();
    domain();
    alignment();
    closedness();
    sizes();
    orthogonality();
    faces();
    if (report_.options.allGeometry) {
        tetsAndEdges();
        faceShapes();
        cellShapes();
        interpolation();
    }
    return std::move(out_);
}

} // namespace

std::string reportText(const PolyMesh& mesh, const MeshReport& report, int precision) {
    return Writer(mesh, report, precision).text();
}

std::string verdictText(const MeshReport& report) {
    return report.isOk() ? "Mesh OK."
                         : fmt::format("Failed {} mesh checks.", report.failed().size());
}

} // namespace polymesh::tools
