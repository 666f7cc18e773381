// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/simplify_mesh.h"

#include <algorithm>
#include <array>
#include <vector>

#include "luxel/core/triangle.h"
#include "luxel/export/displayed_corners.h"
#include "luxel/export/half_edge_collapse.h"

namespace luxel {
namespace {

PatchSet remaining_patches(const PatchSet& patches, const HalfEdgeCollapse& collapse,
                           const std::vector<std::uint32_t>& remaining) {
  PatchSet result;
  result.vertices = patches.vertices;
  result.bands = patches.bands;
  result.wavebands = patches.wavebands;
  result.materials = patches.materials;
  result.point_lights = patches.point_lights;
  result.light_groups = patches.light_groups;
  result.sky_patches = patches.sky_patches;
  result.sky = patches.sky;
  result.textures = patches.textures;
  result.scene_fingerprint = patches.scene_fingerprint;
  result.origin = patches.origin;
  result.uv_sets.resize(patches.uv_sets.size());
  for (const auto p : remaining) {
    const auto& corners = collapse.corners(p);
    const auto of_corners = [&](const auto& values) {
      return std::array{values[corners[0] / 3][corners[0] % 3], values[corners[1] / 3][corners[1] % 3],
                        values[corners[2] / 3][corners[2] % 3]};
    };
    result.corners.push_back(of_corners(patches.corners));
    const auto& c = result.corners.back();
    const auto& v = result.vertices;
    result.normal.push_back(patches.normal[p]);
    result.area.push_back(static_cast<float>(triangle_area(v[c[0]], v[c[1]], v[c[2]])));
    result.material.push_back(patches.material[p]);
    result.triangle.push_back(patches.triangle[p]);
    for (std::size_t s = 0; s < patches.uv_sets.size(); ++s)
      result.uv_sets[s].push_back(of_corners(patches.uv_sets[s]));
    if (!patches.corner_colours.empty()) result.corner_colours.push_back(of_corners(patches.corner_colours));
    const auto copy_row = [&](const std::vector<float>& from, std::vector<float>& to) {
      const auto bands = static_cast<std::ptrdiff_t>(patches.band_count());
      const auto row = from.begin() + static_cast<std::ptrdiff_t>(p) * bands;
      if (!from.empty()) to.insert(to.end(), row, row + bands);
    };
    copy_row(patches.reflectance_ratio, result.reflectance_ratio);
    copy_row(patches.emittance_ratio, result.emittance_ratio);
  }
  return result;
}

// Per side, the largest values of the patches that each one replaces: a side is lit where any of them was.
// Hidden backs are dark.
Solution remaining_solution(const PatchSet& patches, const Solution& solution,
                            const HalfEdgeCollapse& collapse, const std::vector<std::uint32_t>& remaining,
                            const std::vector<std::uint8_t>& hidden_back) {
  const auto bands = patches.band_count();
  Solution result;
  result.bands = solution.bands;
  result.provenance = solution.provenance;
  const auto rows = [&](const std::vector<float>& values, bool back) {
    const auto of = [&](std::size_t p, std::size_t b) {
      return back && !hidden_back.empty() && hidden_back[p] != 0 ? 0.0f : values[p * bands + b];
    };
    std::vector<float> reduced;
    reduced.reserve(remaining.size() * bands);
    for (const auto p : remaining)
      for (std::size_t b = 0; b < bands; ++b) {
        auto value = of(p, b);
        for (const auto q : collapse.replaced_by(p)) value = std::max(value, of(q, b));
        reduced.push_back(value);
      }
    return reduced;
  };
  for (const bool back : {false, true}) {
    result.irradiance.of(back) = rows(solution.irradiance.of(back), back);
    result.radiosity.of(back) = rows(solution.radiosity.of(back), back);
  }
  return result;
}

}  // namespace

SimplifiedMesh simplify_mesh(const PatchSet& patches, const Solution& solution, const SmoothLight& light,
                             const ToneCurve& curve, const SimplifyOptions& options) {
  const DisplayedCorners displayed(patches, solution, light, curve, options.max_error, options.hidden);
  std::vector<bool> stays(patches.size(), false);
  if (options.keeps_textured_patches)
    for (std::size_t p = 0; p < patches.size(); ++p) stays[p] = patches.material_of(p).textures.any();
  HalfEdgeCollapse collapse(patches, light, displayed, stays);
  collapse.run();
  std::vector<std::uint32_t> remaining;
  for (std::uint32_t p = 0; p < patches.size(); ++p)
    if (!collapse.is_gone(p)) remaining.push_back(p);
  SimplifiedMesh result{remaining_patches(patches, collapse, remaining),
                        remaining_solution(patches, solution, collapse, remaining, options.hidden.back),
                        light};
  result.light.corners.clear();
  for (const auto p : remaining) {
    const auto& corners = collapse.corners(p);
    result.light.corners.push_back({light.corners[corners[0] / 3][corners[0] % 3],
                                    light.corners[corners[1] / 3][corners[1] % 3],
                                    light.corners[corners[2] / 3][corners[2] % 3]});
  }
  return result;
}

}  // namespace luxel
