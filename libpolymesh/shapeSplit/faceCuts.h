// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/quality/meshEditor.h"

#include <cstddef>
#include <cstdint>

namespace polymesh {

/// Cuts a face into polygons of at most `most` points along chords between its corners, for both
/// its cells; of the chords that run inside the face those that leave the roundest parts. False
/// when no such chord is found, or the face is frozen; part of the cuts may then be made.
bool cutByChords(MeshEditor& editor, Label face, std::size_t most);

/// What parts of a face may be like.
enum class Parts : std::uint8_t {
    simple, // none crosses itself, seen against the normal of the face
    any     // as it comes
};

/// Cuts a boundary face into `parts` polygons that meet in a new point near its centre, at which
/// the volume that the parts bound is the volume that the face bounded, by OpenFOAM's definition of
/// the centre of a face that is not plane. As many parts as points makes triangles.
/// False, and nothing is changed, when the face has fewer points than parts, or is so concave or
/// bent that no parts of that kind are found.
bool cutFromMiddle(MeshEditor& editor, Label face, std::size_t count, Parts parts = Parts::simple);

/// The same for a boundary face that is not plane, keeping the volume that it bounds: the largest
/// of the polygons becomes triangles round a new point. Nothing is changed when it is false.
bool cutByChordsKeepingVolume(MeshEditor& editor, Label face, std::size_t most);

/// True when the face's centre sees all of its edges, so that a pyramid on it has its centre
/// inside.
bool isStarShaped(const MeshEditor& editor, Label face);

/// Cuts a face into triangles by chords from its corner with that number, counted round it, for
/// both its cells. False, and nothing is changed, when a chord is an edge of one of them already or
/// the face is frozen or a triangle.
bool cutFromCorner(MeshEditor& editor, Label face, std::size_t corner);

/// True when the face is plane up to rounding, so that its parts bound the volume that it bounds.
bool isPlane(const MeshEditor& editor, Label face);

} // namespace polymesh
