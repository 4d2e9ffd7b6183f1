// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Any bytes are a list, patches or zones, or an InputError.

#include "formats/foam/boundaryFile.h"
#include "formats/foam/listReader.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace {

using namespace polymesh;
using foam::FoamReader;

void readByClass(FoamReader& reader) {
    constexpr Label count = 100;
    const std::string& name = reader.header().className;
    if (name == "vectorField") {
        foam::readVectors(reader);
    } else if (name == "faceList" || name == "faceCompactList") {
        foam::readFaces(reader);
    } else if (name == "polyBoundaryMesh") {
        foam::readPatches(reader);
    } else if (name == "cellSet") {
        foam::readLabelText(reader, count);
    } else if (name == "regIOobject") {
        foam::readZones(reader, foam::ZoneKind::face, count);
    } else {
        foam::readLabels(reader, count);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        FoamReader reader(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz");
        readByClass(reader);
    } catch (const InputError&) { // as it should be
    }
    return 0;
}
