// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/report/progress.h"
#include "luxel/trace/tracer.h"
#include "luxel/transport/gather_block.h"
#include "luxel/transport/gather_sides.h"
#include "luxel/transport/operator.h"

namespace luxel {

struct SampledOperatorOptions {
  std::uint64_t seed = 1;
  std::uint32_t replicates = 8;
  bool low_discrepancy = true;  // else independent random numbers
  bool stratified = true;       // one sequence over neighbouring patches; else each side has its own
};

// Transport as a sampled operator: each replicate has n cosine rays a side, from Owen-scrambled points, and
// F_ij is the share of side i's rays whose first hit is side j. Rays are added in rounds; all earlier ones
// stay. A round is stored, or streamed: traced again by every apply(), which needs no memory and gives the
// same bits.
//
// Elements are the slots of GatherSides. Rays that bring no light end in sinks, elements of their own after
// the slots, whose radiosity is 0: escaped, dark (a side that does not gather), and one for each one-sided
// material's back.
//
// Memory: 4 bytes a stored ray. Cost of a round: one nearest hit a ray; of apply(): one look-up a ray. Not
// safe to change while another call runs; all else may run at once.
class SampledOperator {
 public:
  // Keeps references to patches and tracer.
  SampledOperator(const PatchSet& patches, GatherSides sides, const Tracer& tracer,
                  const SampledOperatorOptions& options);

  const GatherSides& sides() const { return sides_; }
  std::uint32_t rays_a_side() const { return rays_a_side_; }  // of one replicate
  std::uint64_t rays_of_round(std::uint32_t per_replicate) const {
    return std::uint64_t{options_.replicates} * per_replicate * sides_.size();
  }

  // Adds per_replicate rays (a power of two) a side and replicate. Returns false, and adds none, if the
  // monitor said stop.
  bool add_stored_round(std::uint32_t per_replicate, const Workers& workers, const Monitor& monitor = {});
  void add_streamed_round(std::uint32_t per_replicate);
  // Forgets the hits of stored rounds: they are streamed from now on.
  void stream_all();

  // Leaves out the slots that are not kept: rays to them end in the dark.
  void keep(const std::vector<std::uint8_t>& kept, const Workers& workers);

  // Sinks, from size() on.
  std::size_t escaped() const { return sides_.size(); }
  std::size_t dark() const { return sides_.size() + 1; }
  std::size_t absorbed(std::size_t material) const { return sides_.size() + 2 + material; }
  std::size_t elements() const { return sides_.size() + 2 + patches_.materials.size(); }

  // F of one replicate. radiosity is of elements(), sinks and all; irradiance of the slots.
  class Replicate final : public TransportOperator {
   public:
    Replicate(const SampledOperator& whole, std::uint32_t index) : whole_(whole), index_(index) {}
    std::size_t size() const override { return whole_.sides_.size(); }
    std::size_t bands() const override { return whole_.patches_.band_count(); }
    void apply(std::span<const float> radiosity, std::span<float> irradiance, std::size_t begin,
               std::size_t end, const Workers& workers) const override;
    std::span<const std::uint32_t> row_begins() const override { return whole_.block_begins_; }

   private:
    const SampledOperator& whole_;
    std::uint32_t index_;
  };
  Replicate replicate(std::uint32_t index) const { return {*this, index}; }

  // Calls body(slot, element hit) for every ray of one replicate whose slot lies in that block, in the order
  // in which apply() adds them up.
  template <typename Body>
  void for_each_hit(std::uint32_t replicate, std::size_t block, Body body) const {
    const GatherBlock rows(sides_, block_begins_[block], block_begins_[block + 1]);
    std::vector<std::uint32_t> traced;
    for (std::size_t k = 0; k < rounds_.size(); ++k) {
      const auto& round = rounds_[k];
      const std::uint32_t* hit = nullptr;
      if (round.is_stored()) {
        hit = round.hits[replicate].data() + std::size_t{rows.first_slot()} * round.per_replicate;
      } else {
        traced.resize(std::size_t{rows.size()} * round.per_replicate);
        trace(rows, static_cast<std::uint32_t>(k), replicate, traced);
        hit = traced.data();
      }
      rows.for_each_point(round.per_replicate,
                          [&](std::uint32_t slot, std::uint32_t) { body(slot, *hit++); });
    }
  }
  std::size_t blocks() const { return block_begins_.size() - 1; }

 private:
  struct Round {
    std::uint32_t per_replicate = 0;
    std::vector<std::vector<std::uint32_t>> hits;  // [replicate]: elements, in the order of tracing
    bool is_stored() const { return !hits.empty(); }
  };

  // The elements that a block's rays of one round and replicate hit.
  void trace(const GatherBlock& rows, std::uint32_t round, std::uint32_t replicate,
             std::span<std::uint32_t> hits) const;
  std::uint32_t element_of(const Hit& hit) const;

  const PatchSet& patches_;
  const Tracer& tracer_;
  GatherSides sides_;
  SampledOperatorOptions options_;
  std::vector<std::uint32_t> block_begins_;
  std::vector<Round> rounds_;
  std::uint32_t rays_a_side_ = 0;
};

}  // namespace luxel
