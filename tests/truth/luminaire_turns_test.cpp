// SPDX-License-Identifier: Apache-2.0
// Luminaires that are turned, divided, or read from two formats give the same light. Figures are compared
// within three standard errors of the difference, see support/three_errors.h for the risk; those without
// noise within rounding.
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/photometry/planes.h"
#include "luxel/solve/sampled.h"
#include "luxel/trace/point_sight.h"

#include "support/luminaires.h"
#include "support/probe_rig.h"
#include "support/three_errors.h"
#include "support/truth_scenes.h"

namespace luxel {
namespace {

using test::expect_truth;
using test::lopsided_distribution;
using test::luminaire;
using test::ProbeRig;
using test::WithError;

constexpr double degrees = std::numbers::pi / 180.0;

// A rotation about an axis, and what it makes of a luminaire and of points (Rodrigues).
struct Turn {
  Vec3d axis;
  double angle;  // radians

  Vec3d operator()(const Vec3d& v) const {
    return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) +
           axis * (glm::dot(axis, v) * (1.0 - std::cos(angle)));
  }
  PointLight operator()(PointLight light) const {
    light.position = Vec3((*this)(Vec3d(light.position)));
    for (auto* v : {&light.direction, &light.local_x, &light.local_y}) *v = Vec3((*this)(Vec3d(*v)));
    return light;
  }
};

const std::array<Turn, 3> turns = {
    {{{0, 0, 1}, 0.6}, {{1, 0, 0}, 2.1}, {glm::normalize(Vec3d(0.3, -0.8, 0.5)), 4.0}}};

// Files of all symmetries with some light in them: the planes from `first` to `last` in equal steps.
IntensityDistribution with_planes(double first, double last, int steps) {
  std::vector<double> gamma, around, candela;
  for (int i = 0; i <= 18; ++i) gamma.push_back(10.0 * i);
  for (int j = 0; j <= steps; ++j) around.push_back(first + (last - first) * j / std::max(1, steps));
  for (int j = 0; j <= steps; ++j)
    for (int i = 0; i <= 18; ++i) {
      const auto c = std::cos(around[static_cast<std::size_t>(j)] * degrees);
      candela.push_back(200.0 + 10.0 * i * (1.0 + 0.5 * c) + (last > 180.0 && last < 300.0 ? 0.0 : 40.0 * c));
    }
  return {GoniometerType::c, gamma, around, candela};
}

// Any rotation about the aim, and any rotation at all: intensity goes with the luminaire.
TEST(TurnedLuminaire, of_each_symmetry_has_turned_intensities) {
  for (const auto& [name, intensity] :
       {std::pair<std::string, IntensityDistribution>("rotational", with_planes(0, 0, 0)),
        {"quadrant", with_planes(0, 90, 3)},
        {"half about C0", with_planes(0, 180, 6)},
        {"half about C90", with_planes(90, 270, 6)},
        {"none", lopsided_distribution()}}) {
    const auto straight = luminaire(intensity, {}, {0.2f, -0.1f, 1.5f});
    for (const auto& turn : turns) {
      const auto turned = turn(straight);
      for (int k = 0; k < 40; ++k) {
        const Vec3d at(std::cos(1.7 * k), std::sin(2.3 * k), 1.5 + 1.2 * std::sin(0.9 * k + 0.4));
        EXPECT_NEAR(relative_intensity(turned, turn(at)), relative_intensity(straight, at), 2e-6) << name;
      }
    }
    for (const double angle : {90.0, 180.0, 37.0, 211.5}) {  // of the file, as --rotate does
      Photometry photometry;
      photometry.intensity = intensity;
      turn_luminaire(photometry, angle);
      for (int k = 0; k < 40; ++k) {
        const auto gamma = 4.5 * k, c = std::fmod(77.0 * k, 360.0);
        EXPECT_NEAR(photometry.intensity.at_angles(gamma, c + angle), intensity.at_angles(gamma, c), 1e-9)
            << name << " by " << angle;
      }
      EXPECT_NEAR(photometry.intensity.linear_flux(), intensity.linear_flux(), 1e-9 * intensity.linear_flux())
          << name;
    }
  }
}

Scene dark_triangle() {
  truth::SceneBuilder b;
  b.material("far", 0.0f, 0.0f).triangle({0, 0, -1e3f}, {1, 0, -1e3f}, {0, 1, -1e3f});
  return b.scene();
}

std::vector<std::pair<Vec3d, Vec3d>> near_points() {
  return {{{0.1, 0.2, 0.4}, {0, 0, 1}},
          {{1.0, -0.5, 0.0}, {0, 0, 1}},
          {{-0.6, 0.3, 1.0}, {1, 0, 0}},
          {{0.5, 1.2, 1.7}, {0, -1, 0}},
          {{-1.5, -1.5, 0.5}, {0.6, 0.6, 0.5}}};
}

// lx at a point of the luminaires; the same random numbers for all.
WithError lit(const ProbeRig& rig, const Vec3d& at, const Vec3d& normal, std::uint64_t seed) {
  const auto light = rig.at(Vec3(at), Vec3(normal), {.error = 0.0005, .max_rays = 1u << 20, .seed = seed});
  return {light.illuminance, light.sampling_error};
}
WithError difference(const WithError& a, const WithError& b) {
  return {a.value - b.value, std::hypot(a.error, b.error)};
}

// With the opening, near by.
TEST(TurnedLuminaire, turns_its_opening) {
  for (const auto shape : {OpeningShape::rectangle, OpeningShape::box, OpeningShape::cylinder_along_x,
                           OpeningShape::ellipsoid}) {
    auto scene = dark_triangle();
    const auto straight = luminaire(lopsided_distribution(), {shape, {0.9, 0.3, 0.1}}, {0.2f, -0.1f, 1.5f});
    scene.point_lights = {straight};
    const ProbeRig before(scene, no_max_edge, 0.0f);
    for (const auto& turn : turns) {
      scene.point_lights = {turn(straight)};
      const ProbeRig after(scene, no_max_edge, 0.0f);
      for (const auto& [at, normal] : near_points()) {
        const auto lx = lit(before, at, normal, 3).value;
        expect_truth(
            [&, at = at, normal = normal](std::uint64_t seed) {
              return difference(lit(after, turn(at), turn(normal), seed), lit(before, at, normal, seed + 10));
            },
            0.0, 1e-5 * lx, fmt::format("opening {} at {} {} {}", static_cast<int>(shape), at.x, at.y, at.z));
      }
    }
  }
}

// The made files of one luminaire: IES with its length along X, EULUMDAT along Y, a quarter turn apart. The
// digits of the files differ by 1e-6 of the maximum.
TEST(LuminaireFormats, of_one_luminaire_give_the_same_light) {
  for (const std::string name : {"led-panel", "wall-washer"}) {
    const auto file = LUXEL_SOURCE_DIR "/scenes/luminaires/" + name;
    const auto ldt = load_photometry(file + ".ldt");
    const auto rotated = load_photometry(file + ".ies", {.rotate = 270.0});
    const auto max = ldt.intensity.maximum();
    for (int c = 0; c < 360; c += 5)
      for (int gamma = 0; gamma <= 180; gamma += 3)
        EXPECT_NEAR(rotated.intensity.at_angles(gamma, c), ldt.intensity.at_angles(gamma, c), 3e-6 * max)
            << name << " " << c << " " << gamma;
    EXPECT_EQ(rotated.opening.shape, ldt.opening.shape);
    EXPECT_NEAR(glm::length(rotated.opening.size - ldt.opening.size), 0.0, 1e-9);

    // As lights, the IES one turned about its aim instead.
    auto scene = dark_triangle();
    const auto light_of = [](const Photometry& photometry) {
      auto light = luminaire(photometry.intensity, photometry.opening, {0.2f, -0.1f, 1.5f});
      return light;
    };
    scene.point_lights = {light_of(ldt)};
    const ProbeRig by_ldt(scene, no_max_edge, 0.0f);
    auto ies = light_of(load_photometry(file + ".ies"));
    ies.local_x = {0, -1, 0};
    ies.local_y = {1, 0, 0};
    scene.point_lights = {ies};
    const ProbeRig by_ies(scene, no_max_edge, 0.0f);
    for (const auto& [at, normal] : near_points())
      expect_truth(
          [&, at = at, normal = normal](std::uint64_t seed) {
            return difference(lit(by_ies, at, normal, seed), lit(by_ldt, at, normal, seed + 10));
          },
          0.0, 1e-5 * max, fmt::format("{} at {} {} {}", name, at.x, at.y, at.z));
  }
}

// A flat luminaire, and the four quarters of its opening with a quarter of its flux each.
std::vector<PointLight> quarters(const PointLight& whole) {
  std::vector<PointLight> parts;
  for (const int i : {-1, 1})
    for (const int j : {-1, 1}) {
      auto part = whole;
      auto photometry = std::make_shared<Photometry>(*whole.photometry);
      photometry->opening.size *= 0.5;
      part.position += static_cast<float>(0.5 * i * photometry->opening.size.x) * whole.local_x +
                       static_cast<float>(0.5 * j * photometry->opening.size.y) * whole.local_y;
      part.intensity *= 0.25f;
      part.photometry = photometry;
      parts.push_back(part);
    }
  return parts;
}

TEST(DividedLuminaire, gives_near_points_the_light_of_the_whole) {
  const auto whole = turns[2](
      luminaire(lopsided_distribution(), {OpeningShape::rectangle, {1.2, 0.6, 0.0}}, {0.2f, -0.1f, 1.5f}));
  auto scene = dark_triangle();
  scene.point_lights = {whole};
  const ProbeRig one(scene, no_max_edge, 0.0f);
  scene.point_lights = quarters(whole);
  const ProbeRig four(scene, no_max_edge, 0.0f);
  for (const auto& [at, normal] : near_points()) {
    const auto place = turns[2](at), facing = turns[2](normal);
    const auto lx = lit(one, place, facing, 3).value;
    expect_truth(
        [&](std::uint64_t seed) {
          return difference(lit(four, place, facing, seed), lit(one, place, facing, seed + 10));
        },
        0.0, 1e-5 * lx, fmt::format("at {} {} {}", at.x, at.y, at.z));
  }
}

// Reflected light as well: the mean irradiance of each material of a room.
TEST(DividedLuminaire, gives_a_room_the_light_of_the_whole) {
  truth::SceneBuilder b;
  test::add_room(b, {0, 0, 0}, {4, 3, 2.5f}, 0.6f);
  auto scene = b.scene();
  const auto whole =
      luminaire(lopsided_distribution(), {OpeningShape::rectangle, {1.2, 0.6, 0.0}}, {1.2f, 1.1f, 1.9f});
  const auto mean = [&](const std::string& material, const std::vector<PointLight>& lights,
                        std::uint64_t seed) {
    scene.point_lights = lights;
    const auto patches = make_patches(scene, {.max_edge = 1.0f});
    const Context context(2);
    const Tracer tracer(patches, context);
    Solution light;
    const auto report = solve_sampled(
        patches, tracer, light, {.error = 4e-3, .error_measure = ErrorMeasure::power, .seed = seed}, context);
    for (const auto& surface : report.means.surfaces)
      if (surface.name == material && !surface.is_back)
        return WithError{luminous_efficacy * surface.irradiance[0],
                         luminous_efficacy * surface.standard_error[0]};
    return WithError{};
  };
  for (const std::string material : {"floor", "walls"}) {
    EXPECT_GT(mean(material, {whole}, 7).value, 100.0);
    expect_truth(
        [&](std::uint64_t seed) {
          return difference(mean(material, quarters(whole), seed), mean(material, {whole}, seed + 10));
        },
        0.0, 1e-3, material);
  }
}

}  // namespace
}  // namespace luxel
