// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace toss {

/// Columns of tracks.csv in their order (spec, outputs of `toss map`).
constexpr const char* kTracksCsvColumns[] = {"scan", "time", "track", "class", "x",  "y",  "z",
                                             "yaw",  "l",    "w",     "h",     "vx", "vy", "vz"};

}  // namespace toss
