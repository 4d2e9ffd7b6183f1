// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/cellField.h"

#include "formats/foam/listWriter.h"
#include "formats/foam/replaceFile.h"
#include "libpolymesh/base/error.h"

#include <algorithm>
#include <array>

namespace polymesh::foam {

namespace {

namespace fs = std::filesystem;

/// The condition that a field must or may have on a patch of that type.
std::string_view conditionOn(const Patch& patch) {
    static constexpr std::array<std::string_view, 12> constrained{"cyclic",
                                                                  "cyclicACMI",
                                                                  "cyclicAMI",
                                                                  "cyclicSlip",
                                                                  "empty",
                                                                  "nonuniformTransformCyclic",
                                                                  "processor",
                                                                  "processorCyclic",
                                                                  "symmetry",
                                                                  "symmetryPlane",
                                                                  "wedge",
                                                                  "overset"};
    return std::ranges::find(constrained, patch.type) != constrained.end()
               ? std::string_view(patch.type)
               : std::string_view("zeroGradient");
}

void writeField(OutputFile& file,
                const HeaderText& header,
                const PolyMesh& mesh,
                std::span<const double> values,
                const WriteFormat& format) {
    writeHeader(file, header, format.format);
    file.write("dimensions      [0 0 0 0 0 0 0];\n\ninternalField   nonuniform List<scalar> ");
    writeScalars(file, format, values);
    file.write(";\n\nboundaryField\n{\n");
    for (const Patch& patch : mesh.patches) {
        const bool isCoupledByMesh = patch.type.starts_with("processor");
        file.write(fmt::format("    {}\n    {{\n        type            {};\n{}    }}\n",
                               patch.name,
                               conditionOn(patch),
                               isCoupledByMesh ? "        value           uniform 0;\n" : ""));
    }
    file.write("}\n");
}

} // namespace

void writeCellField(const fs::path& timeDirectory,
                    const std::string& name,
                    const PolyMesh& mesh,
                    std::span<const double> values,
                    const WriteFormat& format) {
    replaceFile(timeDirectory / name, [&](OutputFile& file) {
        const std::string location = timeDirectory.filename().string();
        writeField(file, {"volScalarField", name, location, ""}, mesh, values, format);
    });
}

} // namespace polymesh::foam
