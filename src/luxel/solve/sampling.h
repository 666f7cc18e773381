// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/core/progress.h"
#include "luxel/lamps/direct_light.h"
#include "luxel/lamps/direct_samples.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/solve/hit_store.h"
#include "luxel/solve/sampled.h"
#include "luxel/solve/sampled_operator.h"

namespace luxel {

// Returns the options for sampling the direct light of such a solve.
DirectOptions direct_options(const SampledOptions& options);

// All samples of a sampled solve: shadow rays and gather rays of every side that light reaches, in units of
// neighbouring receivers whose samples are doubled together.
class Sampling {
 public:
  // Keeps references to all but the options.
  Sampling(const PatchSet& patches, const Tracer& tracer, const SampledOptions& options,
           const Context& context);

  // Takes the first samples of every side, then leaves out those that no light reaches. first_picture: light
  // that is known to arrive somewhere. Returns false, and must not be used further, if the monitor stops the
  // work.
  bool start(const Solution& first_picture, const Monitor& monitor = {});
  // Resumes from a state, in place of start(). Throws MismatchError where the state is not of these patches
  // and options.
  void restore(const SampleState& state);
  // Resumes too, but traces the rays again, for patches that differ in their panes of glass; the hits in the
  // state are not used.
  void restore_rays(const SampleState& state);
  // The input of restore(), and the rays traced; the caller fills in the rest.
  SampleState state() const;

  const PatchTree& tree() const { return tree_; }
  const HitStore& hits() const { return *hits_; }
  // Transport by the rays so far. References this; not valid after more rays.
  std::unique_ptr<const SampledOperator> transport() const {
    return std::make_unique<const SampledOperator>(
        patches_, *hits_, SampledOperatorOptions{.both_ways = options_.both_ways, .one_way = one_way_},
        context_);
  }
  const DirectSamples& direct() const { return *direct_; }
  const DirectLight& direct_light() const { return direct_light_; }
  std::uint64_t unreached_sides() const { return unreached_sides_; }
  std::uint64_t rays() const { return rays_; }  // traced
  // Traced by this process.
  std::uint64_t own_rays() const { return hits_->partition().is_shared() ? own_rays_ : rays_; }

  // Unit u is receivers [units()[u], units()[u + 1]).
  std::span<const std::uint32_t> units() const { return units_; }

  // Doubles the shadow rays of unit u doublings[u] times, and the gather rays of receiver s doublings[units +
  // s] times. Returns false, with some of it done, if the monitor stops the work.
  bool take(std::span<const std::uint8_t> doublings, const Monitor& monitor);

  // Bytes of the hits that are stored, at their senders and where they arrive, and of all else that a solve
  // holds at its peak.
  std::uint64_t bytes_of_hits() const { return 2 * hits_->bytes(); }
  std::uint64_t bytes_of_state() const;

 private:
  // Throws InputError where the light needs more than the free memory; held: bytes that may be part of it.
  void check_memory(std::uint64_t bytes, std::uint64_t held) const;
  // Hits that would not fit are not stored.
  void make_room(std::uint64_t more_rays);
  // Lays out the samples of all sides, initially none.
  void lay_out();
  // Assigns the samples of a take() to processes.
  ProcessTimes distribute(std::span<const std::uint8_t> doublings);
  // The shadow rays of a take(), of one part of the units.
  bool take_direct_part(std::span<const std::uint8_t> doublings, int part, const Monitor& monitor);
  // Polls the monitor a few times per second. Returns false if it stops the work.
  bool take_direct(std::span<const std::uint32_t> receivers, std::uint32_t first, const Monitor& monitor);
  void leave_out_unreached_sides(const Solution& first_picture);
  // Gather rays of this process when each of these receivers gets `more` per replicate.
  std::uint64_t own_gather_rays(std::span<const std::uint32_t> receivers, std::uint32_t more) const;
  std::size_t direct_width() const { return patches_.group_count() * patches_.band_count(); }

  const PatchSet& patches_;
  const Tracer& tracer_;
  SampledOptions options_;
  const Context& context_;
  std::uint64_t memory_;        // bytes that may be held
  std::uint64_t begin_memory_;  // bytes of the process, before any light
  Lamps lamps_;
  DirectLight direct_light_;
  PatchTree tree_;
  std::optional<HitStore> hits_;
  std::vector<std::uint8_t> one_way_;  // [receiver]
  std::optional<DirectSamples> direct_;
  std::vector<std::uint32_t> units_;
  std::uint64_t unreached_sides_ = 0;
  std::uint64_t rays_ = 0;
  std::uint64_t own_rays_ = 0;
};

}  // namespace luxel
