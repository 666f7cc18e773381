// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/page_luminaires.h"

#include <memory>

#include <gtest/gtest.h>

#include "luxel/photometry/luminaire_mesh.h"

namespace luxel {
namespace {

std::shared_ptr<const Photometry> photometry(const LuminousOpening& opening) {
  auto made = std::make_shared<Photometry>();
  made->file = "some.ies";
  made->intensity = {GoniometerType::c, {0.0, 90.0}, {0.0}, {100.0, 0.0}};
  made->opening = opening;
  return made;
}

BandPointLight luminaire(std::shared_ptr<const Photometry> of, std::vector<float> rgb, std::uint32_t group) {
  BandPointLight lamp;
  lamp.light.kind = PointLightKind::luminaire;
  lamp.light.photometry = std::move(of);
  lamp.light.position = {1.0f, 2.0f, 3.0f};
  lamp.intensity = std::move(rgb);
  lamp.light_group = group;
  return lamp;
}

PatchSet two_groups() {
  PatchSet patches;
  patches.bands = {"red", "green", "blue"};
  patches.light_groups = {"panels", "lamps"};
  const auto panel = photometry({OpeningShape::rectangle, {0.6, 0.6, 0.0}});
  patches.point_lights = {luminaire(panel, {1.0f, 1.0f, 1.0f}, 0),
                          luminaire(panel, {2.0f, 2.0f, 2.0f}, 0),
                          luminaire(photometry({}), {3.0f, 0.0f, 0.0f}, 0),
                          {}};
  patches.point_lights.back().intensity = {1.0f, 1.0f, 1.0f};
  patches.point_lights.back().light_group = 1;
  return patches;
}

TEST(PageLuminaires, have_one_mesh_and_one_solid_per_photometric_file) {
  PageArrays arrays;
  const auto patches = two_groups();
  const auto page = add_luminaires(arrays, patches, true);
  ASSERT_EQ(page["kinds"].size(), 2u);
  ASSERT_EQ(page["places"].size(), 3u);
  EXPECT_EQ(page["kinds"][0]["isSheet"], true);
  EXPECT_EQ(page["kinds"][1]["isSheet"], false);
  EXPECT_EQ(page["places"][1]["kind"], 0u);
  EXPECT_EQ(page["places"][2]["kind"], 1u);
  EXPECT_EQ(page["places"][0]["at"], Json({1.0, 2.0, 3.0}));
  ASSERT_EQ(arrays.list().size(), 4u);
  EXPECT_EQ(arrays.list()[0]["count"], 18u);  // two triangles
  EXPECT_EQ(arrays.list()[1]["count"], PhotometricSolid::rows * PhotometricSolid::columns);
  EXPECT_NEAR(page["places"][1]["lumens"].get<double>(), 2.0 * page["places"][0]["lumens"].get<double>(),
              1e-9);
}

// Two white luminaires of 3 W/sr together, and a red one of 3.
TEST(PageLuminaires, weigh_colours_by_lumens) {
  const auto groups = lumens_of_groups(two_groups(), true);
  ASSERT_EQ(groups.size(), 2u);
  const auto red = 3.0 * 0.2126, sum = 3.0 + red;
  EXPECT_NEAR(groups[0][0].get<double>(), 2.0 * red / sum, 1e-9);
  EXPECT_NEAR(groups[0][1].get<double>(), 3.0 * 0.7152 / sum, 1e-9);
  EXPECT_NEAR(groups[0][2].get<double>(), 3.0 * 0.0722 / sum, 1e-9);
  EXPECT_TRUE(groups[1].is_null());
  EXPECT_EQ(lumens_of_groups(two_groups(), false).size(), 1u);
}

}  // namespace
}  // namespace luxel
