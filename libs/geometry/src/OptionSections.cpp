// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/config/CConfigFileMemory.h>
#include <toss/geometry/OptionSections.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "OptionVisitors.h"

namespace toss {
namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string> sectionNames(const std::vector<Options*>& sections) {
  std::vector<std::string> names;
  for (const Options* options : sections) names.emplace_back(options->section());
  return names;
}

Options& findSection(const std::string& name, const std::vector<Options*>& sections,
                     const std::string& where) {
  for (Options* options : sections)
    if (name == options->section()) return *options;
  throw UserError(where, "there is no section '" + name + "'",
                  "did you mean '" + nearestName(name, sectionNames(sections)) + "'?");
}

void checkKey(const Options& options, const std::string& key, const std::string& where) {
  const std::vector<std::string> known = options.keys();
  if (std::find(known.begin(), known.end(), key) == known.end())
    throw UserError(where, "there is no key '" + key + "' in section '" + options.section() + "'",
                    "did you mean '" + nearestName(key, known) + "'?");
}

bool isComment(const std::string& line) {
  return line.empty() || line[0] == '#' || line[0] == ';' || line.compare(0, 2, "//") == 0;
}

/// MRPT's parser passes over what it does not understand; here every line must mean something.
void checkLines(const std::string& text, const std::string& name,
                const std::vector<Options*>& sections) {
  const Options* current = nullptr;
  std::vector<std::string> seen;
  std::istringstream stream(text);
  std::string raw;
  for (int number = 1; std::getline(stream, raw); ++number) {
    const std::string line = trimmed(raw);
    const std::string where = name + ": line " + std::to_string(number);
    if (isComment(line)) continue;
    if (line.front() == '[') {
      const std::string section = trimmed(line.substr(1, line.find(']') - 1));
      current = &findSection(section, sections, where);
      continue;
    }
    const auto equals = line.find('=');
    if (equals == std::string::npos)
      throw UserError(where, "'" + line + "' is neither a [section] nor a key = value",
                      "mend or remove the line");
    const std::string key = trimmed(line.substr(0, equals));
    if (current == nullptr)
      throw UserError(where, "the key '" + key + "' stands before any [section]",
                      "put it under its section");
    checkKey(*current, key, where);
    const std::string fullKey = std::string(current->section()) + "." + key;
    if (std::find(seen.begin(), seen.end(), fullKey) != seen.end())
      throw UserError(where, "'" + fullKey + "' is given twice", "keep one of them");
    seen.push_back(fullKey);
  }
}

}  // namespace

void loadSectionsFromText(const std::string& text, const std::string& name,
                          const std::vector<Options*>& sections) {
  checkLines(text, name, sections);
  mrpt::config::CConfigFileMemory ini;
  ini.setContent(text);
  for (Options* options : sections) try {
      options->loadFromConfigFile(ini, options->section());
    } catch (const UserError& error) {
      throw UserError(name + ": " + error.what());
    }
}

void loadSections(const std::filesystem::path& file, const std::vector<Options*>& sections) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (std::filesystem::is_directory(file) || !stream || !(text << stream.rdbuf()))
    throw UserError(file.string(), "the configuration can not be read",
                    "give the path of an .ini file, such as config/toss.ini");
  loadSectionsFromText(text.str(), file.string(), sections);
}

void setOption(const std::string& assignment, const std::vector<Options*>& sections,
               const std::string& where) {
  const std::string place = where.empty() ? "--set " + assignment : where;
  const auto equals = assignment.find('=');
  const auto dot = assignment.find('.');
  if (equals == std::string::npos || dot == std::string::npos || dot > equals)
    throw UserError(place, "this is not section.key=value",
                    "write, for instance, map.voxel_size=0.2");
  Options& options = findSection(trimmed(assignment.substr(0, dot)), sections, place);
  const std::string key = trimmed(assignment.substr(dot + 1, equals - dot - 1));
  const std::string value = trimmed(assignment.substr(equals + 1));
  if (where.empty()) {
    options.set(key, value);
    return;
  }
  try {
    options.set(key, value);
  } catch (const UserError& error) {
    throw UserError(where + ": " + error.what());
  }
}

std::string sectionsToText(const std::vector<Options*>& sections) {
  std::ostringstream out;
  for (const Options* options : sections) {
    out << "[" << options->section() << "]\n";
    listOptions(*options, [&](const OptionText& option, const std::string& value,
                              const std::string& allowed) {
      out << "# " << option.help << "\n# " << allowed << " (" << option.source << ")\n"
          << option.key << " = " << value << "\n";
    });
    out << "\n";
  }
  return out.str();
}

}  // namespace toss
