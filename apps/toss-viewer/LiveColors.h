// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/render/Color.h>

namespace toss {

/// Colours of the layers, in the window and in films.
constexpr Color kGroundColor{104, 118, 84};
constexpr Color kStandingColor{64, 156, 255};
constexpr Color kMovingColor{255, 52, 44};
constexpr Color kFlipColor{255, 230, 0};
constexpr Color kStandingBoxColor{96, 108, 128};
constexpr Color kTrajectoryColor{255, 255, 255};
constexpr Color kBackground{13, 16, 21};

}  // namespace toss
