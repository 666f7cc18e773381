// SPDX-License-Identifier: Apache-2.0
#include "luxel/transport/sampled_operator.h"

#include <algorithm>
#include <array>

#include "luxel/random/address.h"
#include "luxel/random/sobol.h"
#include "luxel/transport/patch_emitter.h"

namespace luxel {
namespace {

constexpr std::size_t batch = 256;              // rays made, then traced
constexpr std::uint32_t purpose = 0x67617468u;  // keeps these streams apart from those of other stages

// The four numbers of a ray: of one sequence over all sides that face the same way, or one a side, or plain
// random ones.
class Points {
 public:
  Points(const SampledOperatorOptions& options, std::uint32_t round, std::uint32_t replicate, bool back)
      : options_(options),
        key_(mix64(stream_key(options.seed, purpose, 2 * replicate + (back ? 1 : 0)) + round)),
        shared_(key_) {}

  std::array<float, 4> at(std::uint32_t index, std::uint32_t per_replicate, std::uint32_t side) const {
    if (!options_.low_discrepancy) return uniform4(stream_key(key_, 0, side), index % per_replicate);
    if (!options_.stratified) return OwenSobol(stream_key(key_, 0, side)).first4(index % per_replicate);
    return shared_.first4(index);
  }

 private:
  const SampledOperatorOptions& options_;
  std::uint64_t key_;
  OwenSobol shared_;
};

}  // namespace

SampledOperator::SampledOperator(const PatchSet& patches, GatherSides sides, const Tracer& tracer,
                                 const SampledOperatorOptions& options)
    : patches_(patches),
      tracer_(tracer),
      sides_(std::move(sides)),
      options_(options),
      block_begins_(gather_block_begins(sides_)),
      rays_a_slot_(sides_.size(), 0),
      doublings_(sides_.size(), 0) {}

std::uint32_t SampledOperator::element_of(const Hit& hit) const {
  if (!hit) return static_cast<std::uint32_t>(escaped());
  const auto slot = sides_.slot_of_side[side_of(hit.patch, hit.back)];
  if (slot != GatherSides::none) return slot;
  if (hit.back && !patches_.material_of(hit.patch).two_sided)
    return static_cast<std::uint32_t>(absorbed(static_cast<std::size_t>(patches_.material[hit.patch])));
  return static_cast<std::uint32_t>(dark());
}

SampledOperator::Round SampledOperator::make_round(std::vector<std::uint32_t> slots, std::uint32_t level,
                                                   std::uint32_t per_replicate) const {
  Round round{level, per_replicate, std::move(slots), {}, {}};
  for (const auto begin : block_begins_)
    round.begins.push_back(static_cast<std::uint32_t>(
        std::lower_bound(round.slots.begin(), round.slots.end(), begin) - round.slots.begin()));
  return round;
}

void SampledOperator::trace(const GatherBlock& rows, const Round& round, std::size_t block,
                            std::uint32_t replicate, std::span<std::uint32_t> hits) const {
  if (rows.size() == 0) return;
  const auto slot0 = block_begins_[block];
  const auto n = round.per_replicate;
  const Points points(options_, round.level, replicate, slot0 >= sides_.fronts);
  std::vector<PatchEmitter> emitters;
  emitters.reserve(block_begins_[block + 1] - slot0);
  for (auto s = slot0; s < block_begins_[block + 1]; ++s) emitters.emplace_back(patches_, sides_.side[s]);

  std::array<Ray, batch> rays;
  std::array<Hit, batch> found;
  std::size_t waiting = 0;
  std::size_t done = 0;
  const auto flush = [&] {
    tracer_.nearest(std::span(rays.data(), waiting), std::span(found.data(), waiting));
    for (std::size_t i = 0; i < waiting; ++i) hits[done++] = element_of(found[i]);
    waiting = 0;
  };
  rows.for_each_point(n, [&](std::uint32_t slot, std::uint32_t index) {
    rays[waiting++] = emitters[slot - slot0].ray(points.at(index, n, sides_.side[slot]));
    if (waiting == batch) flush();
  });
  flush();
}

std::optional<std::uint64_t> SampledOperator::double_rays(std::vector<std::uint32_t> slots,
                                                          std::uint32_t first, const Workers& workers,
                                                          const Monitor& monitor) {
  if (slots.empty()) return 0;
  const auto so_far = rays_a_slot_[slots[0]];
  const auto per_replicate = so_far > 0 ? so_far : first;
  const auto level = doublings_[slots[0]];
  auto round = make_round(std::move(slots), level, per_replicate);
  const auto whole = std::uint64_t{options_.replicates} * per_replicate * round.slots.size();
  if (!is_streamed_) {
    round.hits.resize(options_.replicates);
    for (auto& h : round.hits) h.resize(round.slots.size() * per_replicate);
    // In turns, between which the monitor is asked.
    const auto jobs = blocks() * options_.replicates;
    constexpr std::size_t turn = 64;
    for (std::size_t from = 0; from < jobs; from += turn) {
      const auto to = std::min(jobs, from + turn);
      workers.for_chunks(to - from, 1, [&](std::size_t begin, std::size_t end, int) {
        for (auto job = from + begin; job < from + end; ++job) {
          const auto block = job / options_.replicates;
          const auto replicate = static_cast<std::uint32_t>(job % options_.replicates);
          const GatherBlock rows(sides_, round.slots_of(block));
          trace(rows, round, block, replicate,
                std::span(round.hits[replicate])
                    .subspan(std::size_t{round.begins[block]} * per_replicate,
                             std::size_t{rows.size()} * per_replicate));
        }
      });
      const auto share = static_cast<double>(to) / static_cast<double>(jobs);
      const auto rays = static_cast<std::uint64_t>(share * static_cast<double>(whole));
      if (tell(monitor, {"light", share, rays}) == Next::stop) return {};
    }
  }
  for (const auto s : round.slots) {
    rays_a_slot_[s] += per_replicate;
    ++doublings_[s];
  }
  rounds_.push_back(std::move(round));
  return whole;
}

void SampledOperator::stream() {
  is_streamed_ = true;
  for (auto& round : rounds_) round.hits = {};
}

std::uint64_t SampledOperator::bytes() const {
  std::uint64_t count = 0;
  for (const auto& round : rounds_)
    count += std::uint64_t{options_.replicates} * round.per_replicate * round.slots.size();
  return is_streamed_ ? 0 : sizeof(std::uint32_t) * count;
}

void SampledOperator::keep(const std::vector<std::uint8_t>& kept, const Workers& workers) {
  SampledOperator smaller(patches_, kept_gather_sides(sides_, kept), tracer_, options_);
  // What an old element is called now.
  std::vector<std::uint32_t> name(elements());
  for (std::size_t e = 0; e < name.size(); ++e)
    name[e] = e >= sides_.size() ? static_cast<std::uint32_t>(e - sides_.size() + smaller.sides_.size())
              : kept[e]          ? smaller.sides_.slot_of_side[sides_.side[e]]
                                 : static_cast<std::uint32_t>(smaller.dark());
  for (std::size_t s = 0; s < kept.size(); ++s)
    if (kept[s]) {
      smaller.rays_a_slot_[name[s]] = rays_a_slot_[s];
      smaller.doublings_[name[s]] = doublings_[s];
    }
  for (const auto& round : rounds_) {
    std::vector<std::uint32_t> slots;
    for (const auto s : round.slots)
      if (kept[s]) slots.push_back(name[s]);
    smaller.rounds_.push_back(smaller.make_round(std::move(slots), round.level, round.per_replicate));
    if (is_streamed_) continue;
    auto& hits = smaller.rounds_.back().hits;
    hits.resize(options_.replicates);
    workers.for_chunks(options_.replicates, 1, [&](std::size_t begin, std::size_t end, int) {
      for (auto r = begin; r < end; ++r) {
        hits[r].reserve(smaller.rounds_.back().slots.size() * round.per_replicate);
        const auto* hit = round.hits[r].data();
        for (std::size_t b = 0; b < blocks(); ++b)
          GatherBlock(sides_, round.slots_of(b))
              .for_each_point(round.per_replicate, [&](std::uint32_t slot, std::uint32_t) {
                if (kept[slot]) hits[r].push_back(name[*hit]);
                ++hit;
              });
      }
    });
  }
  sides_ = std::move(smaller.sides_);
  block_begins_ = std::move(smaller.block_begins_);
  rounds_ = std::move(smaller.rounds_);
  rays_a_slot_ = std::move(smaller.rays_a_slot_);
  doublings_ = std::move(smaller.doublings_);
}

void SampledOperator::Replicate::apply(std::span<const float> radiosity, std::span<float> irradiance,
                                       std::size_t begin, std::size_t end, const Workers& workers) const {
  const auto bands = whole_.patches_.band_count();
  const auto& begins = whole_.block_begins_;
  const auto block_at = [&](std::size_t row) {
    return static_cast<std::size_t>(std::lower_bound(begins.begin(), begins.end(), row) - begins.begin());
  };
  const auto first = block_at(begin);
  workers.for_chunks(block_at(end) - first, 1, [&](std::size_t b, std::size_t e, int) {
    std::vector<double> sum;
    for (auto block = first + b; block < first + e; ++block) {
      const auto slot0 = begins[block];
      sum.assign((begins[block + 1] - slot0) * bands, 0.0);
      if (bands == 3) {  // the rule, and a loop without a branch
        whole_.for_each_hit(index_, block, [&](std::uint32_t slot, std::uint32_t element) {
          auto* to = &sum[3 * (slot - slot0)];
          const auto* from = &radiosity[3 * std::size_t{element}];
          to[0] += static_cast<double>(from[0]);
          to[1] += static_cast<double>(from[1]);
          to[2] += static_cast<double>(from[2]);
        });
      } else {
        whole_.for_each_hit(index_, block, [&](std::uint32_t slot, std::uint32_t element) {
          for (std::size_t i = 0; i < bands; ++i)
            sum[bands * (slot - slot0) + i] += static_cast<double>(radiosity[bands * element + i]);
        });
      }
      for (std::size_t i = 0; i < sum.size(); ++i) {
        const auto rays = whole_.rays_a_slot_[slot0 + i / bands];
        irradiance[bands * slot0 + i] = static_cast<float>(sum[i] / std::max(1u, rays));
      }
    }
  });
}

}  // namespace luxel
