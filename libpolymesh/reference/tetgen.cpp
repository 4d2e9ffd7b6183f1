// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "libpolymesh/reference/tetgen.h"

#include "libpolymesh/base/error.h"
#include "libpolymesh/geometry/solidAngle.h"
#include "libpolymesh/mesh/cellGeometry.h"
#include "libpolymesh/reference/childProcess.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <string>

#ifdef POLYMESH_TETGEN
#define TETLIBRARY
#include <tetgen.h>
#endif

namespace polymesh {

#ifdef POLYMESH_TETGEN

namespace {

constexpr unsigned surfaceSeconds = 3600;
constexpr unsigned cellSeconds = 20;
constexpr double flat = 1e-9; // distance from the plane by the extent of a face given whole

/// A piecewise linear complex: polygons over points.
struct Complex {
    std::vector<Vec3> points;
    Rows<Label> polygons;
};

void fillPolygon(tetgenio::facet& facet, std::span<const Label> points) {
    tetgenio::init(&facet);
    facet.numberofpolygons = 1;
    facet.polygonlist = new tetgenio::polygon[1]; // freed by tetgenio
    tetgenio::polygon& polygon = facet.polygonlist[0];
    tetgenio::init(&polygon);
    polygon.numberofvertices = static_cast<int>(points.size());
    polygon.vertexlist = new int[points.size()];
    std::copy(points.begin(), points.end(), polygon.vertexlist);
}

void fill(tetgenio& in, const Complex& complex) {
    in.firstnumber = 0;
    in.numberofpoints = static_cast<int>(complex.points.size());
    in.pointlist = new REAL[3 * complex.points.size()];
    for (std::size_t p = 0; p < complex.points.size(); ++p)
        for (int axis = 0; axis < 3; ++axis)
            in.pointlist[3 * p + static_cast<std::size_t>(axis)] = complex.points[p][axis];
    const auto count = static_cast<std::size_t>(complex.polygons.size());
    in.numberoffacets = static_cast<int>(count);
    in.facetlist = new tetgenio::facet[count];
    in.facetmarkerlist = new int[count];
    for (std::size_t f = 0; f < count; ++f) {
        fillPolygon(in.facetlist[f], complex.polygons[toLabel(f)]);
        in.facetmarkerlist[f] = 1;
    }
}

/// One of TetGen's regions: its volume and the centre of its largest tetrahedron.
struct TetRegion {
    double volume = 0;
    double largest = 0;
    Vec3 inside;
};

using TetRegions = std::map<double, TetRegion>; // by attribute

Vec3 pointOf(const tetgenio& out, int point) {
    const REAL* p = out.pointlist + 3 * static_cast<std::ptrdiff_t>(point);
    return {p[0], p[1], p[2]};
}

/// A triangulated surface as a complex.
Complex complexOf(const TriSurface& surface) {
    Complex complex;
    complex.points = surface.points;
    for (const auto& triangle : surface.triangles)
        complex.polygons.add(triangle);
    return complex;
}

/// A surface as numbers: how many points, their coordinates, three labels for each triangle.
Numbers numbersOf(const TriSurface& surface) {
    Numbers numbers{static_cast<double>(surface.pointCount())};
    for (const Vec3& p : surface.points)
        numbers.insert(numbers.end(), {p.x, p.y, p.z});
    for (const auto& triangle : surface.triangles)
        numbers.insert(numbers.end(), triangle.begin(), triangle.end());
    return numbers;
}

Complex complexOf(const Numbers& numbers) {
    Complex complex;
    const auto points = static_cast<std::size_t>(numbers.front());
    const auto* at = numbers.data() + 1;
    for (std::size_t p = 0; p < points; ++p, at += 3)
        complex.points.push_back({at[0], at[1], at[2]});
    for (; at != numbers.data() + numbers.size(); at += 3)
        complex.polygons.add(std::array{
            static_cast<Label>(at[0]), static_cast<Label>(at[1]), static_cast<Label>(at[2])});
    return complex;
}

/// The tetrahedra inside a surface as numbers: how many points are new, their coordinates, four
/// labels for each tetrahedron. Empty when TetGen puts points on the surface.
Numbers numbersOfTetrahedra(const Complex& surface) {
    tetgenio in;
    tetgenio out;
    fill(in, surface);
    std::string switches = "pYq2Q"; // with points inside where tetrahedra would be flat
    tetrahedralize(switches.data(), &in, &out);
    if (out.numberoftrifaces != in.numberoffacets) return {};
    Numbers numbers{static_cast<double>(out.numberofpoints - in.numberofpoints)};
    for (int p = in.numberofpoints; p < out.numberofpoints; ++p)
        for (int axis = 0; axis < 3; ++axis)
            numbers.push_back(pointOf(out, p)[axis]);
    for (int i = 0; i < 4 * out.numberoftetrahedra; ++i)
        numbers.push_back(out.tetrahedronlist[i]);
    return numbers;
}

TetMesh tetMeshOf(const Numbers& numbers) {
    TetMesh mesh;
    const auto newPoints = static_cast<std::size_t>(numbers.front());
    const auto* at = numbers.data() + 1;
    for (std::size_t p = 0; p < newPoints; ++p, at += 3)
        mesh.newPoints.push_back({at[0], at[1], at[2]});
    for (; at != numbers.data() + numbers.size(); at += 4)
        mesh.tetrahedra.push_back({static_cast<Label>(at[0]),
                                   static_cast<Label>(at[1]),
                                   static_cast<Label>(at[2]),
                                   static_cast<Label>(at[3])});
    return mesh;
}

TetRegions meshComplex(const Complex& complex) {
    tetgenio in;
    tetgenio out;
    fill(in, complex);
    std::string switches = "pYAQ";
    tetrahedralize(switches.data(), &in, &out);
    TetRegions regions;
    for (int t = 0; t < out.numberoftetrahedra; ++t) {
        const int* corners =
            out.tetrahedronlist + static_cast<std::ptrdiff_t>(t) * out.numberofcorners;
        const Vec3 a = pointOf(out, corners[0]);
        const Vec3 b = pointOf(out, corners[1]) - a;
        const Vec3 c = pointOf(out, corners[2]) - a;
        const Vec3 d = pointOf(out, corners[3]) - a;
        const double volume = std::abs(dot(b, cross(c, d))) / 6;
        const int attributes = out.numberoftetrahedronattributes;
        const double key =
            attributes > 0
                ? out.tetrahedronattributelist[static_cast<std::ptrdiff_t>(t + 1) * attributes - 1]
                : 0;
        TetRegion& region = regions[key];
        region.volume += volume;
        if (volume <= region.largest) continue;
        region.largest = volume;
        region.inside = a + 0.25 * (b + c + d);
    }
    return regions;
}

/// How often the surface winds round a point that is not on it.
double windingNumber(const TriSurface& surface, const Vec3& p) {
    double angle = 0;
    for (Label t = 0; t < surface.triangleCount(); ++t)
        angle += solidAngle(p, surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2));
    return angle / (4 * std::numbers::pi);
}

double volumeInside(const TriSurface& surface) {
    double volume = 0;
    double all = 0;
    for (const auto& [attribute, region] : meshComplex(complexOf(surface))) {
        all += region.volume;
        const auto winding = std::lround(windingNumber(surface, region.inside));
        if (winding % 2 != 0) volume += region.volume;
    }
    return all > 0 ? volume : std::numeric_limits<double>::quiet_NaN();
}

bool isFlat(const PolyMesh& mesh, std::span<const Label> face, const FaceGeometry& geometry) {
    const double area = norm(geometry.area);
    double extent = 0;
    double away = 0;
    for (const Label point : face) {
        const Vec3 d = mesh.points[index(point)] - geometry.centre;
        extent = std::max(extent, norm(d));
        away = std::max(away, std::abs(dot(d, geometry.area)));
    }
    return away <= flat * extent * area;
}

/// Adds a face to the complex of a cell; `local` numbers the cell's points.
void addFace(const PolyMesh& mesh, Label face, std::map<Label, Label>& local, Complex& complex) {
    const std::span<const Label> points = mesh.faces[face];
    std::vector<Label> loop;
    Vec3 sum;
    for (const Label point : points) {
        const auto [found, isNew] = local.try_emplace(point, toLabel(complex.points.size()));
        if (isNew) complex.points.push_back(mesh.points[index(point)]);
        loop.push_back(found->second);
        sum += mesh.points[index(point)];
    }
    if (points.size() == 3 || isFlat(mesh, points, faceGeometry(mesh.points, points))) {
        complex.polygons.add(loop);
        return;
    }
    const Label centre = toLabel(complex.points.size());
    complex.points.push_back(sum / static_cast<double>(points.size()));
    for (std::size_t i = 0; i < loop.size(); ++i)
        complex.polygons.add(std::array{loop[i], loop[(i + 1) % loop.size()], centre});
}

double cellVolume(const PolyMesh& mesh, std::span<const Label> faces) {
    Complex complex;
    std::map<Label, Label> local;
    for (const Label face : faces)
        addFace(mesh, face, local, complex);
    double volume = 0;
    for (const auto& [attribute, region] : meshComplex(complex))
        volume += region.volume;
    return volume > 0 ? volume : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

bool hasTetgen() {
    return true;
}

std::optional<double> tetgenVolume(const TriSurface& surface) {
    return inChildProcess(1, surfaceSeconds, [&](Label) { return volumeInside(surface); }).front();
}

std::vector<std::optional<double>>
tetgenVolumes(const PolyMesh& mesh, const Rows<Label>& cellFaces, std::span<const Label> cells) {
    return inChildProcess(toLabel(cells.size()), cellSeconds, [&](Label i) {
        return cellVolume(mesh, cellFaces[cells[index(i)]]);
    });
}

std::function<std::optional<TetMesh>(const TriSurface&)> tetgenTetrahedraliser() {
    const auto worker = std::make_shared<ChildWorker>(cellSeconds, [](const Numbers& question) {
        return numbersOfTetrahedra(complexOf(question));
    });
    return [worker](const TriSurface& surface) -> std::optional<TetMesh> {
        const auto answer = worker->ask(numbersOf(surface));
        if (!answer || answer->empty()) return std::nullopt;
        return tetMeshOf(*answer);
    };
}

#else

namespace {

[[noreturn]] void refuse() {
    throw InputError("this build has no TetGen; configure with -DPOLYMESH_TETGEN=ON");
}

} // namespace

bool hasTetgen() {
    return false;
}

std::optional<double> tetgenVolume(const TriSurface&) {
    refuse();
}

std::vector<std::optional<double>>
tetgenVolumes(const PolyMesh&, const Rows<Label>&, std::span<const Label>) {
    refuse();
}

std::function<std::optional<TetMesh>(const TriSurface&)> tetgenTetrahedraliser() {
    return {};
}

#endif

} // namespace polymesh
