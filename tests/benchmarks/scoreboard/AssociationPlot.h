// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "AssociationStudy.h"

namespace toss {

/// Draws time by number of traces, both axes logarithmic, a line per method. Throws UserError where
/// the file can not be written.
void drawAssociation(const AssociationStudy& study, const std::filesystem::path& file);

}  // namespace toss
