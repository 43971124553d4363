// SPDX-License-Identifier: BSD-3-Clause
#include <toss/rawlog/ScanSource.h>

#include <system_error>

#include "KittiFolderSource.h"
#include "RawlogSource.h"
#include "RawlogStem.h"

namespace toss {

std::unique_ptr<ScanSource> openScans(const std::filesystem::path& input,
                                      const InputOptions& options) {
  options.check();
  std::error_code error;
  if (std::filesystem::is_directory(input, error))
    return std::make_unique<KittiFolderSource>(input, options);
  return std::make_unique<RawlogSource>(input, options);
}

std::filesystem::path labelsFolderBeside(const std::filesystem::path& rawlog) {
  return besideRawlog(rawlog, "_labels");
}

std::filesystem::path labelsFolderOf(const std::filesystem::path& input) {
  std::error_code error;
  const std::filesystem::path folder =
      std::filesystem::is_directory(input, error) ? input / "labels" : labelsFolderBeside(input);
  return std::filesystem::is_directory(folder, error) ? folder : std::filesystem::path();
}

}  // namespace toss
