// SPDX-License-Identifier: Apache-2.0
#include "bench/reconstruction_scenes.h"

#include "luxel/core/trig.h"

#include "bench/mesher.h"
#include "bench/scenes.h"

namespace luxel::bench {
namespace {

constexpr std::size_t uncut = 1;  // requested triangles: the minimum
constexpr Vec3 room(4.0f, 3.0f, 2.4f);

void add_room(Mesher& mesher) {
  mesher.material("walls", {0.72f, 0.70f, 0.66f});
  mesher.box(Vec3(0.0f), room, true);
}

void add_lamp(Mesher& mesher, const Vec2& at) {
  mesher.material("lamp", Vec3(0.5f), Vec3(60.0f, 55.0f, 45.0f));
  const float half = 0.2f, z = room.z - 0.1f;
  mesher.quad({at.x - half, at.y - half, z}, {at.x - half, at.y + half, z}, {at.x + half, at.y + half, z},
              {at.x + half, at.y - half, z});
}

Scene wall_on_floor() {
  Mesher mesher;
  add_room(mesher);
  mesher.material("screen", {0.55f, 0.30f, 0.20f});
  mesher.quad({1.7f, 0.0f, 0.0f}, {1.9f, 2.2f, 0.0f}, {1.9f, 2.2f, 1.9f}, {1.7f, 0.0f, 1.9f});
  mesher.box({2.7f, 1.1f, 0.0f}, {3.2f, 1.8f, 0.6f});
  add_lamp(mesher, {0.9f, 1.4f});
  return mesher.take();
}

// Vertices of the ball and the column, the same bits for every facet they belong to.
Vec3 on_circle(const Vec3& middle, double radius, double z, int slice, int slices) {
  const auto turn = sin_cos(2.0 * std::numbers::pi * (slice % slices) / slices);
  return middle + Vec3(Vec3d(radius * turn.cosine, radius * turn.sine, z));
}

constexpr Vec3 ball_middle(2.6f, 1.2f, 0.9f);
constexpr float ball_radius = 0.5f;
constexpr Vec3 column_foot(1.0f, 2.1f, 0.0f);
constexpr float column_radius = 0.25f;

Scene ball_and_column() {
  constexpr int slices = 64, rings = 32;
  Mesher mesher;
  add_room(mesher);
  mesher.material("ball", {0.60f, 0.62f, 0.65f});
  const auto on_ball = [](int ring, int slice) {
    const auto lift = sin_cos(std::numbers::pi * (ring - rings / 2) / rings);
    const bool pole = ring == 0 || ring == rings;
    const double r = ball_radius;
    return on_circle(ball_middle, pole ? 0.0 : r * lift.cosine, r * lift.sine, slice, slices);
  };
  for (int ring = 0; ring < rings; ++ring)
    for (int s = 0; s < slices; ++s)
      mesher.quad(on_ball(ring, s), on_ball(ring, s + 1), on_ball(ring + 1, s + 1), on_ball(ring + 1, s));
  mesher.material("column", {0.60f, 0.62f, 0.65f});
  const auto on_column = [](int slice, double z) {
    return on_circle(column_foot, column_radius, z, slice, slices);
  };
  for (int s = 0; s < slices; ++s)
    mesher.quad(on_column(s, 0.0), on_column(s + 1, 0.0), on_column(s + 1, 2.4), on_column(s, 2.4));
  add_lamp(mesher, {1.4f, 0.6f});
  return mesher.take();
}

Vec3 facet_normal(const PatchSet&, std::size_t, const Vec3&, const Vec3& normal) { return normal; }

Vec3 round_normal(const PatchSet& patches, std::size_t patch, const Vec3& point, const Vec3& normal) {
  const auto& name = patches.material_of(patch).name;
  if (name != "ball" && name != "column") return normal;
  auto out = point - (name == "ball" ? ball_middle : column_foot);
  if (name == "column") out.z = 0.0f;
  out = glm::normalize(out);
  return glm::dot(out, normal) < 0.0f ? -out : out;
}

}  // namespace

std::vector<UncutScene> reconstruction_scenes() {
  return {{"Cornell box", cornell_box(uncut), facet_normal},
          {"office", office(uncut), facet_normal},
          {"two rooms", two_rooms(uncut), facet_normal},
          {"wall on floor", wall_on_floor(), facet_normal},
          {"ball and column", ball_and_column(), round_normal}};
}

}  // namespace luxel::bench
