// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/view_candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "luxel/core/address.h"
#include "luxel/core/discrete_distribution.h"
#include "luxel/core/warp.h"
#include "luxel/patch/side.h"
#include "luxel/render/pinhole.h"
#include "luxel/render/side_point.h"

namespace luxel {
namespace {

constexpr std::size_t places = 288;
constexpr std::size_t openness_rays = 4096;
constexpr int turns_inside = 12;
constexpr int turns_outside = 16;
constexpr float pitch_inside = -0.02f;      // of a full turn: 7 degrees downwards
constexpr double half_height_inside = 0.5;  // tangent of half the vertical field of view, for a 4:3 picture
constexpr double half_height_outside = 0.36;
constexpr float eye_level = 0.55f;  // fraction of the height between floor and ceiling

// The half height for which portrait and landscape pictures cover about the same solid angle.
double half_height(double of_4_to_3, float aspect) {
  return of_4_to_3 * std::sqrt(4.0 / 3.0 / static_cast<double>(aspect));
}

float degrees_of(double half_height_tangent) {
  return static_cast<float>(2.0 * std::atan(half_height_tangent) * 180.0 / std::numbers::pi);
}

// Draws lit sides with probability in proportion to a weight, stratified over the list.
std::vector<SideId> draw_sides(const Subject& subject, std::size_t count, bool by_area) {
  DiscreteDistribution sides;
  for (std::size_t i = 0; i < subject.sides.brightness.size(); ++i) {
    const auto side = SideId::at(i);
    const auto weight = by_area ? static_cast<double>(subject.patches.area[side.patch()]) : 1.0;
    sides.add(subject.sides.lit(side) ? weight : 0.0);
  }
  std::vector<SideId> drawn;
  for (std::size_t i = 0; i < count && sides.total() > 0.0; ++i) {
    const auto at = sides.total() * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    drawn.push_back(SideId::at(sides.at(at)));
  }
  return drawn;
}

// A point between the side and the surface opposite, then moved to eye level.
Vec3 place_before(const Subject& subject, SideId side, std::uint64_t sample) {
  const auto random =
      uniform4({.seed = 0, .step = step_of(RandomPurpose::view_candidates), .element = 0, .sample = sample});
  const auto point = point_before(subject.patches, side, random[0], random[1]);
  const auto normal = subject.patches.normal_of(side);
  const auto free = std::min(subject.tracer.nearest({point, normal}).distance, 0.5f * subject.diagonal);
  const auto eye = point + (0.08f + 0.84f * random[2]) * free * normal;

  const auto below = subject.tracer.nearest({eye, -subject.up}).distance;
  const auto above = subject.tracer.nearest({eye, subject.up}).distance;
  if (!std::isfinite(below) || !std::isfinite(above)) return eye;
  return eye + (eye_level * (below + above) - below) * subject.up;
}

// The distance from the centre of the box at which the whole box is in the picture.
float fitting_distance(const Subject& subject, const Camera& direction) {
  const auto forward = glm::normalize(direction.target - direction.eye);
  const auto right = glm::normalize(glm::cross(forward, subject.up));
  const auto above = glm::cross(right, forward);
  const auto half = 0.5f * subject.box.size();
  const auto tangent =
      static_cast<float>(tangent_of_degrees(0.5 * static_cast<double>(direction.vertical_fov)));
  float distance = 0.0f;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 c(corner & 1 ? half.x : -half.x, corner & 2 ? half.y : -half.y, corner & 4 ? half.z : -half.z);
    const auto sideways = std::abs(glm::dot(c, right)) / (tangent * subject.aspect);
    const auto upwards = std::abs(glm::dot(c, above)) / tangent;
    distance = std::max(distance, std::max(sideways, upwards) - glm::dot(c, forward));
  }
  return distance;
}

}  // namespace

Camera camera_of(const View& view, const Vec3& up, float distance) {
  const Frame frame(up);
  const auto around = on_circle(view.turn);
  const auto rise = on_circle(view.pitch);
  const auto forward = rise.x * (around.x * frame.s + around.y * frame.t) + rise.y * frame.n;
  return {view.eye, view.eye + distance * forward, up, view.vertical_fov};
}

double openness(const Subject& subject) {
  const auto sides = draw_sides(subject, openness_rays, true);
  std::size_t free = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const auto random =
        uniform4({.seed = 0, .step = step_of(RandomPurpose::view_directions), .element = 0, .sample = i});
    const auto start = point_before(subject.patches, sides[i], random[0], random[1]);
    const auto direction =
        Frame(subject.patches.normal_of(sides[i])).to_world(cosine_hemisphere(random[2], random[3]));
    if (!subject.tracer.nearest({start, direction})) ++free;
  }
  return sides.empty() ? 1.0 : static_cast<double>(free) / static_cast<double>(sides.size());
}

std::vector<std::vector<View>> views_from_inside(const Subject& subject) {
  // Half of the places are drawn by area and half by number of sides, so that finely modelled parts of a
  // large hall are included.
  auto sides = draw_sides(subject, places / 2, true);
  const auto more = draw_sides(subject, places / 2, false);
  sides.insert(sides.end(), more.begin(), more.end());

  const auto fov = degrees_of(half_height(half_height_inside, subject.aspect));
  std::vector<std::vector<View>> all;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const auto eye = place_before(subject, sides[i], i);
    auto& views = all.emplace_back();
    for (int k = 0; k < turns_inside; ++k)
      views.push_back({eye, static_cast<float>(k) / turns_inside, pitch_inside, fov});
  }
  return all;
}

std::vector<std::vector<View>> views_from_outside(const Subject& subject) {
  const auto fov = degrees_of(half_height(half_height_outside, subject.aspect));
  std::vector<std::vector<View>> all;
  for (int k = 0; k < turns_outside; ++k) {
    auto& views = all.emplace_back();
    for (const auto pitch : {0.0f, -0.03f, -0.06f}) {
      for (const auto crop : {1.0f, 0.85f}) {
        View view{subject.box.center(), static_cast<float>(k) / turns_outside, pitch, fov};
        const auto camera = camera_of(view, subject.up, subject.diagonal);
        const auto backwards = glm::normalize(camera.eye - camera.target);
        view.eye += crop * fitting_distance(subject, camera) * backwards;
        views.push_back(view);
      }
    }
  }
  return all;
}

}  // namespace luxel
