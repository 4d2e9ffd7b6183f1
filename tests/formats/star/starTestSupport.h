// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the tests of STAR-CD files share.

#include "formats/star/starFiles.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/mesh/validate.h"
#include "tests/support/meshes.h"
#include "tests/support/sameMesh.h"
#include "tests/support/temporaryDirectory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace polymesh::star::test {

using namespace polymesh::test;

/// The same cells, faces, patches and zones; points that differ by `tolerance` at most.
inline void expectSameMesh(const PolyMesh& a, const PolyMesh& b, double tolerance) {
    EXPECT_EQ(differenceOf(a, b, tolerance), "");
    EXPECT_EQ(a.patches, b.patches);
    EXPECT_EQ(a.cellZones, b.cellZones);
    EXPECT_TRUE(validate(b).empty());
}

/// Meshes of all kinds of cells.
inline std::map<std::string, PolyMesh> meshesOfAllKinds() {
    return {{"box", box(3, 2, 2)},
            {"jittered box", jittered(box(4, 4, 4), 0.03)},
            {"prisms", prismFan(7)},
            {"tetrahedron", tetrahedron()},
            {"pyramid", pyramid()},
            {"wedge", wedge()},
            {"hanging nodes", hangingNodes()},
            {"concave cell", lShapedCell()}};
}

/// Files of a set, by their endings.
using Texts = std::map<std::string, std::string>;

/// Reads texts as the files of a set.
inline StarMesh readTexts(const Texts& texts, Version version, double scale = 1) {
    const TemporaryDirectory dir;
    for (const auto& [ending, text] : texts)
        writeText(dir / ("m" + ending), text);
    return read(dir / "m", version, scale);
}

/// The message with which reading fails, without the folder; empty when it does not fail.
inline std::string failureOf(const Texts& texts, Version version) {
    try {
        readTexts(texts, version);
    } catch (const InputError& error) {
        const std::string message = error.what();
        const auto name = message.find("/m.");
        return name == std::string::npos ? message : message.substr(name + 1);
    }
    return "";
}

/// The text with the first `from` replaced by `to`, which has to be there.
inline std::string replaced(std::string text, std::string_view from, std::string_view to) {
    const auto place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return text.replace(place, from.size(), to);
}

} // namespace polymesh::star::test
