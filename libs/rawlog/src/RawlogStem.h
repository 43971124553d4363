// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace toss {

/// <stem><ending> beside a rawlog; "a.rawlog" and "a.rawlog.gz" have the same stem.
inline std::filesystem::path besideRawlog(const std::filesystem::path& rawlog, const char* ending) {
  std::filesystem::path stem = rawlog.stem();
  if (rawlog.extension() == ".gz") stem = stem.stem();
  stem += ending;
  return rawlog.parent_path() / stem;
}

}  // namespace toss
