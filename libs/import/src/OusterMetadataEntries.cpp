// SPDX-License-Identifier: BSD-3-Clause
#include "OusterMetadataEntries.h"

#include <toss/geometry/Error.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

namespace toss {
namespace {

constexpr const char* kRemedy =
    "save the metadata of the sensor again (http://SENSOR/api/v1/sensor/metadata)";

nlohmann::json parseFile(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file))
    throw UserError(file.string(), "can't be read", "check the path and its permissions");
  try {
    return nlohmann::json::parse(in);
  } catch (const nlohmann::json::parse_error& error) {
    throw UserError(file.string(), "is no JSON, from byte " + std::to_string(error.byte) + " on",
                    kRemedy);
  }
}

}  // namespace

OusterMetadataEntries::OusterMetadataEntries(std::filesystem::path file)
    : file_(std::move(file)), root_(parseFile(file_)) {
  if (!root_.is_object()) throw UserError(file_.string(), "is no JSON object", kRemedy);
}

void OusterMetadataEntries::fail(const std::string& name, const std::string& problem,
                                 const std::string& remedy) const {
  throw UserError(file_.string(), "entry '" + name + "' " + problem,
                  remedy.empty() ? kRemedy : remedy);
}

const nlohmann::json* OusterMetadataEntries::find(const std::string& name) const {
  // No name occurs in two sections with different meanings. The format in use comes first: the
  // configuration may have been changed since the sensor started.
  for (const char* section : {"lidar_data_format", "data_format", "beam_intrinsics",
                              "lidar_intrinsics", "sensor_info", "config_params"}) {
    const auto group = root_.find(section);
    if (group == root_.end() || !group->is_object()) continue;
    const auto entry = group->find(name);
    if (entry != group->end() && !entry->is_null()) return &*entry;
  }
  const auto entry = root_.find(name);
  return entry == root_.end() || entry->is_null() ? nullptr : &*entry;
}

std::optional<std::string> OusterMetadataEntries::text(const std::string& name) const {
  const nlohmann::json* entry = find(name);
  if (entry == nullptr) return std::nullopt;
  if (!entry->is_string()) fail(name, "is no text");
  return entry->get<std::string>();
}

std::optional<std::uint64_t> OusterMetadataEntries::wholeNumber(const std::string& name,
                                                                std::uint64_t highest) const {
  const nlohmann::json* entry = find(name);
  if (entry == nullptr || *entry == "") return std::nullopt;
  std::uint64_t value = 0;
  if (entry->is_string()) {
    const auto& digits = entry->get_ref<const std::string&>();
    const char* const end = digits.data() + digits.size();
    const auto [next, error] = std::from_chars(digits.data(), end, value);
    if (error != std::errc() || next != end) fail(name, "is no whole number");
  } else {
    if (!entry->is_number_unsigned()) fail(name, "is no whole number");
    value = entry->get<std::uint64_t>();
  }
  if (value > highest) fail(name, "is greater than " + std::to_string(highest));
  return value;
}

std::optional<double> OusterMetadataEntries::number(const std::string& name) const {
  const nlohmann::json* entry = find(name);
  if (entry == nullptr) return std::nullopt;
  if (!entry->is_number()) fail(name, "is no number");
  return entry->get<double>();
}

std::optional<std::vector<double>> OusterMetadataEntries::numbers(
    const std::string& name, std::optional<std::size_t> count) const {
  const nlohmann::json* entry = find(name);
  if (entry == nullptr) return std::nullopt;
  const bool listed =
      entry->is_array() && std::all_of(entry->begin(), entry->end(), [](const nlohmann::json& v) {
        return v.is_number() && std::isfinite(v.get<double>());
      });
  if (!listed) fail(name, "is no list of numbers");
  if (count && entry->size() != *count)
    fail(name,
         "has " + std::to_string(entry->size()) + " numbers instead of " + std::to_string(*count));
  return entry->get<std::vector<double>>();
}

}  // namespace toss
