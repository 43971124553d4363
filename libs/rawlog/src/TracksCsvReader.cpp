// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/rawlog/TracksCsv.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <string>
#include <string_view>

#include "TracksCsvColumns.h"

namespace toss {
namespace {

constexpr std::size_t kColumnCount = std::size(kTracksCsvColumns);

std::vector<std::string_view> splitAtCommas(std::string_view line) {
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    cells.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  return cells;
}

/// Cells of one line by the order of kTracksCsvColumns, with conversion and error messages.
class Line {
 public:
  using Positions = std::array<std::size_t, kColumnCount>;

  Line(std::string_view text, const Positions& positions, std::string where)
      : cells_(splitAtCommas(text)), positions_(positions), where_(std::move(where)) {
    if (cells_.size() <= *std::max_element(positions.begin(), positions.end()))
      fail("has only " + std::to_string(cells_.size()) + " cells");
  }

  std::string_view text(std::size_t column) const { return cells_[positions_[column]]; }

  template <typename Number>
  Number number(std::size_t column) const {
    Number value{};
    const std::string_view cell = text(column);
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size())
      fail("column " + std::string(kTracksCsvColumns[column]) + " is no number: '" +
           std::string(cell) + "'");
    return value;
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw UserError(where_, problem, "give a tracks.csv that toss map has written");
  }

 private:
  std::vector<std::string_view> cells_;
  const Positions& positions_;
  std::string where_;
};

Line::Positions findColumns(std::string_view header, const std::string& file) {
  const auto cells = splitAtCommas(header);
  Line::Positions positions{};
  for (std::size_t column = 0; column < kColumnCount; ++column) {
    const auto found = std::find(cells.begin(), cells.end(), kTracksCsvColumns[column]);
    if (found == cells.end())
      throw UserError(file + ": line 1",
                      "has no column '" + std::string(kTracksCsvColumns[column]) + "'",
                      "give a tracks.csv that toss map has written");
    positions[column] = static_cast<std::size_t>(found - cells.begin());
  }
  return positions;
}

TrackRow parseRow(const Line& line) {
  TrackRow row;
  row.scan = line.number<std::uint64_t>(0);
  row.time = line.number<double>(1);
  row.sample.track = line.number<TrackId>(2);
  row.sample.moving = line.text(3) == "moving";
  if (!row.sample.moving && line.text(3) != "static")
    line.fail("class is neither static nor moving: '" + std::string(line.text(3)) + "'");
  std::array<double, 10> values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = line.number<double>(4 + i);
  row.sample.updated = true;
  row.sample.box.center = {values[0], values[1], values[2]};
  row.sample.box.yaw = values[3];
  row.sample.box.length = values[4];
  row.sample.box.width = values[5];
  row.sample.box.height = values[6];
  row.sample.velocity = {values[7], values[8], values[9]};
  return row;
}

}  // namespace

std::vector<TrackRow> readTracksCsv(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string text;
  if (!std::filesystem::is_regular_file(file) || !in || !std::getline(in, text))
    throw UserError(file.string(), "is missing, empty or not readable", "check the path");
  const Line::Positions positions = findColumns(text, file.string());
  std::vector<TrackRow> rows;
  for (std::size_t number = 2; std::getline(in, text); ++number) {
    if (text.empty() || text == "\r") continue;
    rows.push_back(
        parseRow(Line(text, positions, file.string() + ": line " + std::to_string(number))));
  }
  return rows;
}

}  // namespace toss
