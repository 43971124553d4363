// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/TraversabilitySearch.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace toss {
namespace {

/// Squares around the sensor in which the search may start.
constexpr int kStartRings = 2;
/// Side of the squares [m] for which th_weight is meant.
constexpr float kWeightedSide = 8.0f;

class Search {
 public:
  Search(const TriGridField& field, const GroundOptions& options, std::vector<GroundNode>& nodes)
      : field_(field), options_(options), nodes_(nodes), state_(nodes.size(), State::Unseen) {}

  void run() {
    const int start = startNode();
    if (start < 0) return;
    accept(start);
    spread();
    if (options_.islandPolicy != IslandPolicy::Reject) {
      for (int node = 0; node < field_.nodes(); ++node) {
        if (isIslandToAccept(node)) accept(node);
      }
      spread();
    }
    for (int node = 0; node < field_.nodes(); ++node) {
      if (at(node).isGround() && state(node) != State::Accepted) {
        at(node).type = NodeType::NonGround;
      }
    }
  }

 private:
  enum class State : std::uint8_t { Unseen, Refused, Accepted };

  GroundNode& at(int node) { return nodes_[static_cast<std::size_t>(node)]; }
  State& state(int node) { return state_[static_cast<std::size_t>(node)]; }

  int startNode() {
    int best = -1, nearest = -1;
    float nearestDistance = std::numeric_limits<float>::infinity();
    for (int node = 0; node < field_.nodes(); ++node) {
      if (!at(node).isGround()) continue;
      if (field_.ringOf(node) < kStartRings && (best < 0 || at(node).weight > at(best).weight)) {
        best = node;
      }
      const float distance = at(node).mean.head<2>().squaredNorm();
      if (distance < nearestDistance) nearestDistance = distance, nearest = node;
    }
    return best >= 0 ? best : nearest;
  }

  bool isIslandToAccept(int node) {
    if (!at(node).isGround() || state(node) != State::Unseen) return false;
    if (options_.islandPolicy == IslandPolicy::Accept) return true;
    // The weight of a flat patch grows with its area.
    const float side = field_.cellSize() / kWeightedSide;
    return at(node).weight > static_cast<float>(options_.islandWeight) * side * side;
  }

  void accept(int node) {
    state(node) = State::Accepted;
    queue_.push_back(node);
  }

  void spread() {
    for (; head_ < queue_.size(); ++head_) {
      const int from = queue_[head_];
      for (const auto* to = field_.neighboursBegin(from); to != field_.neighboursEnd(from); ++to) {
        visit(from, *to);
      }
    }
  }

  void visit(int from, int to) {
    if (!at(to).isGround() || state(to) == State::Accepted) return;
    if (state(to) == State::Refused && options_.edgePolicy == EdgePolicy::FirstEdge) return;
    if (isTraversable(at(from), at(to), options_)) {
      accept(to);
    } else {
      state(to) = State::Refused;
    }
  }

  const TriGridField& field_;
  const GroundOptions& options_;
  std::vector<GroundNode>& nodes_;
  std::vector<State> state_;
  std::vector<int> queue_;
  std::size_t head_ = 0;
};

}  // namespace

bool isTraversable(const GroundNode& a, const GroundNode& b, const GroundOptions& options) {
  constexpr float kHalfPi = 1.57079632679f;
  const Eigen::Vector3f step = b.mean - a.mean;
  const float distance = step.norm();
  const float turn = std::min(distance * static_cast<float>(options.convexityNormal), kHalfPi);
  if (a.normal.dot(b.normal) < 1.0f - std::sin(turn)) return false;
  const float rise = distance * std::sin(static_cast<float>(options.convexityPlanar));
  return std::fabs(a.normal.dot(step)) <= rise && std::fabs(b.normal.dot(step)) <= rise;
}

void searchTraversable(const TriGridField& field, const GroundOptions& options,
                       std::vector<GroundNode>& nodes) {
  Search(field, options, nodes).run();
}

}  // namespace toss
