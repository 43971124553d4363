// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Options.h>

#include <filesystem>
#include <string>
#include <vector>

namespace toss {

/// Reads an MRPT .ini into the given options, one section each; absent keys keep their value.
/// Throws UserError naming the file for a file that can't be read, for an unknown section or key
/// (with the nearest known name), and for a value out of range (with its bounds).
void loadSections(const std::filesystem::path& file, const std::vector<Options*>& sections);

/// The same from the text of an .ini; `name` stands for the file in errors.
void loadSectionsFromText(const std::string& text, const std::string& name,
                          const std::vector<Options*>& sections);

/// Applies one "section.key=value". Throws UserError as above; `where` names the place of the
/// assignment in errors, "" = the command line's --set.
void setOption(const std::string& assignment, const std::vector<Options*>& sections,
               const std::string& where = "");

/// The text of an .ini that holds every option with its value, help, unit, range and source.
/// Values are written so that reading them back gives the same bits.
std::string sectionsToText(const std::vector<Options*>& sections);

}  // namespace toss
