// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelMap.h>
#include <toss/rawlog/AtomicFile.h>

#include <filesystem>
#include <memory>
#include <vector>

namespace mrpt::serialization {
class CSerializable;
}
namespace mrpt::maps {
class CPointsMapXYZI;
}

namespace toss {

/// The points as MRPT's map class, in the same order.
std::shared_ptr<mrpt::maps::CPointsMapXYZI> toPointsMap(const std::vector<MapPoint>& points);

/// Writes the points as one serialized mrpt::maps::CPointsMapXYZI in gz (stored, not compressed),
/// the form in which MRPT's programs take a point map. Throws UserError where the file can not be
/// written.
void writeMetricMap(const std::filesystem::path& file, const std::vector<MapPoint>& points);

/// Writes the points of a file that PlyWriter has written as PlyWriter::Layout::Points, coordinates
/// as they are there, in constant memory: the object that writeMetricMap() writes. Throws
/// UserError. `file` is written, not committed.
void copyToMetricMap(const std::filesystem::path& ply, const AtomicFile& file);

/// Writes one object of MRPT, serialized in gz as above: a .metricmap, a .3Dscene. Throws UserError
/// where the file can not be written, a full disk included.
void writeObjectFile(const std::filesystem::path& file,
                     const mrpt::serialization::CSerializable& object);

/// Reads the first object of the file, which must be a point map of MRPT; intensity 0 where its
/// class has none. Throws UserError for anything else.
std::vector<MapPoint> readMetricMap(const std::filesystem::path& file);

}  // namespace toss
