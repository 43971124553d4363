// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/core/exceptions.h>
#include <toss/geometry/Error.h>

namespace toss {

/// A UserError on its way through MRPT, which hands on exceptions of this base as they are and
/// replaces others by its own, their type lost and a stack trace added to their text.
class PlugInError : public UserError, public mrpt::ExceptionWithCallBackBase {
 public:
  explicit PlugInError(const UserError& error)
      : UserError(error), ExceptionWithCallBackBase(error.what(), {}) {}
};

/// What `work` gives; its UserErrors become PlugInErrors.
template <typename Work>
auto passingUserErrors(const Work& work) {
  try {
    return work();
  } catch (const UserError& error) {
    throw PlugInError(error);
  }
}

}  // namespace toss
