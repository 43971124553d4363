// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/LeftoverPoints.h>

#include <algorithm>
#include <cmath>

namespace toss {
namespace {

/// Looks for the nearest node with an instance around one point.
class NearestInstance {
 public:
  NearestInstance(const LinkRules& rules, const ObjectNodes& nodes,
                  const std::vector<std::int32_t>& instanceOfNode, float distance)
      : rules_(rules), nodes_(nodes), instanceOfNode_(instanceOfNode), distance_(distance) {}

  /// Instance of the nearest node within the distance, 0 if there is none.
  std::int32_t find(float x, float y, float z, int row, int column) {
    x_ = x, y_ = y, z_ = z;
    nearest2_ = distance_ * distance_;
    instance_ = 0;
    const float range = std::sqrt(x * x + y * y + z * z);
    const int rowReach = rules_.rowsSpanned(distance_, range);
    const int columnReach = rules_.columnsSpanned(distance_, std::sqrt(x * x + y * y));
    const int last = std::min(nodes_.rows() - 1, row + rowReach);
    for (int r = std::max(0, row - rowReach); r <= last; ++r) {
      search(r, column - columnReach, column + columnReach);
    }
    return instance_;
  }

 private:
  void search(int row, int first, int last) {
    if (first < 0) {
      searchColumns(row, 0, last);
      searchColumns(row, first + rules_.columns, rules_.columns - 1);
    } else if (last >= rules_.columns) {
      searchColumns(row, 0, last - rules_.columns);
      searchColumns(row, first, rules_.columns - 1);
    } else {
      searchColumns(row, first, last);
    }
  }

  void searchColumns(int row, int first, int last) {
    const auto columns = nodes_.column.begin();
    const auto begin = columns + nodes_.rowBegin[static_cast<std::size_t>(row)];
    const auto end = columns + nodes_.rowBegin[static_cast<std::size_t>(row) + 1];
    for (auto it = std::lower_bound(begin, end, first); it != end && *it <= last; ++it) {
      consider(static_cast<std::size_t>(it - columns));
    }
  }

  void consider(std::size_t node) {
    const std::int32_t instance = instanceOfNode_[node];
    if (instance == 0) return;
    const ObjectNodes::Place& place = nodes_.places[node];
    const float dx = place.x - x_, dy = place.y - y_, dz = place.z - z_;
    const float distance2 = dx * dx + dy * dy + dz * dz;
    if (distance2 >= nearest2_) return;
    nearest2_ = distance2;
    instance_ = instance;
  }

  const LinkRules& rules_;
  const ObjectNodes& nodes_;
  const std::vector<std::int32_t>& instanceOfNode_;
  float distance_;
  float x_ = 0.0f, y_ = 0.0f, z_ = 0.0f, nearest2_ = 0.0f;
  std::int32_t instance_ = 0;
};

void attach(std::size_t i, const LevelPoints& points, const RangeImage& image,
            NearestInstance& nearest, Segmentation& segmentation) {
  const std::int32_t instance =
      nearest.find(points.x[i], points.y[i], points.z[i], image.row[i], image.column[i]);
  if (instance == 0) return;
  segmentation.instance[i] = instance;
  segmentation.pointClass[i] = PointClass::Instance;
}

}  // namespace

void attachLeftoverPoints(const LevelPoints& points, const RangeImage& image,
                          const LinkRules& rules, const ObjectNodes& nodes,
                          const std::vector<std::int32_t>& instanceOfNode,
                          const std::vector<NodeComponents::Piece>& leftover, float distance,
                          Segmentation& segmentation) {
  NearestInstance nearest(rules, nodes, instanceOfNode, distance);
  for (const NodeComponents::Piece& piece : leftover) {
    for (std::int32_t n = piece.begin; n < piece.end; ++n) {
      const std::int32_t point = nodes.point[static_cast<std::size_t>(n)];
      attach(static_cast<std::size_t>(point), points, image, nearest, segmentation);
    }
  }
  for (std::size_t m = 0; m < nodes.matePoint.size(); ++m) {
    if (instanceOfNode[static_cast<std::size_t>(nodes.mateNode[m])] != 0) continue;
    attach(static_cast<std::size_t>(nodes.matePoint[m]), points, image, nearest, segmentation);
  }
}

}  // namespace toss
