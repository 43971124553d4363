// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace toss {

/// The entries of a metadata file, found by name whichever section they stand in. All members throw
/// UserError naming file and entry where a value is of another kind than asked for.
class OusterMetadataEntries {
 public:
  /// Throws UserError where the file can't be read or is no JSON object.
  explicit OusterMetadataEntries(std::filesystem::path file);

  std::optional<std::string> text(const std::string& name) const;
  /// A whole number, also where it is written as text, from 0 to `highest`.
  std::optional<std::uint64_t> wholeNumber(const std::string& name, std::uint64_t highest) const;
  std::optional<double> number(const std::string& name) const;
  /// Finite numbers; of any count unless `count` is given.
  std::optional<std::vector<double>> numbers(const std::string& name,
                                             std::optional<std::size_t> count = {}) const;

  /// Throws UserError: what is wrong with the entry, and what to do if not to save the file again.
  [[noreturn]] void fail(const std::string& name, const std::string& problem,
                         const std::string& remedy = "") const;

 private:
  const nlohmann::json* find(const std::string& name) const;

  std::filesystem::path file_;
  nlohmann::json root_;
};

}  // namespace toss
