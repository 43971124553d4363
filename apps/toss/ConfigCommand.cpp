// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/OptionSections.h>
#include <toss/geometry/SensorModel.h>

#include <iostream>
#include <memory>

#include "Command.h"
#include "RunConfiguration.h"

namespace toss {

void addConfigCommand(CLI::App& program, const Verbosity&) {
  auto request = std::make_shared<ConfigurationRequest>();
  auto sensor = std::make_shared<std::string>();
  CLI::App* command =
      program.add_subcommand("config", "Print the configuration with every key documented");
  command->footer("Example: toss config --sensor VLP-16 > my.ini");
  command->add_option("--sensor", *sensor, "With the preset of this sensor, such as HDL-64E");
  command->add_option("--config", request->file, "With the values of this .ini file");
  command->add_option("--keep", request->keep, "As toss map --keep: static, balanced or remove");
  command->add_option("--set", request->settings, "section.key=value, repeatable")
      ->allow_extra_args(false);
  command->callback([request, sensor] {
    if (!sensor->empty()) sensorByName(*sensor);
    RunConfiguration configuration = configure(*request, *sensor);
    std::cout << sectionsToText(configuration.sections());
  });
}

}  // namespace toss
