// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "luxel/core/vector.h"
#include "luxel/image/tone.h"
#include "luxel/patch/patch_set.h"
#include "luxel/render/sky_colours.h"
#include "luxel/scene/camera.h"

namespace luxel {

// Constants of sky_look(), for the implementations on the processor and on a graphics card. Relative to the
// radiance of the sky, which the horizon has.
struct SkyLook {
  static constexpr double zenith[3] = {0.20, 0.40, 0.80};  // reached by the fifth power of 1 - height
  static constexpr double below = 0.75;                    // at most, below the horizon
  static constexpr double haze = 0.06;                     // sine of the depth at which that is reached
};

// Returns the radiance of the ground in displays, relative to that of the sky.
double ground_look(const PatchSet& patches);

// Radiance of a uniform sky in displays: its own at the horizon, bluer and darker towards the zenith, and
// that of the ground below. The light of the scene has no part in it, and files of radiance keep the true
// value. ground: relative, see ground_look(). height: sine of the angle above the horizon, [-1, 1].
Vec3d sky_look(const Vec3d& radiance, double ground, double height);

// The sky as displays show it: an even one with the look above, others as they are. Immutable; safe for any
// number of threads.
class DisplayedSky {
 public:
  DisplayedSky(const PatchSet& patches, const Camera& camera);

  const SkyColours& colours() const { return colours_; }
  // direction: unit. Returns W/(m² sr), linear RGB.
  Vec3d at(const Vec3d& direction) const;

 private:
  SkyColours colours_;
  Vec3d zenith_;
  double ground_;
};

// A pixel of a display's sky.
struct SkyPixel {
  std::uint32_t pixel;
  double fraction;
  Vec3d radiance;
};

void add_sky(const SkyPixel& pixel, SkyPixels& sky);
void append(const SkyPixels& more, SkyPixels& sky);

}  // namespace luxel
