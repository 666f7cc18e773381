// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/lighting/window_groups.h"
#include "luxel/lighting/year_skies.h"
#include "luxel/render/probe_place.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Scene of the sun's rays, and their random numbers.
struct SunSurroundings {
  const PatchSet& patches;  // for their panes of glass
  const Tracer& tracer;
  std::uint64_t seed = 1;
};

// Light straight from the sun at points, hour by hour, by rays to points of its disc. Where the disc is
// partly hidden, the part that is seen has an error; so the rays belong to replicates, in turn, as all other
// rays do.
class SunLight {
 public:
  static constexpr std::uint32_t rays = 8;  // per point and hour, stratified over the disc

  // Polls the monitor; after its stop is_stopped(). dark: the patches without the windows of each group.
  SunLight(const YearSkies& skies, std::span<const ProbePoint> points, const SunSurroundings& around,
           std::span<const PatchSet> dark, const Context& context);

  bool is_stopped() const { return is_stopped_; }
  // lx, [hour * points + point], in the mean over the rays.
  const std::vector<float>& all() const { return all_; }
  // The same through the windows of a group; all() without groups.
  const std::vector<float>& through(std::size_t group) const {
    return through_.empty() ? all_ : through_[group];
  }
  // all() or through() in the mean over the rays of other replicates than left_out.
  std::vector<float> without(const std::vector<float>& light, std::uint32_t replicates,
                             std::uint32_t left_out) const;

 private:
  std::vector<float> all_;
  std::vector<std::vector<float>> through_;  // [group]
  std::vector<std::uint8_t> arrived_;        // a bit for each ray
  bool is_stopped_ = false;
};

}  // namespace luxel
