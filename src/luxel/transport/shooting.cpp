// SPDX-License-Identifier: Apache-2.0
#include "luxel/transport/shooting.h"

#include <algorithm>
#include <array>

#include "luxel/random/address.h"
#include "luxel/transport/deposits.h"
#include "luxel/transport/patch_emitter.h"
#include "luxel/transport/ray_plan.h"

namespace luxel {
namespace {

constexpr std::uint32_t offset_element = 0xffffffffu;  // the address of the one random offset; no side has it
constexpr std::size_t block = 64;                      // rays made, then traced, then delivered
constexpr std::size_t grain = 4096;                    // rays a chunk

// Where one batch's rays put their power.
struct Ledger {
  Ledger(const PatchSet& patches, std::uint64_t rays, const Workers& workers)
      : bands(patches.band_count()),
        sides(2 * patches.size()),
        arrived(sides * bands, rays, workers),
        absorbed(patches.materials.size() * bands, rays, workers),
        escaped(bands, rays, workers),
        shot(bands, rays, workers) {}

  std::size_t bands;
  std::size_t sides;
  Deposits arrived, absorbed, escaped, shot;
};

// Sends the rays of a chunk in blocks: first all of a block are made, then traced, then delivered. Every
// counter of a block is asked for before the first is added to, so that their cache misses overlap.
class ChunkShooter {
 public:
  ChunkShooter(const PatchSet& patches, const Tracer& tracer, const RayPlan& plan,
               const ShootingOptions& options, Ledger& ledger, int worker)
      : patches_(patches),
        tracer_(tracer),
        plan_(plan),
        options_(options),
        ledger_(ledger),
        worker_(worker) {}

  // Rays first + stride * i of the plan, for i in [begin, end).
  void run(std::uint64_t first, std::uint64_t stride, std::size_t begin, std::size_t end) {
    auto ray = first + stride * begin;
    auto side = plan_.side_of_ray(ray);
    PatchEmitter emitter(patches_, side);
    auto key = stream_key(options_.seed, options_.step, static_cast<std::uint32_t>(side));
    for (auto i = begin; i < end; ++i, ray += stride) {
      if (ray >= plan_.first_ray[side + 1]) {
        do ++side;
        while (ray >= plan_.first_ray[side + 1]);
        emitter = PatchEmitter(patches_, side);
        key = stream_key(options_.seed, options_.step, static_cast<std::uint32_t>(side));
      }
      rays_[waiting_] = emitter.ray(uniform4(key, ray - plan_.first_ray[side]));
      sides_[waiting_++] = side;
      if (waiting_ == block) flush();
    }
    flush();
  }

 private:
  void flush() {
    tracer_.nearest(std::span(rays_.data(), waiting_), std::span(hits_.data(), waiting_));
    for (std::size_t i = 0; i < waiting_; ++i)
      if (hits_[i]) ledger_.arrived.prefetch(worker_, side_of(hits_[i].patch, hits_[i].back) * ledger_.bands);
    for (std::size_t i = 0; i < waiting_; ++i)
      deliver(hits_[i], std::span(plan_.quantum).subspan(sides_[i] * ledger_.bands, ledger_.bands));
    waiting_ = 0;
  }

  void deliver(const Hit& hit, std::span<const std::int64_t> quantum) {
    ledger_.shot.add(worker_, 0, quantum);
    if (!hit) return ledger_.escaped.add(worker_, 0, quantum);
    if (hit.back && !patches_.material_of(hit.patch).two_sided)
      return ledger_.absorbed.add(
          worker_, static_cast<std::size_t>(patches_.material[hit.patch]) * ledger_.bands, quantum);
    ledger_.arrived.add(worker_, side_of(hit.patch, hit.back) * ledger_.bands, quantum);
  }

  const PatchSet& patches_;
  const Tracer& tracer_;
  const RayPlan& plan_;
  const ShootingOptions& options_;
  Ledger& ledger_;
  int worker_;
  std::size_t waiting_ = 0;
  std::array<Ray, block> rays_;
  std::array<std::size_t, block> sides_;
  std::array<Hit, block> hits_;
};

}  // namespace

Arrival shoot(const PatchSet& patches, const Tracer& tracer, std::span<const double> leaving,
              const ShootingOptions& options, const Workers& workers, const Monitor& monitor) {
  const double offset = uniform4({options.seed, options.step, offset_element, 0})[0];
  const auto plan = make_ray_plan(leaving, patches.band_count(), options.rays, offset, workers);
  Ledger ledger(patches, plan.rays, workers);

  // Batch j shoots rays j, j + batches, j + 2 batches, ...: each is a stratified sample of the whole, and all
  // of them together are exactly the plan. So a run that is stopped between two of them has an unbiased
  // answer.
  const auto batches = std::max<std::uint64_t>(1, (plan.rays + options.batch - 1) / options.batch);
  std::uint64_t done = 0;
  std::uint64_t traced = 0;
  for (std::uint64_t j = 0; j < batches && plan.rays > 0; ++j) {
    const auto count = static_cast<std::size_t>((plan.rays - j + batches - 1) / batches);
    workers.for_chunks(count, grain, [&](std::size_t begin, std::size_t end, int worker) {
      ChunkShooter(patches, tracer, plan, options, ledger, worker).run(j, batches, begin, end);
    });
    traced += count;
    ++done;
    const auto share = static_cast<double>(done) / static_cast<double>(batches);
    if (tell(monitor, {"light", share, traced}) == Next::stop) break;
  }
  const auto share = plan.rays > 0 ? static_cast<double>(done) / static_cast<double>(batches) : 1.0;
  return {plan.scale,
          ledger.arrived.take_total(workers),
          ledger.shot.take_total(workers),
          ledger.escaped.take_total(workers),
          ledger.absorbed.take_total(workers),
          traced,
          share};
}

}  // namespace luxel
