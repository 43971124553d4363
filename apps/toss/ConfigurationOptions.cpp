// SPDX-License-Identifier: BSD-3-Clause
#include "Command.h"
#include "RunConfiguration.h"

namespace toss {

void addConfigurationOptions(CLI::App& command, ConfigurationRequest& request, bool poses) {
  command.add_option("--config", request.file, "Configuration, an .ini file");
  command.add_option("--set", request.settings, "section.key=value, repeatable")
      ->allow_extra_args(false);
  if (!poses) return;
  command.add_option("--poses", request.poses,
                     "File with poses, TUM or KITTI format, in place of those of the input");
}

}  // namespace toss
