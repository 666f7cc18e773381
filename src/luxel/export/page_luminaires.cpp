// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/page_luminaires.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "luxel/core/utf8.h"
#include "luxel/patch/luminaire_groups.h"
#include "luxel/photometry/luminaire_mesh.h"
#include "luxel/photometry/opening.h"
#include "luxel/scene/band_colours.h"

namespace luxel {
namespace {

constexpr float steps_per_metre = 1e4f;  // of an opening's corners

Json three(const Vec3d& v) { return {v.x, v.y, v.z}; }

void add_opening(PageArrays& arrays, const LuminousOpening& opening, std::size_t kind) {
  const auto mesh = opening_mesh(opening);
  std::vector<std::int32_t> places;
  for (const auto& triangle : mesh.triangles)
    for (const auto v : triangle)
      for (int i = 0; i < 3; ++i)
        places.push_back(static_cast<std::int32_t>(std::lround(mesh.positions[v][i] * steps_per_metre)));
  arrays.add_differences(fmt::format("opening{}", kind), places, 3);
}

// Light above 0 keeps a code above 0.
void add_solid(PageArrays& arrays, const IntensityDistribution& intensity, std::size_t kind) {
  std::vector<std::uint8_t> codes;
  for (const auto radius : photometric_solid(intensity).radius)
    codes.push_back(static_cast<std::uint8_t>(
        radius > 0.0f ? std::max(1l, std::lround(255.0f * std::min(1.0f, radius))) : 0l));
  arrays.add(fmt::format("solid{}", kind), codes);
}

Json kind_of(PageArrays& arrays, const Photometry& photometry, std::size_t number) {
  const auto opening = shown_opening(photometry.opening);
  add_opening(arrays, opening, number);
  add_solid(arrays, photometry.intensity, number);
  return {{"file", valid_utf8(photometry.file)}, {"isSheet", is_flat(opening)}};
}

}  // namespace

Json add_luminaires(PageArrays& arrays, const PatchSet& patches, bool has_groups) {
  Json kinds = Json::array(), places = Json::array();
  const auto colours = patches.colours();
  std::map<const Photometry*, std::size_t> number_of;
  for (const auto& lamp : patches.point_lights) {
    const auto& light = lamp.light;
    if (light.kind != PointLightKind::luminaire) continue;
    const auto& photometry = *light.photometry;
    const auto [found, is_new] = number_of.try_emplace(&photometry, number_of.size());
    if (is_new) kinds.push_back(kind_of(arrays, photometry, found->second));
    places.push_back({{"kind", found->second},
                      {"group", has_groups ? lamp.light_group : 0u},
                      {"name", valid_utf8(light.name)},
                      {"at", three(Vec3d(light.position))},
                      {"x", three(Vec3d(light.local_x))},
                      {"y", three(Vec3d(light.local_y))},
                      {"lumens", luminaire_lumens(lamp, patches)},
                      {"intensity", three(colours.rgb(lamp.intensity))}});
  }
  return {{"kinds", std::move(kinds)},
          {"places", std::move(places)},
          {"metresPerStep", 1.0 / static_cast<double>(steps_per_metre)},
          {"rows", PhotometricSolid::rows},
          {"columns", PhotometricSolid::columns}};
}

Json lumens_of_groups(const PatchSet& patches, bool has_groups) {
  const auto groups = has_groups ? patches.group_count() : 1;
  Json list = Json::array();
  for (std::size_t g = 0; g < groups; ++g) {
    std::array<double, 3> parts{};
    double sum = 0.0;
    for (const auto& lamp : patches.point_lights) {
      if (lamp.light.kind != PointLightKind::luminaire || (has_groups && lamp.light_group != g)) continue;
      const auto rgb = patches.colours().rgb(lamp.intensity);
      const auto lumens = luminaire_lumens(lamp, patches);
      const Vec3d weighted(0.2126 * rgb.r, 0.7152 * rgb.g, 0.0722 * rgb.b);
      const auto luminance = weighted.r + weighted.g + weighted.b;
      if (!(lumens > 0.0) || !(luminance > 0.0)) continue;
      for (std::size_t c = 0; c < 3; ++c) parts[c] += lumens * weighted[static_cast<int>(c)] / luminance;
      sum += lumens;
    }
    if (sum > 0.0)
      list.push_back({parts[0] / sum, parts[1] / sum, parts[2] / sum});
    else
      list.push_back(nullptr);
  }
  return list;
}

}  // namespace luxel
