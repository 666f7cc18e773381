// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// The panes of glass of a scene (PatchSet::panes), and their transmittance along a ray: the product of their
// transmittances at its angles of incidence, in closed form. The tracer does not meet them. Without panes it
// is empty, and everything is transmitted. Immutable; safe for any number of threads. Costs a ray through the
// panes alone, about 0.1 us, and 0.02 us per pane crossed.
class Panes {
 public:
  // Keeps no reference. Builds a table of transmittances by the cosine of the angle of incidence; between its
  // entries they are linear (error below 1e-5).
  explicit Panes(const PatchSet& patches);

  bool empty() const { return state_ == nullptr; }
  // Returns whether any pane transmits bands differently.
  bool is_tinted() const { return is_tinted_; }
  // The weights of the bands in the luminous transmittance; their sum is 1. Those of luminance for white
  // light of equal power in all bands; among wavebands a tenth is spread evenly, so that none has weight 0.
  std::span<const double> weights() const { return weights_; }

  // Transmittance of the panes before max_distance (m): [band], [0, 1]; empty where the ray crosses none.
  // Valid until the next call on the same thread, of any object.
  std::span<const double> along(const Ray& ray, float max_distance) const;
  // Mean of `through` over the bands, by weights(); 1 where it is empty.
  double luminous(std::span<const double> through) const;

 private:
  struct State;

  std::size_t bands_ = 0;
  bool is_tinted_ = false;
  std::vector<double> weights_;  // [band]
  std::shared_ptr<const State> state_;
};

// One band of what Panes::along() returns.
inline double in_band(std::span<const double> through, std::size_t band) {
  return through.empty() ? 1.0 : through[band];
}

}  // namespace luxel
