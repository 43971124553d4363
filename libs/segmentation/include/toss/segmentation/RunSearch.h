// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/RunColumns.h>
#include <toss/segmentation/RunKeys.h>

namespace toss {

/// What runs are searched by: by column first, and those found by what a glance tells.
struct RunSearch {
  RunColumns columns;
  RunKeys keys;
};

}  // namespace toss
