// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/geometry/Options.h>

#include <iostream>
#include <string>
#include <vector>

#include "Command.h"
#include "Interruption.h"

namespace {

constexpr int kWrongInput = 1, kInternalFault = 2, kInterrupted = 130;

/// Throws UserError naming the nearest command where `arguments` name one that `program` lacks.
void checkCommands(const CLI::App& program, const std::vector<std::string>& arguments) {
  const CLI::App* app = &program;
  for (const std::string& argument : arguments) {
    if (argument.empty() || argument.front() == '-') continue;
    std::vector<std::string> names;
    const CLI::App* next = nullptr;
    for (const CLI::App* command : app->get_subcommands([](const CLI::App*) { return true; })) {
      names.push_back(command->get_name());
      if (command->check_name(argument)) next = command;
    }
    if (names.empty()) return;
    if (next == nullptr)
      throw toss::UserError("'" + argument + "'", "is no command",
                            "did you mean '" + toss::nearestName(argument, names) + "'?");
    app = next;
  }
}

int run(int argc, char** argv) {
  CLI::App program("TOSS: clean static maps from LiDAR logs full of people and vehicles", "toss");
  program.set_version_flag("--version", "toss " TOSS_VERSION);
  program.require_subcommand(1);
  program.fallthrough();
  toss::Verbosity verbosity;
  auto* quiet = program.add_flag("-q,--quiet", verbosity.quiet, "Say nothing but errors");
  program.add_flag("-v,--verbose", verbosity.verbose, "Say more")->excludes(quiet);
  toss::addMapCommand(program, verbosity);
  toss::addImportCommand(program, verbosity);
  toss::addSimulateCommand(program, verbosity);
  toss::addEvalCommand(program, verbosity);
  toss::addSnapshotCommand(program, verbosity);
  toss::addInfoCommand(program, verbosity);
  toss::addCheckCommand(program, verbosity);
  toss::addOdometryCommand(program, verbosity);
  toss::addConfigCommand(program, verbosity);
  toss::addBenchmarkCommand(program, verbosity);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error);
    checkCommands(program, {argv + 1, argv + argc});
    std::cerr << "toss: " << error.what() << "; see toss --help\n";
    return kWrongInput;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const toss::UserError& error) {
    std::cerr << "toss: " << error.what() << "\n";
    return kWrongInput;
  } catch (const toss::Interrupted&) {
    std::cerr << "toss: interrupted; what was unfinished is cleared away\n";
    return kInterrupted;
  } catch (const std::exception& error) {
    std::cerr << "toss: internal fault: " << error.what() << "\n";
    return kInternalFault;
  }
}
