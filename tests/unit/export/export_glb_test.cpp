// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/export/export_mesh.h"
#include "luxel/image/image.h"

#include "support/glb_file.h"
#include "support/lit_patches.h"

namespace luxel {
namespace {

using test::GlbFile;
using test::LitPatches;
using test::plain_material;

constexpr float pi_f = std::numbers::pi_v<float>;
const ExportOptions clamped = {.tone = {.op = ToneOperator::clamp}};  // shows radiance as it is, up to 1

std::filesystem::path file(const std::string& name) {
  return std::filesystem::path(testing::TempDir()) / ("export_glb_" + name + ".glb");
}

GlbFile exported(const LitPatches& lit, const Vec3& up = Vec3(0, 1, 0),
                 const ExportOptions& options = clamped) {
  const auto path = file(testing::UnitTest::GetInstance()->current_test_info()->name());
  export_glb(path, lit.patches, lit.solution, make_smooth_light(lit.patches, lit.solution), up, options);
  return GlbFile(path);
}

template <typename T>
std::vector<T> values(const GlbFile& model, std::size_t primitive, const char* attribute) {
  return model.values<T>(model.attribute(primitive, attribute));
}

template <typename T>
std::vector<T> indices(const GlbFile& model, std::size_t primitive) {
  return model.values<T>(model.accessor(model.primitive(primitive).at("indices")));
}

// Two triangles of one square, red below the diagonal and lamp above it, lit by 0.5 pi and 0.25 pi W/m².
LitPatches two_colours() {
  LitPatches lit({plain_material("red", 0.0f), plain_material("lamp", 0.5f, true, 0.5f * pi_f)});
  lit.patches.materials[0].reflectance = {0.5f, 0.25f, 0.0f};
  const auto a = lit.vertex({0, 0, 2}), b = lit.vertex({1, 0, 2}), c = lit.vertex({1, 3, 2}),
             d = lit.vertex({0, 3, 2});
  lit.patch({a, b, c}, 0.5f * pi_f, 0.0f, 0);
  lit.patch({a, c, d}, 0.25f * pi_f, 0.0f, 1);
  return lit;
}

TEST(ExportGlb, colours_are_radiance_and_sharp_at_a_material_border) {
  const auto model = exported(two_colours());
  ASSERT_EQ(model.json["meshes"].size(), 1u);
  ASSERT_EQ(model.primitives(), 2u);

  // Irradiance is 0.5 pi at the red one's own corner, 0.25 pi at the lamp's, the mean of both between them.
  // radiance = (E + rho H) / pi
  const std::array<std::array<float, 3>, 2> reflectance = {{{0.5f, 0.25f, 0.0f}, {0.5f, 0.5f, 0.5f}}};
  const std::array<std::array<float, 3>, 2> irradiance_over_pi = {
      {{0.375f, 0.5f, 0.375f}, {0.375f, 0.375f, 0.25f}}};
  for (std::size_t m = 0; m < 2; ++m) {
    const auto emitted = m == 1 ? 0.5f : 0.0f;
    EXPECT_TRUE(model.attribute(m, "COLOR_0")["normalized"].get<bool>());
    const auto colours = values<std::uint16_t>(model, m, "COLOR_0");
    ASSERT_EQ(colours.size(), 12u);
    for (std::size_t v = 0; v < 3; ++v) {
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(colours[4 * v + c], 65535.0f * (emitted + reflectance[m][c] * irradiance_over_pi[m][v]),
                    0.51f)
            << "material " << m << " vertex " << v << " channel " << c;
      EXPECT_EQ(colours[4 * v + 3], 65535);
    }
  }
}

TEST(ExportGlb, colours_are_those_of_one_curve_fitted_to_all_areas) {
  const auto lit = two_colours();
  const auto model = exported(lit, Vec3(0, 1, 0), {});
  const std::array<Vec3, 2> radiance = {Vec3(0.25f, 0.125f, 0.0f), Vec3(0.625f)};
  const auto curve = fit_curve(radiance, lit.patches.area, {});
  const auto expected = curve(Vec3(0.5f) * Vec3(0.5f, 0.25f, 0.0f));  // the red one's own corner
  const auto colours = values<std::uint16_t>(model, 0, "COLOR_0");
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(colours[4 + c], 65535.0f * expected[c], 1.0f);
}

TEST(ExportGlb, positions_normals_and_bounds_are_exact) {
  const auto model = exported(two_colours());
  EXPECT_EQ(values<float>(model, 0, "POSITION"), (std::vector<float>{0, 0, 2, 1, 0, 2, 1, 3, 2}));
  EXPECT_EQ(values<float>(model, 0, "NORMAL"), (std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}));
  EXPECT_EQ(indices<std::uint16_t>(model, 0), (std::vector<std::uint16_t>{0, 1, 2}));
  const auto& position = model.attribute(0, "POSITION");
  EXPECT_EQ(position["min"].get<std::vector<double>>(), (std::vector<double>{0, 0, 2}));
  EXPECT_EQ(position["max"].get<std::vector<double>>(), (std::vector<double>{1, 3, 2}));
}

TEST(ExportGlb, bounds_of_odd_floats_survive_the_text) {
  auto lit = two_colours();
  lit.patches.vertices[0] = Vec3(-0.1f, 1.0f / 3.0f, 1e-7f);
  const auto model = exported(lit);
  const auto& position = model.attribute(0, "POSITION");
  EXPECT_EQ(position["min"].get<std::vector<double>>(),
            (std::vector<double>{static_cast<double>(-0.1f), 0.0, static_cast<double>(1e-7f)}));
}

TEST(ExportGlb, materials_are_unlit_one_sided_and_named_as_in_the_scene) {
  auto lit = two_colours();
  lit.patches.materials[0].name = "W\xE4nde";  // Latin-1, as found in the wild
  const auto model = exported(lit);
  const auto& materials = model.json["materials"];
  EXPECT_EQ(model.json["extensionsUsed"], nlohmann::json::array({"KHR_materials_unlit"}));
  ASSERT_EQ(materials.size(), 2u);
  EXPECT_EQ(materials[0]["name"], "W?nde");
  EXPECT_EQ(materials[1]["name"], "lamp");
  for (const auto& material : materials) {
    EXPECT_TRUE(material["extensions"].contains("KHR_materials_unlit"));
    EXPECT_FALSE(material.value("doubleSided", false));
  }
}

TEST(ExportGlb, a_back_is_written_only_where_light_fell_on_it) {
  LitPatches lit;
  const auto a = lit.vertex({0, 0, 0}), b = lit.vertex({1, 0, 0}), c = lit.vertex({0, 1, 0});
  const auto d = lit.vertex({5, 0, 0}), e = lit.vertex({6, 0, 0}), f = lit.vertex({5, 1, 0});
  lit.patch({a, b, c}, 0.0f, pi_f);  // lit from behind alone: its front is there, and black
  lit.patch({d, e, f}, pi_f, 0.0f);
  const auto model = exported(lit);
  ASSERT_EQ(model.primitives(), 2u);
  EXPECT_EQ(model.json["materials"].size(), 1u);
  constexpr std::size_t front = 0, back = 1;
  EXPECT_EQ(indices<std::uint16_t>(model, front), (std::vector<std::uint16_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(indices<std::uint16_t>(model, back), (std::vector<std::uint16_t>{0, 2, 1}));
  EXPECT_EQ(values<float>(model, back, "POSITION"), (std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
  const auto normals = values<float>(model, back, "NORMAL");
  for (std::size_t v = 0; v < 3; ++v) EXPECT_EQ(normals[3 * v + 2], -1.0f);
  EXPECT_EQ(values<std::uint16_t>(model, front, "COLOR_0")[0], 0);
  EXPECT_NEAR(values<std::uint16_t>(model, front, "COLOR_0")[12], 32767.5f, 1.0f);
  EXPECT_NEAR(values<std::uint16_t>(model, back, "COLOR_0")[0], 32767.5f, 1.0f);
}

TEST(ExportGlb, neighbours_of_one_material_share_vertices) {
  LitPatches lit;
  const auto a = lit.vertex({0, 0, 0}), b = lit.vertex({1, 0, 0}), c = lit.vertex({1, 1, 0}),
             d = lit.vertex({0, 1, 0});
  lit.patch({a, b, c}, 1.0f);
  lit.patch({a, c, d}, 1.0f);
  const auto model = exported(lit);
  EXPECT_EQ(model.attribute(0, "POSITION")["count"], 4u);
  EXPECT_EQ(indices<std::uint16_t>(model, 0), (std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}));
}

TEST(ExportGlb, many_vertices_get_long_indices) {
  LitPatches lit;
  for (int i = 0; i < 21846; ++i) {  // apart from each other: 65538 vertices
    const auto x = static_cast<float>(2 * i);
    const auto a = lit.vertex({x, 0, 0}), b = lit.vertex({x + 1, 0, 0}), c = lit.vertex({x, 1, 0});
    lit.patch({a, b, c}, 1.0f);
  }
  const auto model = exported(lit);
  const auto corners = indices<std::uint32_t>(model, 0);
  ASSERT_EQ(corners.size(), 65538u);
  EXPECT_EQ(corners.back(), 65537u);
}

// Turns v by the root node's quaternion.
std::vector<double> rotation(const GlbFile& model) {
  return model.json.at("nodes").at(0).value("rotation", std::vector<double>());
}

Vec3d turned(const GlbFile& model, const Vec3d& v) {
  const auto q = rotation(model);
  if (q.empty()) return v;
  const Vec3d axis(q[0], q[1], q[2]);
  return v + 2.0 * glm::cross(axis, glm::cross(axis, v) + q[3] * v);
}

TEST(ExportGlb, what_is_up_becomes_y_up) {
  EXPECT_TRUE(rotation(exported(two_colours(), Vec3(0, 2, 0))).empty());
  for (const auto& up : {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, -3), Vec3(1, 2, 3)}) {
    const auto model = exported(two_colours(), up);
    const auto result = turned(model, glm::normalize(Vec3d(up)));
    EXPECT_NEAR(result.y, 1.0, 1e-12);
    const auto q = rotation(model);
    EXPECT_NEAR(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1.0, 1e-12);
  }
  const auto from_z = turned(exported(two_colours(), Vec3(0, 0, 1)), Vec3d(1, 2, 3));  // the usual (x, z, -y)
  EXPECT_NEAR(from_z.x, 1.0, 1e-12);
  EXPECT_NEAR(from_z.y, 3.0, 1e-12);
  EXPECT_NEAR(from_z.z, -2.0, 1e-12);
  EXPECT_THROW(exported(two_colours(), Vec3(0)), InputError);
}

TEST(ExportGlb, the_asset_says_where_the_light_came_from) {
  auto lit = two_colours();
  lit.solution.provenance.program_version = "1.2.3";
  lit.solution.provenance.method = "stochastic-jacobi";
  lit.solution.provenance.rays = 50'000'000;
  lit.solution.provenance.scene_fingerprint = 0xABCDEF;
  lit.solution.unshot_fraction = 0.25;
  lit.solution.predicted_error = 0.125;
  auto asset = exported(lit).json["asset"];
  EXPECT_EQ(asset["version"], "2.0");
  EXPECT_EQ(asset["generator"], "Luxel 1.2.3");
  const auto& luxel = asset["extras"]["luxel"];
  EXPECT_EQ(luxel["method"], "stochastic-jacobi");
  EXPECT_EQ(luxel["rays"], 5e7);
  EXPECT_EQ(luxel["unshot_fraction"], 0.25);
  EXPECT_EQ(luxel["predicted_error"], 0.125);
  EXPECT_EQ(luxel["scene_fingerprint"], "0000000000abcdef");
}

TEST(ExportGlb, the_same_light_gives_the_same_bytes_and_honest_lengths) {
  const auto lit = two_colours();
  const auto light = make_smooth_light(lit.patches, lit.solution);
  const auto first = file("first"), second = file("second");
  export_glb(first, lit.patches, lit.solution, light, Vec3(0, 0, 1), {});
  export_glb(second, lit.patches, lit.solution, light, Vec3(0, 0, 1), {});
  const auto bytes = read_file(first);
  EXPECT_EQ(bytes, read_file(second));

  const auto word = [&](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, 4);
    return value;
  };
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(word(4), 2u);
  EXPECT_EQ(word(8), bytes.size());
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  const auto binary = 20 + word(12);
  EXPECT_EQ(binary % 4, 0u);
  EXPECT_EQ(bytes.substr(binary + 4, 4), std::string("BIN\0", 4));
  EXPECT_EQ(binary + 8 + word(binary), bytes.size());
}

TEST(ExportGlb, a_scene_without_patches_is_a_valid_file_without_a_mesh) {
  const auto model = exported(LitPatches());
  EXPECT_FALSE(model.json.contains("meshes"));
  EXPECT_FALSE(model.json.contains("buffers"));
  EXPECT_EQ(model.json["asset"]["version"], "2.0");
}

TEST(ExportGlb, light_that_is_not_plain_colour_is_refused) {
  auto lit = two_colours();
  lit.solution.bands = lit.patches.bands = {"a", "b", "c"};
  EXPECT_THROW(exported(lit), MismatchError);
}

TEST(ExportGlb, light_of_another_scene_is_refused) {
  const auto lit = two_colours();
  const LitPatches other;
  const auto light = make_smooth_light(other.patches, other.solution);
  EXPECT_THROW(export_glb(file("other"), lit.patches, lit.solution, light, Vec3(0, 1, 0)), MismatchError);
  EXPECT_THROW(export_glb(file("other"), lit.patches, other.solution,
                          make_smooth_light(lit.patches, lit.solution), Vec3(0, 1, 0)),
               MismatchError);
}

TEST(ExportGlb, a_place_that_cannot_be_written_is_a_device_error) {
  const auto lit = two_colours();
  const auto light = make_smooth_light(lit.patches, lit.solution);
  EXPECT_THROW(export_glb(file("no_such_folder") / "a.glb", lit.patches, lit.solution, light, Vec3(0, 1, 0)),
               DeviceError);
  EXPECT_THROW(export_glb("/dev/full", lit.patches, lit.solution, light, Vec3(0, 1, 0)), DeviceError);
}

// The irradiance of the first material of two_colours(), by linear sRGB.
TEST(ExportGlb, irradiance_goes_with_the_colours) {
  const auto model = exported(two_colours());
  const auto irradiance = values<float>(model, 0, "_IRRADIANCE");
  ASSERT_EQ(irradiance.size(), 9u);
  for (std::size_t v = 0; v < 3; ++v)
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(irradiance[3 * v + c], (v == 1 ? 0.5f : 0.375f) * pi_f, 1e-5f);
  const auto& luxel = model.json["asset"]["extras"]["luxel"];
  EXPECT_EQ(luxel["as"], "vertex");
  EXPECT_EQ(luxel["light"]["_IRRADIANCE"]["unit"], "W/m2 by linear sRGB");
  EXPECT_EQ(luxel["light"]["COLOR_0"]["scale"], 1.0);
}

TEST(ExportGlb, godot_gets_codes_that_its_importer_decodes) {
  auto options = clamped;
  const auto linear = exported(two_colours(), Vec3(0, 1, 0), options);
  options.program = TargetApplication::godot;
  const auto coded = exported(two_colours(), Vec3(0, 1, 0), options);
  EXPECT_EQ(coded.json["materials"][0]["name"], "red-vcol");
  EXPECT_FALSE(coded.primitive(0)["attributes"].contains("_IRRADIANCE"));
  const auto at = [](const GlbFile& model) { return values<std::uint16_t>(model, 0, "COLOR_0"); };
  const auto a = at(linear), b = at(coded);
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_NEAR(b[i] / 65535.0f, i % 4 == 3 ? 1.0f : srgb_encode(a[i] / 65535.0f), 1e-4f);
}

TEST(ExportGlb, every_program_has_a_word) {
  for (const auto word : mesh_program_names()) EXPECT_EQ(name(*target_application(word)), word);
  EXPECT_FALSE(target_application("maya"));
}

}  // namespace
}  // namespace luxel
