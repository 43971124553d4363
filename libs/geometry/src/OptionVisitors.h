// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Options.h>

#include <functional>
#include <string>
#include <vector>

namespace toss {

/// Text of a real number that reads back to the same bits, as short as that allows.
std::string exactText(double value);

/// Gives each option that `lookUp` knows the value of the text found there. `where` names the
/// source in errors. lookUp(key, text) returns false to leave an option alone.
class OptionReader : public OptionVisitor {
 public:
  using LookUp = std::function<bool(const std::string& key, std::string& text)>;
  OptionReader(std::string where, LookUp lookUp)
      : where_(std::move(where)), lookUp_(std::move(lookUp)) {}

  using OptionVisitor::choice;
  void real(const OptionText& text, double& value, double low, double high) override;
  void integer(const OptionText& text, int& value, int low, int high) override;
  void flag(const OptionText& text, bool& value) override;
  void string(const OptionText& text, std::string& value) override;
  void choice(const OptionText& text, int& index, const std::vector<std::string>& names) override;

 private:
  [[noreturn]] void fail(const OptionText& option, const std::string& value,
                         const std::string& expected) const;
  std::string where_;
  LookUp lookUp_;
};

/// Hands out every option as text, with the values that it may take.
class OptionWriter : public OptionVisitor {
 public:
  using Sink = std::function<void(const OptionText& option, const std::string& value,
                                  const std::string& allowed)>;
  explicit OptionWriter(Sink sink) : sink_(std::move(sink)) {}

  using OptionVisitor::choice;
  void real(const OptionText& text, double& value, double low, double high) override;
  void integer(const OptionText& text, int& value, int low, int high) override;
  void flag(const OptionText& text, bool& value) override;
  void string(const OptionText& text, std::string& value) override;
  void choice(const OptionText& text, int& index, const std::vector<std::string>& names) override;

 private:
  Sink sink_;
};

/// Calls `sink` with every option of `options`, which stays as it is.
void listOptions(const Options& options, const OptionWriter::Sink& sink);

}  // namespace toss
