// SPDX-License-Identifier: Apache-2.0
#include "luxel/transport/lamp_check.h"

#include <algorithm>

#include <fmt/format.h>

#include "luxel/random/address.h"
#include "luxel/transport/patch_emitter.h"

namespace luxel {
namespace {

constexpr std::size_t rays_a_side = 1000;
constexpr double nearly_all = 0.98;
constexpr double much_nearer =
    0.03;  // front distance over back distance of a lamp that hugs a wall the wrong way

// Rays spread over the lamp's patches by area.
LampView::Side look(const PatchSet& patches, const Tracer& tracer, const std::vector<std::size_t>& lamp,
                    const std::vector<double>& area_before, bool back) {
  std::vector<float> distances;
  for (std::size_t i = 0; i < rays_a_side; ++i) {
    const auto at = area_before.back() * (static_cast<double>(i) + 0.5) / static_cast<double>(rays_a_side);
    const auto k =
        std::upper_bound(area_before.begin() + 1, area_before.end() - 1, at) - area_before.begin() - 1;
    const auto side = side_of(lamp[static_cast<std::size_t>(k)], back);
    const auto hit = tracer.nearest(PatchEmitter(patches, side).ray(uniform4(stream_key(0, 0, 0), i)));
    if (hit) distances.push_back(hit.distance);
  }
  LampView::Side result;
  result.escaped = 1.0 - static_cast<double>(distances.size()) / static_cast<double>(rays_a_side);
  if (distances.empty()) return result;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  result.median_distance = *middle;
  return result;
}

}  // namespace

std::vector<LampView> view_from_lamps(const PatchSet& patches, const Tracer& tracer) {
  std::vector<std::vector<std::size_t>> lamps(patches.materials.size());
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (patches.material_of(p).is_lamp()) lamps[static_cast<std::size_t>(patches.material[p])].push_back(p);

  std::vector<LampView> views;
  for (std::size_t m = 0; m < lamps.size(); ++m) {
    if (lamps[m].empty()) continue;
    std::vector<double> area_before{0.0};
    for (const auto p : lamps[m])
      area_before.push_back(area_before.back() + static_cast<double>(patches.area[p]));
    LampView view;
    view.material = m;
    view.patches = lamps[m].size();
    for (const auto emittance : patches.materials[m].emittance)
      view.power.push_back(area_before.back() * static_cast<double>(emittance));
    view.front = look(patches, tracer, lamps[m], area_before, false);
    view.back = look(patches, tracer, lamps[m], area_before, true);
    views.push_back(std::move(view));
  }
  return views;
}

std::string lamp_fault(const PatchSet& patches, const LampView& view) {
  const auto& name = patches.materials[view.material].name;
  const auto advice =
      fmt::format("it seems to face the wrong way: turn its faces round with --flip {}", name);
  if (view.front.escaped > nearly_all) {
    const auto fact = fmt::format("lamp '{}' lights nothing: {:.0f} % of its light leaves the scene", name,
                                  100.0 * view.front.escaped);
    return view.back.escaped < 0.5 ? fmt::format("{}, and {}", fact, advice) : fact;
  }
  const bool hugs_a_wall = view.front.median_distance < much_nearer * view.back.median_distance;
  if (hugs_a_wall && view.back.escaped < 0.5)
    return fmt::format(
        "lamp '{}' shines at a surface {:.3g} m before it, while its back has {:.3g} m of room; {}", name,
        view.front.median_distance, view.back.median_distance, advice);
  return {};
}

}  // namespace luxel
