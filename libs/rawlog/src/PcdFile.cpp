// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/rawlog/PcdFile.h>

#include <fstream>

#include "PointRecords.h"

namespace toss {

PcdScan readPcdScan(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!std::filesystem::is_regular_file(file) || !in)
    throw UserError(file.string(), "can not be read", "check the path and its permissions");
  const PointTable table = readPcdHeader(in, file);
  PointRows rows = readRows(in, table, file);
  return {std::move(rows.points), rows.offset, table.viewpoint};
}

}  // namespace toss
