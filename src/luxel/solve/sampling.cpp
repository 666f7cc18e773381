// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/sampling.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "luxel/report/memory.h"
#include "luxel/solve/dark_sides.h"

namespace luxel {
namespace {

constexpr std::uint64_t least_rays = 1 << 17;  // of the first samples, shadow rays and gather rays each
constexpr std::uint32_t unit_positions = 64;

// The power of two that brings the rays of all slots above the least.
std::uint32_t first_samples(std::size_t slots, std::uint32_t replicates) {
  std::uint32_t n = 1;
  while (n < 1024 && n * replicates * slots < least_rays) n *= 2;
  return n;
}

}  // namespace

Sampling::Sampling(const PatchSet& patches, const Tracer& tracer, const SampledOptions& options,
                   const Workers& workers)
    : patches_(patches),
      tracer_(tracer),
      options_(options),
      workers_(workers),
      memory_(options.memory > 0 ? options.memory : free_memory() / 2),
      lamps_(patches),
      direct_light_(patches, tracer, lamps_,
                    {.seed = options.seed,
                     .replicates = options.replicates,
                     .low_discrepancy = options.low_discrepancy,
                     .stratified = options.stratified,
                     .importance = options.importance,
                     .control_variate = options.control_variate,
                     .multiple_importance = options.multiple_importance}) {}

void Sampling::start(const Solution& first_picture) {
  tree_ = make_patch_tree(patches_, workers_);
  transport_.emplace(patches_, all_gather_sides(patches_, tree_), tracer_,
                     SampledOperatorOptions{.seed = options_.seed,
                                            .replicates = options_.replicates,
                                            .low_discrepancy = options_.low_discrepancy,
                                            .stratified = options_.stratified});
  direct_.emplace(direct_light_, transport_->sides(), options_.replicates, patches_.band_count());
  std::vector<std::uint32_t> all(transport_->sides().size());
  std::iota(all.begin(), all.end(), 0u);
  const auto first = first_samples(all.size(), options_.replicates);
  rays_ += direct_->double_samples(all, first, workers_);
  make_room(std::uint64_t{first} * options_.replicates * all.size());
  rays_ += transport_->double_rays(all, first, workers_).value();
  leave_out_dark_sides(first_picture);
  units_ = neighbour_begins(transport_->sides(), unit_positions);
}

void Sampling::leave_out_dark_sides(const Solution& first_picture) {
  const auto lit = lit_slots(patches_, *transport_, first_picture, direct_->irradiance(), workers_);
  dark_sides_ = static_cast<std::uint64_t>(std::count(lit.begin(), lit.end(), 0));
  if (dark_sides_ == 0) return;
  transport_->keep(lit, workers_);
  direct_->keep(lit, transport_->sides());
}

bool Sampling::take(std::span<const std::uint8_t> doublings, const Monitor& monitor) {
  const auto n = units_.size() - 1;
  const auto turns = *std::max_element(doublings.begin(), doublings.end());
  for (std::uint8_t turn = 0; turn < turns; ++turn) {
    std::vector<std::uint32_t> direct;
    std::map<std::uint32_t, std::vector<std::uint32_t>> gathered;  // by rays so far
    for (std::size_t u = 0; u < n; ++u)
      for (auto s = units_[u]; s < units_[u + 1]; ++s) {
        if (doublings[u] > turn) direct.push_back(s);
        if (doublings[n + u] > turn) gathered[transport_->rays_a_slot()[s]].push_back(s);
      }
    const auto told = [&](const Progress& p) { return tell(monitor, {p.stage, p.done, rays_ + p.rays}); };
    rays_ += direct_->double_samples(direct, 0, workers_);
    if (told({"light"}) == Next::stop) return false;
    for (auto& [rays, slots] : gathered) {
      make_room(std::uint64_t{rays} * options_.replicates * slots.size());
      const auto traced = transport_->double_rays(std::move(slots), 0, workers_, told);
      if (!traced) return false;
      rays_ += *traced;
    }
  }
  return true;
}

void Sampling::make_room(std::uint64_t more_rays) {
  const auto hits = bytes_of_hits() + sizeof(std::uint32_t) * more_rays;
  if (!transport_->is_streamed() && bytes_of_state() + hits > memory_) transport_->stream();
}

std::uint64_t Sampling::bytes_of_state() const {
  const std::uint64_t numbers = transport_->sides().size() * patches_.band_count();
  // Direct and gathered light of each replicate, and one more copy of direct light, for sharing; the
  // iteration's vectors; mean, error, bias, reflectance; what is kept by slot; the tree; and the solution.
  return sizeof(float) * numbers * (3 * options_.replicates + 12 + 6) + 64 * transport_->sides().size() +
         patches_.size() * (60 + sizeof(float) * 6 * patches_.band_count());
}

}  // namespace luxel
