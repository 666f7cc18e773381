// SPDX-License-Identifier: Apache-2.0
// Textures on surfaces: rooms whose colours are textures against the same rooms whose colours are materials;
// holes. Means over triangles are tested in tests/unit/patch/texel_sums_test.cpp.
//
// Risk. Seeds are fixed. With other random numbers the root mean square of some thousand errors of two rooms
// lies above 1.3 of the predicted with a chance below one in a thousand; the sheet with holes is compared
// within six standard errors, one in a hundred million.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>

#include <gtest/gtest.h>

#include "luxel/patch/colour_patches.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/refine_patches.h"
#include "luxel/render/final_gather.h"
#include "luxel/render/path_picture.h"
#include "luxel/render/render.h"
#include "luxel/solution/solution_file.h"
#include "luxel/solve/sampled.h"
#include "luxel/surface/smooth_light.h"
#include "luxel/trace/tracer.h"

namespace luxel {
namespace {

constexpr int squares = 4;  // along a side of the floor and of the lamp

// A box of 1 m, its floor of squares in two colours, its ceiling a lamp with squares that are dark. As
// materials: textured false. Materials: 0 walls, 1 floor, 2 ceiling, then the floor's and the ceiling's other
// colour.
Scene chequered_box(bool textured) {
  Scene scene;
  scene.source = "box";
  scene.groups = {"default"};
  scene.materials = {{"walls", Vec3(0.6f)}, {"floor"}, {"ceiling"}, {"dark floor"}, {"dark ceiling"}};
  const Vec3 red(0.8f, 0.2f, 0.1f), blue(0.1f, 0.3f, 0.7f), glow(3.0f, 2.0f, 1.0f);
  const auto code = [](const Vec3& c) {
    return Raster::Code{srgb_code(c.r), srgb_code(c.g), srgb_code(c.b), 255};
  };
  const auto stored = [&](const Vec3& c) {
    auto one = Raster{1, 1, {code(c)}, {}};
    return one.colour(0);
  };
  scene.materials[1].reflectance = stored(red);
  scene.materials[3].reflectance = stored(blue);
  scene.materials[2].emittance = glow;
  if (textured) {
    auto floor = std::make_shared<Raster>(Raster{2, 2, {code(red), code(blue), code(blue), code(red)}, {}});
    auto lamp = std::make_shared<Raster>(Raster{2, 2, {}, {glow, Vec3(0.0f), Vec3(0.0f), glow}});
    scene.textures = {{"floor.png", floor}, {"lamp.exr", lamp}};
    auto& of_floor = scene.materials[1].textures;
    of_floor.reflectance = TextureUse{0, 0, {squares / 2, 0, 0, 0, squares / 2, 0}};
    scene.materials[1].reflectance = 0.5f * (stored(red) + stored(blue));
    scene.materials[2].textures.emittance = TextureUse{1, 0, {squares / 2, 0, 0, 0, squares / 2, 0}};
    scene.materials[2].emittance = 0.5f * glow;
    scene.uv_sets.resize(1);
  }
  const auto add = [&](const Vec3& at, const Vec3& s, const Vec3& t, int cuts, std::uint32_t one,
                       std::uint32_t other) {
    for (int j = 0; j < cuts; ++j)
      for (int i = 0; i < cuts; ++i) {
        const auto first = static_cast<std::uint32_t>(scene.positions.size());
        std::array<Vec2, 4> uv;
        for (int k = 0; k < 4; ++k) {
          uv[k] = Vec2(i + (k == 1 || k == 2 ? 1 : 0), j + (k > 1 ? 1 : 0)) / static_cast<float>(cuts);
          scene.positions.push_back(at + uv[k].x * s + uv[k].y * t);
        }
        for (const auto& c : {std::array{0u, 1u, 2u}, std::array{0u, 2u, 3u}}) {
          scene.triangles.push_back({first + c[0], first + c[1], first + c[2]});
          scene.triangle_material.push_back(MaterialId{!textured && (i + j) % 2 == 1 ? other : one});
          scene.triangle_line.push_back(0);
          scene.triangle_group.push_back(0);
          if (textured) scene.uv_sets[0].push_back({uv[c[0]], uv[c[1]], uv[c[2]]});
        }
      }
  };
  add({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, squares, 1, 3);
  add({0, 1, 0}, {1, 0, 0}, {0, 0, 1}, squares, 2, 4);
  scene.materials[4].reflectance = scene.materials[2].reflectance;
  add({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1, 0, 0);
  add({0, 0, 1}, {0, 1, 0}, {1, 0, 0}, 1, 0, 0);
  add({0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1, 0, 0);
  add({1, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1, 0, 0);
  check_scene(scene);
  return scene;
}

Solution solved(const PatchSet& patches) {
  const Context context(2);
  const Tracer tracer(patches, context);
  Solution light;
  solve_sampled(patches, tracer, light, {.error = 0.01, .error_measure = ErrorMeasure::power}, context);
  return light;
}

TEST(Textures, LightAsMaterialsOfTheSameColoursDo) {
  const auto plain = make_patches(chequered_box(false), {.max_edge = 0.13f});
  const auto textured = make_patches(chequered_box(true), {.max_edge = 0.13f});
  ASSERT_EQ(plain.corners, textured.corners);
  for (std::size_t p = 0; p < plain.size(); ++p)
    for (std::size_t b = 0; b < 3; ++b) {
      ASSERT_NEAR(plain.reflectance(p, b), textured.reflectance(p, b), 1e-5);
      ASSERT_NEAR(plain.emittance(p, b), textured.emittance(p, b), 1e-5);
    }
  // Lamps are joined differently, so both are separate estimates of the same light, within their errors.
  const auto one = solved(plain), other = solved(textured);
  double off2 = 0.0, squared_light = 0.0;
  for (std::size_t i = 0; i < one.irradiance.front.size(); ++i) {
    const double area = plain.area[i / 3];
    const auto d = double{one.irradiance.front[i]} - double{other.irradiance.front[i]};
    off2 += area * d * d;
    squared_light += area * double{one.irradiance.front[i]} * double{one.irradiance.front[i]};
  }
  EXPECT_LT(std::sqrt(off2 / squared_light), 1.3 * std::hypot(one.predicted_error, other.predicted_error));
}

TEST(Textures, ColourAlikeOnAnyNumberOfThreads) {
  const auto scene = chequered_box(true);
  const auto one = make_patches(scene, {.max_edge = 0.02f}, Context(1));
  const auto four = make_patches(scene, {.max_edge = 0.02f}, Context(4));
  EXPECT_EQ(one.reflectance_ratio, four.reflectance_ratio);
  EXPECT_EQ(one.emittance_ratio, four.emittance_ratio);
  EXPECT_EQ(one.uv_sets, four.uv_sets);
}

// Cuts every patch: the mean reflectance of its parts is that of the patch.
void expect_parts_have_the_means_of(const PatchSet& wholes) {
  const auto cut = refine_patches(wholes, std::vector<std::uint8_t>(wholes.size(), 1));
  std::vector<double> sums(wholes.size() * 3, 0.0);
  for (std::size_t p = 0; p < cut.patches.size(); ++p)
    for (std::size_t b = 0; b < 3; ++b)
      sums[cut.parent[p] * 3 + b] += double{cut.patches.area[p]} * double{cut.patches.reflectance(p, b)};
  for (std::size_t i = 0; i < sums.size(); ++i)
    EXPECT_NEAR(sums[i] / double{wholes.area[i / 3]}, wholes.reflectance(i / 3, i % 3), 1e-4);
}

TEST(Textures, AreColouredAnewWhenPatchesAreCut) {
  expect_parts_have_the_means_of(make_patches(chequered_box(true), {.max_edge = 1.0f, .contacts = false}));
}

// Two cuts of every third patch: what stays whole keeps its colours, what is cut has those of its own place.
TEST(Textures, AreColouredAsIfCutAtOnceWhereOnlySomePatchesAreCut) {
  auto patches = make_patches(chequered_box(true), {.max_edge = 0.3f, .contacts = false});
  for (int round = 0; round < 2; ++round) {
    std::vector<std::uint8_t> marks(patches.size(), 0);
    for (std::size_t p = 0; p < marks.size(); p += 3) marks[p] = 1;
    auto cut = refine_patches(patches, marks);
    std::size_t whole = 0;
    for (std::size_t p = 0; p < cut.patches.size(); ++p) {
      if (cut.patches.corners[p] != patches.corners[cut.parent[p]]) continue;
      ++whole;
      for (std::size_t b = 0; b < 3; ++b) {
        ASSERT_EQ(cut.patches.reflectance(p, b), patches.reflectance(cut.parent[p], b));
        ASSERT_EQ(cut.patches.emittance(p, b), patches.emittance(cut.parent[p], b));
      }
      ASSERT_EQ(cut.patches.area[p], patches.area[cut.parent[p]]);
    }
    EXPECT_GT(whole, 5u);
    patches = std::move(cut.patches);
  }
  expect_parts_have_the_means_of(patches);
}

TEST(Textures, OfReflectanceAreLeftOutOnRequestAndThoseOfLampsStay) {
  const auto scene = chequered_box(true);
  const PatchOptions usual{.max_edge = 0.1f, .contacts = false};
  auto plain = usual;
  plain.plain_reflectance = true;
  const auto with = make_patches(scene, usual), without = make_patches(scene, plain);
  EXPECT_TRUE(without.reflectance_ratio.empty());
  EXPECT_EQ(without.emittance_ratio, with.emittance_ratio);
  EXPECT_EQ(without.corners, with.corners);
}

// The ratio of red to blue that one pixel in twenty exceeds, over that which nineteen exceed.
double contrast_of(const Image& picture) {
  std::vector<double> ratio;
  for (const auto& pixel : picture.pixels) ratio.push_back(double{pixel.r} / double{pixel.b});
  std::sort(ratio.begin(), ratio.end());
  return ratio[ratio.size() * 19 / 20] / ratio[ratio.size() / 20];
}

// The floor changes its colour within each patch, as the picture of the patches' light shows it.
TEST(Textures, AreSeenInPathTracedAndGatheredPictures) {
  auto scene = chequered_box(true);
  scene.materials[1].textures.reflectance = TextureUse{0, 0, {8, 0, 0, 0, 8, 0}};
  const auto patches = make_patches(scene, {.max_edge = 1.0f, .contacts = false});
  const Context context(2);
  const Tracer tracer(patches, context);
  const Camera camera{.eye = {0.5f, 0.7f, 0.5f}, .target = {0.5f, 0.0f, 0.5f}, .up = {0, 0, 1}};
  const auto light = solved(patches);
  const auto smooth = make_smooth_light(patches, light);
  const auto expected =
      contrast_of(render(patches, smooth, tracer, camera, {.width = 48, .height = 48}, context));
  EXPECT_GT(expected, 3.0);
  const auto paths = trace_picture(patches, tracer, camera, {48, 48}, {.limits = {.samples = 64}}, context);
  EXPECT_NEAR(contrast_of(paths.radiance), expected, 0.1 * expected);
  const auto gathered =
      gather_picture(patches, light, tracer, camera, {.width = 48, .height = 48, .rays = 64}, context);
  EXPECT_NEAR(contrast_of(gathered), expected, 0.1 * expected);
}

TEST(Textures, ComeBackFromASolutionFile) {
  auto patches = make_patches(chequered_box(true), {.max_edge = 0.5f});
  patches.point_lights.push_back({{.name = "bulb", .kind = PointLightKind::spot}, {1.0f, 2.0f, 3.0f}});
  const auto light = solved(patches);
  const auto path = std::filesystem::temp_directory_path() / "luxel-textures-test.vtkhdf";
  write_solution(path, patches, light);
  const auto back = read_solution(path).patches;
  std::filesystem::remove(path);
  EXPECT_EQ(back.reflectance_ratio, patches.reflectance_ratio);
  EXPECT_EQ(back.emittance_ratio, patches.emittance_ratio);
  EXPECT_EQ(back.uv_sets, patches.uv_sets);
  ASSERT_EQ(back.textures.size(), 2u);
  EXPECT_EQ(back.textures[0].raster->codes, patches.textures[0].raster->codes);
  EXPECT_EQ(back.textures[1].raster->linear, patches.textures[1].raster->linear);
  EXPECT_EQ(back.materials[1].textures.reflectance, patches.materials[1].textures.reflectance);
  ASSERT_EQ(back.point_lights.size(), 1u);
  EXPECT_EQ(back.point_lights[0].intensity, patches.point_lights[0].intensity);
  EXPECT_EQ(back.point_lights[0].light.name, "bulb");
}

TEST(Textures, ShowFinerThanPatches) {
  const auto patches = make_patches(chequered_box(true), {.max_edge = no_max_edge, .contacts = false});
  const FineColours fine(patches, Context());
  for (std::size_t p = 0; p < patches.size(); ++p) {
    if (patches.material_of(p).textures.reflectance) continue;
    EXPECT_EQ(fine.reflectance(p, 0.4f, 0.3f), Vec3(1.0f));
  }
  double sum = 0.0;
  constexpr int steps = 60;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; i + j < steps; ++j)
      sum += double{fine.reflectance(0, (static_cast<float>(i) + 1.0f / 3.0f) / steps,
                                     (static_cast<float>(j) + 1.0f / 3.0f) / steps)
                        .r};
  // Interpolation moves light from this square to its neighbours of the other colour.
  EXPECT_GT(sum / (steps * (steps + 1) / 2), 0.5);
  EXPECT_LT(sum / (steps * (steps + 1) / 2), 1.0);
}

// A sheet of 2 m between two facing ones, of which every second of 8 strips is a hole.
Scene sheet_with_holes() {
  Scene scene;
  scene.source = "sheet";
  scene.groups = {"default"};
  scene.materials = {{"sheet", Vec3(0.5f)}};
  auto strips = std::make_shared<Raster>();
  strips->width = 2;
  strips->height = 1;
  strips->codes = {{255, 255, 255, 255}, {255, 255, 255, 0}};
  scene.textures = {{"strips", strips}};
  scene.materials[0].textures.cutout = TextureUse{0, 0, {4, 0, 0, 0, 1, 0}};
  scene.positions = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  scene.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.triangle_material = {MaterialId{0}, MaterialId{0}};
  scene.triangle_line = {0, 0};
  scene.triangle_group = {0, 0};
  scene.uv_sets = {{{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)}, {Vec2(0, 0), Vec2(1, 1), Vec2(0, 1)}}};
  check_scene(scene);
  return scene;
}

TEST(Holes, LetRaysThrough) {
  const auto patches = make_patches(sheet_with_holes(), {.max_edge = 0.3f});
  const Tracer tracer(patches, Context(1));
  double area = 0.0;
  for (const auto a : patches.area) area += double{a};
  EXPECT_NEAR(area, 2.0, 1e-3);  // half of 4 m²
  for (int i = 0; i < 1000; ++i) {
    const auto x = (static_cast<float>(i) + 0.5f) / 500.0f;
    const bool is_hole = static_cast<int>(x * 4.0f) % 2 == 1;
    const Ray ray{{x, 0.9f, 1.0f}, {0, 0, -1}};
    EXPECT_EQ(static_cast<bool>(tracer.nearest(ray)), !is_hole) << x;
    EXPECT_EQ(tracer.occluded(ray, 2.0f), !is_hole) << x;
  }
}

TEST(Holes, pass_the_fraction_of_a_sky_that_they_are) {
  auto scene = sheet_with_holes();
  // A much smaller plate right below the sheet: it sees the sky through the strips only.
  scene.materials.push_back({"plate", Vec3(0.0f)});
  scene.materials[0].reflectance = Vec3(0.0f);
  const auto first = static_cast<std::uint32_t>(scene.positions.size());
  for (const auto& p : {Vec3(0.5f, 0.5f, -0.02f), Vec3(1.5f, 0.5f, -0.02f), Vec3(1.5f, 1.5f, -0.02f),
                        Vec3(0.5f, 1.5f, -0.02f)})
    scene.positions.push_back(p);
  for (const auto& c : {std::array{0u, 1u, 2u}, std::array{0u, 2u, 3u}}) {
    scene.triangles.push_back({first + c[0], first + c[1], first + c[2]});
    scene.triangle_material.push_back(MaterialId{1});
    scene.triangle_line.push_back(0);
    scene.triangle_group.push_back(0);
    scene.uv_sets[0].push_back({});
  }
  scene.sky = Vec3(1.0f);
  const auto patches = make_patches(scene, {.max_edge = 1.0f});
  const auto light = solved(patches);
  double sum = 0.0, area = 0.0, squared_error = 0.0;
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (patches.material[p] == MaterialId{1}) {
      sum += double{patches.area[p]} * double{light.irradiance.front[3 * p]};
      squared_error += std::pow(double{patches.area[p]} * double{light.standard_error.front[3 * p]}, 2);
      area += double{patches.area[p]};
    }
  // The plate is as wide as two pairs of strips, and at 2 cm what it sees past its own strips is the next
  // ones: a pattern of even halves moved sideways covers half of any whole number of pairs.
  EXPECT_NEAR(sum / area, M_PI / 2.0, 6.0 * std::sqrt(squared_error) / area + 0.01);
}

}  // namespace
}  // namespace luxel
