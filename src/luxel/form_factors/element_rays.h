// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/form_factors/view_elements.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/gather_rays.h"
#include "luxel/trace/gather_sides.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct ElementRayOptions {
  const std::vector<std::uint8_t>& rows;  // elements whose rays are wanted; empty: all
  std::uint64_t seed = 1;
  std::uint32_t replicates = 8;
};

// The rays that estimate view factors: cosine rays from uniform points of patch sides, Owen-scrambled Sobol
// points, in independent replicates. A hit is a number: an element, or elements.size() + a ViewFactors::Sink.
class ElementRays {
 public:
  // Keeps references to patches, tracer and elements.
  ElementRays(const PatchSet& patches, const Tracer& tracer, const ViewElements& elements,
              const ElementRayOptions& options, const Context& context);

  // The sides that have rays, neighbours together.
  std::size_t receivers() const { return sides_.size(); }
  std::uint32_t element_of_receiver(std::size_t receiver) const {
    return elements_.of_side[sides_.side[receiver].index()];
  }
  double area_of_receiver(std::size_t receiver) const {
    return static_cast<double>(patches_.area[sides_.side[receiver].patch()]);
  }
  std::uint32_t replicates() const { return replicates_; }
  const ViewElements& elements() const { return elements_; }

  // Returns the begin of each run of these receivers (rising) that may be traced together, and at the end
  // their number: runs of at most this many positions, a power of two up to 4096.
  std::vector<std::size_t> runs(std::span<const std::uint32_t> receivers, std::uint32_t positions) const;

  // Traces per_receiver rays, a power of two, of each receiver in one replicate, at that level of doubling.
  // The hit of ray k of receivers[i] is written to met[i * per_receiver + k].
  void trace(std::span<const std::uint32_t> receivers, std::uint32_t replicate, std::uint32_t level,
             std::uint32_t per_receiver, std::span<std::uint32_t> met) const;

 private:
  std::uint32_t number_of(const Hit& hit) const;

  const PatchSet& patches_;
  const Tracer& tracer_;
  const ViewElements& elements_;
  GatherSides sides_;
  std::uint64_t seed_;
  std::uint32_t replicates_;
};

}  // namespace luxel
