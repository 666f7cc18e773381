// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/lit_mesh.h"

#include <span>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/none.h"
#include "luxel/solution/back_is_lit.h"

namespace luxel {
namespace {

void check(const PatchSet& patches, const Solution& solution, const SmoothLight& light) {
  const auto values = patches.size() * solution.bands.size();
  if (solution.bands != patches.bands || solution.radiosity.front.size() != values ||
      solution.radiosity.back.size() != values || solution.irradiance.back.size() != values)
    throw MismatchError(
        fmt::format("the solution has {} radiosities but the patches need {}: it was not "
                    "made from this scene; solve it again",
                    solution.radiosity.front.size(), values));
  if (light.corners.size() != patches.size())
    throw MismatchError(
        fmt::format("the smooth light has {} patches but the scene has {}: smooth the light "
                    "of this scene",
                    light.corners.size(), patches.size()));
}

std::span<const float> of_element(const std::vector<float>& values, std::size_t element, std::size_t bands) {
  return std::span(values).subspan(element * bands, bands);
}

// The patches of each material and side, in order: entry 2 * material is its fronts, the next its backs.
std::vector<std::vector<std::uint32_t>> patches_by_side(const PatchSet& patches, const Solution& solution) {
  std::vector<std::vector<std::uint32_t>> sides(2 * patches.materials.size());
  for (std::uint32_t p = 0; p < patches.size(); ++p) {
    const auto material = static_cast<std::size_t>(patches.material[p]);
    sides[2 * material].push_back(p);
    if (back_is_lit(solution, p)) sides[2 * material + 1].push_back(p);
  }
  return sides;
}

// number: [smooth vertex]; its vertex in the current part, or none; unchanged on return.
LitPart part_of(const PatchSet& all, const std::vector<std::uint32_t>& patches, const SmoothLight& light,
                std::size_t material, bool back, std::vector<std::uint32_t>& number) {
  LitPart part{material, back, {}, {}, VertexTextureRatios(all)};
  part.triangles.reserve(patches.size());
  for (const auto p : patches) {
    auto corners = light.corners[p];
    for (auto& corner : corners) {
      auto& n = number[corner];
      if (n == none) {
        n = static_cast<std::uint32_t>(part.smooth.size());
        part.smooth.push_back(corner);
      }
      corner = n;
      part.ratios.add(n, p);
    }
    if (back) std::swap(corners[1], corners[2]);
    part.triangles.push_back(corners);
  }
  for (const auto s : part.smooth) number[s] = none;
  return part;
}

}  // namespace

ToneCurve curve_for(const PatchSet& patches, const Solution& solution, const ToneOptions& tone) {
  const auto colours = patches.colours();
  std::vector<Vec3> radiance;
  std::vector<float> areas;
  const auto add = [&](const std::vector<float>& radiosity, std::size_t patch) {
    radiance.push_back(in_gamut(colours.rgb(of_element(radiosity, patch, colours.bands()))) / pi);
    areas.push_back(patches.area[patch]);
  };
  for (std::size_t p = 0; p < patches.size(); ++p) {
    add(solution.radiosity.front, p);
    if (back_is_lit(solution, p)) add(solution.radiosity.back, p);
  }
  return fit_curve(radiance, areas, tone);
}

LitMesh::LitMesh(const PatchSet& patches, const Solution& solution, const SmoothLight& light,
                 const ToneOptions& tone)
    : patches_(patches), light_(light), colours_(patches.colours()) {
  check(patches, solution, light);
  curve_ = curve_for(patches, solution, tone);
  std::vector<std::uint32_t> number(light.size(), none);
  const auto sides = patches_by_side(patches, solution);
  for (std::size_t m = 0; m < patches.materials.size(); ++m)
    for (const bool back : {false, true})
      if (const auto& members = sides[2 * m + (back ? 1 : 0)]; !members.empty())
        parts_.push_back(part_of(patches, members, light, m, back, number));
}

LitVertex LitMesh::vertex(const LitPart& part, std::size_t i) const {
  const auto s = part.smooth[i];
  const auto& irradiance = light_.irradiance.of(part.back);
  LitVertex v{};
  v.position = patches_.vertices[light_.vertex[s]];
  v.normal = part.back ? -light_.normal[s] : light_.normal[s];
  const auto here = of_element(irradiance, s, colours_.bands());
  v.irradiance = Vec3(colours_.rgb(here));
  v.colour = curve_(in_gamut(radiance_of(patches_.materials[part.material], part.back,
                                         irradiance_at(light_, s, part.back, colours_.bands()), colours_,
                                         part.ratios.at(i))));
  return v;
}

}  // namespace luxel
