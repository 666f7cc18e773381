// SPDX-License-Identifier: Apache-2.0
#include "luxel/solution/check_solution.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "luxel/solution/solution_layout.h"
#include "luxel/solution/surface_file.h"

namespace luxel {
namespace {

constexpr float unit_tolerance = 1e-3f;  // of a normal's squared length

std::string fault_in_lengths(const PatchSet& patches) {
  const auto n = patches.size();
  constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();
  if (n > most || patches.vertices.size() > most)
    return fmt::format("{} patches on {} vertices are more than an index can name", n,
                       patches.vertices.size());
  const auto fits = [n](std::size_t length) { return length == n; };
  if (!fits(patches.normal.size()) || !fits(patches.area.size()) || !fits(patches.material.size()) ||
      !fits(patches.triangle.size()))
    return fmt::format("the arrays of {} patches are not all that long", n);
  if (patches.bands.empty()) return "there is no band";
  return {};
}

std::string fault_in_wavebands(const PatchSet& patches) {
  const auto& bands = patches.wavebands;
  if (!bands.empty() && bands.size() != patches.band_count())
    return fmt::format("there are {} wavelengths of {} bands", bands.size(), patches.band_count());
  double before = 0.0;
  for (const auto& band : bands) {
    if (!(band.wavelength > before && band.width > 0.0 && std::isfinite(band.wavelength + band.width)))
      return fmt::format("a band has the wavelength {} nm and the width {} nm, after {} nm", band.wavelength,
                         band.width, before);
    before = band.wavelength;
  }
  return {};
}

std::string fault_in_material(const BandMaterial& material, std::size_t bands) {
  if (material.reflectance.size() != bands || material.emittance.size() != bands)
    return fmt::format("material '{}' does not have one number for each of the {} bands", material.name,
                       bands);
  for (const auto r : material.reflectance)
    if (!(r >= 0.0f && r < 1.0f))
      return fmt::format("material '{}' has the reflectance {}, expected 0 to below 1", material.name, r);
  if (!material.transmittance.empty() && material.transmittance.size() != bands)
    return fmt::format("the glass '{}' does not have one transmittance for each of the {} bands",
                       material.name, bands);
  if (material.is_diffuser() && (material.diffuse_transmittance.size() != bands || !material.two_sided))
    return fmt::format(
        "the diffuser '{}' does not have two sides and one transmittance for each of the {} bands",
        material.name, bands);
  for (const auto t : material.diffuse_transmittance)
    if (!(t >= 0.0f && t <= max_reflectance))
      return fmt::format("material '{}' has the diffuse transmittance {}, expected 0 to below 1",
                         material.name, t);
  for (const auto e : material.emittance)
    if (!(e >= 0.0f && std::isfinite(e)))
      return fmt::format("material '{}' has the emittance {} W/m²", material.name, e);
  return {};
}

std::string fault_in_light_groups(const PatchSet& patches) {
  for (const auto& material : patches.materials)
    if (material.light_group >= patches.group_count())
      return fmt::format("material '{}' names light group {} of {}", material.name, material.light_group,
                         patches.light_groups.size());
  return {};
}

std::string fault_in_sky(const PatchSet& patches) {
  const auto count = patches.sky_patches.size() * patches.band_count();
  if (!patches.sky.empty() && patches.sky.size() != count)
    return fmt::format("the sky does not have one number for each of the {} bands", count);
  for (const auto radiance : patches.sky)
    if (!(radiance >= 0.0f && std::isfinite(radiance)))
      return fmt::format("the sky has the radiance {} W/(m² sr)", radiance);
  return {};
}

std::string fault_in_patch(const PatchSet& patches, std::size_t i) {
  for (const auto corner : patches.corners[i])
    if (corner >= patches.vertices.size())
      return fmt::format("patch {} names vertex {} of {}", i, corner, patches.vertices.size());
  const auto& normal = patches.normal[i];
  if (!(std::abs(glm::dot(normal, normal) - 1.0f) <= unit_tolerance))
    return fmt::format("patch {} has a normal that is not of length 1", i);
  const auto area = patches.area[i];
  if (!(area > 0.0f && std::isfinite(area))) return fmt::format("patch {} has the area {} m²", i, area);
  const auto material = static_cast<std::size_t>(patches.material[i]);
  if (material >= patches.materials.size())
    return fmt::format("patch {} names material {} of {}", i, material, patches.materials.size());
  if (i > 0 && patches.triangle[i] < patches.triangle[i - 1])
    return fmt::format("patch {} is not in the order of its input triangles", i);
  return {};
}

std::string fault_in_contacts(const PatchSet& patches) {
  for (std::size_t i = 0; i < patches.contacts.size(); ++i) {
    const auto& [edge, into] = patches.contacts[i];
    if (edge[0] >= edge[1] || edge[1] >= patches.vertices.size())
      return fmt::format("contact {} is at an edge from vertex {} to {} of {}", i, edge[0], edge[1],
                         patches.vertices.size());
    if (!(std::abs(glm::dot(into, into) - 1.0f) <= unit_tolerance))
      return fmt::format("contact {} has a direction that is not of length 1", i);
    if (i > 0 && edge < patches.contacts[i - 1].edge)
      return fmt::format("contact {} is not in the order of edges", i);
  }
  return {};
}

std::string fault_in_errors(const Solution& solution, std::size_t length) {
  const auto both_or_none = [length](const std::vector<float>& front, const std::vector<float>& back) {
    return front.empty() && back.empty() ? 0 : length;
  };
  const auto errors = both_or_none(solution.standard_error.front, solution.standard_error.back);
  const auto biases = both_or_none(solution.smoothing_bias.front, solution.smoothing_bias.back);
  for (const auto& [name, values] : error_arrays(solution)) {
    const bool is_bias = values == &solution.smoothing_bias.front || values == &solution.smoothing_bias.back;
    const auto expected = is_bias ? biases : errors;
    if (values->size() != expected)
      return fmt::format("'{}' holds {} numbers, expected {}", name, values->size(), expected);
    if (!std::all_of(values->begin(), values->end(), [](float x) { return x >= 0.0f && std::isfinite(x); }))
      return fmt::format("'{}' holds a number that is not finite, or below 0", name);
  }
  for (const auto& [name, value] :
       {std::pair("mesh_error", solution.mesh_error), std::pair("error_95th", solution.error_95th),
        std::pair("predicted_bias", solution.predicted_bias), std::pair("seen_error", solution.seen_error),
        std::pair("error_degrees_of_freedom", solution.error_degrees_of_freedom)})
    if (!(value >= 0.0 && std::isfinite(value))) return fmt::format("{} is {}", name, value);
  return {};
}

std::string fault_in_light(const Solution& solution, std::size_t length) {
  for (const auto& [name, values] : light_arrays(solution)) {
    if (values->size() != length)
      return fmt::format("'{}' holds {} numbers, expected {}", name, values->size(), length);
    if (!std::all_of(values->begin(), values->end(), [](float x) { return std::isfinite(x); }))
      return fmt::format("'{}' holds a number that is not finite", name);
  }
  if (auto fault = fault_in_errors(solution, length); !fault.empty()) return fault;
  if (!std::isfinite(solution.unshot_fraction) || !std::isfinite(solution.predicted_error))
    return "unshot_fraction or predicted_error is not finite";
  return {};
}

}  // namespace

std::string fault_in(const PatchSet& patches, const Solution& solution) {
  if (auto fault = fault_in_lengths(patches); !fault.empty()) return fault;
  for (const auto& material : patches.materials)
    if (auto fault = fault_in_material(material, patches.band_count()); !fault.empty()) return fault;
  if (auto fault = fault_in_wavebands(patches); !fault.empty()) return fault;
  if (auto fault = fault_in_sky(patches); !fault.empty()) return fault;
  if (auto fault = fault_in_light_groups(patches); !fault.empty()) return fault;
  if (auto fault = fault_in_surface(patches); !fault.empty()) return fault;
  if (const auto& o = patches.origin; !(std::isfinite(o.x) && std::isfinite(o.y) && std::isfinite(o.z)))
    return "the origin is not finite";
  if (!is_finite(patches.up)) return "the up direction is not finite";
  for (std::size_t i = 0; i < patches.vertices.size(); ++i)
    if (!is_finite(patches.vertices[i])) return fmt::format("vertex {} is not finite", i);
  for (std::size_t i = 0; i < patches.size(); ++i)
    if (auto fault = fault_in_patch(patches, i); !fault.empty()) return fault;
  if (solution.bands != patches.bands)
    return fmt::format("the light is of the bands {}, the patches of {}", fmt::join(solution.bands, " "),
                       fmt::join(patches.bands, " "));
  if (auto fault = fault_in_contacts(patches); !fault.empty()) return fault;
  if (solution.provenance.scene_fingerprint != patches.scene_fingerprint)
    return fmt::format("the light is of the scene {:016x}, the patches of {:016x}",
                       solution.provenance.scene_fingerprint, patches.scene_fingerprint);
  return fault_in_light(solution, patches.size() * patches.band_count());
}

}  // namespace luxel
