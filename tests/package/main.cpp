// SPDX-License-Identifier: BSD-3-Clause
#include <toss/pipeline/Pipeline.h>

#include <iostream>

int main() {
  toss::Pipeline pipeline(toss::PipelineOptions(), toss::sensorByName("VLP-16"));
  toss::PosedScan scan;
  scan.points.resize(100);
  const std::size_t labels = pipeline.process(scan).state.size();
  pipeline.finish();
  std::cout << labels << " labels, " << pipeline.staticMap().size() << " map points\n";
  return labels == 100 ? 0 : 1;
}
