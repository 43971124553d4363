// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/serialization/CArchive.h>
#include <toss/geometry/Error.h>
#include <toss/rawlog/AtomicFile.h>
#include <toss/rawlog/MetricMapFile.h>

#include "OutputStream.h"

namespace toss {
namespace {

constexpr const char* kRemedy = "give a static_map.metricmap of toss map or another MRPT point map";

mrpt::serialization::CSerializable::Ptr readFirstObject(const std::filesystem::path& file) {
  mrpt::io::CFileGZInputStream stream;
  if (!std::filesystem::is_regular_file(file) || !stream.open(file.string()))
    throw UserError(file.string(), "can not be read", "check the path and its permissions");
  try {
    return mrpt::serialization::archiveFrom(stream).ReadObject();
  } catch (const std::exception&) {
    throw UserError(file.string() + ": object 0", "is cut short, damaged or of an unknown class",
                    kRemedy);
  }
}

}  // namespace

std::shared_ptr<mrpt::maps::CPointsMapXYZI> toPointsMap(const std::vector<MapPoint>& points) {
  auto map = mrpt::maps::CPointsMapXYZI::Create();
  map->setSize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    map->setPointFast(i, points[i].x, points[i].y, points[i].z);
    map->setPointColor_fast(i, points[i].intensity, 0, 0);
  }
  map->mark_as_modified();
  return map;
}

void writeMetricMap(const std::filesystem::path& file, const std::vector<MapPoint>& points) {
  writeObjectFile(file, *toPointsMap(points));
}

void writeObjectFile(const std::filesystem::path& file,
                     const mrpt::serialization::CSerializable& object) {
  writeAtomically(file, [&](const std::filesystem::path& temporary) {
    OutputStream out(temporary, file.string(), OutputStream::Format::GzStored);
    out.writeObject(object);
    out.close();
  });
}

std::vector<MapPoint> readMetricMap(const std::filesystem::path& file) {
  const auto object = readFirstObject(file);
  const auto* map = dynamic_cast<const mrpt::maps::CPointsMap*>(object.get());
  if (!map) throw UserError(file.string() + ": object 0", "is no point map", kRemedy);
  const auto* withIntensity = dynamic_cast<const mrpt::maps::CPointsMapXYZI*>(map);
  std::vector<MapPoint> points(map->size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    map->getPointFast(i, points[i].x, points[i].y, points[i].z);
    if (withIntensity) points[i].intensity = withIntensity->getPointIntensity_fast(i);
  }
  return points;
}

}  // namespace toss
