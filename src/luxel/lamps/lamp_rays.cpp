// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/lamp_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "luxel/core/none.h"
#include "luxel/core/trig.h"
#include "luxel/core/warp.h"
#include "luxel/lamps/lamp_choices.h"
#include "luxel/lamps/lamp_sample.h"

namespace luxel {

LampRays::LampRays(const PatchSet& patches, const Tracer& tracer, const Lamps& lamps,
                   bool multiple_importance)
    : tracer_(tracer),
      lamps_(lamps),
      multiple_importance_(multiple_importance),
      tree_(lamps),
      portals_(patches),
      panes_(patches),
      punctual_(patches),
      sky_patches_(patches.sky_patches) {
  for (const auto& lamp : lamps.triangles()) lift_.push_back(origin_lift(lamp.corner));
}

// Both ends are lifted off their planes by the bound on rounding. The lamp's own triangle therefore stays
// behind the end of the ray, at grazing angles and at short distances too.
void LampRays::look(const Vec3& from, const Vec3d& to, float min_lift, LampTerm& term) const {
  const auto& triangle = lamps_.triangles()[term.lamp];
  const auto lift = triangle.is_portal() ? 0.0 : static_cast<double>(std::max(min_lift, lift_[term.lamp]));
  const auto way = to + lift * triangle.normal - Vec3d(from);
  const auto length = glm::length(way);
  if (!(length > 0.0)) {
    term.seen = triangle.is_portal() ? 0.0 : 1.0;
    return;
  }
  const Ray ray{from, Vec3(way / length)};
  const auto distance =
      triangle.is_portal() ? std::numeric_limits<float>::infinity() : static_cast<float>(length);
  const bool visible =
      triangle.is_portal() ? sky_is_visible(ray, triangle.portal) : !tracer_.occluded(ray, distance);
  if (visible) look_through_panes(ray, distance, term);
}

void LampRays::look_through_panes(const Ray& ray, float distance, LampTerm& term) const {
  const auto through = panes_.along(ray, distance);
  term.seen = panes_.luminous(through);
  if (panes_.is_tinted()) term.of_band = through;
}

// Only the first of several portals on a line counts, so that each line counts once.
bool LampRays::sky_is_visible(const Ray& ray, std::uint32_t portal_side) const {
  return !tracer_.occluded(ray, std::numeric_limits<float>::infinity()) &&
         portals_.first_crossed(ray) == portal_side;
}

// Returns the sky patch behind a portal in that direction; 0 for other lamps.
std::uint32_t LampRays::sky_patch(std::uint32_t lamp, const Vec3d& direction) const {
  return lamps_.triangles()[lamp].is_portal() ? static_cast<std::uint32_t>(sky_patches_.patch_of(direction))
                                              : 0;
}

// Sample towards a chosen lamp.
LampTerm LampRays::towards_lamp(const LampRayOrigin& origin, const LampChoices& choices,
                                const std::array<float, 2>& u, LampRayEnds* ends) const {
  const auto& [from, normal, lift] = origin;
  const auto [choice, chosen] = choices.choose(tree_, from, normal, static_cast<double>(u[0]));
  if (!(chosen.probability > 0.0)) return {};
  if (chosen.lamp == none)
    return towards_ball(origin, choices, choice, {chosen.rest, static_cast<double>(u[1])}, ends);
  const auto sample =
      sample_lamp(lamps_.triangles()[chosen.lamp], Vec3d(from), chosen.rest, static_cast<double>(u[1]));
  const auto cosine = glm::dot(Vec3d(normal), sample.direction);
  if (!(sample.density > 0.0) || !(cosine > 0.0)) return {};
  const auto to = Vec3d(from) + sample.distance * sample.direction;
  if (ends != nullptr) *ends = {from, Vec3(to)};
  LampTerm term{.choice = choice,
                .lamp = chosen.lamp,
                .sky_patch = sky_patch(chosen.lamp, sample.direction),
                .given = given(cosine, sample.density * chosen.probability),
                .rays = 1};
  look(from, to, lift, term);
  return term;
}

// Sample towards the bounding sphere of a bulb, uniform in solid angle; the hit determines the facet.
LampTerm LampRays::towards_ball(const LampRayOrigin& origin, const LampChoices& choices, std::size_t choice,
                                const std::array<double, 2>& u, LampRayEnds* ends) const {
  const auto& from = origin.position;
  const auto& branch = choices.branch(choice);
  const auto ball = tree_.sphere(branch);
  const auto to = Vec3d(ball.centre) - Vec3d(from);
  const auto sine2 = static_cast<double>(ball.radius) * ball.radius / glm::dot(to, to);
  const auto width = sine2 / (1.0 + std::sqrt(1.0 - sine2));  // 1 - cosine of the cone's half angle
  const auto away = u[0] * width;
  const auto sine = std::sqrt(away * (2.0 - away));
  const auto turn = sin_cos(2.0 * std::numbers::pi * u[1]);
  const Frame frame(Vec3(glm::normalize(to)));
  const auto direction = glm::normalize(
      frame.to_world(Vec3(static_cast<float>(sine * turn.cosine), static_cast<float>(sine * turn.sine),
                          static_cast<float>(1.0 - away))));
  const auto cosine = static_cast<double>(glm::dot(origin.normal, direction));
  if (!(cosine > 0.0)) return {};
  const auto hit = tracer_.nearest({from, direction});
  const auto lamp = hit && !hit.back ? lamps_.lamp_at(hit.patch, from + hit.distance * direction) : none;
  if (lamp == none || !tree_.holds(branch, lamp)) return {.rays = 1};
  if (ends != nullptr) *ends = {from, from + hit.distance * direction};
  const auto density = choices.probability(choice) / (2.0 * std::numbers::pi * width);
  LampTerm term{.choice = choice, .lamp = lamp, .given = given(cosine, density), .rays = 1};
  look_through_panes({from, direction}, hit.distance, term);
  return term;
}

// Cosine ray, which may hit a lamp.
LampTerm LampRays::along(const Ray& ray, const Vec3& normal, const LampChoices& choices,
                         LampRayEnds* ends) const {
  const auto hit = tracer_.nearest(ray);
  auto lamp = hit && !hit.back ? lamps_.lamp_at(hit.patch, ray.origin + hit.distance * ray.direction) : none;
  if (!hit && !portals_.empty()) lamp = lamps_.lamp_of_portal(portals_.first_crossed(ray));
  const auto cosine = static_cast<double>(glm::dot(normal, ray.direction));
  if (lamp == none || !(cosine > 0.0)) return {.rays = 1};
  const auto found = choices.find(tree_, lamp, ray.origin, normal);
  const auto density = lamp_density(lamps_.triangles()[lamp], Vec3d(ray.origin), Vec3d(ray.direction));
  const auto length = hit ? hit.distance : portals_.distance(ray);
  if (ends != nullptr) *ends = {ray.origin, ray.origin + length * ray.direction};
  LampTerm term{.choice = found.choice,
                .lamp = lamp,
                .sky_patch = sky_patch(lamp, Vec3d(ray.direction)),
                .given = given(cosine, density * found.lamp.probability),
                .rays = 1};
  look_through_panes(ray, hit.distance, term);
  return term;
}

// The balance heuristic (Veach and Guibas 1995) divides both by the sum of the two densities.
double LampRays::given(double cosine, double lamp_density) const {
  return cosine / (lamp_density + (multiple_importance_ ? cosine / std::numbers::pi : 0.0));
}

}  // namespace luxel
