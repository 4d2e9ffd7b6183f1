// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// mpsSplit: constant/polyMesh -> mid-point subdivision -> constant/polyMesh.

#include "formats/foam/polyMeshIo.h"
#include "formats/foam/sets.h"
#include "libpolymesh/base/error.h"
#include "libpolymesh/mesh/validate.h"
#include "libpolymesh/mps/midPointSubdivision.h"
#include "libpolymesh/quality/standardShape.h"
#include "tools/mpsSplitReport.h"
#include "tools/toolMain.h"

namespace polymesh::tools {

namespace {

const ToolDescription description{
    "mpsSplit", "divides every cell of the mesh into hexahedra and a few pyramids", {}};

const std::vector<Option> options{};

ExitCode run(ToolRun& tool) {
    const foam::WriteFormat format = tool.writeFormat();
    tool.clock.start("read");
    const PolyMesh mesh = foam::readPolyMesh(tool.meshDir());
    tool.clock.start("check mesh");
    refuseInvalid(tool, mesh);
    tool.clock.start("plan");
    SubdivisionPlan plan = planSubdivision(mesh);
    const MpsFigures figures = figuresOf(mesh, plan);
    tool.clock.start("divide");
    const PolyMesh result = divide(mesh, std::move(plan));
    tool.clock.start("validate");
    requireValid(result, "the divided mesh");
    tool.clock.start("write");
    foam::writePolyMesh(result, tool.meshDir(), format);
    tool.clock.start("report");
    return reportSplit(tool, figures, result) ? ExitCode::success : ExitCode::failure;
}

} // namespace

} // namespace polymesh::tools

int main(int argc, char** argv) {
    using namespace polymesh::tools;
    return runTool(argc, argv, description, options, run);
}
