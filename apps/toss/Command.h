// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

namespace toss {

/// How much a run says.
struct Verbosity {
  bool quiet = false, verbose = false;
};

struct ConfigurationRequest;

/// Adds --config and --set to a command, and --poses where `poses`. `request` must outlive it.
void addConfigurationOptions(CLI::App& command, ConfigurationRequest& request, bool poses = true);

// Each adds one sub-command to the program; its callback runs it and throws UserError where the
// input or the options are wrong.
void addMapCommand(CLI::App& program, const Verbosity& verbosity);
void addImportCommand(CLI::App& program, const Verbosity& verbosity);
void addSimulateCommand(CLI::App& program, const Verbosity& verbosity);
void addEvalCommand(CLI::App& program, const Verbosity& verbosity);
void addSnapshotCommand(CLI::App& program, const Verbosity& verbosity);
void addInfoCommand(CLI::App& program, const Verbosity& verbosity);
void addCheckCommand(CLI::App& program, const Verbosity& verbosity);
void addOdometryCommand(CLI::App& program, const Verbosity& verbosity);
void addConfigCommand(CLI::App& program, const Verbosity& verbosity);
void addBenchmarkCommand(CLI::App& program, const Verbosity& verbosity);

}  // namespace toss
