// SPDX-License-Identifier: Apache-2.0
// CIE 171:2006, daylight: test cases 5.5, directional transmittance of clear glass; 5.9 and 5.10, openings in
// a roof without and with glass; 5.11 and 5.12, openings in a façade. The document is not public; geometry is
// that of published validation reports. Every true value was derived twice, to at least five digits:
// tools/validation/daylight_truth.py.
//
// Figures are compared within three standard errors, see support/three_errors.h for the risk, and to 0.05 %
// for the size of the patches of the sky.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "luxel/lamps/choose_portals.h"
#include "luxel/patch/make_patches.h"
#include "luxel/scene/luminous_efficacy.h"

#include "support/axes.h"
#include "support/daylight_rooms.h"
#include "support/glass_panes.h"
#include "support/probe_rig.h"
#include "support/three_errors.h"

namespace luxel {
namespace {

using test::cie171_sky;
using test::down;
using test::expect_truth;
using test::facade_2x1;
using test::facade_4x3;
using test::north;
using test::Opening;
using test::ProbeRig;
using test::roof_1x1;
using test::roof_4x4;
using test::south;
using test::up;
using test::WithError;
using truth::SceneBuilder;

constexpr double sky_lux = 10'000.0, patch_size = 5e-4, max_error = 6e-4;
constexpr float glass_transmittance = 0.88f;  // at normal incidence

// 5.5: a sun that shines through a pane on a surface that faces it. In per cent of the transmittance at
// normal incidence, at angles of incidence of 0, 10 ... 80 degrees: Fresnel's amplitudes with the geometric
// series, and Snell's angles with the sum of the rays that leave the pane.
TEST(Cie171Case5_5, clear_glass_has_its_directional_transmittance) {
  SceneBuilder b;
  b.material("glass", 0.0f, 0.0f).quad({-9, -9, 1}, {9, -9, 1}, {9, 9, 1}, {-9, 9, 1});
  b.material("floor", 0.0f, 0.0f).quad({-9, -9, -9}, {9, -9, -9}, {9, 9, -9}, {-9, 9, -9});
  auto scene = b.scene();
  truth::make_pane(scene, "glass", Vec3(glass_transmittance));
  constexpr std::array<double, 9> percent = {100.0,     99.969266, 99.842361, 99.48951, 98.586541,
                                             96.353018, 90.894122, 77.71051,  48.130247};
  for (std::size_t i = 0; i < percent.size(); ++i) {
    const auto angle = static_cast<double>(i) * std::numbers::pi / 18.0;
    PointLight light;
    light.kind = PointLightKind::directional;
    light.direction = {static_cast<float>(std::sin(angle)), 0, -static_cast<float>(std::cos(angle))};
    light.intensity = Vec3(static_cast<float>(sky_lux / luminous_efficacy));
    scene.point_lights = {light};
    const ProbeRig rig(scene, no_max_edge, 0.0f);
    const auto lux = rig.at({0, 0, 0}, -light.direction).illuminance;
    EXPECT_NEAR(lux / (sky_lux * double{glass_transmittance}), 0.01 * percent[i], 1e-5) << 10 * i;
  }
}

// Percentages of the illuminance of open ground.
using Wall = std::array<double, 6>;   // A to F, 0.25 m below the ceiling to 0.25 m above the floor
using Level = std::array<double, 8>;  // G to N on the floor, G' to N' on the ceiling

// Compares the light of points in a black room under a sky with the truth.
class Room {
 public:
  Room(const SceneBuilder& builder, const Daylight& daylight) : rig_(made(builder, daylight), 0.0f) {}
  void hold(const std::string& label, const Vec3& at, const Vec3& normal, double percent) const {
    const auto measure = [&](std::uint64_t seed) {
      const auto light = rig_.at(at, normal, {.error = 5e-4, .max_rays = 1u << 20, .seed = seed});
      const auto error = 100.0 * light.standard_error() / sky_lux;
      EXPECT_LT(error, max_error * percent) << label;
      return WithError{100.0 * light.illuminance / sky_lux, error};
    };
    expect_truth(measure, percent, patch_size * percent, label);
  }

 private:
  static PatchSet made(const SceneBuilder& builder, const Daylight& daylight) {
    auto scene = builder.scene();
    truth::make_pane(scene, "glass", Vec3(glass_transmittance));
    set_daylight(daylight, up, scene);
    auto patches = make_patches(scene, {.max_edge = no_max_edge});
    set_portals(scene, patches, Context(2));
    return patches;
  }
  ProbeRig rig_;
};

std::string label(const char* letters, std::size_t i, int type) {
  return fmt::format("{}, type {}", letters[i], type);
}

// The points A to F are on the wall y = 0, G to N on the floor away from it. The sun stands in front of this
// wall.
void hold_roof(const SceneBuilder& builder, int type, const Wall& wall, const Level& floor) {
  const Room room(builder, cie171_sky(type, 0.0));
  for (std::size_t i = 0; i < wall.size(); ++i)
    room.hold(label("ABCDEF", i, type), {2, 0, 2.75f - 0.5f * static_cast<float>(i)}, north, wall[i]);
  for (std::size_t i = 0; i < floor.size(); ++i)
    room.hold(label("GHIJKLMN", i, type), {2, 0.25f + 0.5f * static_cast<float>(i), 0}, up, floor[i]);
}

SceneBuilder glazed_roof(const Opening& o) {
  auto b = test::roof_room(o);
  b.material("glass", 0.0f, 0.0f);
  return b.quad({o.u0, o.v0, 3}, {o.u1, o.v0, 3}, {o.u1, o.v1, 3}, {o.u0, o.v1, 3});
}

TEST(Cie171Case5_9, an_open_roof) {
  const auto room = test::roof_room(roof_4x4);
  hold_roof(room, 16, {37.355334, 32.144491, 26.723778, 21.745383, 17.501773, 14.031821},
            {31.346678, 36.73994, 40.681589, 42.735924, 42.735924, 40.681589, 36.73994, 31.346678});
  hold_roof(room, 5, {45.122604, 35.900505, 27.991624, 21.638511, 16.716315, 12.967372},
            {26.795188, 30.938711, 33.975719, 35.566592, 35.566592, 33.975719, 30.938711, 26.795188});
  hold_roof(room, 12, {67.278176, 54.425324, 44.200544, 36.072187, 29.52158, 24.195474},
            {42.283113, 43.882418, 43.493062, 40.915065, 35.900451, 29.225447, 22.574258, 16.804471});
}

TEST(Cie171Case5_9, a_roof_opening_of_1_m) {
  const auto room = test::roof_room(roof_1x1);
  hold_roof(room, 12, {1.7430954, 3.7569566, 4.5466642, 4.6093917, 4.23993, 3.6333844},
            {5.7225874, 6.0048155, 5.1131773, 3.9680372, 2.8972835, 2.0345186, 1.4022746, 0.96470794});
  hold_roof(room, 13, {1.6065712, 3.7595624, 4.8668215, 5.164719, 4.8904261, 4.2638831},
            {6.7588314, 7.0052927, 5.7855198, 4.3015556, 2.9833827, 1.9850511, 1.302109, 0.86000808});
}

TEST(Cie171Case5_10, glazed_roof_openings) {
  hold_roof(glazed_roof(roof_1x1), 12, {0.57720487, 2.652837, 3.7151242, 3.9281696, 3.6696739, 3.1660821},
            {5.008301, 5.2701601, 4.4950874, 3.4908846, 2.549042, 1.7889424, 1.2311429, 0.84445104});
  hold_roof(glazed_roof(roof_4x4), 16, {27.486333, 25.443211, 22.047811, 18.366265, 14.98757, 12.118264},
            {27.384804, 32.156978, 35.646564, 37.466024, 37.466024, 35.646564, 32.156978, 27.384804});
}

// The points A to F are on the wall y = 4, opposite the façade y = 0; G to N on the floor and G' to N' on the
// ceiling, from this wall to the façade. The sun stands in front of the façade.
void hold_facade(const SceneBuilder& builder, int type, const Wall& wall, const Level& floor,
                 const Level& ceiling) {
  const Room room(builder, cie171_sky(type, 180.0));
  for (std::size_t i = 0; i < wall.size(); ++i)
    room.hold(label("ABCDEF", i, type), {2, 4, 2.75f - 0.5f * static_cast<float>(i)}, south, wall[i]);
  for (std::size_t i = 0; i < floor.size(); ++i) {
    const auto y = 3.75f - 0.5f * static_cast<float>(i);
    room.hold(label("GHIJKLMN", i, type), {2, y, 0}, up, floor[i]);
    room.hold(label("GHIJKLMN", i, type) + ", ceiling", {2, y, 3}, down, ceiling[i]);
  }
}

SceneBuilder glazed_facade(const Opening& o) {
  auto b = test::facade_room(o);
  b.material("glass", 0.0f, 0.0f);
  return b.quad({o.u0, 0, o.v0}, {o.u1, 0, o.v0}, {o.u1, 0, o.v1}, {o.u0, 0, o.v1});
}

TEST(Cie171Case5_11, a_facade_opening_of_2_x_1_m) {
  const auto room = test::facade_room(facade_2x1);
  // By the ground alone, under any sky.
  const Level ceiling = {0.3796719, 0.52622174, 0.74635043, 1.077466,
                         1.555363,  2.1340764,  2.3978559,  1.2384196};
  hold_facade(room, 16, {0.95068225, 1.0630323, 1.2744236, 1.705621, 2.0587488, 2.1425314},
              {0.94491074, 1.3758135, 2.0662555, 3.1875835, 4.9660296, 7.4213587, 9.1115324, 5.0372251},
              ceiling);
  hold_facade(room, 12, {0.95068225, 1.0630323, 2.3840402, 4.930544, 5.8050878, 5.0116749},
              {1.9966869, 2.7954624, 4.0585102, 6.1257386, 9.5358288, 14.556572, 16.367948, 5.0264413},
              ceiling);
}

TEST(Cie171Case5_11, an_open_facade) {
  hold_facade(test::facade_room(facade_4x3), 14,
              {8.8749797, 15.55431, 20.238246, 23.790788, 26.575972, 28.780381},
              {10.118846, 13.442278, 18.216518, 25.093315, 34.722158, 46.376816, 58.043417, 68.485328},
              {1.7361818, 2.2880623, 3.0571452, 4.1316745, 5.6217322, 7.6396475, 10.244362, 13.347462});
}

TEST(Cie171Case5_12, glazed_facade_openings) {
  hold_facade(glazed_facade(facade_2x1), 12,
              {0.83540067, 0.93486962, 2.0974261, 4.3375081, 5.1052598, 4.4039897},
              {1.7525061, 2.4507925, 3.5508634, 5.337947, 8.2340733, 12.264802, 12.687425, 2.1604104},
              {0.33324265, 0.46135313, 0.6530487, 0.93910738, 1.3437811, 1.7997952, 1.8477424, 0.52490956});
  hold_facade(glazed_facade(facade_4x3), 16, {4.6054928, 5.6756881, 6.773677, 7.7598146, 8.5341775, 9.057965},
              {3.9307222, 5.3563162, 7.4013301, 10.320637, 14.384948, 19.689527, 25.63456, 30.066489},
              {1.5185953, 1.9963762, 2.6566368, 3.5652683, 4.7885247, 6.3424571, 8.055954, 9.3301773});
}

}  // namespace
}  // namespace luxel
