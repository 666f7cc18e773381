// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/hit_store.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <chrono>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/address.h"
#include "luxel/core/error.h"
#include "luxel/core/none.h"
#include "luxel/solve/tuning.h"

namespace luxel {
namespace {

using namespace tuning::hits;

using Clock = std::chrono::steady_clock;

// The position of each of `values` among the receivers.
std::vector<std::uint32_t> places_of(std::span<const std::uint32_t> values,
                                     std::span<const std::uint32_t> receivers) {
  std::vector<std::uint32_t> places;
  for (const auto v : values)
    places.push_back(static_cast<std::uint32_t>(std::lower_bound(receivers.begin(), receivers.end(), v) -
                                                receivers.begin()));
  return places;
}

// A number that differs from ray to ray; of the same ray it is the same whenever it is traced.
std::uint64_t key_of(const Ray& ray) {
  std::uint64_t key = 0;
  for (const auto& v : {ray.origin, ray.direction})
    for (int i = 0; i < 3; ++i) key = nth_key(key, std::bit_cast<std::uint32_t>(v[i]));
  return key;
}

}  // namespace

HitStore::HitStore(const PatchSet& patches, GatherSides sides, const Tracer& tracer,
                   const HitStoreOptions& options, const SharedWork& work)
    : patches_(patches),
      tracer_(tracer),
      portals_(patches),
      panes_(patches),
      tints_(patches, panes_),
      sides_(std::move(sides)),
      options_(options),
      partition_(work, gather_block_positions, sides_.position),
      block_begins_(neighbour_begins(sides_, gather_block_positions)),
      rays_per_receiver_(sides_.size(), 0),
      doublings_(sides_.size(), 0) {}

std::uint32_t HitStore::escape_of(const Ray& ray, std::optional<std::size_t> tint) const {
  const auto sky_patch = patches_.sky_patches.patch_of(Vec3d(ray.direction));
  const bool is_open = portals_.first_crossed(ray) == none;
  if (tint)
    return static_cast<std::uint32_t>(is_open ? tinted(sky_patch, *tint)
                                              : tinted_through_portal(sky_patch, *tint));
  return static_cast<std::uint32_t>(is_open ? escaped(sky_patch) : through_portal(sky_patch));
}

std::uint32_t HitStore::element_of(const Hit& hit, const Ray& ray) const {
  std::optional<std::size_t> tint;
  if (const auto through = panes_.along(ray, hit.distance); !through.empty()) {
    const auto u = uniform4(key_of(ray), 0);
    const auto transmitted = panes_.luminous(through);
    if (!(static_cast<double>(u[0]) < transmitted)) return static_cast<std::uint32_t>(in_panes());
    if (!hit && tints() > 0) tint = tints_.choose(through, transmitted, static_cast<double>(u[1]));
  }
  if (!hit) return escape_of(ray, tint);
  const auto receiver = sides_.receiver_of_side[hit.side().index()];
  if (receiver != none) return receiver;
  if (hit.back && !patches_.material_of(hit.patch).two_sided)
    return static_cast<std::uint32_t>(absorbed(static_cast<std::size_t>(patches_.material[hit.patch])));
  return static_cast<std::uint32_t>(dark());
}

HitStore::Round HitStore::make_round(HitRound round) const {
  auto begins = places_of(block_begins_, round.receivers);
  return {std::move(round), std::move(begins)};
}

void HitStore::make_room(Round& round) const {
  round.hits =
      std::make_shared_for_overwrite<std::uint32_t[]>(options_.replicates * round.hits_per_replicate());
}

void HitStore::count(std::span<const std::uint32_t> receivers, std::uint32_t per_replicate) {
  for (const auto s : receivers) {
    rays_per_receiver_[s] += per_replicate;
    ++doublings_[s];
  }
}

void HitStore::trace(const Round& round, std::span<const std::uint32_t> receivers, std::size_t begin_row,
                     std::size_t end_row, std::span<std::uint32_t* const> to) const {
  if (receivers.empty()) return;
  const auto n = round.per_replicate;
  GatherRays rays(patches_, sides_, receivers, {options_.seed, options_.low_discrepancy, options_.stratified},
                  round.level, n);
  std::array<GatherRays::Row, GatherRays::max_rows> rows;
  while (begin_row < end_row) {
    const auto count = std::min(end_row - begin_row, rows.size());
    for (std::size_t i = 0; i < count; ++i, ++begin_row) {
      const auto replicate = static_cast<std::uint32_t>(begin_row / n);
      const auto sample = static_cast<std::uint32_t>(begin_row % n);
      rows[i] = {replicate, sample, to[replicate] + sample};
    }
    rays.trace(tracer_, std::span(rows.data(), count),
               [this](const Hit& hit, const Ray& ray) { return element_of(hit, ray); });
  }
}

// Blocks with few rays per receiver have too few rays of similar direction.
std::vector<std::uint32_t> HitStore::traced_together(std::uint32_t per_replicate) const {
  const std::size_t most =
      options_.replicates * per_replicate > GatherRays::max_rows ? 1 : GatherRays::max_blocks;
  std::vector<std::uint32_t> begins;
  std::size_t first = 0;
  for (std::size_t b = 0; b < blocks(); ++b)
    if (b == 0 || b - first == most || block_begins_[b] == sides_.fronts) {
      begins.push_back(block_begins_[b]);
      first = b;
    }
  begins.push_back(static_cast<std::uint32_t>(sides_.size()));
  return begins;
}

std::optional<std::uint64_t> HitStore::double_rays(std::vector<std::uint32_t> receivers, std::uint32_t first,
                                                   const Context& context) {
  assert(first == 0 || std::has_single_bit(first));
  assert(std::is_sorted(receivers.begin(), receivers.end()));
  if (receivers.empty()) return 0;
  const auto so_far = rays_per_receiver_[receivers[0]];
  const auto per_replicate = so_far > 0 ? so_far : first;
  const auto level = doublings_[receivers[0]];
  const auto whole = std::uint64_t{options_.replicates} * per_replicate * receivers.size();
  const auto begin_time = Clock::now();
  auto round = make_round({level, per_replicate, mine(receivers), nullptr});
  if (!is_streamed_) {
    make_room(round);
    // Processed in turns of some tenths of a second; the monitor is polled between them.
    const auto rows = std::size_t{options_.replicates} * per_replicate;
    const auto groups = places_of(traced_together(per_replicate), round.receivers);
    const auto jobs_per_group = (rows + rows_per_job - 1) / rows_per_job;
    const auto jobs = (groups.size() - 1) * jobs_per_group;
    const auto turn = 32 * static_cast<std::size_t>(context.threads());
    std::vector<double> seconds(jobs);
    for (std::size_t from = 0; from < jobs; from += turn) {
      const auto to = std::min(jobs, from + turn);
      context.for_chunks(to - from, 1, [&](std::size_t begin, std::size_t end, int) {
        std::vector<std::uint32_t*> places(options_.replicates);
        for (auto job = from + begin; job < from + end; ++job) {
          const auto job_begin = Clock::now();
          const auto* group = &groups[job / jobs_per_group];
          const auto row = job % jobs_per_group * rows_per_job;
          for (std::uint32_t r = 0; r < options_.replicates; ++r) places[r] = round.hits_of(r, group[0]);
          trace(round, std::span(round.receivers).subspan(group[0], group[1] - group[0]), row,
                std::min(rows, row + rows_per_job), places);
          seconds[job] = std::chrono::duration<double>(Clock::now() - job_begin).count();
        }
      });
      const auto all_gather = static_cast<double>(to) / static_cast<double>(jobs);
      const auto rays = static_cast<std::uint64_t>(all_gather * static_cast<double>(whole));
      if (context.report({"light", all_gather, rays}) == Next::stop) return {};
    }
    learn_pace(round, groups, seconds, std::chrono::duration<double>(Clock::now() - begin_time).count());
  }
  count(receivers, per_replicate);
  rounds_.push_back(std::move(round));
  return whole;
}

void HitStore::restore(std::vector<HitRound> rounds) {
  const auto require = [](bool holds, const char* what) {
    if (!holds) throw MismatchError(fmt::format("the kept rays do not belong to these patches: {}", what));
  };
  for (auto& given : rounds) {
    auto round = make_round(std::move(given));
    const auto& receivers = round.receivers;
    require(std::is_sorted(receivers.begin(), receivers.end(), std::less_equal<>()) &&
                (receivers.empty() || receivers.back() < sides_.size()),
            "their sides are not in order");
    require(std::has_single_bit(round.per_replicate), "a round's number of rays is no power of two");
    for (const auto s : receivers)
      require(
          round.level == doublings_[s] && (round.level == 0 || round.per_replicate == rays_per_receiver_[s]),
          "a round is missing");
    if (round.hits) {
      const auto count = options_.replicates * round.hits_per_replicate();
      require(std::all_of(round.hits.get(), round.hits.get() + count,
                          [&](std::uint32_t element) { return element < elements(); }),
              "a hit is on no element");
    } else {
      is_streamed_ = true;
    }
    count(receivers, round.per_replicate);
    rounds_.push_back(partition_.is_shared() ? own_part(round) : std::move(round));
  }
  if (is_streamed_) stream();
}

void HitStore::trace_again(const Context& context) {
  const auto earlier = std::exchange(rounds_, {});
  std::fill(rays_per_receiver_.begin(), rays_per_receiver_.end(), 0u);
  std::fill(doublings_.begin(), doublings_.end(), 0u);
  is_streamed_ = false;
  for (const auto& round : earlier) double_rays(round.receivers, round.per_replicate, context.quiet());
}

void HitStore::stream() {
  is_streamed_ = true;
  for (auto& round : rounds_) round.hits.reset();
}

std::uint64_t HitStore::bytes() const {
  std::uint64_t count = 0;
  for (const auto& round : rounds_) count += options_.replicates * round.hits_per_replicate();
  return is_streamed_ ? 0 : sizeof(std::uint32_t) * count;
}

void HitStore::keep(const std::vector<std::uint8_t>& kept, const Context& context) {
  assert(kept.size() == sides_.size());
  HitStore smaller(patches_, restored_gather_sides(sides_, kept), tracer_, options_, partition_);
  // The new index of an old element.
  std::vector<std::uint32_t> name(elements());
  for (std::size_t e = 0; e < name.size(); ++e)
    name[e] = e >= sides_.size() ? static_cast<std::uint32_t>(e - sides_.size() + smaller.sides_.size())
              : kept[e]          ? smaller.sides_.receiver_of_side[sides_.side[e].index()]
                                 : static_cast<std::uint32_t>(smaller.dark());
  for (std::size_t s = 0; s < kept.size(); ++s)
    if (kept[s]) {
      smaller.rays_per_receiver_[name[s]] = rays_per_receiver_[s];
      smaller.doublings_[name[s]] = doublings_[s];
    }
  for (const auto& round : rounds_) {
    std::vector<std::uint32_t> receivers;
    for (const auto s : round.receivers)
      if (kept[s]) receivers.push_back(name[s]);
    auto fewer = smaller.make_round({round.level, round.per_replicate, std::move(receivers), nullptr});
    if (!is_streamed_) {
      smaller.make_room(fewer);
      const std::size_t n = round.per_replicate;
      context.for_chunks(options_.replicates, 1, [&](std::size_t begin, std::size_t end, int) {
        for (auto r = static_cast<std::uint32_t>(begin); r < end; ++r) {
          auto* to = fewer.hits_of(r, 0);
          for (std::size_t i = 0; i < round.receivers.size(); ++i)
            if (kept[round.receivers[i]])
              for (std::size_t k = 0; k < n; ++k) *to++ = name[round.hits_of(r, i)[k]];
        }
      });
    }
    smaller.rounds_.push_back(std::move(fewer));
  }
  sides_ = std::move(smaller.sides_);
  block_begins_ = std::move(smaller.block_begins_);
  rounds_ = std::move(smaller.rounds_);
  rays_per_receiver_ = std::move(smaller.rays_per_receiver_);
  doublings_ = std::move(smaller.doublings_);
}

}  // namespace luxel
