// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/smooth_light.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/trig.h"
#include "luxel/patch/colour_patches.h"
#include "luxel/scene/band_colours.h"
#include "luxel/surface/hidden_light.h"
#include "luxel/surface/node_light.h"
#include "luxel/surface/side_light.h"
#include "luxel/surface/side_nodes.h"

namespace luxel {
namespace {

void check(const PatchSet& patches, const Solution& solution, const SmoothOptions& options) {
  const auto values = patches.size() * patches.band_count();
  if (solution.bands != patches.bands || solution.irradiance.front.size() != values ||
      solution.irradiance.back.size() != values)
    throw MismatchError(
        fmt::format("the solution has {} irradiances but the patches need {}: it was not "
                    "made from this scene; solve it again",
                    solution.irradiance.front.size(), values));
  if (!(options.crease_angle >= 0.0f && options.crease_angle <= 180.0f))
    throw InputError(
        fmt::format("the crease angle must be from 0 to 180 degrees, but it is {}", options.crease_angle));
}

// A smooth vertex has a front and a back: corners share one where both their nodes are the same.
struct CornerNodes {
  std::uint32_t front, back, patch, corner;

  auto order() const { return std::tuple(front, back, patch); }
};

// Area-weighted unit normal of the surface that continues smoothly from the front of a corner.
Vec3 normal_at(const PatchSet& patches, const SideNodes& nodes, const CornerNodes& c) {
  Vec3d sum(0.0);
  for (const auto& m : nodes.at(c.front)) {
    const auto area = static_cast<double>(patches.area[m.side.patch()]);
    sum += Vec3d(patches.normal[m.side.patch()]) * (m.side.is_back() ? -area : area);
  }
  const auto length = glm::length(sum);
  if (length > 0.0) return Vec3(sum / length);
  const auto& own = patches.normal[c.patch];
  return glm::dot(own, own) > 0.0f ? own : Vec3(0.0f, 0.0f, 1.0f);
}

SmoothLight smooth_vertices(const PatchSet& patches, const SideNodes& nodes,
                            const std::vector<float>& irradiance) {
  const auto bands = patches.band_count();
  SmoothLight light;
  light.corners.resize(patches.size());
  const auto append = [&](std::vector<float>& out, std::uint32_t node) {
    for (std::size_t b = 0; b < bands; ++b) out.push_back(irradiance[node * bands + b]);
  };
  std::vector<CornerNodes> corners;
  for (std::uint32_t v = 0; v < patches.vertices.size(); ++v) {
    corners.clear();
    for (auto node = nodes.first[v]; node < nodes.first[v + 1]; ++node)
      for (const auto& m : nodes.at(node))
        if (!m.side.is_back() && m.place < 3)
          corners.push_back(
              {node, nodes.of_side[m.side.opposite().index()][m.place], m.side.patch(), m.place});
    std::sort(corners.begin(), corners.end(),
              [](const auto& a, const auto& b) { return a.order() < b.order(); });
    const CornerNodes* previous = nullptr;
    for (const auto& c : corners) {
      if (previous == nullptr || c.front != previous->front || c.back != previous->back) {
        light.vertex.push_back(v);
        light.normal.push_back(normal_at(patches, nodes, c));
        append(light.irradiance.front, c.front);
        append(light.irradiance.back, c.back);
      }
      light.corners[c.patch][c.corner] = static_cast<std::uint32_t>(light.vertex.size() - 1);
      previous = &c;
    }
  }
  return light;
}

}  // namespace

SmoothLight make_smooth_light(const PatchSet& patches, const Solution& solution, const SmoothOptions& options,
                              const Context& context) {
  check(patches, solution, options);
  const auto nodes = make_side_nodes(patches, cosine_of_degrees(options.crease_angle), context);
  auto light =
      smooth_vertices(patches, nodes, light_of_nodes(patches, SideLight(patches, solution), nodes, context));
  if (options.lights_hidden) light_hidden_vertices(patches, solution, light);
  return light;
}

SmoothLight make_smooth_light(const PatchSet& patches, const Solution& solution,
                              const SmoothOptions& options) {
  return make_smooth_light(patches, solution, options, Context(1));
}

TextureRatio texture_ratio_of_patch(const PatchSet& patches, std::size_t patch) {
  const auto of = [&](const std::vector<float>& ratios) {
    return ratios.empty() ? nullptr : &ratios[patch * patches.band_count()];
  };
  return {of(patches.reflectance_ratio), of(patches.emittance_ratio)};
}

TextureRatio texture_ratio_at(const PatchSet& patches, const FineColours& fine, std::size_t patch, float u,
                              float v) {
  auto ratio = texture_ratio_of_patch(patches, patch);
  ratio.fine_reflectance = fine.reflectance(patch, u, v);
  ratio.fine_emittance = fine.emittance(patch, u, v);
  return ratio;
}

SeenIrradiance irradiance_at(const SmoothLight& light, std::size_t vertex, bool back, std::size_t bands) {
  return {light.irradiance.of(back).data() + vertex * bands,
          light.irradiance.of(!back).data() + vertex * bands};
}

Vec3d radiance_of(const BandMaterial& material, bool back, const SeenIrradiance& irradiance,
                  const BandColours& colours, const TextureRatio& ratio) {
  Vec3d emitted(0.0), reflected(0.0), transmitted(0.0);
  if (back && !material.two_sided) return reflected;
  for (std::size_t b = 0; b < material.reflectance.size(); ++b) {
    reflected +=
        static_cast<double>(reflectance_at(material, ratio, b) * irradiance.here[b] / pi) * colours.of(b);
    if (material.is_diffuser())
      transmitted +=
          static_cast<double>(material.diffuse_transmittance[b] * irradiance.behind[b] / pi) * colours.of(b);
    const auto emittance = material.emittance[b] * (ratio.emittance ? ratio.emittance[b] : 1.0f);
    if (!back) emitted += static_cast<double>(emittance / pi) * colours.of(b);
  }
  return emitted * Vec3d(ratio.fine_emittance) + reflected * Vec3d(ratio.fine_reflectance) + transmitted;
}

float effective_irradiance(const BandMaterial& material, const SeenIrradiance& irradiance,
                           const TextureRatio& ratio, std::size_t band) {
  if (!material.is_diffuser()) return irradiance.here[band];
  const auto rho = reflectance_at(material, ratio, band), tau = material.diffuse_transmittance[band];
  return rho + tau > 0.0f ? (rho * irradiance.here[band] + tau * irradiance.behind[band]) / (rho + tau)
                          : 0.0f;
}

}  // namespace luxel
