// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CObservationVelodyneScan.h>

namespace toss {

/// Whether generatePointCloud() decodes the first 16 of the 32 returns of each block only: MRPT
/// 2.5.8 does, which loses every second firing of a VLP-16 and half the lasers of the others.
bool mrptLosesSecondHalves();

/// A scan whose blocks have their second 16 returns in the place of the first, with the calibration
/// of their lasers and the azimuth [0.01 degrees] of their firings: what generatePointCloud() loses
/// of `scan` it gives of this. Lasers of sensors with more than 16 count 16 less in it.
mrpt::obs::CObservationVelodyneScan secondHalves(const mrpt::obs::CObservationVelodyneScan& scan);

}  // namespace toss
