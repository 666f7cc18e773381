// SPDX-License-Identifier: Apache-2.0
#include "luxel/trace/open_space.h"

#include <algorithm>
#include <vector>

#include "luxel/core/address.h"
#include "luxel/patch/side.h"
#include "luxel/trace/start_sides.h"

namespace luxel {
namespace {

// In a room whose window is a thousandth of its walls, one path in twenty escapes, so two looks in three of
// those in the room detect it: enough for the room.
constexpr std::uint32_t paths = 24;
constexpr std::uint32_t path_rays = 48;

bool is_light(const PatchSet& patches, SideId side) {
  if (side == Panorama::escaped) return patches.has_sky();
  return side != Panorama::absorbed && !side.is_back() && patches.material_of(side.patch()).is_lamp();
}

class Paths {
 public:
  Paths(const PatchSet& patches, const Tracer& tracer, std::span<const Vec3> eyes)
      : patches_(patches), tracer_(tracer), points_(eyes.begin(), eyes.end()) {
    for (const auto& lamp : patches.point_lights) {
      if (lamp.light.kind == PointLightKind::directional)
        towards_.push_back(-lamp.light.direction);
      else
        points_.push_back(lamp.light.position);
    }
  }

  bool has_points() const { return !points_.empty() || !towards_.empty(); }

  // Returns whether a punctual light or an eye is visible from the point.
  bool sees_point(const Vec3& from) const {
    for (const auto& to : points_) {
      const auto line = to - from;
      const auto distance = glm::length(line);
      if (!(distance > 0.0f) || !tracer_.occluded({from, line / distance}, distance)) return true;
    }
    return std::any_of(towards_.begin(), towards_.end(), [&](const Vec3& d) {
      return !tracer_.nearest({from, d});
    });
  }

  bool finds_light(SideId side, std::uint64_t key) const {
    for (std::uint32_t i = 0; i < path_rays && Panorama::is_side(side); ++i) {
      const auto ray = ray_from_side(patches_, side, uniform4(key, i));
      if (has_points() && sees_point(ray.origin)) return true;
      side = side_met(patches_, tracer_.nearest(ray));
      if (is_light(patches_, side)) return true;
      if (Panorama::is_side(side) && passes_diffuser(side, key, i)) side = side.opposite();
    }
    return false;
  }

 private:
  // Returns true at random for half of the times that a path meets a diffuser.
  bool passes_diffuser(SideId side, std::uint64_t key, std::uint32_t ray) const {
    return patches_.material_of(side.patch()).is_diffuser() && uniform4(key, path_rays + ray)[0] < 0.5f;
  }

  const PatchSet& patches_;
  const Tracer& tracer_;
  std::vector<Vec3> points_, towards_;
};

}  // namespace

bool is_open_space(const PatchSet& patches, const Tracer& tracer, const Panorama& look,
                   std::span<const Vec3> eyes, std::uint64_t key) {
  if (std::any_of(look.side.begin(), look.side.end(), [&](auto side) { return is_light(patches, side); }))
    return true;
  const Paths walk(patches, tracer, eyes);
  if (walk.has_points() && walk.sees_point(look.eye)) return true;
  for (std::uint32_t i = 0; i < paths && !look.side.empty(); ++i)
    if (walk.finds_light(look.side[i * look.side.size() / paths], stream_key(key, i, 0))) return true;
  return false;
}

}  // namespace luxel
