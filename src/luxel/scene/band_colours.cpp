// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/band_colours.h"

#include <algorithm>

#include "luxel/scene/luminous_efficacy.h"
#include "luxel/scene/observer.h"

namespace luxel {
namespace {

constexpr double lumens_per_watt_of_y = 683.0;  // lm/W at 555 nm, the definition of the candela

// IEC 61966-2-1, by columns. The middle row is the luminance used for RGB, so that lumens agree between both
// representations.
glm::dmat3 xyz_of_rgb() {
  return {{0.4124, 0.2126, 0.0193}, {0.3576, 0.7152, 0.1192}, {0.1805, 0.0722, 0.9505}};
}

}  // namespace

BandColours::BandColours(const std::vector<Waveband>& wavebands) {
  if (wavebands.empty()) of_band_ = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  const auto& eye = cie_1931_observer();
  const auto rgb_of_xyz = glm::inverse(xyz_of_rgb());
  for (std::size_t i = 0; i < wavebands.size(); ++i) {
    const auto seen = [&](const Spectrum& sensitivity) {
      return mean_around(wavebands, i, sensitivity, Beyond::zero);
    };
    of_band_.push_back(lumens_per_watt_of_y / luminous_efficacy *
                       (rgb_of_xyz * Vec3d(seen(eye.x), seen(eye.y), seen(eye.z))));
  }
}

double BandColours::lumens_of(const Vec3d& rgb) { return luxel::lumens(rgb.r, rgb.g, rgb.b); }

Vec3 in_gamut(const Vec3d& rgb) {
  const auto least = std::min({rgb.r, rgb.g, rgb.b});
  if (least >= 0.0) return Vec3(rgb);
  const auto grey = 0.2126 * rgb.r + 0.7152 * rgb.g + 0.0722 * rgb.b;
  if (!(grey > 0.0)) return Vec3(0.0f);
  const auto kept = grey / (grey - least);
  return glm::max(Vec3(Vec3d(grey) + kept * (rgb - Vec3d(grey))), Vec3(0.0f));
}

}  // namespace luxel
