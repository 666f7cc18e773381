// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/portal_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "luxel/core/address.h"
#include "luxel/core/warp.h"

namespace luxel {
namespace {

constexpr std::uint32_t trial_rays = 64;  // per portal
constexpr double min_seen = 0.01;         // of the sky, so that no portal is left out by bad luck

// Normal times twice the area.
Vec3d area_vector(const std::array<Vec3, 3>& corner) {
  return glm::cross(Vec3d(corner[1]) - Vec3d(corner[0]), Vec3d(corner[2]) - Vec3d(corner[0]));
}

Vec3 point_on(const std::array<Vec3, 3>& corner, float u1, float u2) {
  const auto at = uniform_triangle(u1, u2);
  return corner[0] + at.x * (corner[1] - corner[0]) + at.y * (corner[2] - corner[0]);
}

}  // namespace

PortalTable::PortalTable(const PatchSet& patches, const Tracer& tracer) : portals_(patches) {
  if (patches.portals.empty()) return;
  auto low = patches.portals.front().corner[0];
  auto high = low;
  for (const auto& portal : patches.portals) {
    corners_.push_back(portal.corner);
    for (const auto& corner : portal.corner) low = glm::min(low, corner), high = glm::max(high, corner);
  }
  centre_ = 0.5f * (low + high);
  radius_ = glm::length(high - centre_);
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const auto outwards = -area_vector(corners_[i]);
    const auto key = stream_key(0, RandomPurpose::portals, static_cast<std::uint32_t>(i));
    std::uint32_t open = 0;
    for (std::uint32_t r = 0; r < trial_rays; ++r) {
      const auto u = uniform4(key, r);
      const Ray ray{point_on(corners_[i], u[0], u[1]),
                    Frame(Vec3(glm::normalize(outwards))).to_world(cosine_hemisphere(u[2], u[3]))};
      const auto last = last_crossed(ray);
      if ((!last || last->portal == i) && !tracer.occluded(ray, std::numeric_limits<float>::infinity()))
        ++open;
    }
    by_sky_.add(0.5 * glm::length(outwards) * std::max(min_seen, static_cast<double>(open) / trial_rays));
  }
}

// The first portal met on the way back from beyond all of them.
std::optional<PortalTable::Crossing> PortalTable::last_crossed(const Ray& ray) const {
  const auto far = glm::length(centre_ - ray.origin) + 2.0f * radius_;
  const auto hit = portals_.nearest({ray.origin + far * ray.direction, -ray.direction});
  if (!hit || !(hit.distance < far)) return std::nullopt;
  return Crossing{hit.patch, static_cast<double>(far) - static_cast<double>(hit.distance)};
}

std::optional<Ray> PortalTable::sample(const Vec3& from, const std::array<float, 3>& u) const {
  const auto chosen = by_sky_.choose(static_cast<double>(u[0]));
  const auto way = Vec3d(point_on(corners_[chosen], u[1], u[2])) - Vec3d(from);
  const auto distance = glm::length(way);
  if (!(distance > 0.0)) return std::nullopt;
  const Ray ray{from, Vec3(way / distance)};
  const auto last = last_crossed(ray);
  if (!last || last->portal != chosen) return std::nullopt;
  return ray;
}

double PortalTable::density(const Ray& ray) const {
  const auto last = last_crossed(ray);
  if (!last) return 0.0;
  const auto doubled = area_vector(corners_[last->portal]);
  const auto projected = 0.5 * std::abs(glm::dot(doubled, Vec3d(ray.direction)));  // m²
  if (!(projected > 0.0)) return 0.0;
  return by_sky_.weight(last->portal) / by_sky_.total() * last->distance * last->distance / projected;
}

}  // namespace luxel
