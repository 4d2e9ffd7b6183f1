// SPDX-FileCopyrightText: The polymesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The main function of every tool.

#include "tools/toolMain.h"

int main(int argc, char** argv) {
    return polymesh::tools::runTool(argc, argv, polymesh::tools::thisTool());
}
