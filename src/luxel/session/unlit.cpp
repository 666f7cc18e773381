// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/unlit.h"

#include <algorithm>
#include <array>

#include "luxel/core/address.h"
#include "luxel/core/bounds.h"
#include "luxel/core/warp.h"
#include "luxel/patch/side.h"
#include "luxel/session/lamp_by_power.h"
#include "luxel/session/walk.h"
#include "luxel/trace/start_sides.h"

namespace luxel {
namespace {

constexpr std::uint32_t stops = 4;
constexpr float small_fraction =
    0.02f;  // of the scene's diagonal: light does not end within such a short edge

// Result of a walk. A walk that meets a patch known to be lit finds light, though perhaps not on that part of
// the patch: other patches are not marked from such a walk.
enum class End { in_the_dark, near_light, in_light };

// The sides that a walk met.
struct Trail {
  std::array<SideId, stops + 1> side{};
  std::uint32_t length = 0;
  std::uint32_t rays = 0;
};

class Looker {
 public:
  // is_lit: [side], results so far; must outlive this.
  Looker(const PatchSet& patches, const Tracer& tracer, const UnlitOptions& options,
         const std::vector<std::uint8_t>& is_lit)
      : patches_(patches), tracer_(tracer), options_(options), is_lit_(is_lit), lamps_(patches) {
    Bounds box;
    for (const auto& p : patches.vertices) box.add(p);
    const auto small = small_fraction * glm::length(box.size());
    is_small_.resize(patches.size());
    for (std::size_t p = 0; p < patches.size(); ++p) {
      const auto c = patches.points(p);
      is_small_[p] = std::max({glm::distance(c[0], c[1]), glm::distance(c[1], c[2]),
                               glm::distance(c[2], c[0])}) <= small;
    }
  }

  // Result of a walk from a patch: even numbers start at its front, odd ones at its back.
  End walk(std::uint32_t patch, std::uint32_t number, Trail& trail) const {
    const bool back = number % 2 == 1;
    trail.side[trail.length++] = SideId(patch, back);
    const auto u = uniform4({options_.seed, step_of(RandomPurpose::unlit_walks, number), patch, 0});
    auto from = patch;
    auto from_back = back;
    auto weights = uniform_triangle(u[0], u[1]);
    for (std::uint32_t stop = 0; stop < stops; ++stop) {
      const auto v = uniform4({options_.seed, step_of(RandomPurpose::unlit_walks, number), patch, 1 + stop});
      const auto ray = ray_from_side(patches_, SideId(from, from_back), weights, v[0], v[1]);
      if (!lamps_.empty() && sees_lamp(ray.origin, from, from_back, v, trail.rays)) return End::in_light;
      ++trail.rays;
      const auto hit = tracer_.nearest(ray);
      if (!hit) return options_.has_sky ? End::in_light : End::in_the_dark;
      if (!hit.back && patches_.material_of(hit.patch).is_lamp()) return End::in_light;
      if (!reflects(patches_, hit)) return End::in_the_dark;
      from = hit.patch;
      const auto side = hit.side();
      trail.side[trail.length++] = side;
      if (is_lit_[side.index()] != 0 && is_small_[hit.patch] != 0) return End::near_light;
      from_back =
          hit.back != passes_diffuser(hit.patch, {options_.seed, step_of(RandomPurpose::unlit_walks, number),
                                                  patch, 1 + stops + stop});
      weights = {hit.u, hit.v};
    }
    return End::in_the_dark;
  }

 private:
  // By chance, half of the times that a walk meets a diffuser.
  bool passes_diffuser(std::size_t patch, const RandomAddress& at) const {
    return patches_.material_of(patch).is_diffuser() && uniform4(at)[0] < 0.5f;
  }

  bool sees_lamp(const Vec3& at, std::size_t from, bool from_back, const std::array<float, 4>& u,
                 std::uint32_t& rays) const {
    const auto lamp = lamps_.at(static_cast<double>(u[2]));
    const auto p = patches_.points(lamp);
    // One number yields two: from its high and its low digits.
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
  const std::vector<std::uint8_t>& is_lit_;
  LampByPower lamps_;
  std::vector<std::uint8_t> is_small_;  // [patch]
};

}  // namespace

Unlit find_unlit(const PatchSet& patches, const Tracer& tracer, const UnlitOptions& options,
                 const Context& context) {
  constexpr std::size_t grain = 1024;
  std::vector<std::uint8_t> is_lit(side_count(patches.size()), 0);
  if (!options.is_known_lit.empty()) is_lit.assign(options.is_known_lit.begin(), options.is_known_lit.end());
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (patches.material_of(p).is_lamp()) is_lit[SideId(p, false).index()] = 1;
  const Looker looker(patches, tracer, options, is_lit);

  Unlit result;
  for (std::uint32_t p = 0; p < patches.size(); ++p)
    if (is_lit[SideId(p, false).index()] == 0 && is_lit[SideId(p, true).index()] == 0)
      result.patches.push_back(p);
  // Rounds with more and more walks for the fewer and fewer patches that are left: 1, 2, ... 32 in total.
  for (const std::uint32_t upto : {1u, 2u, 3u, 5u, 9u, 17u, 32u}) {
    auto& left = result.patches;
    const auto begin = static_cast<std::uint32_t>(result.walks);
    const auto expected = static_cast<double>(left.size()) * (upto - begin) * 4.0 * stops;
    if (begin >= 3 && static_cast<double>(result.rays) + expected > static_cast<double>(options.max_rays))
      break;
    // In parts, to report progress. Patches found lit are marked when all are done.
    std::vector<SideId> sides;
    std::vector<std::uint8_t> is_done(left.size(), 0);
    const auto part = std::max<std::size_t>(grain, left.size() / 16 / grain * grain);
    for (std::size_t first = 0; first < left.size(); first += part) {
      const auto fraction = static_cast<double>(first) / static_cast<double>(left.size());
      if (context.report({.stage = "dark places",
                          .done = (begin + (upto - begin) * fraction) / 32.0,
                          .rays = result.rays}) == Next::stop) {
        result.is_whole = false;
        return result;
      }
      const auto count = std::min(part, left.size() - first);
      std::vector<std::vector<SideId>> lit((count + grain - 1) / grain);
      std::vector<std::uint64_t> rays(lit.size(), 0);
      context.for_chunks(count, grain, [&](std::size_t from, std::size_t to, int) {
        const auto chunk = from / grain;
        for (auto i = first + from; i < first + to; ++i)
          for (auto walk = 2 * begin; walk < 2 * upto && is_done[i] == 0; ++walk) {
            Trail trail;
            const auto end = looker.walk(left[i], walk, trail);
            rays[chunk] += trail.rays;
            is_done[i] = end != End::in_the_dark;
            if (end == End::in_light)
              lit[chunk].insert(lit[chunk].end(), trail.side.begin(), trail.side.begin() + trail.length);
          }
      });
      for (const auto& some : lit) sides.insert(sides.end(), some.begin(), some.end());
      for (const auto r : rays) result.rays += r;
    }
    for (const auto side : sides) is_lit[side.index()] = 1;
    std::vector<std::uint32_t> dark;
    for (std::size_t i = 0; i < left.size(); ++i)
      if (is_done[i] == 0 && is_lit[SideId(left[i], false).index()] == 0 &&
          is_lit[SideId(left[i], true).index()] == 0)
        dark.push_back(left[i]);
    left = std::move(dark);
    result.walks = upto;
    if (left.empty()) break;
  }
  return result;
}

}  // namespace luxel
