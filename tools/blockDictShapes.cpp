// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces that a blockMeshDict projects onto.

#include "formats/surfaceIo.h"
#include "libpolymesh/base/error.h"
#include "tools/blockDictReader.h"

#include <string_view>

namespace polymesh::tools {
namespace {

double radiusOf(const foam::Dictionary& surface) {
    const double radius = surface.scalar("radius");
    if (!(radius > 0)) surface.entry("radius").value().fail("radius", "a positive number");
    return radius;
}

Vec3 centreOf(const foam::Dictionary& surface) {
    return surface.vector(surface.has("centre") ? "centre" : "origin");
}

Shape cylinderOf(const foam::Dictionary& surface) {
    const Vec3 end1 = surface.vector("point1");
    const Vec3 end2 = surface.vector("point2");
    if (end1 == end2) surface.entry("point2").value().fail("point2", "a point other than point1");
    return cylinderShape(end1, end2, radiusOf(surface));
}

Shape boxOf(const foam::Dictionary& surface) {
    const Box box{surface.vector("min"), surface.vector("max")};
    for (int axis = 0; axis < 3; ++axis)
        if (!(box.min[axis] < box.max[axis]))
            surface.entry("max").value().fail("max", "a corner above min in x, y and z");
    return boxShape(box);
}

Shape plateOf(const foam::Dictionary& surface) {
    return plateShape(surface.vector("origin"), surface.vector("span"));
}

Shape shapeOf(const std::string& name,
              const foam::Dictionary& surface,
              const FindSurface& findSurface) {
    std::string type = surface.word("type");
    constexpr std::string_view longForm = "searchable"; // searchableSphere is sphere
    if (type.starts_with(longForm) && type.size() > longForm.size()) {
        type.erase(0, longForm.size());
        type[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(type[0])));
    }
    if (type == "sphere") return sphereShape(centreOf(surface), radiusOf(surface));
    if (type == "cylinder") return cylinderOf(surface);
    if (type == "box") return boxOf(surface);
    if (type == "plate") return plateOf(surface);
    if (type == "triSurfaceMesh" || type == "triSurface")
        return surfaceShape(readSurface(findSurface(surface.string("file", name))));
    surface.entry("type").value().fail(
        "type",
        "sphere, cylinder, box, plate or triSurfaceMesh; projection onto another type is not "
        "supported");
}

} // namespace

const Shape& BlockDictReader::shape(const foam::Value& names) {
    const bool isList = names.kind == foam::Value::Kind::list;
    if (isList && names.items.size() != 1)
        names.fail("project", "one surface; projection onto several is not supported");
    const std::string name = (isList ? names.items.front() : names).string("project");
    const auto known = shapes.find(name);
    if (known != shapes.end()) return known->second;
    const foam::Dictionary& geometry = dictionary.dictionary("geometry");
    require(geometry.has(name),
            "{}: project: there is no surface {} in geometry; enter it there",
            names.place.text(),
            name);
    return shapes[name] = shapeOf(name, geometry.dictionary(name), findSurface);
}

} // namespace polymesh::tools
