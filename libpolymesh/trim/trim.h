// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/geometry/box.h"
#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/surface/triSurface.h"
#include "libpolymesh/trim/adjustOptions.h"

#include <functional>
#include <string>
#include <vector>

namespace polymesh {

struct AdjustedNodes;
struct FeaturedSurface;
struct MeshCut;
struct TrimOptions;

/// A way to the exact cut of mesh and surface; cells far outside may go from the mesh.
using CutFinder = MeshCut (*)(PolyMesh& mesh,
                              const FeaturedSurface& surface,
                              const AdjustedNodes& adjusted,
                              const TrimOptions& options);

/// Which side of the surface the mesh keeps.
enum class Keep { inside, outside };

struct TrimOptions {
    Keep keep = Keep::inside;
    /// Largest distance between the surface and the faces that stand for it inside a cell, as a
    /// fraction of the cell size; 0: exact, every triangle's part is kept. Round cells that would
    /// be bad more or less than that, whichever makes them good: see FidelityPlace.
    double deviation = 0.1;
    double featureAngle = 0.5236; // [rad] sharper edges of the surface are edges of the mesh
    double minEdge = 0.05;        // shorter edges are collapsed, fraction of the cell size; 0: off
    double minVolume = 0.01;      // smaller cells are merged, fraction of the cell; 0: off
    AdjustOptions adjust;         // what is done to nodes near the surface beforehand
    bool mendsCells = true;       // split concave cells, repair what checkMesh would fail
    /// Another way to the exact cut than findCut (cutCells.h), which is the default.
    CutFinder findCut = nullptr;
    /// Patch type of each region; empty: wall for all.
    std::vector<std::string> regionTypes;
    /// Called with the name of each stage when it begins.
    std::function<void(const std::string&)> onStage = [](const std::string&) {};
};

/// A place where the deviation is another one than elsewhere, because cells came out bad.
struct FidelityPlace {
    Box box;              // holds the middles of the cells meant [m]
    double factor = 1;    // times the deviation
    bool isBlunt = false; // features of the surface are not kept, but borders of regions
};

/// What the trim did.
struct TrimSummary {
    Label untouchedCells = 0; // as in the initial mesh
    Label trimmedCells = 0;   // cut by the surface
    Label mergedCells = 0;    // small ones that went to a neighbour
    Label collapsedEdges = 0;
    Label splitCells = 0;   // cuts of concave cells
    Label repairs = 0;      // other local changes for the sake of quality
    Label badCells = 0;     // cells left that checkMesh will fail
    Label holedFaces = 0;   // faces with a hole, cut open
    Label featureEdges = 0; // of the surface
    Label featureCorners = 0;
    Label remadeCells = 0; // near the surface, made with another deviation: they came out bad
    std::vector<FidelityPlace> remadePlaces; // where these are; in several, the last one counts
    AdjustCounts adjusted;                   // nodes that were moved
};

struct Trimmed {
    PolyMesh mesh;
    TrimSummary summary;
};

/// Trims a mesh with a closed surface: what lies on one side of it stays, cells that it cuts become
/// polyhedra, and each region of the surface becomes a patch.
///
/// Laws: (1) with deviation 0 and without clean-up the result is the exact Boolean: its volume is
/// the surface's up to rounding; (2) the inside and the outside of one surface fill the mesh;
/// (3) the result is a valid PolyMesh; (4) it does not depend on the number of threads.
/// Requires: the mesh is valid; the surface is closed and consistently oriented with normals out of
/// the part (see surface/check.h, surface/orient.h).
/// Throws InputError where the surface intersects itself so that inside is not defined, and where
/// nothing is left; WorkError on a bug.
/// Cost: O(mesh) with a small constant, and about 10 us for a cut cell. The mesh is taken by value
/// and let go early: move it in where memory matters. With `adjust` it is kept, since where that
/// makes bad cells the trim is done again without the moves round them, and where projected nodes
/// leave small cells with other moves. Source: the paper,
/// section 2.3; docs/trim.md.
Trimmed trim(PolyMesh mesh, TriSurface surface, const TrimOptions& options);

} // namespace polymesh
