// SPDX-License-Identifier: Apache-2.0
// Openings of luminaires in exported GLB files.
#include <algorithm>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/export/export_mesh.h"
#include "luxel/export/export_round_trip.h"
#include "luxel/export/opening_faces.h"
#include "luxel/import/load_scene.h"

#include "support/glb_file.h"
#include "support/lit_patches.h"
#include "support/luminaires.h"
#include "support/round_trip_file.h"

namespace luxel {
namespace {

using test::GlbFile;

BandPointLight lamp_of(const PointLight& light) {
  return {light, {light.intensity.r, light.intensity.g, light.intensity.b}, 0};
}

std::size_t node_named(const GlbFile& file, const std::string& name) {
  const auto& nodes = file.json.at("nodes");
  for (std::size_t n = 0; n < nodes.size(); ++n)
    if (nodes[n].value("name", "") == name) return n;
  ADD_FAILURE() << "there is no node " << name;
  return 0;
}

bool is_below(const GlbFile& file, std::size_t node, std::size_t parent) {
  for (const auto& child : file.json.at("nodes")[parent].value("children", nlohmann::json::array()))
    if (child == node) return true;
  return false;
}

// Two luminaires of one file: a panel of 0.6 x 0.3 m of 100 cd at most, aims down, and one that aims along
// +X.
test::LitPatches lit_square() {
  test::LitPatches lit({test::plain_material("wall", 0.5f)});
  const auto a = lit.vertex({0, 0, 0}), b = lit.vertex({1, 0, 0}), c = lit.vertex({1, 1, 0});
  lit.patch({a, b, c}, 1.0f, 0.0f, 0);
  auto light = test::luminaire(test::cosine_distribution(100.0), {OpeningShape::rectangle, {0.6, 0.3, 0.0}},
                               {1.0f, 2.0f, 3.0f});
  light.name = "first";
  lit.patches.point_lights.push_back(lamp_of(light));
  light.name = "second";
  light.direction = {1, 0, 0};
  light.local_x = {0, 0, 1};
  light.local_y = {0, 1, 0};
  lit.patches.point_lights.push_back(lamp_of(light));
  return lit;
}

TEST(OpeningBodies, are_emissive_meshes_at_their_luminaires) {
  const auto lit = lit_square();
  const auto path = std::filesystem::path(testing::TempDir()) / "openings.glb";
  export_glb(path, lit.patches, lit.solution, make_smooth_light(lit.patches, lit.solution), Vec3(0, 1, 0),
             {.tone = {.op = ToneOperator::clamp}});
  const GlbFile file(path);
  const auto first = node_named(file, "first"), second = node_named(file, "second");
  const auto& node = file.json.at("nodes")[first];
  EXPECT_TRUE(is_below(file, first, 0));
  EXPECT_NEAR(node.at("matrix")[12].get<double>(), 1.0, 1e-6);
  EXPECT_NEAR(node.at("matrix")[14].get<double>(), 3.0 - 6e-3, 1e-6);
  EXPECT_NEAR(node.at("extras").at("luxel_lumens").get<double>(), 100.0 * std::numbers::pi, 0.1);
  EXPECT_NEAR(file.json.at("nodes")[second].at("matrix")[12].get<double>(), 1.0 + 6e-3, 1e-6);
  EXPECT_EQ(file.json.at("meshes").size(), 2u);  // the surfaces, and one for both luminaires
  EXPECT_EQ(node.at("mesh"), file.json.at("nodes")[second].at("mesh"));
  const auto& mesh = file.json.at("meshes")[node.at("mesh").get<std::size_t>()];
  EXPECT_EQ(mesh.at("extras").at("luxel_opening"), true);
  const auto& primitive = mesh.at("primitives")[0];
  const auto& box = file.accessor(primitive.at("attributes").at("POSITION"));
  EXPECT_NEAR(box.at("max")[0].get<double>(), 0.3, 1e-6);
  EXPECT_NEAR(box.at("max")[1].get<double>(), 0.15, 1e-6);
  // Radiance of a cosine panel: its largest intensity over its area, here above the display's white.
  const auto& emitted =
      file.json.at("materials")[primitive.at("material").get<std::size_t>()].at("emissiveFactor");
  EXPECT_EQ(emitted, nlohmann::json({1.0, 1.0, 1.0}));
}

TEST(OpeningBodies, have_the_radiance_of_their_flux_and_area) {
  auto lit = lit_square();
  for (auto& lamp : lit.patches.point_lights)
    lamp.intensity = {0.09f, 0.045f, 0.0f};  // W/sr; the area: 0.18 m²
  const auto path = std::filesystem::path(testing::TempDir()) / "dim_openings.glb";
  export_glb(path, lit.patches, lit.solution, make_smooth_light(lit.patches, lit.solution), Vec3(0, 1, 0),
             {.tone = {.op = ToneOperator::clamp}});
  const auto emitted = GlbFile(path).json.at("materials").back().at("emissiveFactor");
  EXPECT_NEAR(emitted[0].get<double>(), 0.5, 1e-3);
  EXPECT_NEAR(emitted[1].get<double>(), 0.25, 1e-3);
  EXPECT_EQ(emitted[2].get<double>(), 0.0);
}

TEST(OpeningBodies, have_no_mesh_where_nothing_is_emitted) {
  auto lit = lit_square();
  auto dark = std::make_shared<Photometry>(*lit.patches.point_lights[0].light.photometry);
  dark->intensity = IntensityDistribution(GoniometerType::c, {0.0, 90.0}, {0.0}, {0.0, 0.0});
  lit.patches.point_lights[0].light.photometry = dark;
  const auto path = std::filesystem::path(testing::TempDir()) / "dark_opening.glb";
  export_glb(path, lit.patches, lit.solution, make_smooth_light(lit.patches, lit.solution), Vec3(0, 1, 0),
             {.tone = {.op = ToneOperator::clamp}});
  const GlbFile file(path);
  EXPECT_FALSE(file.json.at("nodes")[node_named(file, "first")].contains("mesh"));
  EXPECT_TRUE(file.json.at("nodes")[node_named(file, "second")].contains("mesh"));
  for (const auto& mesh : file.json.at("meshes")) EXPECT_FALSE(mesh.at("primitives").empty());
}

TEST(OpeningBodies, are_no_surfaces_and_no_lamps_when_the_file_is_read) {
  const auto lit = lit_square();
  for (const auto compression : {MeshCompression::plain, MeshCompression::quantised}) {
    const auto path = std::filesystem::path(testing::TempDir()) / "read_openings.glb";
    export_glb(path, lit.patches, lit.solution, make_smooth_light(lit.patches, lit.solution), Vec3(0, 1, 0),
               {.tone = {}, .compression = compression});
    const auto scene = load_scene(path);
    EXPECT_EQ(scene.triangles.size(), 1u);
    EXPECT_EQ(scene.materials.size(), 1u);
    EXPECT_TRUE(scene.point_lights.empty());
    for (const auto& material : scene.materials) EXPECT_EQ(material.emittance, Vec3(0.0f));
  }
}

// Radiance and normal of each face.
std::vector<std::pair<double, Vec3>> faces_of(const LuminousOpening& opening,
                                              const IntensityDistribution& intensity) {
  Photometry photometry;
  photometry.intensity = intensity;
  photometry.opening = opening;
  std::vector<std::pair<double, Vec3>> faces;
  for (const auto& face : opening_faces(photometry, 0.01))
    faces.emplace_back(face.radiance, face.mesh.normals.at(0));
  return faces;
}

// Three quarters of the light go up.
IntensityDistribution mostly_up() {
  return {GoniometerType::c, {0.0, 90.0, 90.001, 180.0}, {0.0}, {10.0, 10.0, 30.0, 30.0}};
}

TEST(OpeningFaces, of_a_sheet_emit_what_leaves_to_their_side) {
  const auto faces = faces_of({OpeningShape::rectangle, {0.5, 0.4, 0.0}}, mostly_up());
  ASSERT_EQ(faces.size(), 2u);
  EXPECT_EQ(faces[0].second, Vec3(0, 0, -1));
  EXPECT_EQ(faces[1].second, Vec3(0, 0, 1));
  // Half of the sphere at a third of the largest intensity, and at the largest, over pi times the area.
  EXPECT_NEAR(faces[0].first, 2.0 / 3.0 / 0.2, 2e-3);
  EXPECT_NEAR(faces[1].first, 2.0 / 0.2, 2e-3);
}

TEST(OpeningFaces, that_emit_nothing_are_left_out) {
  const IntensityDistribution up(GoniometerType::c, {90.0, 180.0}, {0.0}, {0.0, 50.0});
  const auto faces = faces_of({OpeningShape::ellipse, {0.5, 0.5, 0.0}}, up);
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_EQ(faces[0].second, Vec3(0, 0, 1));
  EXPECT_TRUE(faces_of({OpeningShape::rectangle, {1.0, 1.0, 0.0}},
                       IntensityDistribution(GoniometerType::c, {0.0, 90.0}, {0.0}, {0.0, 0.0}))
                  .empty());
}

// A sphere has the same projected area from everywhere, so an even light gives each of its parts the radiance
// 1 / area; the sum of radiance times area is the flux.
TEST(OpeningFaces, of_bodies_sum_to_the_whole_flux) {
  const IntensityDistribution even(GoniometerType::c, {0.0, 180.0}, {0.0}, {20.0, 20.0});
  const LuminousOpening ball{OpeningShape::ellipsoid, Vec3d(0.3)};
  const auto parts = faces_of(ball, even);
  ASSERT_EQ(parts.size(), 3u);
  for (const auto& [radiance, normal] : parts)
    EXPECT_NEAR(radiance, 1.0 / (std::numbers::pi / 4.0 * 0.09), 0.02 * radiance);

  for (const auto& opening : {LuminousOpening{OpeningShape::box, {0.6, 0.3, 0.1}},
                              LuminousOpening{OpeningShape::vertical_cylinder, {0.2, 0.2, 0.4}}}) {
    Photometry photometry;
    photometry.intensity = mostly_up();
    photometry.opening = opening;
    double flux = 0.0;
    std::vector<double> radiances;
    for (const auto& [mesh, radiance] : opening_faces(photometry, 0.01)) {
      double area = 0.0;
      for (const auto& [a, b, c] : mesh.triangles)
        area += 0.5 * glm::length(glm::cross(mesh.positions[b] - mesh.positions[a],
                                             mesh.positions[c] - mesh.positions[a]));
      flux += std::numbers::pi * area * radiance;
      radiances.push_back(radiance);
    }
    EXPECT_NEAR(flux, photometry.intensity.linear_flux() / photometry.intensity.maximum(), 1e-4);
    ASSERT_EQ(radiances.size(), 3u);  // bottom, sides, top
    EXPECT_LT(radiances[0], radiances[1]);
    EXPECT_LT(radiances[1], radiances[2]);
  }
}

TEST(OpeningFaces, of_a_sheet_are_so_far_apart_that_rays_meet_the_nearer_one) {
  Photometry photometry;
  photometry.intensity = mostly_up();
  photometry.opening = {OpeningShape::vertical_disk, {0.0, 0.4, 0.4}};
  const auto faces = opening_faces(photometry, 0.01);
  ASSERT_EQ(faces.size(), 2u);
  for (std::size_t v = 0; v < faces[0].mesh.positions.size(); ++v) {
    const auto from_back = faces[0].mesh.positions[v] - faces[1].mesh.positions[v];
    EXPECT_NEAR(glm::dot(from_back, faces[0].mesh.normals[v]), 0.01f, 1e-6f);
    EXPECT_EQ(faces[0].mesh.normals[v], -faces[1].mesh.normals[v]);
  }
}

// In a glTF scene of other units they are at the same places, and a second export has them once.
class RoundTripOpenings : public test::ExportRoundTrip {};

TEST_F(RoundTripOpenings, are_in_the_units_of_the_file_and_not_doubled) {
  files_.write("room.glb", test::small_room().glb());
  LoadOptions options;
  options.scale = 0.01;
  for (int times = 0; times < 2; ++times) {
    scene_ = load_scene(times == 0 ? files_.path("room.glb") : out(), options);
    EXPECT_EQ(std::count(scene_.objects.begin(), scene_.objects.end(), "disk"), 0);
    patches_ = make_patches(scene_, {.max_edge = 1.0f});
    auto light = test::luminaire(test::cosine_distribution(100.0), {OpeningShape::ellipse, {0.2, 0.2, 0.0}},
                                 {0.01f, 0.02f, 0.03f});
    light.name = "disk";
    patches_.point_lights.push_back(lamp_of(light));
    solution_ = test::linear_light(patches_);
    export_round_trip_cut(out(), input(), make_smooth_light(patches_, solution_),
                          {.tone = {}, .metres_per_unit = 0.01});
    const GlbFile file(out());
    const auto node = file.json.at("nodes").back();
    EXPECT_EQ(node.at("name"), "disk");
    const auto& origin = patches_.origin;
    EXPECT_NEAR(node.at("matrix")[12].get<double>(), 1.0 + 100.0 * origin.x, 1e-4);
    EXPECT_NEAR(node.at("matrix")[14].get<double>(), 3.0 + 100.0 * origin.z - 0.6, 1e-4);
    EXPECT_NEAR(node.at("matrix")[0].get<double>(), 100.0, 1e-9);
    std::size_t openings = 0;
    for (const auto& each : file.json.at("nodes"))
      if (each.contains("mesh") && file.json.at("meshes")[each.at("mesh").get<std::size_t>()]
                                       .value("extras", nlohmann::json())
                                       .contains("luxel_opening"))
        ++openings;
    EXPECT_EQ(openings, 1u);
  }
}

}  // namespace
}  // namespace luxel
