// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/MappingOptions.h>
#include <toss/segmentation/GroundOptions.h>
#include <toss/segmentation/ObjectOptions.h>
#include <toss/segmentation/ProjectionOptions.h>
#include <toss/tracking/BoxOptions.h>
#include <toss/tracking/MotionOptions.h>
#include <toss/tracking/TrackingOptions.h>
#include <toss/visibility/VisibilityOptions.h>
#include <toss/voting/DecisionOptions.h>
#include <toss/voting/VotingOptions.h>

#include <vector>

namespace toss {

/// The options of every stage of the method.
struct PipelineOptions {
  ProjectionOptions projection;
  GroundOptions ground;
  ObjectOptions objects;
  BoxOptions boxes;
  TrackingOptions tracking;
  MotionOptions motion;
  VisibilityOptions visibility;
  VotingOptions voting;
  DecisionOptions decision;
  MappingOptions mapping;

  /// One entry per section, in the order of the stages.
  std::vector<Options*> sections() {
    return {&projection, &ground,     &objects, &boxes,    &tracking,
            &motion,     &visibility, &voting,  &decision, &mapping};
  }
};

}  // namespace toss
