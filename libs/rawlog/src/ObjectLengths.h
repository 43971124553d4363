// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace toss {

/// MRPT makes room for as many points as a length field says before it reads them: a flipped bit
/// there would take all memory. Looks at the length fields of a serialized object of points
/// (CObservationPointCloud, CObservationVelodyneScan) before it is read.
///
/// `head`: its first bytes (4096 are plenty). `bytesLeft`: bytes that may follow from its beginning
/// on. Returns what is impossible about it, "" if nothing or if the object is of another kind.
std::string impossibleLength(std::string_view head, std::uint64_t bytesLeft);

}  // namespace toss
