// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/sampling.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/hint.h"
#include "luxel/core/memory.h"
#include "luxel/core/none.h"
#include "luxel/solve/sampled_light.h"
#include "luxel/solve/survey_sides.h"
#include "luxel/solve/tuning.h"

namespace luxel {
namespace {

using namespace tuning::first_samples;

using Clock = std::chrono::steady_clock;

// The power of two for which the rays of all receivers reach the minimum.
std::uint32_t first_samples(std::size_t receivers, std::uint32_t replicates) {
  std::uint32_t n = 1;
  while (n < 1024 && n * replicates * receivers < min_rays) n *= 2;
  return n;
}

}  // namespace

DirectOptions direct_options(const SampledOptions& options) {
  return {.seed = options.seed,
          .replicates = options.replicates,
          .low_discrepancy = options.low_discrepancy,
          .stratified = options.stratified,
          .importance = options.importance,
          .control_variate = options.control_variate,
          .multiple_importance = options.multiple_importance};
}

Sampling::Sampling(const PatchSet& patches, const Tracer& tracer, const SampledOptions& options,
                   const Context& context)
    : patches_(patches),
      tracer_(tracer),
      options_(options),
      context_(context),
      memory_(options.memory > 0 ? options.memory
                                 : free_memory() / 2 / SharedWork(context).processes_on_this_machine()),
      begin_memory_(resident_memory()),
      lamps_(patches),
      direct_light_(patches, tracer, lamps_, direct_options(options)) {}

void Sampling::lay_out() {
  tree_ = make_patch_tree(patches_, context_);
  hits_.emplace(patches_, all_gather_sides(patches_, tree_), tracer_,
                HitStoreOptions{.seed = options_.seed,
                                .replicates = options_.replicates,
                                .low_discrepancy = options_.low_discrepancy,
                                .stratified = options_.stratified},
                SharedWork(context_));
  // Before it is known which sides are reached, such as those inside of closed things: half of all at least.
  check_memory(bytes_of_state() / 2, 0);
  direct_.emplace(direct_light_, hits_->sides(), options_.replicates, direct_width(), hits_->partition());
}

bool Sampling::start(const Solution& first_picture, const Monitor& monitor) {
  const auto told = [&](const Progress& p) { return tell(monitor, {p.stage, p.done, rays_ + p.rays}); };
  lay_out();
  std::vector<std::uint32_t> all(hits_->sides().size());
  std::iota(all.begin(), all.end(), 0u);
  const auto first = first_samples(all.size(), options_.replicates);
  if (!take_direct(all, std::max(first, min_shadow_rays), monitor)) return false;
  const auto direct_rays = rays_;
  make_room(std::uint64_t{first} * options_.replicates * all.size());
  const auto traced = hits_->double_rays(all, first, context_.with_monitor(told));
  if (!traced) return false;
  own_rays_ = direct_rays + own_gather_rays(all, first);
  rays_ = direct_->all_gather(all, direct_rays) + *traced;
  leave_out_unreached_sides(first_picture);
  if (options_.both_ways) one_way_ = one_way_sides(patches_, hits_->sides(), tracer_, context_);
  // With smoothing, viewpoints, pictures of the light on its way and what is written; measured: 1.4 and 1.8.
  constexpr double with_all = 1.3;
  constexpr double always = 8 << 20;
  check_memory(static_cast<std::uint64_t>(with_all * static_cast<double>(bytes_of_state()) + always),
               std::max(resident_memory(), begin_memory_) - begin_memory_);
  units_ = neighbour_begins(hits_->sides(), unit_positions);
  return true;
}

bool Sampling::take_direct(std::span<const std::uint32_t> receivers, std::uint32_t first,
                           const Monitor& monitor) {
  constexpr std::uint64_t turn_rays = 1 << 19;   // per thread
  constexpr std::size_t min_receivers = 1 << 7;  // minimum: some chunks of a loop
  const auto threads = static_cast<std::size_t>(context_.threads());
  while (!receivers.empty()) {
    std::size_t count = 0;
    for (std::uint64_t rays = 0;
         count < receivers.size() && (rays < turn_rays * threads || count < min_receivers * threads);
         ++count) {
      const auto so_far = direct_->samples_per_receiver()[receivers[count]];
      rays += std::uint64_t{options_.replicates} * (so_far > 0 ? so_far : first);
    }
    rays_ += direct_->double_samples(receivers.first(count), first, context_);
    receivers = receivers.subspan(count);
    if (tell(monitor, {"light", 0.0, rays_}) == Next::stop) return false;
  }
  return true;
}

void Sampling::restore(const SampleState& state) {
  if (state.replicates != options_.replicates)
    throw MismatchError(
        fmt::format("the kept samples have {} replicates, not {}", state.replicates, options_.replicates));
  lay_out();
  const auto all = hits_->sides().size();
  std::vector<std::uint8_t> kept(all, 0);
  for (const auto side : state.sides) {
    const auto receiver = side.index() < hits_->sides().receiver_of_side.size()
                              ? hits_->sides().receiver_of_side[side.index()]
                              : none;
    if (receiver == none)
      throw MismatchError("the kept samples are not of these patches: a side of theirs gathers no light");
    kept[receiver] = 1;
  }
  unreached_sides_ = all - static_cast<std::uint64_t>(std::count(kept.begin(), kept.end(), 1));
  if (unreached_sides_ > 0) {
    hits_->keep(kept, context_);
    direct_->keep(kept, hits_->sides());
  }
  if (hits_->sides().side != state.sides)
    throw MismatchError("the kept samples are not of these patches: their sides stand in another order");
  hits_->restore(state.rounds);
  if (options_.both_ways) one_way_ = one_way_sides(patches_, hits_->sides(), tracer_, context_);
  direct_->restore(state.direct, state.direct_samples, state.direct_doublings);
  if (bytes_of_state() + bytes_of_hits() > memory_) hits_->stream();
  rays_ = state.rays;
  units_ = neighbour_begins(hits_->sides(), unit_positions);
}

void Sampling::restore_rays(const SampleState& state) {
  auto rays = state;
  for (auto& round : rays.rounds) round.hits.reset();
  restore(rays);
  hits_->trace_again(context_);
}

SampleState Sampling::state() const {
  SampleState state;
  state.replicates = options_.replicates;
  state.rays = rays_;
  state.sides = hits_->sides().side;
  state.rounds = hits_->rounds();
  state.direct = direct_->irradiance();
  const auto samples = direct_->samples_per_receiver();
  const auto doublings = direct_->doublings_per_receiver();
  state.direct_samples = {samples.begin(), samples.end()};
  state.direct_doublings = {doublings.begin(), doublings.end()};
  return state;
}

void Sampling::leave_out_unreached_sides(const Solution& first_picture) {
  const auto direct =
      sum_of_groups(direct_->irradiance(), patches_.group_count(), patches_.band_count(), {}, context_);
  const auto lit = lit_receivers(patches_, *hits_, first_picture, direct, context_);
  unreached_sides_ = static_cast<std::uint64_t>(std::count(lit.begin(), lit.end(), 0));
  if (unreached_sides_ == 0) return;
  hits_->keep(lit, context_);
  direct_->keep(lit, hits_->sides());
}

ProcessTimes Sampling::distribute(std::span<const std::uint8_t> doublings) {
  const auto n = units_.size() - 1;
  std::vector<double> more_samples(hits_->sides().size(), 0.0), more_rays(more_samples);
  const auto more = [](std::uint32_t so_far, std::uint8_t times) {
    return static_cast<double>(so_far) * static_cast<double>((1u << times) - 1u);
  };
  for (std::size_t u = 0; u < n; ++u)
    for (auto s = units_[u]; s < units_[u + 1]; ++s) {
      more_samples[s] = more(direct_->samples_per_receiver()[s], doublings[u]);
      more_rays[s] = more(hits_->rays_per_receiver()[s], doublings[n + s]);
    }
  auto& units = direct_->units();
  auto times = hits_->balance(more_rays, units.expected_seconds(more_samples));
  units.deal(more_samples, times);
  return times;
}

bool Sampling::take(std::span<const std::uint8_t> doublings, const Monitor& monitor) {
  const auto n = units_.size() - 1;
  auto times = hits_->partition().is_shared() ? distribute(doublings) : ProcessTimes{};
  const auto begin_time = Clock::now();
  const auto turns = *std::max_element(doublings.begin() + static_cast<std::ptrdiff_t>(n), doublings.end());
  for (std::uint8_t turn = 0; turn < turns; ++turn) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> gathered;  // by rays so far
    for (std::uint32_t s = 0; s < hits_->sides().size(); ++s)
      if (doublings[n + s] > turn) gathered[hits_->rays_per_receiver()[s]].push_back(s);
    const auto told = [&](const Progress& p) { return tell(monitor, {p.stage, p.done, rays_ + p.rays}); };
    for (auto& [rays, receivers] : gathered) {
      make_room(std::uint64_t{rays} * options_.replicates * receivers.size());
      own_rays_ += own_gather_rays(receivers, rays);
      const auto traced = hits_->double_rays(std::move(receivers), 0, context_.with_monitor(told));
      if (!traced) return false;
      rays_ += *traced;
    }
  }
  const auto before = rays_;
  if (!take_direct_part(doublings, 0, monitor)) return false;
  if (!hits_->partition().is_shared()) return true;
  // While other processes finish their first part, this one starts the second.
  const double own = std::chrono::duration<double>(Clock::now() - begin_time).count();
  const auto asked = hits_->partition().start_all_gather_value(own, std::span(times.ready));
  if (!take_direct_part(doublings, 1, monitor)) return false;
  asked->wait();
  direct_->units().deal_rest(std::move(times));
  if (!take_direct_part(doublings, 2, monitor)) return false;
  std::vector<std::uint32_t> sampled;
  for (std::size_t u = 0; u < n; ++u)
    for (auto s = units_[u]; doublings[u] > 0 && s < units_[u + 1]; ++s) sampled.push_back(s);
  own_rays_ += rays_ - before;
  rays_ = before + direct_->all_gather(sampled, rays_ - before);
  return true;
}

std::uint64_t Sampling::own_gather_rays(std::span<const std::uint32_t> receivers, std::uint32_t more) const {
  const auto own = std::count_if(receivers.begin(), receivers.end(), [this](std::uint32_t s) {
    return hits_->partition().is_mine(hits_->sides().position[s]);
  });
  return std::uint64_t{options_.replicates} * more * static_cast<std::uint64_t>(own);
}

bool Sampling::take_direct_part(std::span<const std::uint8_t> doublings, int part, const Monitor& monitor) {
  const auto n = units_.size() - 1;
  const auto turns =
      n == 0 ? 0 : *std::max_element(doublings.begin(), doublings.begin() + static_cast<std::ptrdiff_t>(n));
  for (std::uint8_t turn = 0; turn < turns; ++turn) {
    std::vector<std::uint32_t> receivers;
    for (std::size_t u = 0; u < n; ++u)
      for (auto s = units_[u]; doublings[u] > turn && s < units_[u + 1]; ++s)
        if (direct_->units().part_of(s) == part) receivers.push_back(s);
    if (!take_direct(receivers, 0, monitor)) return false;
  }
  return true;
}

// Hits can be traced again, but stored light cannot: memory beyond the limit would end the process.
void Sampling::check_memory(std::uint64_t bytes, std::uint64_t held) const {
  const auto lack = lack_of_memory(static_cast<double>(bytes) - static_cast<double>(held));
  if (lack.empty()) return;
  throw with_hints(
      InputError(fmt::format(
          "the light of {} patch sides in {} bands needs about {}: make fewer patches with a longer edge, or "
          "take fewer bands",
          hits_->sides().size(), patches_.band_count(), lack)),
      {{Setting::max_edge}, {Setting::bands}});
}

void Sampling::make_room(std::uint64_t more_rays) {
  const auto hits = bytes_of_hits() + 2 * sizeof(std::uint32_t) * more_rays;
  if (!hits_->is_streamed() && bytes_of_state() + hits > memory_) hits_->stream();
}

std::uint64_t Sampling::bytes_of_state() const {
  const auto groups = patches_.light_groups.empty() ? 1 : 2 * patches_.group_count();
  const std::uint64_t numbers = hits_->sides().size() * patches_.band_count();
  // Direct and gathered light of each replicate; direct light of each group, and a copy of it if the state is
  // stored; the iteration's vectors of two halves; mean, error, bias and reflectance; arrays by receiver and
  // replicate; the tree; and the solution.
  return sizeof(float) * numbers * ((2 + groups) * options_.replicates + 24 + 6) +
         (64 + 12 * options_.replicates) * hits_->sides().size() +
         patches_.size() * (60 + sizeof(float) * 6 * patches_.band_count());
}

}  // namespace luxel
