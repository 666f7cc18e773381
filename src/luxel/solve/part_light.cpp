// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/part_light.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "luxel/classical/scattering.h"
#include "luxel/lamps/direct_samples.h"
#include "luxel/patch/refine_patches.h"
#include "luxel/patch/side.h"
#include "luxel/solve/hit_store.h"
#include "luxel/solve/replicate_solve.h"
#include "luxel/solve/sampled_light.h"
#include "luxel/solve/sampling.h"

namespace luxel {
namespace {

constexpr std::uint32_t replicates =
    4;  // of a light: the fewest with which direct light has no bias to speak of
constexpr std::uint32_t min_rays = 16, max_rays = 128;  // of a side
constexpr std::size_t grain = 4096;                     // receivers per chunk

// The rays of one call: samples of direct light, and first hits. Each light has its own replicates.
class PartRays {
 public:
  PartRays(const Cut& cut, std::uint32_t lights, const SampledOptions& options, const Context& context)
      : patches_(cut.parts),
        context_(context),
        lamps_(patches_),
        direct_light_(patches_, cut.tracer, lamps_, direct_of(lights * replicates, options)),
        hits_(patches_, all_gather_sides(patches_, make_patch_tree(patches_, context)), cut.tracer,
              {.seed = options.seed,
               .replicates = lights * replicates,
               .low_discrepancy = options.low_discrepancy,
               .stratified = options.stratified},
              SharedWork(context)),
        direct_(direct_light_, hits_.sides(), lights * replicates,
                patches_.group_count() * patches_.band_count(), hits_.partition()) {}

  // Returns false if the monitor stops the work.
  bool take(std::span<const std::uint32_t> rays) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> receivers;  // by rays
    const auto& sides = hits_.sides();
    for (std::uint32_t s = 0; s < sides.size(); ++s)
      if (const auto n = rays[sides.side[s].index()]; n > 0) receivers[n].push_back(s);
    std::uint64_t own_direct = 0;
    for (auto& [n, with_n] : receivers) {
      sampled_.insert(sampled_.end(), with_n.begin(), with_n.end());
      own_direct += direct_.double_samples(with_n, n / replicates, context_);
      const auto told = [&](const Progress& p) {
        return context_.report({p.stage, p.done, own_direct + traced_ + p.rays});
      };
      const auto traced = hits_.double_rays(std::move(with_n), n / replicates, context_.with_monitor(told));
      if (!traced) return false;
      traced_ += *traced;
    }
    std::sort(sampled_.begin(), sampled_.end());
    traced_ += direct_.all_gather(sampled_, own_direct);
    return true;
  }

  std::uint64_t traced() const { return traced_; }
  const GatherSides& sides() const { return hits_.sides(); }
  std::span<const std::uint32_t> sampled() const { return sampled_; }  // receivers, rising

  // [receiver * bands + band], W/m².
  std::vector<float> direct(std::uint32_t light) const {
    const auto own = std::span(direct_.irradiance()).subspan(light * replicates, replicates);
    return mean_of(sum_of_groups(own, patches_.group_count(), patches_.band_count(), {}, context_), context_);
  }

  // Returns the irradiance that the rays of a light find if the receivers send on `sent`; both [receiver *
  // bands + band], W/m².
  std::vector<float> gathered(std::uint32_t light, std::span<const float> sent) const {
    const auto bands = patches_.band_count();
    const auto receivers = sides().size();
    // After the receivers' own two rows each come the sinks.
    auto radiosity = dark_but_for_sky(hits_, patches_);
    radiosity.erase(radiosity.begin(), radiosity.begin() + static_cast<std::ptrdiff_t>(receivers * bands));
    std::copy(sent.begin(), sent.end(), radiosity.begin());
    std::vector<float> mean(receivers * bands, 0.0f);
    context_.for_chunks(hits_.blocks(), 1, [&](std::size_t begin, std::size_t end, int) {
      for (auto block = begin; block < end; ++block)
        for (auto r = light * replicates; r < (light + 1) * replicates; ++r)
          hits_.for_each_hit(r, block, [&](std::uint32_t receiver, std::size_t hit) {
            const auto part = 1.0f / static_cast<float>(replicates * hits_.rays_per_receiver()[receiver]);
            for (std::size_t b = 0; b < bands; ++b)
              mean[receiver * bands + b] += part * radiosity[hit * bands + b];
          });
    });
    hits_.all_gather_receivers(mean, bands);
    return mean;
  }

 private:
  static DirectOptions direct_of(std::uint32_t all_replicates, const SampledOptions& options) {
    auto direct = direct_options(options);
    direct.replicates = all_replicates;
    return direct;
  }

  const PatchSet& patches_;
  const Context& context_;
  Lamps lamps_;
  DirectLight direct_light_;
  HitStore hits_;
  DirectSamples direct_;
  std::vector<std::uint32_t> sampled_;
  std::uint64_t traced_ = 0;
};

}  // namespace

Solution inherited_light(const Solution& wholes, const Cut& cut) {
  auto light = wholes;
  const auto bands = cut.parts.band_count();
  for (auto values :
       {&Solution::irradiance, &Solution::radiosity, &Solution::standard_error, &Solution::smoothing_bias})
    for (const bool back : {false, true}) {
      const auto& from = (wholes.*values).of(back);
      if (from.empty()) continue;
      auto& to = (light.*values).of(back);
      to.resize(cut.parts.size() * bands);
      for (std::size_t p = 0; p < cut.parts.size(); ++p)
        std::copy_n(&from[cut.parent[p] * bands], bands, &to[p * bands]);
    }
  return light;
}

std::vector<std::uint32_t> rays_of_parts(const Cut& cut, const Solution& light,
                                         std::span<const double> weight, double allowed) {
  const auto bands = cut.parts.band_count();
  std::vector<std::uint32_t> rays(side_count(cut.parts.size()), 0);
  for (std::size_t p = 0; p < cut.parts.size(); ++p) {
    if (!is_part(cut.parent, p)) continue;
    for (const bool back : {false, true}) {
      if (back && !cut.parts.material_of(p).two_sided) continue;
      double of_one = 0.0;  // squared error with one ray
      for (std::size_t b = 0; b < bands; ++b) {
        const auto e = static_cast<double>(light.irradiance.of(back)[p * bands + b]);
        of_one += weight[SideId(cut.parent[p], back).index()] * e * e;
      }
      const auto needed = std::clamp(of_one / allowed, double{min_rays}, double{max_rays});
      rays[SideId(p, back).index()] = std::bit_ceil(static_cast<std::uint32_t>(needed));
    }
  }
  return rays;
}

namespace {

// Replaces the light on sampled sides by that of its own rays.
void gather(const PatchSet& patches, const PartRays& rays, std::uint32_t number, const Scattering& sends,
            Solution& light, const Context& context) {
  const auto bands = patches.band_count();
  const auto& sides = rays.sides();
  const auto irradiance = [&](std::size_t i) {
    const auto side = sides.side[i / bands];
    return light.irradiance.of(side)[side.patch() * bands + i % bands];
  };
  std::vector<float> sent(sides.size() * bands);
  context.for_chunks(sent.size(), grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto i = begin; i < end; ++i) sent[i] = sends.sent_on(irradiance, i, bands);
  });
  const auto direct = rays.direct(number);
  const auto gathered = rays.gathered(number, sent);
  for (const auto receiver : rays.sampled()) {
    const auto side = sides.side[receiver];
    for (std::size_t b = 0; b < bands; ++b)
      light.irradiance.of(side)[side.patch() * bands + b] =
          direct[receiver * bands + b] + gathered[receiver * bands + b];
  }
  for (const auto receiver : rays.sampled()) {
    const auto side = sides.side[receiver];
    for (std::size_t b = 0; b < bands; ++b)
      light.radiosity.of(side)[side.patch() * bands + b] =
          (side.is_back() ? 0.0f : static_cast<float>(patches.emittance(side.patch(), b))) +
          sends.sent_on(irradiance, receiver * bands + b, bands);
  }
}

}  // namespace

std::optional<std::uint64_t> gather_on_parts(const Cut& cut, std::span<const std::uint32_t> rays,
                                             const SampledOptions& options, std::span<Solution* const> lights,
                                             const Context& context) {
  PartRays part_rays(cut, static_cast<std::uint32_t>(lights.size()), options, context);
  if (!part_rays.take(rays)) return std::nullopt;
  const auto scattering = scattering_of(cut.parts, part_rays.sides(), context);
  for (std::uint32_t i = 0; i < lights.size(); ++i)
    gather(cut.parts, part_rays, i, scattering.view(), *lights[i], context);
  return part_rays.traced();
}

}  // namespace luxel
