// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "luxel/live/live_state.h"
#include "luxel/live/probe.h"
#include "luxel/view/lines.h"
#include "luxel/window/background.h"
#include "luxel/window/look.h"

namespace luxel {

// Lines and points over the surfaces that show how the scene and the solver work: normals, boxes, rays.
class Instruments {
 public:
  // Another scene.
  void forget();
  // What the look asks for, of the newest light and the patch under the cursor. True where the marks are
  // others than before.
  bool update(const Look& look, const std::shared_ptr<const LiveMesh>& mesh,
              const std::shared_ptr<const LiveLight>& light, const std::optional<Probe>& probe,
              bool is_pinned);
  const Marks& marks() const { return marks_; }
  std::uint64_t version() const { return version_; }
  int box_levels() const { return boxes_ ? static_cast<int>(boxes_->levels.size()) : 0; }  // known so far
  bool is_busy() const { return finding_boxes_.is_busy(); }

 private:
  struct Boxes {
    std::shared_ptr<const PatchSet> of;
    std::vector<std::vector<Bounds>> levels;
  };
  void find_boxes(const LiveMesh& mesh);

  // What the marks were made of.
  struct Made {
    bool normals = false, boxes = false, rays = false, samples = false;
    int level = 0;
    std::uint64_t light = 0;
    const void* mesh = nullptr;
    const void* tree = nullptr;
    std::optional<std::uint64_t> side;
    bool operator==(const Made&) const = default;
  } made_;
  std::shared_ptr<const Boxes> boxes_;
  Background<std::shared_ptr<const Boxes>> finding_boxes_;
  Marks marks_;
  std::uint64_t version_ = 0;
};

}  // namespace luxel
