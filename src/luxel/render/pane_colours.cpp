// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/pane_colours.h"

namespace luxel {

PaneColours::PaneColours(const PatchSet& patches, const BandColours& colours) : panes_(patches) {
  Vec3d white(0.0);
  for (std::size_t b = 0; b < colours.bands(); ++b) {
    const auto width = patches.wavebands.empty() ? 1.0 : patches.wavebands[b].width;
    of_band_.push_back(width * colours.of(b));
    white += of_band_.back();
  }
  for (auto& colour : of_band_) colour /= white;
}

Vec3d PaneColours::along(const Ray& ray, float distance) const {
  const auto through = panes_.along(ray, distance);
  if (through.empty()) return Vec3d(1.0);
  Vec3d tint(0.0);
  for (std::size_t b = 0; b < through.size(); ++b) tint += through[b] * of_band_[b];
  return glm::max(tint, Vec3d(0.0));
}

}  // namespace luxel
