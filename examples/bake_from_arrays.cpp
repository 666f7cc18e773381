// SPDX-License-Identifier: Apache-2.0
// Bakes a scene that is made of arrays, not read from a file: a closed room of 4 x 3 x 5 m with a lamp below
// its ceiling. Writes bake_from_arrays.png, a picture of it, and bake_from_arrays.glb, the mesh with its
// light at the vertices.
//
//     bake_from_arrays
#include <cstdio>

#include <luxel/luxel.h>

using luxel::Vec3;

// Adds the quad a, b, c, d, counter-clockwise seen from its front, as two triangles.
static void add_quad(luxel::Scene& scene, unsigned material, Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const auto first = static_cast<std::uint32_t>(scene.positions.size());
  scene.positions.insert(scene.positions.end(), {a, b, c, d});
  for (const auto& triangle :
       {std::array{first, first + 1, first + 2}, std::array{first, first + 2, first + 3}}) {
    scene.triangles.push_back(triangle);
    scene.triangle_material.push_back(luxel::MaterialId(material));
    scene.triangle_line.push_back(0);   // of a source file: there is none
    scene.triangle_group.push_back(0);  // all in one group
  }
}

int main() try {
  luxel::Scene scene;
  scene.groups = {"room"};
  // Reflectances are linear, emittances W/m² per band of linear sRGB.
  scene.materials = {{.name = "white", .reflectance = Vec3(0.75f)},
                     {.name = "red", .reflectance = Vec3(0.65f, 0.06f, 0.05f)},
                     {.name = "lamp", .reflectance = Vec3(0.5f), .emittance = Vec3(60.0f, 50.0f, 35.0f)}};
  const auto white = 0, red = 1, lamp = 2;
  add_quad(scene, white, {0, 0, 5}, {4, 0, 5}, {4, 0, 0}, {0, 0, 0});  // floor, its front up
  add_quad(scene, white, {0, 3, 0}, {4, 3, 0}, {4, 3, 5}, {0, 3, 5});  // ceiling
  add_quad(scene, white, {0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0});  // back wall
  add_quad(scene, white, {4, 0, 5}, {0, 0, 5}, {0, 3, 5}, {4, 3, 5});  // front wall
  add_quad(scene, red, {0, 0, 5}, {0, 0, 0}, {0, 3, 0}, {0, 3, 5});    // left wall
  add_quad(scene, white, {4, 0, 0}, {4, 0, 5}, {4, 3, 5}, {4, 3, 0});  // right wall
  add_quad(scene, lamp, {1.5f, 2.9f, 2}, {2.5f, 2.9f, 2}, {2.5f, 2.9f, 3}, {1.5f, 2.9f, 3});  // shines down

  // Patches of 25 cm at most, and light to a standard error of 2 %.
  const auto baked = luxel::bake(scene, {.patches = {.max_edge = 0.25f}, .light = {.error = 0.02}});
  const auto& light = baked.solution;
  std::printf("patches %zu, rays %llu, error %.4f\n", baked.patches.size(),
              static_cast<unsigned long long>(light.provenance.rays), light.seen_error);

  const luxel::Camera camera = {.eye = {2, 1.5f, 4.9f}, .target = {2, 1.4f, 0}, .vertical_fov = 65};
  const auto radiance = luxel::render(baked, camera, {.width = 640, .height = 480});
  luxel::write_png("bake_from_arrays.png", luxel::tone_map(radiance));
  luxel::export_glb("bake_from_arrays.glb", baked);
} catch (const luxel::Error& error) {
  std::fprintf(stderr, "bake_from_arrays: %s\n", error.what());
  return 1;
}
