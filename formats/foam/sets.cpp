// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/foam/sets.h"

#include "formats/foam/listReader.h"
#include "formats/foam/listWriter.h"
#include "formats/foam/replaceFile.h"

#include <algorithm>

namespace polymesh::foam {
namespace {

namespace fs = std::filesystem;

const char* classOf(SetKind kind) {
    switch (kind) {
    case SetKind::point:
        return "pointSet";
    case SetKind::face:
        return "faceSet";
    case SetKind::cell:
        break;
    }
    return "cellSet";
}

} // namespace

void writeSet(const fs::path& polyMeshDirectory,
              SetKind kind,
              const std::string& name,
              std::span<const Label> labels) {
    replaceFile(polyMeshDirectory / "sets" / name, [&](OutputFile& file) {
        writeHeader(file, {classOf(kind), name, "constant/polyMesh/sets", ""}, Format::ascii);
        writeLabels(file, Format::ascii, labels);
    });
}

std::vector<Label>
readSet(const fs::path& polyMeshDirectory, SetKind kind, const std::string& name) {
    FoamReader reader(polyMeshDirectory / "sets" / name);
    if (reader.header().className != classOf(kind))
        reader.failInFile("class '{}': expected {}", reader.header().className, classOf(kind));
    std::vector<Label> labels = readLabelText(reader, 1);
    std::ranges::sort(labels);
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
    return labels;
}

} // namespace polymesh::foam
