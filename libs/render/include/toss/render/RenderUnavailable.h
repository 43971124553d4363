// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Error.h>

namespace toss {

/// This machine can not draw off-screen: what() names the packages that are missing. Everything but
/// pictures works without.
class RenderUnavailable : public UserError {
 public:
  using UserError::UserError;
};

}  // namespace toss
