// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/convertMeshFiles.h"

#include "formats/foam/polyMeshIo.h"
#include "formats/star/starFiles.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/base/parallel.h"
#include "libpolymesh/mesh/validate.h"

#include <optional>

namespace polymesh::tools {

namespace {

namespace fs = std::filesystem;

/// Words for each form; the first is the one that messages use.
const std::vector<std::string> forms{
    "foam", "star4", "star3", "openfoam", "v4", "v3", "starcd4", "starcd3"};

MeshForm formNamed(const Settings& settings, const std::string& option) {
    const std::string word = settings.word(option, forms, "");
    if (word.ends_with('4')) return MeshForm::star4;
    return word.ends_with('3') ? MeshForm::star3 : MeshForm::foam;
}

bool isStar(MeshForm form) {
    return form != MeshForm::foam;
}

star::Version versionOf(MeshForm form) {
    return form == MeshForm::star4 ? star::Version::v4 : star::Version::v3;
}

MeshForm formOfInput(const Settings& settings) {
    if (settings.has("from")) return formNamed(settings, "from");
    const fs::path path = settings.text("in");
    if (fs::is_directory(path / "constant")) return MeshForm::foam;
    const auto version = star::versionOf(star::prefixOf(path));
    if (version) return *version == star::Version::v4 ? MeshForm::star4 : MeshForm::star3;
    require(fs::is_directory(path),
            "{}: {}: neither a case directory nor the name of STAR-CD files ({} is not there)",
            settings.place("in"),
            path.string(),
            star::prefixOf(path).string() + ".cel");
    return MeshForm::foam;
}

MeshForm formOfOutput(const Settings& settings, MeshForm in) {
    if (settings.has("to")) return formNamed(settings, "to");
    const fs::path path = settings.text("out");
    if (star::prefixOf(path) != path) return MeshForm::star4;
    return fs::is_directory(path) || isStar(in) ? MeshForm::foam : MeshForm::star4;
}

MeshPlace placeOf(const Settings& settings, const std::string& name, MeshForm form) {
    const fs::path path = settings.text(name);
    return {form, isStar(form) ? star::prefixOf(path) : path, settings.text("region", "")};
}

/// STAR-CD files of version 4 are in millimetres, as OpenFOAM's converters have it, those of
/// version 3 in metres.
double metresIn(MeshForm form) {
    return form == MeshForm::star4 ? 0.001 : 1;
}

double usualScale(MeshForm in, MeshForm out) {
    if (in == out) return 1;
    constexpr double millimetres = 1000;
    return metresIn(in) * (out == MeshForm::star4 ? millimetres : 1);
}

void addSetNotes(const fs::path& polyMesh, std::vector<std::string>& notes) {
    const fs::path sets = polyMesh / "sets";
    if (!fs::is_directory(sets)) return;
    const auto count = std::distance(fs::directory_iterator(sets), fs::directory_iterator());
    if (count > 0) notes.push_back(fmt::format("{} sets of {} are left out", count, sets.string()));
}

} // namespace

std::string_view nameOf(MeshForm form) {
    return forms[static_cast<std::size_t>(form)];
}

fs::path MeshPlace::polyMesh() const {
    return foam::CaseDirectory{path, region}.polyMesh();
}

Conversion conversionOf(const ToolRun& tool) {
    const Settings& settings = tool.settings;
    require(settings.has("in") && settings.has("out"),
            "two names are needed: convertMesh IN OUT (-help lists the options)");
    const MeshForm in = formOfInput(settings);
    const MeshForm out = formOfOutput(settings, in);
    constexpr double smallest = 1e-30;
    return {placeOf(settings, "in", in),
            placeOf(settings, "out", out),
            settings.numberOr(usualScale(in, out), "scale", smallest, 1 / smallest)};
}

ConvertedMesh readMesh(const Conversion& conversion) {
    const MeshPlace& in = conversion.in;
    ConvertedMesh converted;
    if (isStar(in.form)) {
        star::StarMesh read = star::read(in.path, versionOf(in.form), conversion.scale);
        return {std::move(read.mesh), std::move(read.notes)};
    }
    converted.mesh = foam::readPolyMesh(in.polyMesh());
    addSetNotes(in.polyMesh(), converted.notes);
    if (!isStar(conversion.out.form) && conversion.scale != 1)
        parallelFor(converted.mesh.pointCount(), [&](Label p) {
            Vec3& point = converted.mesh.points[index(p)];
            point = conversion.scale * point;
        });
    return converted;
}

void refuseUnwritable(const Conversion& conversion, ConvertedMesh& converted) {
    const PolyMesh& mesh = converted.mesh;
    Label negative = 0;
    Label disordered = 0;
    for (const Defect& defect : validate(mesh)) {
        const bool isOnPoint = defect.law == 5 && defect.message.starts_with("point");
        const bool isInsideOut = defect.law == 1 && defect.message.starts_with("cell");
        negative += isInsideOut ? 1 : 0;
        disordered += defect.law == 2 ? 1 : 0;
        require(isOnPoint || isInsideOut || defect.law == 2,
                "{}: {}; mend the mesh first (checkMesh says more)",
                conversion.in.path.string(),
                defect.message);
    }
    if (negative > 0)
        converted.notes.push_back(fmt::format("{} cells have a negative volume", negative));
    if (disordered > 0)
        converted.notes.push_back(
            fmt::format("{} internal faces are not in OpenFOAM's order", disordered));
}

void writeMesh(const ToolRun& tool, const Conversion& conversion, ConvertedMesh& converted) {
    const MeshPlace& out = conversion.out;
    if (isStar(out.form)) {
        const double scale = isStar(conversion.in.form) ? 1 : conversion.scale;
        const auto notes = star::write(converted.mesh, out.path, versionOf(out.form), scale);
        converted.notes.insert(converted.notes.end(), notes.begin(), notes.end());
        return;
    }
    std::optional<std::string> option;
    if (tool.settings.has("format")) option = tool.settings.text("format");
    const foam::CaseDirectory directory{out.path, out.region};
    foam::writePolyMesh(converted.mesh, out.polyMesh(), foam::writeFormat(directory, option));
}

} // namespace polymesh::tools
