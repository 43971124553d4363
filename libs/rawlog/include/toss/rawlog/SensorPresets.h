// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

namespace toss {

/// Text of config/sensors/NAME.ini by NAME.
const std::map<std::string, std::string>& sensorPresets();

}  // namespace toss
