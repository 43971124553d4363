// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/config/CConfigFileBase.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <toss/geometry/Options.h>

#include <algorithm>
#include <numeric>
#include <ostream>

#include "OptionVisitors.h"

namespace toss {

void Options::loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                                 const std::string& sectionName) {
  OptionReader reader(sectionName, [&](const std::string& key, std::string& text) {
    if (!source.keyExists(sectionName, key)) return false;
    text = source.read_string(sectionName, key, "");
    return true;
  });
  visit(reader);
}

void Options::saveToConfigFile(mrpt::config::CConfigFileBase& target,
                               const std::string& sectionName) const {
  listOptions(
      *this, [&](const OptionText& option, const std::string& value, const std::string& allowed) {
        target.write(sectionName, option.key, value, -1, -1,
                     std::string(option.help) + " (" + allowed + ") [" + option.source + "]");
      });
}

void Options::dumpToTextStream(std::ostream& out) const {
  mrpt::config::CConfigFileMemory memory;
  saveToConfigFile(memory, section());
  out << memory.getContent();
}

void Options::set(const std::string& key, const std::string& value) {
  const std::vector<std::string> known = keys();
  if (std::find(known.begin(), known.end(), key) == known.end())
    throw UserError(std::string(section()) + "." + key, "there is no such option",
                    "did you mean '" + nearestName(key, known) + "'?");
  OptionReader reader(section(), [&](const std::string& each, std::string& text) {
    if (each != key) return false;
    text = value;
    return true;
  });
  visit(reader);
}

void Options::check() const {
  // Written out and read back: what can be read is within its bounds.
  const auto all = values();
  OptionReader reader(section(), [&](const std::string& key, std::string& text) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& entry) { return entry.first == key; });
    text = found->second;
    return true;
  });
  const_cast<Options&>(*this).visit(reader);
}

std::vector<std::pair<std::string, std::string>> Options::values() const {
  std::vector<std::pair<std::string, std::string>> result;
  listOptions(*this, [&](const OptionText& option, const std::string& value, const std::string&) {
    result.emplace_back(option.key, value);
  });
  return result;
}

std::vector<std::string> Options::keys() const {
  std::vector<std::string> result;
  for (const auto& [key, value] : values()) result.push_back(key);
  return result;
}

namespace {

std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({substituted, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

}  // namespace

std::string nearestName(const std::string& name, const std::vector<std::string>& known) {
  const auto nearest = std::min_element(
      known.begin(), known.end(),
      [&](const auto& a, const auto& b) { return editDistance(name, a) < editDistance(name, b); });
  return nearest == known.end() ? std::string() : *nearest;
}

}  // namespace toss
