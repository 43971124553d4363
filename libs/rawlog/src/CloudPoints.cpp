// SPDX-License-Identifier: BSD-3-Clause
// Points of a CObservationPointCloud, inside the rawlog or in an external file.
#include <mrpt/io/lazy_load_path.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/serialization/CArchive.h>
#include <toss/geometry/Error.h>
#include <toss/rawlog/ObservationPoints.h>

#include <algorithm>

#include "InputStream.h"
#include "KittiPoints.h"

namespace toss {
namespace {

namespace fs = std::filesystem;

using mrpt::obs::CObservationPointCloud;
using Format = CObservationPointCloud::ExternalStorageFormat;

void copyMap(const mrpt::maps::CPointsMap& map, PointCloud& points) {
  points.resize(map.size());
  const auto copy = [](const auto& from, std::vector<float>& to) {
    std::copy(from.begin(), from.end(), to.begin());
  };
  copy(map.getPointsBufferRef_x(), points.x);
  copy(map.getPointsBufferRef_y(), points.y);
  copy(map.getPointsBufferRef_z(), points.z);
  const auto* xyzi = dynamic_cast<const mrpt::maps::CPointsMapXYZI*>(&map);
  if (!xyzi) points.intensity.clear();
  // One by one: what MRPT calls its buffer of intensities changes from version to version.
  for (std::size_t i = 0; i < points.intensity.size(); ++i)
    points.intensity[i] = xyzi->getPointIntensity_fast(i);
}

/// MRPT's own search, CRawlog::detectImagesDirectory(), loses the slash after the rawlog's folder.
fs::path externalFolder(const fs::path& rawlog) {
  const std::string stem = (rawlog.parent_path() / rawlog.stem()).string();
  for (const fs::path& folder :
       {fs::path(stem + "_Images"), fs::path(stem + "_images"), rawlog.parent_path() / "Images"})
    if (fs::is_directory(folder)) return folder;
  return stem + "_Images";
}

/// MRPT would take the end of a gz file that is cut off for its proper end.
mrpt::maps::CPointsMap::Ptr readSerialized(const std::filesystem::path& file) {
  InputStream stream(file);
  auto object = mrpt::serialization::archiveFrom(stream).ReadObject();
  if (!stream.atEnd() || !stream.damage().empty())
    throw UserError(file.string(),
                    stream.damage().empty() ? "goes on after its point map" : stream.damage(),
                    "copy the file again");
  auto map = std::dynamic_pointer_cast<mrpt::maps::CPointsMap>(object);
  if (!map) throw UserError(file.string(), "holds no point map", "copy the file again");
  return map;
}

void readExternal(CObservationPointCloud& observation, Format format,
                  const std::filesystem::path& rawlog, const std::filesystem::path& file,
                  PointCloud& points) {
  if (!std::filesystem::exists(file))
    throw UserError(file.string(), "does not exist", "put the external files of the rawlog there");
  if (format == Format::KittiBinFile && file.extension() != ".gz") {
    readKittiPoints(file, points);
  } else if (format == Format::MRPT_Serialization) {
    copyMap(*readSerialized(file), points);
  } else {
    // The base folder is global in MRPT: it is set anew each time, other logs may be open.
    mrpt::io::setLazyLoadPathBase(externalFolder(rawlog).string());
    observation.load();
    copyMap(*observation.pointcloud, points);
  }
}

/// MRPT keeps the format to itself; its serialization tells it.
Format formatOf(const CObservationPointCloud& observation) {
  struct Access : CObservationPointCloud {
    static Format of(const CObservationPointCloud& o) { return o.*(&Access::m_externally_stored); }
  };
  return Access::of(observation);
}

}  // namespace

void readCloudPoints(mrpt::obs::CObservation& observation, const std::filesystem::path& rawlog,
                     const std::string& place, PosedScan& scan) {
  auto& cloud = dynamic_cast<CObservationPointCloud&>(observation);
  if (cloud.pointcloud) {
    copyMap(*cloud.pointcloud, scan.points);
    return;
  }
  scan.points.resize(0);
  if (!cloud.isExternallyStored()) return;
  std::filesystem::path file = cloud.getExternalStorageFile();
  if (file.is_relative()) file = externalFolder(rawlog) / file;
  try {
    readExternal(cloud, formatOf(cloud), rawlog, file, scan.points);
  } catch (const UserError& error) {
    throw UserError(place + ": its external file " + error.what());
  } catch (const std::exception&) {
    throw UserError(place, "its external file " + file.string() + " can't be read",
                    "copy the external files of the rawlog again");
  }
}

}  // namespace toss
