// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/blockExtrude.h"

#include "formats/foam/polyMeshIo.h"
#include "formats/surfaceIo.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/initial/extrude.h"
#include "tools/blockDictReader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace polymesh::tools {

namespace {

void readQuads(const foam::Dictionary& dictionary, ExtrusionSpec& extrusion) {
    for (const foam::Value& point : dictionary.list("points"))
        extrusion.points.push_back(pointOf(point, "points"));
    const Label count = toLabel(extrusion.points.size());
    for (const foam::Value& quad : dictionary.list("quads")) {
        const std::vector<foam::Value>& items = quad.list("quads");
        if (items.size() != 4) quad.fail("quads", "four points");
        SheetQuad added{{}, quad.place.text()};
        for (std::size_t i = 0; i < 4; ++i) {
            added.points[i] = items[i].label("quads");
            if (added.points[i] < 0 || added.points[i] >= count)
                items[i].fail("quads", fmt::format("a point, from 0 to {}", count - 1));
        }
        extrusion.quads.push_back(std::move(added));
    }
}

/// Triangles t and t + 1 as one quadrilateral, the way a reader cuts it: both begin at the same
/// corner, and the second goes on where the first ends.
void addPair(const TriSurface& surface,
             Label t,
             const std::string& where,
             std::vector<SheetQuad>& quads) {
    require(t + 1 < surface.triangleCount(),
            "{}: is no quadrilateral but a triangle; write the surface in quadrilaterals (OBJ, "
            "OFF, PLY)",
            where);
    const auto& a = surface.triangles[index(t)];
    const auto& b = surface.triangles[index(t + 1)];
    require(a[0] == b[0] && a[2] == b[1],
            "{}: is no quadrilateral; write the surface in quadrilaterals (OBJ, OFF, PLY)",
            where);
    quads.push_back({{a[0], a[1], a[2], b[2]}, where});
}

void readSheet(const foam::Value& name, const ShorthandFiles& files, ExtrusionSpec& extrusion) {
    const std::filesystem::path file = files.findSurface(name.string("surface"));
    TriSurface surface = readSurface(file);
    for (Label t = 0; t < surface.triangleCount(); t += 2)
        addPair(surface,
                t,
                fmt::format("{}: {}: face {}", name.place.text(), file.string(), t / 2),
                extrusion.quads);
    extrusion.points = std::move(surface.points);
}

void readPatch(const foam::Value& name, const ShorthandFiles& files, ExtrusionSpec& extrusion) {
    const PolyMesh mesh = foam::readPolyMesh(files.polyMesh);
    const std::string patchName = name.string("patch");
    const auto patch = std::ranges::find(mesh.patches, patchName, &Patch::name);
    if (patch == mesh.patches.end()) {
        std::vector<std::string> names;
        for (const Patch& known : mesh.patches)
            names.push_back(known.name);
        name.fail(
            "patch",
            fmt::format("a patch of {}: {}", files.polyMesh.string(), fmt::join(names, ", ")));
    }
    std::vector<Label> place(mesh.points.size(), -1);
    for (Label f = patch->start; f < patch->start + patch->size; ++f) {
        const auto face = mesh.faces[f];
        SheetQuad quad{
            {},
            fmt::format("{}: face {} of patch {}", name.place.text(), f - patch->start, patchName)};
        require(face.size() == 4,
                "{}: has {} points; name a patch of quadrilaterals alone",
                quad.where,
                face.size());
        for (std::size_t i = 0; i < 4; ++i) {
            Label& local = place[index(face[i])];
            if (local < 0) {
                local = toLabel(extrusion.points.size());
                extrusion.points.push_back(mesh.points[index(face[i])]);
            }
            quad.points[i] = local;
        }
        extrusion.quads.push_back(std::move(quad));
    }
}

void readCells(const foam::Dictionary& dictionary, ExtrusionSpec& extrusion) {
    if (!dictionary.has("cells")) return;
    const foam::Value& cells = dictionary.entry("cells").value();
    const std::vector<foam::Value>& items = cells.list("cells");
    if (items.size() != 2) cells.fail("cells", "two numbers of cells for each quadrilateral");
    for (std::size_t i = 0; i < 2; ++i)
        extrusion.cells[i] = cellCount(items[i], "cells");
}

} // namespace

BlockMeshDescription readExtrude(const foam::Dictionary& dictionary, const ShorthandFiles& files) {
    const int sheets = int{dictionary.has("points") || dictionary.has("quads")} +
                       int{dictionary.has("surface")} + int{dictionary.has("patch")};
    require(sheets == 1,
            "{}: extrude: found {} sheets, expected one: points and quads, surface, or patch",
            dictionary.place().text(),
            sheets);
    ExtrusionSpec extrusion;
    if (dictionary.has("surface"))
        readSheet(dictionary.entry("surface").value(), files, extrusion);
    else if (dictionary.has("patch"))
        readPatch(dictionary.entry("patch").value(), files, extrusion);
    else
        readQuads(dictionary, extrusion);
    require(!extrusion.quads.empty(),
            "{}: extrude: the sheet has no quadrilaterals; give it at least one",
            dictionary.place().text());
    const foam::Value& vector = dictionary.entry("vector").value();
    extrusion.vector = pointOf(vector, "vector");
    if (extrusion.vector == Vec3{}) vector.fail("vector", "a vector with a length");
    readCells(dictionary, extrusion);
    if (dictionary.has("layers"))
        extrusion.layers = cellCount(dictionary.entry("layers").value(), "layers");
    if (dictionary.has("grading"))
        extrusion.grading = gradingOf(dictionary.entry("grading").value(), "grading");
    return extrudedBlocks(extrusion);
}

} // namespace polymesh::tools
