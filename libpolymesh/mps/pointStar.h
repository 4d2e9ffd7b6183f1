// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mps/movingMesh.h"
#include "libpolymesh/mps/partGeometry.h"

#include <span>
#include <vector>

namespace polymesh {

/// A point of a moving mesh with all that its move changes: the cells that have it, their faces.
class PointStar {
public:
    /// `pointFaces`: the faces that have the point, ascending.
    PointStar(MovingMesh& moving, Label point, std::span<const Label> pointFaces);

    /// Whether the point may move: not where the boundary bends or two patches meet.
    bool isFree() const { return !axes_.empty(); }

    /// The directions in which it may: three inside the domain, else two along the boundary.
    std::span<const Vec3> axes() const { return axes_; }

    const Vec3& place() const { return moving_.mesh().points[index(point_)]; }

    /// The points that share an edge with this one, ascending.
    std::vector<Label> others() const;

    /// Distance [m] to the closest of them.
    double reach() const;

    /// Moves the point. One of the boundary goes along it, and across as far as needed for the
    /// faces at it to hold the volume that they held at first.
    void move(const Vec3& to);

    /// Puts the point back to where it was at first.
    void restore() { put(start_); }

    /// How far all that is beyond OpenFOAM's limits, or close to them, is from being well within:
    /// a sum over cells and faces, 0 when nothing is.
    double excess() const;

    /// Takes down how good everything is now.
    void remember();

    /// Whether everything is within the limits or no further beyond them than when taken down, and
    /// no corner's Jacobian nor cosine of a lean (movingMesh.h) below `least` and what was then,
    /// nor the point about to fall together with another.
    bool isNoWorse(double least) const;

private:
    struct Measures {
        std::vector<double> byLimit; // stretches of cells, skewness of faces
        std::vector<double> leans;   // of faces
        double jacobian = 1;         // the least scaled one at corners that have the point
        double evenness = 1;         // the shortest by the longest edge from the point
    };

    Measures measures() const;
    double evenness() const;
    void findCorners(Label cell);
    void findAxes();

    void put(const Vec3& to) { moving_.move(point_, to, faces_, cells_); }

    double held() const;

    MovingMesh& moving_;
    Label point_;
    Vec3 start_;
    std::span<const Label> faces_;         // that have the point
    std::span<const Label> boundaryFaces_; // of them
    std::vector<Label> cells_;             // that have the point
    std::vector<Label> allFaces_;          // of the cells
    std::vector<PartCorner> corners_;      // that have the point
    std::vector<Vec3> axes_;
    Vec3 boundaryArea_; // [m^2]
    double held_ = 0;   // [m^3] three times the volume under the boundary faces over start_
    Measures remembered_;
};

} // namespace polymesh
