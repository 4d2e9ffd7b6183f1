// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/surface/triSurface.h"

namespace polymesh {

/// What orientSurface did and found.
struct OrientationReport {
    Label turnedTriangles = 0; // of which the order of corners was reversed
    bool turnedAll = false;    // the whole surface was inside out
    Label shells = 0;          // closed components
    Label nestedShells = 0;    // of which inside an odd number of others: cavities
    Label nestedTurned = 0;    // cavities that were turned inward
    Label openParts = 0;       // components that do not close; left as they are
};

/// Turns triangles so that each component is consistent and the surface's winding numbers are 0
/// and 1: outermost shells get outward normals, shells inside them inward ones (cavities), and so
/// on by depth of nesting. Shells that touch or cross others are not nested in them.
///
/// Triangles are connected where exactly two share a side; connected ones that disagree are turned
/// to the majority. Parts that cannot be oriented (gaps, Moebius bands, more than two triangles at
/// a side that do not belong to closed shells) are left as they are. What is right already
/// stays the same bit for bit.
///
/// Whether a shell is inside another is told by its extreme points: crossing shells can deceive it,
/// but for them there is no right answer.
///
/// Cost: O(n log n), and n for every shell within the box of another.
OrientationReport orientSurface(TriSurface& surface);

} // namespace polymesh
