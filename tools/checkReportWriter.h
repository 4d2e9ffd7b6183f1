// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "libpolymesh/mesh/polyMesh.h"
#include "libpolymesh/quality/checks.h"

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace polymesh::tools {

/// Writes the report of checkMesh (checkReport.h) part by part, each in OpenFOAM's words.
class ReportWriter {
public:
    ReportWriter(const PolyMesh& mesh, const MeshReport& report, int precision)
        : mesh_(mesh), report_(report), precision_(precision) {}

    std::string text();

private:
    template<class... Args>
    void line(fmt::format_string<Args...> format, Args&&... args) {
        fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
        out_ += '\n';
    }

    std::string num(double value) const { return fmt::format("{:.{}g}", value, precision_); }

    std::string vec(const Vec3& v) const {
        return fmt::format("({} {} {})", num(v.x), num(v.y), num(v.z));
    }

    const CheckResult& result(CheckId id) const { return report_[id]; }

    // checkReportTopology.cpp
    void stats();
    void shapes();
    void addressing();
    void connectivity();
    void regions();
    void surfaces(const std::vector<PatchTopology>& list, std::string_view heading);
    void patches();
    void cellZones();
    // checkReportGeometry.cpp
    void domain();
    void alignment();
    void closedness();
    void sizes();
    void orthogonality();
    void faces();
    void tetsAndEdges();
    void faceShapes();
    void cellShapes();
    void interpolation();

    void set(CheckId id);
    void set(CheckId id, const std::string& contents);
    void worst(CheckId id);

    const PolyMesh& mesh_;
    const MeshReport& report_;
    int precision_;
    std::string out_;
};

} // namespace polymesh::tools
