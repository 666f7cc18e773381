// SPDX-License-Identifier: Apache-2.0
#include "luxel/trace/collect_views.h"

#include <algorithm>
#include <numeric>

#include "luxel/patch/side.h"

namespace luxel {

Views collect_views(const PatchSet& patches, std::span<const Panorama> looks, std::span<const float> weight,
                    std::size_t cameras) {
  const auto is_focused = [&](SideId side) {
    return patches.focus.empty() || patches.focus[side.patch()] != 0;
  };
  Views views;
  views.first.push_back(0);
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const auto begin = views.seen.size();
    bool any = false;
    for (const auto side : looks[i].side) {
      if (side == Panorama::escaped && patches.has_sky()) views.seen.push_back(Views::sky);
      if (!Panorama::is_side(side)) continue;
      views.seen.push_back(side.index() | (is_focused(side) ? 0 : Views::unfocused));
      any |= is_focused(side);
    }
    if (!any) {
      views.seen.resize(begin);
      continue;
    }
    views.eye.push_back(looks[i].eye);
    views.weight.push_back(weight[i]);
    if (i + cameras >= looks.size()) ++views.cameras;
    views.first.push_back(static_cast<std::uint32_t>(views.seen.size()));
  }
  const auto sum = std::accumulate(views.weight.begin(), views.weight.end(), 0.0);
  for (auto& w : views.weight) w = static_cast<float>(w / sum);
  // Replaces sides by indices into the list of seen sides.
  for (const auto s : views.seen)
    if (s != Views::sky) views.sides.push_back(SideId::at(s & ~Views::unfocused));
  std::sort(views.sides.begin(), views.sides.end());
  views.sides.erase(std::unique(views.sides.begin(), views.sides.end()), views.sides.end());
  for (auto& s : views.seen) {
    if (s == Views::sky) continue;
    const auto at =
        std::lower_bound(views.sides.begin(), views.sides.end(), SideId::at(s & ~Views::unfocused));
    s = static_cast<std::uint32_t>(at - views.sides.begin()) | (s & Views::unfocused);
  }
  return views;
}

}  // namespace luxel
