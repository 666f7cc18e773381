// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/bright_pictures.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "luxel/image/image_file.h"

#include "support/round_trip_file.h"

namespace luxel {
namespace {

using namespace test;

// A plate of 2 m by 1 m below a picture of its own.
class BrightPicturesTest : public ExportRoundTrip {
 protected:
  // light: radiosity of a white surface, which the curve takes as it is.
  void bake(const Raster& picture, float light, ToneOperator op = ToneOperator::neutral) {
    const auto bytes = png_of(picture);
    files_.write("picture.png", bytes);
    SmallGltf gltf;
    gltf.points({0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 1, 0});
    gltf.array<std::uint8_t>(SmallGltf::u8, "SCALAR", 6, {0, 1, 2, 0, 2, 3});
    gltf.array<float>(SmallGltf::f32, "VEC2", 4, {0, 0, 1, 0, 1, 1, 0, 1});
    gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":2},"indices":1,"material":0}]})";
    gltf.rest =
        R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicFactor":0}}],)"
        R"("textures":[{"source":0}],"images":[{"uri":"picture.png"}])";
    files_.write("plate.glb", gltf.glb());
    solve("plate.glb", 0.4f);
    const auto bands = patches_.band_count();
    for (const bool back : {false, true}) {
      auto& irradiance = solution_.irradiance.of(back);
      std::fill(irradiance.begin(), irradiance.end(), back ? 0.0f : light);
      auto& radiosity = solution_.radiosity.of(back);
      radiosity.assign(patches_.size() * bands, 0.0f);
      if (back) continue;
      for (std::size_t p = 0; p < patches_.size(); ++p)
        for (std::size_t b = 0; b < bands; ++b)
          radiosity[p * bands + b] =
              light * reflectance_at(patches_.material_of(p), texture_ratio_of_patch(patches_, p), b);
    }
    curve_ = {.options = {.op = op, .scale = pi}, .scale = pi};
    export_round_trip_cut(out(), input(), make_smooth_light(patches_, solution_), {.tone = curve_.options});
  }

  Raster shown_picture() {
    const auto written = files_.load("lit.glb");
    return *written.textures[written.materials[0].textures.reflectance->texture].raster;
  }

  // Returns the vertex colour, and expects all vertices to have it.
  Vec3 colour() {
    auto file = lit();
    const GltfArray colours(file, file.root()["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"], 3, 4);
    const auto first = colours.at(0);
    for (std::uint32_t v = 1; v < colours.size(); ++v)
      for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(colours.at(v)[c], first[c], 1e-3f);
    return {first[0], first[1], first[2]};
  }

  ToneCurve curve_;
};

Raster plain(const Raster::Code& code) { return {4, 4, std::vector<Raster::Code>(16, code), {}}; }
Vec3 linear(const Raster::Code& c) { return plain(c).colour(0); }

TEST_F(BrightPicturesTest, a_dark_picture_in_bright_light_is_as_bright_as_the_curve_makes_it) {
  const Raster::Code wood{150, 110, 100, 255};
  for (const float light : {0.5f, 2.0f, 20.0f}) {
    bake(plain(wood), light);
    const auto shown = colour() * linear(shown_picture().codes[0]);
    const auto expected = curve_(light / pi * linear(wood));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(shown[c], expected[c], 0.01f) << light;
  }
}

TEST_F(BrightPicturesTest, a_few_white_pixels_do_not_keep_it_dark) {
  auto with_white = plain({150, 120, 100, 255});
  with_white.codes[5] = {255, 255, 255, 255};
  bake(with_white, 20.0f);
  const auto shown = shown_picture();
  EXPECT_EQ(shown.codes[0], (Raster::Code{255, 255, 255, 255}));
  EXPECT_EQ(shown.codes[5], (Raster::Code{255, 255, 255, 255}));
}

TEST_F(BrightPicturesTest, one_that_is_white_or_has_enough_light_stays_as_it_is) {
  const auto white = plain({255, 255, 255, 255});
  bake(white, 20.0f);
  EXPECT_EQ(shown_picture().codes, white.codes);
  const auto dim = plain({150, 110, 70, 128});
  bake(dim, 0.5f);
  EXPECT_EQ(shown_picture().codes, dim.codes);
}

TEST_F(BrightPicturesTest, colours_from_which_the_light_is_recovered_leave_it_as_it_is) {
  const auto wood = plain({150, 110, 70, 255});
  for (const auto op : {ToneOperator::clamp, ToneOperator::maximum}) {
    bake(wood, 0.75f, op);
    EXPECT_EQ(shown_picture().codes, wood.codes);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(colour()[c], 0.75f, 1e-3f);
  }
}

TEST_F(BrightPicturesTest, alpha_stays) {
  const Raster::Code leaf{100, 120, 60, 200};
  bake(plain(leaf), 20.0f);
  EXPECT_GT(shown_picture().codes[0][1], 250);
  EXPECT_EQ(shown_picture().codes[0][3], 200);
}

TEST(SoftLimit, rises_evenly_to_one) {
  EXPECT_EQ(soft_limit(0.95f, 1.0f), 0.95f);
  EXPECT_EQ(soft_limit(0.95f, 0.9f), 0.95f);
  EXPECT_EQ(soft_limit(1.5f, 1.0f), 1.0f);
  for (const float largest : {1.2f, 3.0f, 50.0f}) {
    EXPECT_EQ(soft_limit(0.8f, largest), 0.8f);
    EXPECT_EQ(soft_limit(largest, largest), 1.0f);
    EXPECT_EQ(soft_limit(2.0f * largest, largest), 1.0f);
    float last = 0.0f, last_step = 1.0f;
    const auto step = largest / 1000.0f;
    for (float colour = 0.0f; colour < largest; colour += step) {
      const auto limited = soft_limit(colour, largest);
      EXPECT_GE(limited, last);
      if (colour > 0.0f) {
        EXPECT_LE(limited - last, last_step + 1e-5f) << "ever flatter";
        last_step = limited - last;
      }
      last = limited;
    }
  }
}

TEST(ColourOverPicture, keeps_the_hue_of_the_light) {
  const Vec3 mean(0.3f, 0.4f, 0.5f);
  for (const float brightness : {0.2f, 0.5f, 1.0f}) {
    const Vec3 colour = brightness * Vec3(0.9f, 0.7f, 0.4f);
    const auto over = colour_over_picture(colour, mean);
    const auto shown = over * mean;
    for (int c = 0; c < 3; ++c) {
      EXPECT_LE(over[c], 1.0f);
      EXPECT_NEAR(shown[c] / shown.r, colour[c] / colour.r, 1e-5f);
    }
  }
  EXPECT_EQ(colour_over_picture(Vec3(0.2f), Vec3(0.5f)), Vec3(0.4f)) << "as it is";
}

}  // namespace
}  // namespace luxel
