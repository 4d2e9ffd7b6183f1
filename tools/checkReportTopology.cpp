// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/checkReportWriter.h"

#include <algorithm>

namespace polymesh::tools {

void ReportWriter::stats() {
    const TopologyFacts& facts = report_.topology;
    const auto facesPerCell = static_cast<double>(mesh_.faceCount() + mesh_.internalFaceCount()) /
                              static_cast<double>(std::max(Label{1}, mesh_.cellCount));
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

void ReportWriter::shapes() {
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

void ReportWriter::addressing() {
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

void ReportWriter::connectivity() {
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

void ReportWriter::regions() {
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

void ReportWriter::surfaces(const std::vector<PatchTopology>& list, std::string_view heading) {
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

void ReportWriter::patches() {
    line("\nChecking patch topology for multiply connected surfaces...");
    surfaces(report_.topology.patches, "Patch");
    line("\nChecking faceZone topology for multiply connected surfaces...");
    if (report_.topology.faceZones.empty())
        line("    No faceZones found.");
    else
        surfaces(report_.topology.faceZones, "FaceZone");
    set(CheckId::nonManifoldPoints);
}

void ReportWriter::cellZones() {
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

} // namespace polymesh::tools
