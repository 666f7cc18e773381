// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/export_round_trip.h"
#include "luxel/scene/band_colours.h"

namespace luxel {

Scene scene_of(const PatchSet& patches) {
  Scene scene;
  scene.source = "the solution";
  scene.positions = patches.vertices;
  scene.triangles = patches.corners;
  scene.triangle_material = patches.material;
  scene.triangle_line.resize(patches.size());
  scene.triangle_group.resize(patches.size());
  scene.groups = {"surfaces"};
  const auto colours = patches.colours();
  const std::vector<float> ones(patches.band_count(), 1.0f);
  const auto white = colours.rgb(ones);
  for (const auto& of_patches : patches.materials) {
    Material material;
    material.name = of_patches.name;
    material.two_sided = of_patches.two_sided;
    material.reflectance = in_gamut(colours.rgb(of_patches.reflectance) / white);
    material.emittance = in_gamut(colours.rgb(of_patches.emittance));
    if (of_patches.is_diffuser())
      material.diffuse_transmittance = in_gamut(colours.rgb(of_patches.diffuse_transmittance) / white);
    material.textures = of_patches.textures;
    scene.materials.push_back(std::move(material));
  }
  scene.textures = patches.textures;
  scene.uv_sets = patches.uv_sets;
  scene.corner_colours = patches.corner_colours;
  scene.origin = patches.origin;
  return scene;
}

}  // namespace luxel
