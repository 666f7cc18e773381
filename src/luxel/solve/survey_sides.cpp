// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/survey_sides.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "luxel/core/address.h"
#include "luxel/solve/tuning.h"
#include "luxel/trace/patch_emitter.h"

namespace luxel {

namespace {

using namespace tuning::one_way;

bool is_sliver(const std::array<Vec3, 3>& p, float area, float lift) {
  const auto longest =
      std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
  return 2.0f * area < min_height * lift * longest;
}

}  // namespace

std::vector<std::uint8_t> one_way_sides(const PatchSet& patches, const GatherSides& sides,
                                        const Tracer& tracer, const Context& context) {
  std::vector<std::uint8_t> one_way(sides.size(), 0);
  context.for_chunks(sides.size(), probe_grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto s = begin; s < end; ++s) {
      const auto side = sides.side[s];
      const auto patch = side.patch();
      const auto points = patches.points(patch);
      const auto lift = origin_lift(points);
      if (patches.material_of(patch).textures.cutout || is_sliver(points, patches.area[patch], lift)) {
        one_way[s] = 1;
        continue;
      }
      const PatchEmitter emitter(patches, side);
      const auto length = std::max(probe_length * lift, probe_fraction * std::sqrt(patches.area[patch]));
      for (std::uint32_t i = 0; i < probes && one_way[s] == 0; ++i) {
        const auto ray = emitter.ray(uniform4(stream_key(0, RandomPurpose::one_way_sides, side.index()), i));
        const auto hit = tracer.nearest({ray.origin + length * ray.direction, -ray.direction});
        if (hit && hit.patch == patch && hit.back == (side.is_back())) continue;
        one_way[s] = 1;
      }
    }
  });
  return one_way;
}

namespace {

using namespace tuning::unreached;

// Neighbours of reached sides count as reached too: where few rays find the light, a picture made of patches
// would be speckled.
void light_neighbours(std::span<const std::uint32_t> begins, std::vector<std::uint8_t>& lit) {
  for (std::size_t g = 0; g + 1 < begins.size(); ++g) {
    const auto first = lit.begin() + begins[g];
    const auto end = lit.begin() + begins[g + 1];
    if (std::find(first, end, std::uint8_t{1}) != end) std::fill(first, end, std::uint8_t{1});
  }
}

void light_through_diffusers(const PatchSet& patches, const GatherSides& sides,
                             std::vector<std::uint8_t>& lit) {
  for (std::size_t s = 0; s < sides.size(); ++s)
    if (lit[s] && patches.material_of(sides.side[s].patch()).is_diffuser())
      lit[sides.receiver_of_side[sides.side[s].opposite().index()]] = 1;
}

}  // namespace

std::vector<std::uint8_t> lit_receivers(const PatchSet& patches, const HitStore& hits,
                                        const Solution& first_picture,
                                        std::span<const std::vector<float>> direct, const Context& context) {
  const auto& sides = hits.sides();
  const auto bands = patches.band_count();
  std::vector<std::uint8_t> lit(hits.elements(), 0);
  const auto any = [bands](const std::vector<float>& values, std::size_t index) {
    return std::any_of(&values[index * bands], &values[index * bands] + bands,
                       [](float x) { return x > 0.0f; });
  };
  context.for_chunks(sides.size(), reach_grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto s = begin; s < end; ++s) {
      const auto patch = sides.side[s].patch();
      const bool back = sides.side[s].is_back();
      const auto& H = first_picture.irradiance.of(back);
      const bool is_lit = any(H, patch) || (!back && patches.material_of(patch).is_lamp()) ||
                          std::any_of(direct.begin(), direct.end(), [&](const auto& d) { return any(d, s); });
      lit[s] = is_lit ? 1 : 0;
    }
  });
  for (std::size_t e = sides.size(); e < hits.elements(); ++e)
    lit[e] = patches.has_sky() && hits.is_escape(e) ? 1 : 0;
  const auto groups = neighbour_begins(sides, neighbours);
  // Light propagates from receiver to receiver. Each pass reads the result of the one before, so the result
  // does not depend on threads.
  for (bool changed = true; changed;) {
    light_through_diffusers(patches, sides, lit);
    light_neighbours(groups, lit);
    light_through_diffusers(patches, sides, lit);
    auto next = lit;
    context.for_chunks(hits.blocks(), 1, [&](std::size_t begin, std::size_t end, int) {
      for (auto block = begin; block < end; ++block)
        for (std::uint32_t r = 0; r < direct.size(); ++r)
          hits.for_each_hit(r, block, [&](std::uint32_t receiver, std::uint32_t element) {
            if (lit[element]) next[receiver] = 1;
          });
    });
    hits.partition().all_gather(
        std::span(next), 1, sides.size(), [](std::size_t s) { return s; },
        [&](std::size_t s) { return sides.position[s]; });
    changed = next != lit;
    lit = std::move(next);
  }
  lit.resize(sides.size());
  return lit;
}

namespace {

double squared(double x) { return x * x; }

// body(receiver, element met) for the first rays of all receivers.
template <typename Body>
void for_first_rays(const HitStore& hits, const Context& context, Body body) {
  context.for_chunks(hits.blocks(), 1, [&](std::size_t begin, std::size_t end, int) {
    for (auto block = begin; block < end; ++block)
      for (std::uint32_t r = 0; r < hits.replicates(); ++r) hits.for_each_first_hit(r, block, body);
  });
}

double sum_over(std::span<const float> numbers, std::uint32_t begin, std::uint32_t end) {
  return std::accumulate(numbers.begin() + begin, numbers.begin() + end, 0.0);
}

}  // namespace

SkyNotFound::SkyNotFound(const PatchSet& patches, const HitStore& hits, std::span<const std::uint32_t> units,
                         const Context& context)
    : patches_(patches), hits_(hits), units_(units.begin(), units.end()) {
  if (!patches.has_sky() || units.size() < 2) return;
  const auto receivers = hits.sides().size();
  std::vector<float> rays(receivers, 0.0f), found(receivers, 0.0f), nearby(receivers, 0.0f);
  for_first_rays(hits, context, [&](std::uint32_t receiver, std::uint32_t element) {
    rays[receiver] += 1.0f;
    found[receiver] += hits.is_sky(element) ? 1.0f : 0.0f;
  });
  hits.all_gather_receivers(rays, 1);
  hits.all_gather_receivers(found, 1);
  std::vector<float> found_by_unit(receivers);  // fraction of the rays of the receiver's unit
  for (std::size_t u = 0; u + 1 < units.size(); ++u) {
    const auto of_unit = sum_over(rays, units[u], units[u + 1]);
    const auto fraction = of_unit > 0.0 ? sum_over(found, units[u], units[u + 1]) / of_unit : 0.0;
    std::fill(found_by_unit.begin() + units[u], found_by_unit.begin() + units[u + 1],
              static_cast<float>(fraction));
  }
  for_first_rays(hits, context, [&](std::uint32_t receiver, std::uint32_t element) {
    nearby[receiver] += element < receivers ? found_by_unit[element] : hits.is_sky(element) ? 1.0f : 0.0f;
  });
  hits.all_gather_receivers(nearby, 1);
  // If no ray of the whole scene met the sky, half a ray of all of them is assumed.
  const auto least = 0.5 / (1.0 + std::accumulate(rays.begin(), rays.end(), 0.0));
  for (std::size_t u = 0; u + 1 < units.size(); ++u) {
    const auto of_unit = sum_over(rays, units[u], units[u + 1]);
    expected_.push_back(least + (of_unit > 0.0 ? sum_over(nearby, units[u], units[u + 1]) / of_unit : 0.0));
  }
}

std::vector<float> SkyNotFound::variance() const {
  const auto bands = patches_.band_count();
  const auto sky = patches_.mean_sky();
  std::vector<float> variance(hits_.sides().size() * bands, 0.0f);
  for (std::size_t u = 0; u < expected_.size(); ++u) {
    const auto of_unit = hits_.rays_per_receiver().subspan(units_[u], units_[u + 1] - units_[u]);
    const auto rays = hits_.replicates() * std::accumulate(of_unit.begin(), of_unit.end(), 0.0);
    if (rays == 0.0) continue;
    const auto q = expected_[u];
    const auto of_fraction = q / (rays * (1.0 + 2.0 * q * rays));
    for (auto s = units_[u]; s < units_[u + 1]; ++s)
      for (std::size_t b = 0; b < bands; ++b)
        variance[s * bands + b] =
            static_cast<float>(of_fraction * squared(std::numbers::pi * static_cast<double>(sky[b])));
  }
  return variance;
}

}  // namespace luxel
