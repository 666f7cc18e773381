// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/lamp_check.h"

#include <algorithm>

#include <fmt/format.h>

#include "luxel/core/address.h"
#include "luxel/core/discrete_distribution.h"
#include "luxel/patch/side.h"
#include "luxel/trace/patch_emitter.h"

namespace luxel {
namespace {

constexpr std::size_t rays_per_side = 1000;
constexpr double nearly_all = 0.98;
constexpr double much_nearer =
    0.03;  // ratio of front to back distance below which a lamp faces the wall it is mounted on

struct Lamp {
  std::vector<std::size_t> patches;
  DiscreteDistribution by_area;
};

// The patches of each material that emits and has patches, in the order of materials.
std::vector<Lamp> lamp_patches(const PatchSet& patches) {
  std::vector<Lamp> lamps(patches.materials.size());
  std::vector<bool> is_lamp;
  for (const auto& material : patches.materials) is_lamp.push_back(material.is_lamp());
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto m = static_cast<std::size_t>(patches.material[p]);
    if (!is_lamp[m]) continue;
    lamps[m].patches.push_back(p);
    lamps[m].by_area.add(static_cast<double>(patches.area[p]));
  }
  std::erase_if(lamps, [](const Lamp& lamp) { return lamp.patches.empty(); });
  return lamps;
}

// Rays spread over the lamp's patches by area.
LampView::Side look(const PatchSet& patches, const Tracer& tracer, const Lamp& lamp, bool back) {
  std::vector<float> distances;
  for (std::size_t i = 0; i < rays_per_side; ++i) {
    const auto at =
        lamp.by_area.total() * (static_cast<double>(i) + 0.5) / static_cast<double>(rays_per_side);
    const auto side = SideId(lamp.patches[lamp.by_area.at(at)], back);
    const auto hit = tracer.nearest(PatchEmitter(patches, side).ray(uniform4(stream_key(0, 0, 0), i)));
    if (hit) distances.push_back(hit.distance);
  }
  LampView::Side result;
  result.escaped = 1.0 - static_cast<double>(distances.size()) / static_cast<double>(rays_per_side);
  if (distances.empty()) return result;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  result.median_distance = *middle;
  return result;
}

}  // namespace

std::vector<LampView> view_from_lamps(const PatchSet& patches, const Tracer& tracer, const Context& context) {
  std::vector<LampView> views;
  const auto lamps = lamp_patches(patches);
  for (const auto& lamp : lamps) {
    LampView view;
    view.material = static_cast<std::size_t>(patches.material[lamp.patches[0]]);
    view.patches = lamp.patches.size();
    for (const auto emittance : patches.materials[view.material].emittance)
      view.power.push_back(lamp.by_area.total() * static_cast<double>(emittance));
    views.push_back(std::move(view));
  }
  context.for_chunks(lamps.size(), 1, [&](std::size_t begin, std::size_t end, int) {
    for (auto i = begin; i < end; ++i) {
      views[i].front = look(patches, tracer, lamps[i], false);
      views[i].back = look(patches, tracer, lamps[i], true);
    }
  });
  return views;
}

bool turning_helps(const LampView& view) { return view.back.escaped < 0.5; }

LampFault judge(const LampView& view) {
  if (view.front.escaped > nearly_all) return LampFault::lights_nothing;
  const bool hugs_a_wall = view.front.median_distance < much_nearer * view.back.median_distance;
  return hugs_a_wall && turning_helps(view) ? LampFault::faces_wall : LampFault::no_fault;
}

std::string lamp_fact(const PatchSet& patches, const LampView& view) {
  const auto& name = patches.materials[view.material].name;
  switch (judge(view)) {
    case LampFault::no_fault:
      break;
    case LampFault::lights_nothing:
      return fmt::format("lamp '{}' lights nothing: {:.0f} % of its light leaves the scene", name,
                         100.0 * view.front.escaped);
    case LampFault::faces_wall:
      return fmt::format(
          "lamp '{}' shines at a surface {:.3g} m before it, while its back has {:.3g} m of room", name,
          view.front.median_distance, view.back.median_distance);
  }
  return {};
}

LampWarning lamp_warning(const PatchSet& patches, const LampView& view) {
  const auto fact = lamp_fact(patches, view);
  if (fact.empty() || !turning_helps(view)) return {fact, {}};
  return {fmt::format("{}{} it seems to face the wrong way: turn its faces round", fact,
                      judge(view) == LampFault::faces_wall ? ";" : ", and"),
          {{Setting::flip, patches.materials[view.material].name}}};
}

}  // namespace luxel
