// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "luxel/export/export_round_trip.h"
#include "luxel/import/gltf_array.h"
#include "luxel/import/gltf_parts.h"
#include "luxel/patch/make_patches.h"
#include "luxel/surface/vertex_fit.h"

#include "support/linear_light.h"
#include "support/scene_files.h"
#include "support/small_gltf.h"

namespace luxel::test {

// A quad of 2 x 1 that three nodes show: as it is, turned and scaled below a parent, and mirrored.
// Beside it a strip without indices whose vertices nothing else has; data unknown to Luxel, and a point
// light.
inline SmallGltf small_room() {
  SmallGltf gltf;
  gltf.points({0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 1, 0});
  gltf.array<std::uint8_t>(SmallGltf::u8, "SCALAR", 6, {0, 1, 2, 0, 2, 3});
  gltf.array<float>(SmallGltf::f32, "VEC2", 4, {0, 0, 1, 0, 1, 0.5f, 0, 0.5f});
  gltf.array<float>(SmallGltf::f32, "VEC3", 4, {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
  gltf.points({5, 0, 0, 6, 0, 0, 5, 1, 0, 6, 1, 1, 5, 2, 1});
  gltf.meshes = R"({"name":"plate","primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":2,"NORMAL":3},)"
                R"("indices":1,"material":1,"extras":{"mine":7}}]},)"
                R"({"primitives":[{"attributes":{"POSITION":4},"mode":5,"material":0}]})";
  gltf.nodes =
      R"({"mesh":0,"name":"one","extras":["kept"]},)"
      R"({"children":[2],"translation":[0,0,4],"rotation":[0,0.7071067811865476,0,0.7071067811865476]},)"
      R"({"mesh":0,"scale":[2,1,1]},{"mesh":0,"translation":[0,3,0],"scale":[-1,1,1]},{"mesh":1},)"
      R"({"extensions":{"KHR_lights_punctual":{"light":0}}})";
  gltf.rest = R"(,"materials":[{"name":"strip"},{"name":"plate","doubleSided":true,"extras":{"of":"mine"},)"
              R"("pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,0.125,1],"metallicFactor":0}}],)"
              R"("extensionsUsed":["KHR_lights_punctual","FREE_wind"],"extensions":{"FREE_wind":{"speed":3},)"
              R"("KHR_lights_punctual":{"lights":[{"type":"point"}]}},"extras":"a room")";
  return gltf;
}

class ExportRoundTrip : public testing::Test {
 protected:
  void solve(const std::string& name, float max_edge) {
    scene_ = files_.load(name);
    patches_ = make_patches(scene_, {.max_edge = max_edge});
    solution_ = linear_light(patches_);
  }
  RoundTripInput input() const { return {scene_, patches_, solution_}; }
  std::filesystem::path out() const { return files_.path("lit.glb"); }
  GltfFile lit() const { return GltfFile(out(), known_extensions()); }
  void cut() { export_round_trip_cut(out(), input(), make_smooth_light(patches_, solution_), {}); }
  void uncut() {
    export_round_trip_uncut(out(), input(),
                            fit_vertices(scene_, patches_, make_smooth_light(patches_, solution_)), {});
  }

  SceneFiles files_;
  Scene scene_;
  PatchSet patches_;
  Solution solution_;
};

class ExportRoundTripPages : public ExportRoundTrip {};

struct Vertex {
  Vec3d place;  // in the scene
  std::uint32_t number;
};

// Calls for each triangle of each part, its corners as a reader of the file winds them in the scene.
inline void for_triangles(GltfFile& file,
                          const std::function<void(const GltfPart&, const std::array<Vertex, 3>&)>& visit) {
  for (const auto& part : drawn_parts(file, placed_nodes(file)).parts) {
    const GltfArray positions(file, part.primitive["attributes"]["POSITION"], 3, 3);
    for (auto corners : triangle_corners(file, part.primitive, positions.size())) {
      if (mirrors(part.placed.world)) std::swap(corners[1], corners[2]);
      std::array<Vertex, 3> triangle{};
      for (std::size_t i = 0; i < 3; ++i) {
        const auto p = positions.at(corners[i]);
        triangle[i] = {Vec3d(part.placed.world * glm::dvec4(p[0], p[1], p[2], 1.0)), corners[i]};
      }
      visit(part, triangle);
    }
  }
}

inline Vec3d normal_of(const std::array<Vertex, 3>& t) {
  return glm::cross(t[1].place - t[0].place, t[2].place - t[0].place);
}

inline constexpr double plates = 2.0 + 4.0 + 2.0;  // m², of the three nodes
inline const double strip = 0.5 + 2 * 0.5 * std::sqrt(3.0);

}  // namespace luxel::test
