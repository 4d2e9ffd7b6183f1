// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/base/error.h"
#include "libpolymesh/mesh/polyMesh.h"
#include "tests/support/temporaryDirectory.h"

#include <string>

namespace polymesh::test {

/// The message of the InputError that `call` throws; says so when it throws none.
template<class Call>
std::string inputError(Call&& call) {
    try {
        call();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no InputError";
}

/// Two unit cubes side by side, with zones and a patch that has further entries.
inline PolyMesh twoCubes() {
    PolyMesh mesh;
    for (const double z : {0.0, 1.0})
        for (const double y : {0.0, 1.0 / 3.0})
            for (const double x : {0.0, 0.1, 2e-7})
                mesh.points.push_back({x, y, z});
    const auto add = [&](std::initializer_list<Label> face, Label owner) {
        mesh.faces.add(std::span<const Label>(face.begin(), face.size()));
        mesh.owner.push_back(owner);
    };
    add({1, 4, 10, 7}, 0);
    mesh.neighbour = {1};
    add({0, 6, 9, 3}, 0);
    add({2, 5, 11, 8}, 1);
    for (const Label cell : {0, 1}) {
        add({cell, 3 + cell, 4 + cell, 1 + cell}, cell);
        add({6 + cell, 7 + cell, 10 + cell, 9 + cell}, cell);
        add({cell, 1 + cell, 7 + cell, 6 + cell}, cell);
        add({3 + cell, 9 + cell, 10 + cell, 4 + cell}, cell);
    }
    mesh.patches = {{"inlet", "patch", 1, 1, {}},
                    {"nothing", "empty", 2, 0, {{"inGroups", "1(empty)"}}},
                    {"sides",
                     "wall",
                     2,
                     9,
                     {{"inGroups", "2(wall outer)"},
                      {"offset", "{ distance 3; name \"a ; b\"; }"},
                      {"transform", "unknown"}}}};
    mesh.pointZones = {{"corners", {0, 2, 11}, {}}};
    mesh.faceZones = {{"middle", {0, 3, 10}, {true, false, true}}, {"none", {}, {}}};
    mesh.cellZones = {{"left", {0}, {}}, {"both", {0, 1}, {}}};
    mesh.cellCount = 2;
    return mesh;
}

} // namespace polymesh::test
