// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "luxel/core/triangle.h"
#include "luxel/solution/solution_file.h"

namespace luxel::sample {

// Numbers that differ everywhere, some of them awkward: not round, tiny, minus zero.
inline std::vector<float> numbers(std::size_t count, float first) {
  std::vector<float> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = first + static_cast<float>(i) / 3.0f;
  if (count > 2) values[1] = -0.0f;
  if (count > 2) values[2] = 1e-42f;
  return values;
}

// A strip of triangles along x, each of its own input triangle, with two alternating materials.
inline PatchSet patches(std::size_t count, std::size_t bands) {
  PatchSet set;
  for (std::size_t i = 0; i < count + 2; ++i)
    set.vertices.emplace_back(static_cast<float>(i) / 7.0f, i % 2 == 0 ? 0.0f : 1.0f, 0.1f);
  for (std::uint32_t i = 0; i < count; ++i) {
    set.corners.push_back(i % 2 == 0 ? std::array{i, i + 2, i + 1} : std::array{i, i + 1, i + 2});
    const auto [a, b, c] = set.points(i);
    set.normal.push_back(triangle_normal(a, b, c));
    set.area.push_back(static_cast<float>(triangle_area(a, b, c)));
    set.material.push_back(MaterialId{i % 2});
    set.triangle.push_back(3 * i);
  }
  for (std::size_t i = 0; i < bands; ++i) set.bands.push_back("band " + std::to_string(i));
  set.materials = {{"wall", true, std::vector(bands, 0.7f), std::vector(bands, 0.0f)},
                   {"lamp, \"größer\"", false, std::vector(bands, 0.1f), numbers(bands, 15.0f)}};
  set.scene_fingerprint = 0xfedcba9876543210;
  return set;
}

inline Solution solution(const PatchSet& patches) {
  const auto count = patches.size() * patches.band_count();
  Solution solution;
  solution.bands = patches.bands;
  solution.irradiance.front = numbers(count, 1.0f);
  solution.irradiance.back = numbers(count, 1000.0f);
  solution.radiosity.front = numbers(count, 2000.0f);
  solution.radiosity.back = numbers(count, 3000.0f);
  solution.unshot_fraction = 1.0 / 3.0;
  solution.predicted_error = 0.01;
  solution.stop = StopReason::converged;
  solution.provenance = {"0.1.0",
                         "luxel solve room.obj --error 1%",
                         "stochastic-jacobi",
                         {{"error", "0.01"}, {"time", ""}, {"seed", "7"}},
                         7,
                         12'345'678'901,
                         patches.scene_fingerprint,
                         {}};
  return solution;
}

inline Baked baked(std::size_t count, std::size_t bands) {
  auto set = patches(count, bands);
  auto light = solution(set);
  return {std::move(set), std::move(light)};
}

// The same with the values that only a method with error estimates gives.
inline Baked baked_with_errors(std::size_t count, std::size_t bands) {
  auto sample = baked(count, bands);
  auto& light = sample.solution;
  light.standard_error.front = numbers(count * bands, 4000.0f);
  light.standard_error.back = numbers(count * bands, 5000.0f);
  light.smoothing_bias.front = numbers(count * bands, 6000.0f);
  light.smoothing_bias.back = numbers(count * bands, 7000.0f);
  light.error_95th = 0.025;
  light.error_degrees_of_freedom = 6.0;
  light.predicted_bias = 0.003;
  light.stop = StopReason::error_reached;
  light.provenance.method = "sampled";
  return sample;
}

// The same far from its file's zero.
inline Baked baked_far_away(std::size_t count, std::size_t bands) {
  auto sample = baked(count, bands);
  sample.patches.origin = {100'000.0, 0.0, -1'000'000.0};
  return sample;
}

// To the bit: == would call 0 and -0 the same.
template <typename T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

inline bool same_material(const BandMaterial& a, const BandMaterial& b) {
  return a.name == b.name && a.two_sided == b.two_sided && a.light_group == b.light_group &&
         same_bits(a.reflectance, b.reflectance) && same_bits(a.emittance, b.emittance) &&
         same_bits(a.transmittance, b.transmittance) &&
         same_bits(a.diffuse_transmittance, b.diffuse_transmittance);
}

// The first member that differs, or nothing.
inline std::string difference(const PatchSet& a, const PatchSet& b) {
  if (!same_bits(a.vertices, b.vertices)) return "vertices";
  if (a.origin != b.origin) return "origin";
  if (a.corners != b.corners) return "corners";
  if (!same_bits(a.normal, b.normal)) return "normal";
  if (!same_bits(a.area, b.area)) return "area";
  if (a.material != b.material) return "material";
  if (a.triangle != b.triangle) return "triangle";
  if (a.bands != b.bands) return "bands";
  if (!std::equal(a.materials.begin(), a.materials.end(), b.materials.begin(), b.materials.end(),
                  same_material))
    return "materials";
  if (a.sky != b.sky) return "sky";
  if (a.light_groups != b.light_groups) return "light_groups";
  if (a.contacts != b.contacts) return "contacts";
  if (a.portals != b.portals) return "portals";
  if (a.panes != b.panes) return "panes";
  return a.scene_fingerprint == b.scene_fingerprint ? "" : "scene_fingerprint";
}

inline std::string difference(const Provenance& a, const Provenance& b) {
  if (a.program_version != b.program_version) return "program_version";
  if (a.command_line != b.command_line) return "command_line";
  if (a.method != b.method) return "method";
  if (a.options != b.options) return "options";
  if (a.seed != b.seed) return "seed";
  if (a.rays != b.rays) return "rays";
  if (a.merged != b.merged) return "merged";
  return a.scene_fingerprint == b.scene_fingerprint ? "" : "scene_fingerprint";
}

inline std::string difference(const Solution& a, const Solution& b) {
  if (a.bands != b.bands) return "bands";
  if (!same_bits(a.irradiance.front, b.irradiance.front)) return "irradiance_front";
  if (!same_bits(a.irradiance.back, b.irradiance.back)) return "irradiance_back";
  if (!same_bits(a.radiosity.front, b.radiosity.front)) return "radiosity_front";
  if (!same_bits(a.radiosity.back, b.radiosity.back)) return "radiosity_back";
  if (!same_bits(a.standard_error.front, b.standard_error.front)) return "standard_error_front";
  if (!same_bits(a.standard_error.back, b.standard_error.back)) return "standard_error_back";
  if (!same_bits(a.smoothing_bias.front, b.smoothing_bias.front)) return "smoothing_bias_front";
  if (!same_bits(a.smoothing_bias.back, b.smoothing_bias.back)) return "smoothing_bias_back";
  if (a.error_95th != b.error_95th) return "error_95th";
  if (a.error_degrees_of_freedom != b.error_degrees_of_freedom) return "error_degrees_of_freedom";
  if (a.predicted_bias != b.predicted_bias) return "predicted_bias";
  if (a.unshot_fraction != b.unshot_fraction) return "unshot_fraction";
  if (a.predicted_error != b.predicted_error) return "predicted_error";
  if (a.stop != b.stop) return "stop";
  return difference(a.provenance, b.provenance);
}

}  // namespace luxel::sample
