// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace toss {

/// What the user gave is wrong (a file, an option, a pose path), and the user can mend it.
/// what() is one line: where, what is wrong, what to do. Programs print it and exit with 1.
class UserError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;

  /// `where`: file or option, with the place in it ("a.rawlog: object 17").
  /// `problem`: what is wrong there. `remedy`: what the user can do about it.
  UserError(const std::string& where, const std::string& problem, const std::string& remedy)
      : std::runtime_error(where + ": " + problem + "; " + remedy) {}
};

}  // namespace toss
