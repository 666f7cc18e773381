// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "luxel/image/image.h"

namespace luxel {

enum class ToneOperator {
  maximum,         // divide by the largest value
  clamp,           // cut at 1
  reinhard,        // Reinhard et al. 2002, global, equation 3 with key; eq. 4 where white is given
  reinhard_local,  // Reinhard et al. 2002, dodging and burning, equations 5 to 9; pictures only
};

struct ToneOptions {
  ToneOperator op = ToneOperator::reinhard;
  float exposure = 0.0f;  // stops, applied before the curve: 2^exposure
  float key = 0.18f;      // what the log-average luminance is mapped to, (0, 1]
  float white = 0.0f;     // smallest luminance shown as white after keying; 0: none (equation 3)
};

// A tone curve fitted to what is to be shown; then applied colour by colour. Display-referred results are
// linear RGB in [0, 1], not yet sRGB encoded. Hue is kept: luminance is mapped, colour scaled with it, then
// clamped.
struct ToneCurve {
  ToneOptions options;
  float scale = 1.0f;  // radiance to curve input, exposure included

  Vec3 operator()(const Vec3& radiance) const;
};

// weights: the visible area (m², or pixels) behind each colour; the log-average is over area, not over
// patches. Colours without light are left out of it. radiance.size() == weights.size(). An empty or black
// input gives scale 1. reinhard_local is fitted like reinhard.
ToneCurve fit_curve(std::span<const Vec3> radiance, std::span<const float> weights,
                    const ToneOptions& options = {});

// A scene-referred picture (radiance) made displayable: linear RGB in [0, 1].
Image tone_map(const Image& radiance, const ToneOptions& options = {});

}  // namespace luxel
