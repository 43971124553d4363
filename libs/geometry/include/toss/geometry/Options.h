// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/config/CLoadableOptions.h>
#include <toss/geometry/Error.h>

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace toss {

/// What is written about one option wherever it is shown: help, config/toss.ini, errors.
struct OptionText {
  /// Key in the .ini section, lower case with underscores.
  const char* key;
  /// Unit as it is shown, e.g. "m", "s", "rad", "" for pure numbers.
  const char* unit;
  /// One sentence: what it does, and which way a larger value pulls.
  const char* help;
  /// Where the default comes from: paper section or equation, or spec section.
  const char* source;
};

/// Sees each option of a module once. Loading, saving, checking and listing are visitors, so a
/// module names each of its options in a single place: its visit().
class OptionVisitor {
 public:
  virtual ~OptionVisitor() = default;
  /// A real number within [low, high].
  virtual void real(const OptionText& text, double& value, double low, double high) = 0;
  /// A whole number within [low, high].
  virtual void integer(const OptionText& text, int& value, int low, int high) = 0;
  /// true or false.
  virtual void flag(const OptionText& text, bool& value) = 0;
  /// Free text.
  virtual void string(const OptionText& text, std::string& value) = 0;
  /// One of `names`, given as its index.
  virtual void choice(const OptionText& text, int& index,
                      const std::vector<std::string>& names) = 0;

  /// One of `names`, in the order of the enumeration's values 0, 1, ...
  template <typename Enum, typename = std::enable_if_t<std::is_enum_v<Enum>>>
  void choice(const OptionText& text, Enum& value, const std::vector<std::string>& names) {
    int index = static_cast<int>(value);
    choice(text, index, names);
    value = static_cast<Enum>(index);
  }
};

/// Base of every module's options struct: MRPT's CLoadableOptions, implemented once for all.
class Options : public mrpt::config::CLoadableOptions {
 public:
  /// Name of the module's .ini section, e.g. "ground".
  virtual const char* section() const = 0;
  /// Shows every option to `visitor`, in the order in which they are documented.
  virtual void visit(OptionVisitor& visitor) = 0;

  /// Reads the keys that `source` has; absent ones keep their value. Throws UserError for a value
  /// that is no number or choice, or lies out of range, naming section, key, value and bounds.
  void loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                          const std::string& sectionName) override;
  /// Writes every key with its help, unit, range and source as comment.
  void saveToConfigFile(mrpt::config::CConfigFileBase& target,
                        const std::string& sectionName) const override;
  void dumpToTextStream(std::ostream& out) const override;

  /// Sets one option from text. Throws UserError for an unknown key, naming the nearest known one.
  void set(const std::string& key, const std::string& value);
  /// Throws UserError at the first value that is out of range. Modules call it when they are made.
  void check() const;
  /// The keys of all options, in order of visit(), without and with their values as text.
  std::vector<std::string> keys() const;
  std::vector<std::pair<std::string, std::string>> values() const;
};

/// The entry of `known` with the smallest edit distance to `name`; "" if `known` is empty.
std::string nearestName(const std::string& name, const std::vector<std::string>& known);

}  // namespace toss
