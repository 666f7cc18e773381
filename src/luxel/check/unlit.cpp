// SPDX-License-Identifier: Apache-2.0
#include "luxel/check/unlit.h"

#include <algorithm>
#include <array>

#include "luxel/check/lamp_choice.h"
#include "luxel/check/walk.h"
#include "luxel/random/address.h"

namespace luxel {
namespace {

constexpr std::uint32_t first_step = 0x0c4ed000;  // of the random numbers: no solver counts that far
constexpr std::uint32_t stops = 8;

// What a walk came by.
struct Trail {
  std::array<std::uint32_t, stops> patch{};
  std::uint32_t length = 0;
  std::uint32_t rays = 0;
};

class Looker {
 public:
  Looker(const PatchSet& patches, const Tracer& tracer, const UnlitOptions& options)
      : patches_(patches), tracer_(tracer), options_(options), lamps_(patches) {}

  // Whether walk number `look` from a patch finds light.
  bool finds_light(std::uint32_t patch, std::uint32_t look, Trail& trail) const {
    const bool back = look % 2 == 1;
    const auto u = uniform4({options_.seed, first_step + look, patch, 0});
    auto from = patch;
    auto from_back = back;
    auto weights = uniform_triangle(u[0], u[1]);
    for (std::uint32_t stop = 0; stop < stops; ++stop) {
      const auto v = uniform4({options_.seed, first_step + look, patch, 1 + stop});
      const auto ray = bounce(patches_, from, from_back, weights, v[0], v[1]);
      if (!lamps_.empty() && sees_lamp(ray.origin, from, from_back, v, trail.rays)) return true;
      ++trail.rays;
      const auto hit = tracer_.nearest(ray);
      if (!hit) return options_.has_sky;
      if (!hit.back && patches_.material_of(hit.patch).is_lamp()) return true;
      if (!reflects(patches_, hit)) return false;
      from = hit.patch;
      trail.patch[trail.length++] = hit.patch;
      from_back = hit.back;
      weights = {hit.u, hit.v};
    }
    return false;
  }

 private:
  bool sees_lamp(const Vec3& at, std::size_t from, bool from_back, const std::array<float, 4>& u,
                 std::uint32_t& rays) const {
    const auto lamp = lamps_.at(static_cast<double>(u[2]));
    const auto p = patches_.points(lamp);
    // One number gives two: its high digits and its low ones.
    const auto digits = 4096.0f * u[3];
    const auto high = static_cast<float>(static_cast<int>(digits)) / 4096.0f;
    const auto w = uniform_triangle(high, digits - 4096.0f * high);
    const auto target =
        p[0] + w.x * (p[1] - p[0]) + w.y * (p[2] - p[0]) + origin_lift(p) * patches_.normal[lamp];
    const auto way = target - at;
    const auto distance = glm::length(way);
    const auto facing = from_back ? -patches_.normal[from] : patches_.normal[from];
    if (!(distance > 0.0f) || glm::dot(way, facing) <= 0.0f || glm::dot(way, patches_.normal[lamp]) >= 0.0f)
      return false;
    ++rays;
    return !tracer_.occluded({at, way / distance}, distance * (1.0f - 1e-5f));
  }

  const PatchSet& patches_;
  const Tracer& tracer_;
  const UnlitOptions& options_;
  LampChoice lamps_;
};

}  // namespace

Unlit find_unlit(const PatchSet& patches, const Tracer& tracer, const UnlitOptions& options,
                 const Workers& workers, const Monitor& monitor) {
  constexpr std::size_t grain = 1024;
  const Looker looker(patches, tracer, options);
  std::vector<std::uint8_t> is_lit(patches.size(), 0);
  if (!options.is_known_lit.empty()) is_lit.assign(options.is_known_lit.begin(), options.is_known_lit.end());
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (patches.material_of(p).is_lamp()) is_lit[p] = 1;

  Unlit result;
  const auto take_dark = [&] {
    result.patches.clear();
    for (std::uint32_t p = 0; p < patches.size(); ++p)
      if (is_lit[p] == 0) result.patches.push_back(p);
  };
  take_dark();
  // Rounds of ever more looks at the ever fewer that are left: 1, 2, 6, ... 64 in all.
  for (const std::uint32_t upto : {1u, 2u, 6u, 14u, 30u, 64u}) {
    const auto& left = result.patches;
    const auto begin = static_cast<std::uint32_t>(result.looks);
    const auto expected = static_cast<double>(left.size()) * (upto - begin) * 2.0 * stops;
    if (begin >= 6 && static_cast<double>(result.rays) + expected > static_cast<double>(options.most_rays))
      break;
    // In parts, so that somebody can be told. What each chunk found lit is marked when all are done.
    const auto part = std::max<std::size_t>(grain, left.size() / 16 / grain * grain);
    for (std::size_t first = 0; first < left.size(); first += part) {
      const auto share = static_cast<double>(first) / static_cast<double>(left.size());
      if (tell(monitor, {.stage = "dark places",
                         .done = (begin + (upto - begin) * share) / 64.0,
                         .rays = result.rays}) == Next::stop) {
        result.is_whole = false;
        return result;
      }
      const auto count = std::min(part, left.size() - first);
      std::vector<std::vector<std::uint32_t>> found((count + grain - 1) / grain);
      std::vector<std::uint64_t> rays(found.size(), 0);
      workers.for_chunks(count, grain, [&](std::size_t from, std::size_t to, int) {
        auto& lit = found[from / grain];
        for (auto i = first + from; i < first + to; ++i)
          for (auto look = begin; look < upto; ++look) {
            Trail trail;
            const bool finds = looker.finds_light(left[i], look, trail);
            rays[from / grain] += trail.rays;
            if (!finds) continue;
            lit.push_back(left[i]);
            lit.insert(lit.end(), trail.patch.begin(), trail.patch.begin() + trail.length);
            break;
          }
      });
      for (const auto& lit : found)
        for (const auto p : lit) is_lit[p] = 1;
      for (const auto r : rays) result.rays += r;
    }
    take_dark();
    result.looks = upto;
    if (result.patches.empty()) break;
  }
  return result;
}

}  // namespace luxel
