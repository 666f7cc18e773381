// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace luxel {

struct TexelOptions {
  double error = 0.02;            ///< relative standard error asked of a texel; 0: no final gather
  std::uint32_t max_rays = 4096;  ///< cosine rays per texel, and as many to lamps; 64 and more
  bool directional = false;       ///< the light vector too, and so all texels by final gather
  double dark = 0.1;              ///< of the mean light: below, the error is of this much
  std::uint64_t seed = 1;
};

struct LightmapOptions {
  std::optional<double> texels_per_metre = {};  ///< nothing: as many as fill half of a page of 512 x 512
  int page_size = 1024;                         ///< texels, the most a page is wide and high
  int margin = 2;                               ///< texels between charts; filled from both sides
  float crease_angle = 30.0f;                   ///< degrees, as in SmoothOptions
  TexelOptions texels = {};
};

/// What the gathering of texels did.
struct TexelReport {
  std::uint64_t texels = 0;       ///< with light of their own
  std::uint64_t gathered = 0;     ///< of them, by final gather
  std::uint64_t short_of_it = 0;  ///< of these, with max_rays and still a larger error than asked
  std::uint64_t rays = 0;         ///< traced
  /// By the monitor in the stage "texels": those not reached hold the interpolated light.
  bool stopped = false;
};

/// What making seams agree did.
struct SeamReport {
  std::size_t places = 0;                                  ///< along seams where two charts are compared
  double difference_before = 0.0, difference_after = 0.0;  ///< relative, root mean square over the places
  int steps = 0;                                           ///< of conjugate gradients, the most of a colour
  bool stopped = false;                                    ///< by the monitor: not all texels are changed
};

struct LightmapReport {
  std::size_t charts = 0;
  TexelReport texels;
  SeamReport seams;
};

}  // namespace luxel
