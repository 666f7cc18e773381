// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/cli/workplace.h"
#include "luxel/patch/side.h"
#include "luxel/runs/outputs.h"

namespace luxel {

// A picture after every step of an iteration, all from one camera and with one exposure, so that they can be
// compared: that of the last step, which is why they are drawn at the end. Keeps two numbers per patch and
// band for each step.
class StepPictures {
 public:
  // Makes the folder. Without a folder nothing is stored or drawn. Throws DeviceError.
  explicit StepPictures(std::string folder);

  // Stores a step's light.
  void add(const Solution& light);

  // Writes step-001.png and so on; returns their names. camera: where a picture was already taken from. The
  // tone operator reinhard-local, which has no exposure of the whole, is replaced by reinhard.
  std::vector<std::string> write(const Baked& baked, const Tracer& tracer,
                                 const std::optional<Camera>& camera, const OutputSettings& settings,
                                 const Workplace& place) const;

 private:
  struct Step {
    SideValues irradiance;
  };

  std::string folder_;
  std::vector<Step> steps_;
};

}  // namespace luxel
