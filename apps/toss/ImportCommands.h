// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Command.h"

namespace toss {

// Each adds one format to `toss import`.
void addImportOuster(CLI::App& import_, const Verbosity& verbosity);
void addImportVelodyne(CLI::App& import_, const Verbosity& verbosity);
void addImportPcd(CLI::App& import_, const Verbosity& verbosity);

}  // namespace toss
