// SPDX-License-Identifier: Apache-2.0
// Meshes with the coordinates of a lightmap, for other bakers.
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/export/export_round_trip.h"
#include "luxel/export/round_trip_layout.h"
#include "luxel/render/lightmap.h"

#include "support/lightmap_places.h"
#include "support/round_trip_file.h"

namespace luxel {
namespace {

using namespace test;

using ExportUnwrapped = ExportRoundTripPages;

// Place and coordinates of each vertex of an OBJ file, and the triangles.
struct ReadObj {
  std::vector<Vec3d> places;
  std::vector<Vec2> uvs;
  std::vector<std::array<std::size_t, 3>> triangles;
};
ReadObj read_obj(const std::string& text) {
  ReadObj obj;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind, corner;
    words >> kind;
    if (kind == "v") {
      auto& p = obj.places.emplace_back();
      words >> p.x >> p.y >> p.z;
    } else if (kind == "vt") {
      auto& uv = obj.uvs.emplace_back();
      words >> uv.x >> uv.y;
    } else if (kind == "f") {
      auto& triangle = obj.triangles.emplace_back();
      for (auto& index : triangle) {
        words >> corner;
        index = std::stoul(corner) - 1;
      }
    }
  }
  return obj;
}

TEST_F(ExportUnwrapped, an_obj_has_the_coordinates_of_the_lightmap) {
  files_.write("room.glb", small_room().glb());
  solve("room.glb", 0.4f);
  const auto atlas = new_atlas(patches_, solution_, {.texel = 0.05f, .page_size = 64});
  const auto pages = pages_of_places(patches_, atlas);
  ASSERT_GT(pages.size(), 1u) << "the test is to have several pages";
  const auto path = files_.path("room.obj");
  ASSERT_TRUE(export_unwrapped(path, input(), {atlas, {}, 1.0f}, {}));
  const auto obj = read_obj(read_file(path));
  ASSERT_EQ(obj.places.size(), obj.uvs.size());
  double area = 0.0;
  for (const auto& [a, b, c] : obj.triangles) {
    area += 0.5 * glm::length(glm::cross(obj.places[b] - obj.places[a], obj.places[c] - obj.places[a]));
    const auto place = (obj.places[a] + obj.places[b] + obj.places[c]) / 3.0;
    auto uv = (obj.uvs[a] + obj.uvs[b] + obj.uvs[c]) / 3.0f;
    const auto page = static_cast<std::size_t>(uv.x);
    uv = {uv.x - static_cast<float>(page), 1.0f - uv.y};
    const auto found = look_up(pages.at(page), uv * static_cast<float>(atlas.page_size));
    EXPECT_LT(glm::length(Vec3d(found) - place), 0.025);
  }
  EXPECT_NEAR(area, 2.0 * plates + strip, 1e-4);
  EXPECT_THROW(export_unwrapped(path, input(), {atlas, {}, 1.0f, true}, {}), InputError);
}

TEST_F(ExportUnwrapped, a_glb_keeps_its_own_coordinates_and_materials) {
  files_.write("room.glb", small_room().glb());
  solve("room.glb", 0.4f);
  const auto atlas = new_atlas(patches_, solution_, {.texel = 0.05f, .page_size = 64});
  const auto pages = pages_of_places(patches_, atlas);
  ASSERT_TRUE(export_unwrapped(out(), input(), {atlas, {}, 1.0f}, {}));
  auto file = lit();
  std::size_t seen = 0;
  for_triangles(file, [&](const GltfPart& part, const std::array<Vertex, 3>& triangle) {
    const auto note = part.primitive["extras"]["luxel_lightmap"];
    ASSERT_TRUE(note);
    const auto attributes = part.primitive["attributes"];
    EXPECT_TRUE(attributes["TEXCOORD_0"]);
    EXPECT_EQ(note["texCoord"].whole(), 1);
    const GltfArray uvs(file, attributes["TEXCOORD_1"], 2, 2);
    Vec2 uv(0.0f);
    Vec3d place(0.0);
    for (const auto& corner : triangle) {
      const auto at = uvs.at(corner.number);
      uv += Vec2(at[0], at[1]) / 3.0f;
      place += corner.place / 3.0;
    }
    const auto page = static_cast<std::size_t>(note["page"].whole()) - 1;
    const auto found = look_up(pages.at(page), uv * static_cast<float>(atlas.page_size));
    EXPECT_LT(glm::length(Vec3d(found) - place), 0.025);
    EXPECT_FALSE(file.object(part.primitive["material"], "materials")["extensions"]["MOZ_lightmap"]);
    ++seen;
  });
  EXPECT_GT(seen, 5u);
}

}  // namespace
}  // namespace luxel
