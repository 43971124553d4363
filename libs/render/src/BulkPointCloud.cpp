// SPDX-License-Identifier: BSD-3-Clause
#include "BulkPointCloud.h"

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

namespace toss {
namespace {

/// The first place from `begin` on where two texts differ.
std::size_t firstDifference(const std::string& a, const std::string& b, std::size_t begin) {
  const auto start = static_cast<std::ptrdiff_t>(begin);
  return static_cast<std::size_t>(
      std::mismatch(a.begin() + start, a.end(), b.begin() + start, b.end()).first - a.begin());
}

}  // namespace

using mrpt::img::TColor;
using mrpt::math::TPoint3Df;
static_assert(sizeof(TPoint3Df) == 12 && sizeof(TColor) == 4, "written as they are in memory");

void BulkPointCloud::assign(const PointBatch& batch) {
  m_vertex_buffer_data.clear();
  m_vertex_buffer_data.reserve(batch.positions.size());
  for (const Eigen::Vector3f& p : batch.positions)
    m_vertex_buffer_data.emplace_back(p.x(), p.y(), p.z());
  m_color_buffer_data.clear();
  m_color_buffer_data.reserve(batch.colors.size());
  for (const Color& color : batch.colors)
    m_color_buffer_data.emplace_back(color.red, color.green, color.blue);
  markAllPointsAsNew();
}

std::string BulkPointCloud::written(std::size_t count) const {
  const auto firstOf = [count](auto& all) {
    return std::exchange(all, {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)});
  };
  auto positions = firstOf(m_vertex_buffer_data);
  auto colors = firstOf(m_color_buffer_data);
  mrpt::io::CMemoryStream stream;
  auto archive = mrpt::serialization::archiveFrom(stream);
  CPointCloudColoured::serializeTo(archive);
  m_vertex_buffer_data.swap(positions);
  m_color_buffer_data.swap(colors);
  return {static_cast<const char*>(stream.getRawBufferData()),
          static_cast<std::size_t>(stream.getTotalBytesCount())};
}

void BulkPointCloud::serializeTo(mrpt::serialization::CArchive& out) const {
  const auto count = static_cast<std::uint32_t>(m_vertex_buffer_data.size());
  if (count == 0) return CPointCloudColoured::serializeTo(out);
  // A cloud of one point begins to differ from one of none where the number of its positions
  // stands, and behind the position again where that of its colours does.
  const std::string none = written(0), one = written(1);
  const std::size_t positions = firstDifference(none, one, 0);
  const std::size_t colors =
      firstDifference(none,
                      one.substr(0, positions + sizeof count) +
                          one.substr(positions + sizeof count + sizeof(TPoint3Df)),
                      positions + sizeof count);
  const auto write = [&](std::size_t begin, std::size_t end, const void* values, std::size_t size) {
    out.WriteBuffer(none.data() + begin, end - begin);
    out << count;
    out.WriteBuffer(values, count * size);
  };
  write(0, positions, m_vertex_buffer_data.data(), sizeof(TPoint3Df));
  write(positions + sizeof count, colors, m_color_buffer_data.data(), sizeof(TColor));
  out.WriteBuffer(none.data() + colors + sizeof count, none.size() - colors - sizeof count);
}

}  // namespace toss
