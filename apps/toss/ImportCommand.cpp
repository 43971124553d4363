// SPDX-License-Identifier: BSD-3-Clause
#include <toss/import/KittiImport.h>

#include <iostream>
#include <memory>

#include "Command.h"
#include "ImportCommands.h"
#include "Progress.h"
#include "WholeNumber.h"

namespace toss {
namespace {

struct ImportRequest {
  std::filesystem::path input, output;
  KittiImportOptions options;
};

void import(ImportRequest& request, bool quiet) {
  Progress progress("importing", "%", quiet);
  request.options.progress = [&](double share) {
    progress.update(static_cast<std::uint64_t>(100.0 * share), share);
  };
  const KittiImportResult result = importKitti(request.input, request.output, request.options);
  if (quiet) return;
  std::cout << request.output.string() << ": " << result.scans << " scans, " << result.labelled
            << " with labels\n";
  for (const std::string& warning : result.input.warnings) std::cout << "note: " << warning << "\n";
}

}  // namespace

void addImportCommand(CLI::App& program, const Verbosity& verbosity) {
  auto request = std::make_shared<ImportRequest>();
  CLI::App* import_ = program.add_subcommand("import", "Turn other formats into a rawlog");
  import_->footer("Example: toss import kitti sequences/07 seq07.rawlog");
  import_->require_subcommand(1);
  CLI::App* kitti = import_->add_subcommand("kitti", "KITTI odometry or SemanticKITTI folder");
  kitti->footer("Example: toss import kitti sequences/07 seq07.rawlog --from 630 --to 820");
  kitti->add_option("DIR", request->input, "Folder with velodyne/ and poses.txt")->required();
  kitti->add_option("OUT", request->output, "The rawlog")->required();
  kitti->add_option("--from", request->options.from, "First scan, by the number in its name")
      ->check(wholeNumber());
  kitti->add_option("--to", request->options.to, "Last scan, included")->check(wholeNumber());
  kitti->add_flag("--gz", request->options.gz,
                  "Compress: a quarter smaller, some hundred times slower");
  kitti->callback([request, &verbosity] { import(*request, verbosity.quiet); });
  addImportOuster(*import_, verbosity);
  addImportVelodyne(*import_, verbosity);
  addImportPcd(*import_, verbosity);
}

}  // namespace toss
