// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What all surface formats' tests share.

#include "formats/surfaceIo.h"
#include "libpolymesh/base/error.h"
#include "tests/support/temporaryDirectory.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

namespace polymesh::test {

inline std::filesystem::path corpusFile(const std::string& format, const std::string& name) {
    return std::filesystem::path(POLYMESH_CORPUS) / format / name;
}

/// The message of the InputError that reading this file throws; "" when it throws none.
inline std::string messageOf(const std::filesystem::path& file) {
    try {
        readSurface(file);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

/// Reads the whole corpus of a format: `bad-*` must be refused by one line that names the file,
/// `odd-*` must be read, others may do either.
inline void expectCorpusIsHandled(const std::string& format) {
    int bad = 0;
    int odd = 0;
    for (const auto& entry : std::filesystem::directory_iterator(corpusFile(format, ""))) {
        const std::string name = entry.path().filename().string();
        const std::string message = messageOf(entry.path());
        if (name.starts_with("bad-")) {
            ++bad;
            EXPECT_NE(message.find(name), std::string::npos) << name << ": " << message;
            EXPECT_EQ(message.find('\n'), std::string::npos) << name << ": " << message;
            if (!name.ends_with(".gz")) { // these say themselves that the archive is damaged
                EXPECT_TRUE(message.ends_with("or export the surface again")) << message;
            }
        } else if (name.starts_with("odd-")) {
            ++odd;
            EXPECT_EQ(message, "") << name;
        }
    }
    EXPECT_GT(bad, 0);
    EXPECT_GT(odd, 0);
}

/// The triangles as coordinates with their region's name: what must survive a change of numbering.
inline auto contentOf(const TriSurface& surface) {
    std::multiset<std::pair<std::array<Vec3, 3>, std::string>> content;
    for (Label t = 0; t < surface.triangleCount(); ++t)
        content.insert({{surface.corner(t, 0), surface.corner(t, 1), surface.corner(t, 2)},
                        surface.regionNames[index(surface.region[index(t)])]});
    return content;
}

} // namespace polymesh::test
