// SPDX-License-Identifier: BSD-3-Clause
#include "OptionVisitors.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>

namespace toss {
namespace {

std::string rangeText(const std::string& low, const std::string& high, const char* unit) {
  return low + " to " + high + (*unit != '\0' ? std::string(" ") + unit : std::string());
}

std::string join(const std::vector<std::string>& names) {
  std::string result;
  for (const std::string& name : names) result += (result.empty() ? "" : " | ") + name;
  return result;
}

bool parseReal(const std::string& text, double& value) {
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && rest == end;
}

bool parseInteger(const std::string& text, int& value) {
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && rest == end;
}

}  // namespace

std::string exactText(double value) {
  char buffer[64];
  const auto result = std::to_chars(buffer, buffer + sizeof(buffer), value);
  return std::string(buffer, result.ptr);
}

void OptionReader::fail(const OptionText& option, const std::string& value,
                        const std::string& expected) const {
  throw UserError(where_ + "." + option.key, "the value '" + value + "' is not allowed",
                  "give " + expected);
}

void OptionReader::real(const OptionText& text, double& value, double low, double high) {
  std::string found;
  if (!lookUp_(text.key, found)) return;
  double parsed = 0;
  // Negated so that NaN fails too.
  if (!parseReal(found, parsed) || !(parsed >= low && parsed <= high))
    fail(text, found, "a number from " + rangeText(exactText(low), exactText(high), text.unit));
  value = parsed;
}

void OptionReader::integer(const OptionText& text, int& value, int low, int high) {
  std::string found;
  if (!lookUp_(text.key, found)) return;
  int parsed = 0;
  if (!parseInteger(found, parsed) || parsed < low || parsed > high)
    fail(text, found,
         "a whole number from " + rangeText(std::to_string(low), std::to_string(high), text.unit));
  value = parsed;
}

void OptionReader::flag(const OptionText& text, bool& value) {
  std::string found;
  if (!lookUp_(text.key, found)) return;
  if (found != "true" && found != "false" && found != "1" && found != "0")
    fail(text, found, "true or false");
  value = found == "true" || found == "1";
}

void OptionReader::string(const OptionText& text, std::string& value) {
  std::string found;
  if (lookUp_(text.key, found)) value = found;
}

void OptionReader::choice(const OptionText& text, int& index,
                          const std::vector<std::string>& names) {
  std::string found;
  if (!lookUp_(text.key, found)) return;
  const auto match = std::find(names.begin(), names.end(), found);
  if (match == names.end()) fail(text, found, "one of " + join(names));
  index = static_cast<int>(match - names.begin());
}

void OptionWriter::real(const OptionText& text, double& value, double low, double high) {
  sink_(text, exactText(value), rangeText(exactText(low), exactText(high), text.unit));
}

void OptionWriter::integer(const OptionText& text, int& value, int low, int high) {
  sink_(text, std::to_string(value),
        rangeText(std::to_string(low), std::to_string(high), text.unit));
}

void OptionWriter::flag(const OptionText& text, bool& value) {
  sink_(text, value ? "true" : "false", "true | false");
}

void OptionWriter::string(const OptionText& text, std::string& value) {
  sink_(text, value, "any text");
}

void OptionWriter::choice(const OptionText& text, int& index,
                          const std::vector<std::string>& names) {
  if (index < 0 || index >= static_cast<int>(names.size()))
    throw std::logic_error(std::string("option ") + text.key + " has more values than names");
  sink_(text, names[static_cast<std::size_t>(index)], join(names));
}

void listOptions(const Options& options, const OptionWriter::Sink& sink) {
  OptionWriter writer(sink);
  // The writer only reads, but visit() serves readers and writers alike.
  const_cast<Options&>(options).visit(writer);
}

}  // namespace toss
