// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/solution/solution.h"

namespace luxel {

class BandColours;
class FineColours;

struct SmoothOptions {
  float crease_angle = 30.0f;  ///< degrees, 0 to 180; neighbours that meet at a sharper angle are different
                               ///< surfaces. 0: every patch is, and keeps its own value
  /// For pictures and meshes: vertices of sides that no light reaches, as below a cupboard, take the light of
  /// the lit sides that go on in their plane, since a rasteriser may show a pixel of them at the edge.
  bool lights_hidden = false;
};

/// Smooth light over each surface: values at the vertices whose linear interpolation approximates the
/// patches' means (node_light.h), exactly where light is linear, at borders too. Only patches of one
/// smooth surface influence each other's light, so that a corner between walls does not smear. The
/// values are irradiance, not radiosity: surface colour and emission are applied afterwards, per patch,
/// and stay sharp at material borders. One smooth vertex for each vertex and each smooth surface that
/// meets there.
///
/// Sides are joined, not patches: a neighbour with the opposite winding continues with its back, and a wall
/// that stands on a floor separates the light in front of the floor but not behind it. Where windings differ,
/// two smooth vertices therefore mirror each other, each with the front of its own patches. The back of a
/// one-sided material has no light and does not influence others.
struct SmoothLight {
  std::vector<std::uint32_t> vertex;  ///< [smooth vertex]: index into PatchSet::vertices, ascending
  std::vector<Vec3> normal;           ///< [smooth vertex]: unit, front side, area-weighted
  SideValues irradiance;              ///< [smooth vertex][band], W/m²
  std::vector<std::array<std::uint32_t, 3>> corners;  ///< [patch]: its three smooth vertices

  std::size_t size() const { return vertex.size(); }
};

/// Cost: linear in the number of patches but for sorts of the few that meet at each vertex and of the edges
/// that no other patch shares. The same on any number of threads.
/// Throws MismatchError where the solution is not of these patches, InputError for a senseless crease angle.
SmoothLight make_smooth_light(const PatchSet& patches, const Solution& solution, const SmoothOptions& options,
                              const Context& context);
/// Runs on the calling thread.
SmoothLight make_smooth_light(const PatchSet& patches, const Solution& solution,
                              const SmoothOptions& options = {});

/// Ratio of the surface at a place to the mean of its material (PatchSet::reflectance_ratio).
struct TextureRatio {
  const float* reflectance = nullptr;  ///< [band], of the patch; none: 1
  const float* emittance = nullptr;
  Vec3 fine_reflectance = Vec3(1.0f);  ///< of the place, over the patch (FineColours)
  Vec3 fine_emittance = Vec3(1.0f);
};
/// Reflectance of a material there in a band, averaged over the patch: [0, 1).
inline float reflectance_at(const BandMaterial& material, const TextureRatio& ratio, std::size_t band) {
  const auto of_material = material.reflectance[band];
  if (!ratio.reflectance && !material.is_diffuser()) return of_material;
  const auto transmitted = material.is_diffuser() ? material.diffuse_transmittance[band] : 0.0f;
  return std::min(max_reflectance - transmitted,
                  ratio.reflectance ? of_material * ratio.reflectance[band] : of_material);
}
/// The diffuse reflectance plus the diffuse transmittance there: [0, 1).
inline float albedo_at(const BandMaterial& material, const TextureRatio& ratio, std::size_t band) {
  const auto reflected = reflectance_at(material, ratio, band);
  return material.is_diffuser() ? reflected + material.diffuse_transmittance[band] : reflected;
}
TextureRatio texture_ratio_of_patch(const PatchSet& patches, std::size_t patch);
/// Returns the ratio at (1-u-v) a + u b + v c of the patch.
TextureRatio texture_ratio_at(const PatchSet& patches, const FineColours& fine, std::size_t patch, float u,
                              float v);

/// Irradiance where a surface is seen, [band], W/m²: on the side that is seen, and on the other one, whose
/// light a diffuser transmits.
struct SeenIrradiance {
  const float* here = nullptr;
  const float* behind = nullptr;
};
/// Returns the irradiance at a smooth vertex.
SeenIrradiance irradiance_at(const SmoothLight& light, std::size_t vertex, bool back, std::size_t bands);

/// Returns the radiance, W/(m² sr) in linear sRGB, that leaves a side of a patch at the given irradiance: (E
/// + rho H + tau H of the other side) / pi in each band, converted to colour afterwards. A wavelength that a
/// surface does not reflect does not affect its colour, however bright it arrives. A back does not emit, and
/// the back of a one-sided material is black.
Vec3d radiance_of(const BandMaterial& material, bool back, const SeenIrradiance& irradiance,
                  const BandColours& colours, const TextureRatio& ratio = {});

/// Returns the irradiance that would give the same appearance to a surface that reflects its whole albedo,
/// rho + tau: the mean of both sides weighted by the fraction of each that leaves this side; without a
/// diffuser H itself. Outputs shown as reflectance times irradiance, such as lightmaps and pages, use it.
float effective_irradiance(const BandMaterial& material, const SeenIrradiance& irradiance,
                           const TextureRatio& ratio, std::size_t band);

}  // namespace luxel
