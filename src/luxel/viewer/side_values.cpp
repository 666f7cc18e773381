// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/side_values.h"

#include <limits>
#include <numeric>

#include "luxel/patch/side.h"
#include "luxel/scene/band_colours.h"
#include "luxel/session/patch_levels.h"

namespace luxel {
namespace {

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

// Values of the mesh: the same on both sides.
template <typename Values>
std::vector<float> on_both_sides(const Values& values) {
  std::vector<float> sides;
  sides.reserve(2 * values.size());
  for (const auto value : values) sides.insert(sides.end(), 2, static_cast<float>(value));
  return sides;
}

std::vector<float> per_cent(std::vector<float> fractions) {
  for (auto& fraction : fractions) fraction *= 100.0f;
  return fractions;
}

// Sums over bands, W/m², or lux; empty for the back of a one-sided material.
std::vector<float> band_values(const PatchSet& patches, bool lux, const SideValues& values) {
  if (values.front.empty()) return {};
  const auto bands = patches.band_count();
  const auto colours = patches.colours();
  const auto one = [&](SideId side) {
    const float* const first = values.of(side).data() + side.patch() * bands;
    return lux ? static_cast<float>(colours.lumens(first)) : std::accumulate(first, first + bands, 0.0f);
  };
  std::vector<float> sides(side_count(patches.size()), unknown);
  for (std::size_t patch = 0; patch < patches.size(); ++patch) {
    const SideId front(patch, false), back(patch, true);
    sides[front.index()] = one(front);
    if (patches.material_of(patch).two_sided && !values.back.empty()) sides[back.index()] = one(back);
  }
  return sides;
}

}  // namespace

std::vector<float> side_values(Show show, bool lux, const PatchSet& patches, const SessionLight* light,
                               const LightDifference* difference) {
  switch (show) {
    case Show::patch_size:
      return on_both_sides(patch_sizes(patches));
    case Show::level:
      return on_both_sides(patch_levels(patches));
    case Show::difference:
      return difference == nullptr ? std::vector<float>() : per_cent(difference->relative);
    case Show::standard_error:
      if (light == nullptr) return {};
      return band_values(patches, lux, light->solution.standard_error);
    case Show::unshot:
      if (light == nullptr) return {};
      return band_values(patches, lux, light->unshot);
    default:
      return {};
  }
}

bool is_of_light(Show show) { return show == Show::standard_error || show == Show::unshot; }

const char* unit_of(Show show, bool lux) {
  switch (show) {
    case Show::irradiance:
    case Show::standard_error:
    case Show::unshot:
      return lux ? "lux" : "W/m\u00b2";
    case Show::patch_size:
      return "m";
    case Show::difference:
      return "%";
    default:
      return "";
  }
}

const char* heading_of(Show show) {
  switch (show) {
    case Show::light:
      return "Light";
    case Show::irradiance:
      return "Irradiance";
    case Show::standard_error:
      return "Standard error";
    case Show::patch_size:
      return "Longest edge of a patch";
    case Show::level:
      return "Times halved";
    case Show::difference:
      return "Relative difference";
    case Show::unshot:
      return "Unshot light";
    case Show::grey:
      return "Grey";
    case Show::sides:
      return "Front and back";
  }
  return "";
}

}  // namespace luxel
