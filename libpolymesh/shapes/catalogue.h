// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/shapes/faceGraph.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace polymesh {

/// Number of a shape in the catalogue.
using ShapeId = std::uint8_t;

/// An edge of a base shape, the lower vertex first.
using ShapeEdge = std::array<ShapeVertex, 2>;

/// A shape that STAR-CD accepts: a base shape, some of whose edges may have collapsed.
struct CatalogueShape {
    BaseShape base = BaseShape::tetrahedron; // the first, in their order, that it is a variant of
    std::vector<ShapeEdge> collapsed;        // ascending; the fewest that make it
    std::vector<BaseShape> bases;            // all that it is a variant of
    std::string name;                        // "sammTrim5:1-2,2-3"
    std::size_t pointCount = 0;
    std::vector<std::size_t> faceSizes; // ascending
};

/// All acceptable shapes: those that base shapes become when edges collapse, such that no face has
/// fewer than three points left and the faces still make a closed polyhedron. Shapes are the same
/// when their face graphs are, mirror images included.
class Catalogue {
public:
    /// Made at the first call, in some milliseconds, from the face tables of the base shapes.
    static const Catalogue& instance();

    /// By base, then by the number of collapsed edges.
    const std::vector<CatalogueShape>& shapes() const { return shapes_; }

    const CatalogueShape& operator[](ShapeId id) const { return shapes_[id]; }

    /// Number of shapes that are variants of the base, the base among them.
    std::size_t variantCount(BaseShape base) const;

    /// How a shape looks from one of its darts: which of the points that a walk meets each vertex
    /// of the base shape is.
    struct View {
        RootedCode code;
        std::array<std::uint8_t, maxShapePoints> met{}; // [vertex of the base]
        ShapeId shape = 0;
        BaseShape base = BaseShape::tetrahedron;
    };

    /// The view with that code, in which the base shape is right-handed; null when no shape of the
    /// catalogue looks so.
    const View* find(const RootedCode& code) const;

private:
    Catalogue();

    void addBase(BaseShape base);
    void addVariant(BaseShape base, const std::vector<ShapeEdge>& collapsed);
    ShapeId addShape(BaseShape base, const std::vector<ShapeEdge>& collapsed, const FaceGraph& g);
    void addViews(const FaceGraph& graph,
                  std::span<const Label> pointOfVertex,
                  BaseShape base,
                  ShapeId shape);
    void enter(const View& view);

    static constexpr std::size_t tableSize = 1U << 15U; // several times the number of views
    static std::size_t slotOf(const RootedCode& code);

    std::vector<CatalogueShape> shapes_;
    std::vector<View> views_;
    std::vector<std::uint16_t> table_ = std::vector<std::uint16_t>(tableSize, 0); // 1 + view
};

} // namespace polymesh
