// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/image/tone.h"

namespace luxel {

// Code common to tone.cpp and tone_map.cpp; private to this module.

// NaN and negative channels become 0, the rest is at most 1e30: no sum or product of colours is infinite.
Vec3 clean_color(const Vec3& radiance);

// Reinhard et al. 2002, equation 4 (white > 0) or 3, with the luminance below the line taken from
// `surround`: equation 9. For the global operator the surround is the luminance itself.
double reinhard(double L, double surround, double white);

// The key of Reinhard's operators: 0.18 where it is automatic.
double reinhard_key(const ToneOptions& options);

// Khronos PBR Neutral without its offset. clean: times the scale.
Vec3 neutral(const Vec3d& scaled);

// The colour whose curve input has luminance L, brought to the display luminance: scaled, then clamped to [0,
// 1].
Vec3 with_luminance(const Vec3& clean, double scale, double L, double display);

}  // namespace luxel
