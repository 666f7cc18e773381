// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "luxel/session/diagnose.h"
#include "luxel/session/session_snapshot.h"
#include "luxel/viewer/light_probe.h"
#include "luxel/viewer/lines.h"
#include "luxel/viewer/look.h"

namespace luxel {

// Lines and points over the surfaces that show how the scene and the solver work: normals, boxes of the
// hierarchy, rays of a patch, diagnostics, photometric solids of luminaires, the line that light is plotted
// along.
class Overlays {
 public:
  // Removes all marks, for another scene.
  void forget();
  // Makes the marks requested by `look`, for the newest light and the patch under the light_probe. Returns
  // true where the marks have changed. Cost: linear for changed requests, otherwise negligible.
  bool update(const Look& look, const std::shared_ptr<const SessionMesh>& mesh,
              const std::shared_ptr<const SessionLight>& light, const LightProbe& light_probe,
              const std::shared_ptr<const CheckReport>& diagnostics);
  const Marks& marks() const { return marks_; }
  std::uint64_t version() const { return version_; }

 private:
  // Inputs of the current marks.
  struct Made {
    bool normals = false, boxes = false, rays = false, samples = false;
    int level = 0;
    std::uint64_t light = 0, line = 0;
    const void* mesh = nullptr;
    const void* diagnostics = nullptr;
    const void* luminaires = nullptr;  // patches whose solids are shown
    std::optional<std::uint64_t> side;
    bool operator==(const Made&) const = default;
  } made_;
  Marks marks_;
  std::uint64_t version_ = 0;
};

}  // namespace luxel
