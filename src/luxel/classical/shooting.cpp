// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/shooting.h"

#include <algorithm>
#include <array>
#include <utility>

#include "luxel/classical/deposits.h"
#include "luxel/classical/ray_plan.h"
#include "luxel/core/address.h"
#include "luxel/core/none.h"
#include "luxel/core/work_partition.h"
#include "luxel/patch/side.h"
#include "luxel/trace/patch_emitter.h"

namespace luxel {
namespace {

constexpr std::uint32_t offset_element = none;  // the address of the random offset; no side has this index
constexpr std::size_t block = 64;               // rays generated, then traced, then deposited
constexpr std::size_t grain = 4096;             // rays per chunk

// Counters for the power of the rays.
struct Ledger {
  Deposits& arrived;
  Deposits& absorbed;
  Deposits& whole;
};
enum Place : std::size_t { escaped, shot, from_sky, whole_places };  // of Ledger::whole

// Expands sparse sums to an array over all places.
std::vector<std::int64_t> spread_out(const Deposits::Sums& sums, std::size_t places, std::size_t bands) {
  std::vector<std::int64_t> all(places * bands, 0);
  for (std::size_t e = 0; e < sums.place.size(); ++e)
    std::copy_n(&sums.sum[e * bands], bands, &all[sums.place[e] * bands]);
  return all;
}

// The sums over all processes. Counters are integers, so their sums do not depend on the order.
Deposits::Sums take(Deposits& deposits, std::size_t bands, const Context& context) {
  const SharedWork work(context);
  auto own = deposits.take(context);
  if (!work.is_shared()) return own;
  const auto places = work.all_gather_lists(own.place);
  const auto sums = work.all_gather_lists(own.sum);
  for (std::size_t e = 0; e < places.size(); ++e)
    deposits.add(0, places[e], std::span(sums).subspan(e * bands, bands));
  return deposits.take(context);
}

// Data that all chunks of a shot use.
struct Shot {
  const PatchSet& patches;
  const Tracer& tracer;
  const SkyBox* sky;                 // null where there is none
  std::span<const float> sky_ratio;  // of Shooter
  const SidePower& leaving;
  const RayPlan& plan;
  const ShootingOptions& options;
  const Ledger& ledger;
};

// Sends the rays of a chunk in blocks: all rays of a block are generated, then traced, then deposited. Every
// counter of a block is prefetched before the first add, so that their cache misses overlap.
class ChunkShooter {
 public:
  ChunkShooter(const Shot& shot, int thread)
      : patches_(shot.patches),
        tracer_(shot.tracer),
        sky_(shot.sky),
        sky_ratio_(shot.sky_ratio),
        leaving_(shot.leaving),
        plan_(shot.plan),
        options_(shot.options),
        ledger_(shot.ledger),
        thread_(thread),
        bands_(patches_.band_count()),
        quantum_(bands_ * (block + 1)) {}

  // Rays first + stride * i of the plan, for i in [begin, end).
  void run(std::uint64_t first, std::uint64_t stride, std::size_t begin, std::size_t end) {
    auto ray = first + stride * begin;
    auto entry = plan_.entry_of_ray(ray);
    auto shooter = shooter_of(entry);
    for (auto i = begin; i < end; ++i, ray += stride) {
      if (ray >= plan_.first_ray[entry + 1]) {
        do ++entry;
        while (ray >= plan_.first_ray[entry + 1]);
        shooter = shooter_of(entry);
      }
      const auto u = uniform4(shooter.key, ray - plan_.first_ray[entry]);
      rays_[waiting_] = shooter.emitter ? shooter.emitter->ray(u) : sky_->ray(shooter.face, u);
      is_of_sky_[waiting_] = !shooter.emitter;
      std::copy_n(&quantum_[block * bands_], bands_, &quantum_[waiting_ * bands_]);
      if (is_of_sky_[waiting_] && !sky_ratio_.empty()) scale_by_sky();
      if (++waiting_ == block) flush();
    }
    flush();
  }

 private:
  struct SideShooter {
    std::optional<PatchEmitter> emitter;  // none: a face of the sky
    std::size_t face;
    std::uint64_t key;
  };
  // Writes the power of its rays at the end of quantum_.
  SideShooter shooter_of(std::size_t entry) {
    const auto side = leaving_.side[entry];
    const auto sides = side_count(patches_.size());
    plan_.write_quantum(std::span(leaving_.watts).subspan(entry * bands_, bands_),
                        std::span(quantum_).subspan(block * bands_));
    const auto key = stream_key(options_.seed, options_.step, side.index());
    if (side.index() >= sides) return {{}, side.index() - sides, key};
    return {PatchEmitter(patches_, side), 0, key};
  }

  // Scales the power of the latest ray by the radiance of the sky where the ray comes from.
  void scale_by_sky() {
    const auto sky_patch = patches_.sky_patches.patch_of(-Vec3d(rays_[waiting_].direction));
    for (std::size_t b = 0; b < bands_; ++b) {
      auto& quantum = quantum_[waiting_ * bands_ + b];
      quantum = static_cast<std::int64_t>(
          static_cast<double>(sky_ratio_[sky_patch * bands_ + b]) * static_cast<double>(quantum) + 0.5);
    }
  }

  void flush() {
    tracer_.nearest(std::span(rays_.data(), waiting_), std::span(hits_.data(), waiting_));
    for (std::size_t i = 0; i < waiting_; ++i)
      if (hits_[i]) ledger_.arrived.prefetch(thread_, hits_[i].side().index());
    for (std::size_t i = 0; i < waiting_; ++i)
      deliver(hits_[i], is_of_sky_[i], std::span(quantum_).subspan(i * bands_, bands_));
    waiting_ = 0;
  }

  void deliver(const Hit& hit, bool is_of_sky, std::span<const std::int64_t> quantum) {
    const bool arrives = takes_part(patches_, hit);
    if (is_of_sky && !arrives) return;
    if (is_of_sky) ledger_.whole.add(thread_, Place::from_sky, quantum);
    ledger_.whole.add(thread_, Place::shot, quantum);
    if (!hit) return ledger_.whole.add(thread_, Place::escaped, quantum);
    if (!arrives)
      return ledger_.absorbed.add(thread_, static_cast<std::size_t>(patches_.material[hit.patch]), quantum);
    ledger_.arrived.add(thread_, hit.side().index(), quantum);
  }

  const PatchSet& patches_;
  const Tracer& tracer_;
  const SkyBox* sky_;
  std::span<const float> sky_ratio_;
  const SidePower& leaving_;
  const RayPlan& plan_;
  const ShootingOptions& options_;
  const Ledger& ledger_;
  int thread_;
  std::size_t bands_;
  std::size_t waiting_ = 0;
  std::array<Ray, block> rays_;
  std::array<Hit, block> hits_;
  std::array<bool, block> is_of_sky_{};
  std::vector<std::int64_t> quantum_;  // [ray of the block, then that of the current side][band]
};

}  // namespace

Shooter::Shooter(const PatchSet& patches, const Tracer& tracer, const Context& context)
    : patches_(patches),
      tracer_(tracer),
      context_(context),
      arrived_(side_count(patches.size()), patches.band_count(), context),
      absorbed_(patches.materials.size(), patches.band_count(), context),
      whole_(whole_places, patches.band_count(), context) {
  if (!patches.has_sky()) return;
  sky_.emplace(patches);
  if (patches.has_even_sky()) return;
  const auto mean = patches.mean_sky();
  for (std::size_t i = 0; i < patches.sky.size(); ++i) {
    const auto of_band = mean[i % mean.size()];
    sky_ratio_.push_back(of_band > 0.0f ? patches.sky[i] / of_band : 0.0f);
  }
}

Arrival Shooter::shoot(const SidePower& leaving, const ShootingOptions& options, const Monitor& monitor) {
  const auto bands = patches_.band_count();
  const double offset = uniform4({options.seed, options.step, offset_element, 0})[0];
  const auto plan = make_ray_plan(leaving, bands, options.rays, offset, context_);
  for (auto* deposits : {&arrived_, &absorbed_, &whole_}) deposits->expect(plan.rays);
  const Ledger ledger{arrived_, absorbed_, whole_};
  const auto* sky = sky_ ? &*sky_ : nullptr;

  // Batch j shoots rays j, j + batches, j + 2 batches, ...: each is a stratified sample of the whole, and all
  // together are exactly the plan. The result is therefore unbiased after any number of batches.
  const auto batches = std::max<std::uint64_t>(1, (plan.rays + options.batch - 1) / options.batch);
  const SharedWork work(context_);
  std::uint64_t done = 0;
  std::uint64_t traced = 0;
  for (std::uint64_t j = 0; j < batches && plan.rays > 0; ++j) {
    const auto count = static_cast<std::size_t>((plan.rays - j + batches - 1) / batches);
    context_.for_chunks(count, grain, [&](std::size_t begin, std::size_t end, int thread) {
      if (begin / grain % work.processes() != work.process()) return;
      ChunkShooter({patches_, tracer_, sky, sky_ratio_, leaving, plan, options, ledger}, thread)
          .run(j, batches, begin, end);
    });
    traced += count;
    ++done;
    const auto fraction = static_cast<double>(done) / static_cast<double>(batches);
    if (work.broadcast(tell(monitor, {"light", fraction, traced})) == Next::stop) break;
  }

  Arrival arrival;
  arrival.scale = plan.scale;
  const auto take_from = [&](Deposits& deposits) { return take(deposits, bands, context_); };
  auto arrived = take_from(arrived_);
  arrival.side = sides_at(arrived.place);
  arrival.arrived = std::move(arrived.sum);
  arrival.absorbed = spread_out(take_from(absorbed_), patches_.materials.size(), bands);
  const auto whole = spread_out(take_from(whole_), whole_places, bands);
  const auto part = [&](Place place) {
    const auto begin = whole.begin() + static_cast<std::ptrdiff_t>(place * bands);
    return std::vector<std::int64_t>(begin, begin + static_cast<std::ptrdiff_t>(bands));
  };
  arrival.escaped = part(Place::escaped);
  arrival.shot = part(Place::shot);
  arrival.from_sky = part(Place::from_sky);
  arrival.rays = traced;
  arrival.fraction = plan.rays > 0 ? static_cast<double>(done) / static_cast<double>(batches) : 1.0;
  return arrival;
}

Arrival shoot(const PatchSet& patches, const Tracer& tracer, const SidePower& leaving,
              const ShootingOptions& options, const Context& context) {
  return Shooter(patches, tracer, context).shoot(leaving, options, context.monitor());
}

}  // namespace luxel
