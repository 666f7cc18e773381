// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/sky_reach.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "luxel/core/address.h"
#include "luxel/patch/side.h"
#include "luxel/trace/look_around.h"
#include "luxel/trace/start_sides.h"

namespace luxel {
namespace {

constexpr std::size_t starts = 1024;
constexpr std::size_t max_cameras = 8;
constexpr std::size_t camera_grid = 8;  // 128 directions per camera
constexpr std::uint32_t path_rays = 32;
constexpr std::uint32_t paths_per_side = 4;  // of a triangle that may be hidden
constexpr double mostly = 0.5;

constexpr std::uint32_t of_fronts = 0, of_triangles = 1, of_cameras = 2;  // streams

class Reach {
 public:
  Reach(const PatchSet& patches, const Tracer& tracer, const Context& context)
      : patches_(patches), tracer_(tracer), context_(context) {}

  double of_cameras_view() const {
    const auto eyes = patches_.eyes();
    const auto cameras = std::min(eyes.size(), max_cameras);
    const LookGrid grid(camera_grid);
    return fraction(cameras * grid.cells(), of_cameras, [&](std::size_t i, std::uint64_t key) {
      const auto cell = i % grid.cells();
      const auto side =
          side_met(patches_, tracer_.nearest({eyes[i / grid.cells()], grid.direction(cell, 0.5f, 0.5f)}));
      return finds_sky(side, key);
    });
  }

  double of_surface_fronts() const {
    const StartSides sides(patches_, {});
    if (sides.empty()) return 0.0;
    return fraction(starts, of_fronts, [&](std::size_t i, std::uint64_t key) {
      const auto u = (static_cast<float>(i) + uniform4(key, 0)[0]) / static_cast<float>(starts);
      return finds_sky(SideId(sides.pick(u).patch(), false), key);
    });
  }

  // Returns whether most triangles are reached on one side or the other. Asks few of them where these agree:
  // rays are slow where triangles pierce one another.
  bool of_most_triangles() const {
    constexpr std::size_t few = 64, most = 256;
    constexpr double clearly = 0.3;  // from `mostly`: nearly five standard deviations of `few`
    const auto rough = of_triangles_spread(std::min(patches_.size(), few));
    if (std::abs(rough - mostly) > clearly) return rough > mostly;
    return of_triangles_spread(std::min(patches_.size(), most)) >= mostly;
  }

  double of_triangles_spread(std::size_t count) const {
    return fraction(count, of_triangles, [&](std::size_t i, std::uint64_t key) {
      const auto patch = static_cast<std::uint32_t>(i * patches_.size() / count);
      for (std::uint32_t n = 0; n < 2 * paths_per_side; ++n)
        if (finds_sky(SideId(patch, n % 2 == 1), nth_key(key, n))) return true;
      return false;
    });
  }

 private:
  // Follows cosine rays from the side, as if each surface reflected all light.
  bool finds_sky(SideId side, std::uint64_t key) const {
    for (std::uint32_t i = 1; i <= path_rays && Panorama::is_side(side); ++i)
      side = side_met(patches_, tracer_.nearest(ray_from_side(patches_, side, uniform4(key, i))));
    return side == Panorama::escaped;
  }

  template <typename Found>
  double fraction(std::size_t count, std::uint32_t stream, const Found& found) const {
    std::vector<std::uint8_t> is_found(count, 0);
    context_.for_chunks(count, 16, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = begin; i < end; ++i)
        is_found[i] =
            found(i, stream_key(seed_of(RandomSeed::sky_reach), stream, static_cast<std::uint32_t>(i)));
    });
    return static_cast<double>(std::count(is_found.begin(), is_found.end(), 1)) /
           static_cast<double>(std::max<std::size_t>(1, count));
  }

  const PatchSet& patches_;
  const Tracer& tracer_;
  const Context& context_;
};

}  // namespace

double sky_reach(const PatchSet& patches, const Tracer& tracer, const Context& context) {
  const Reach reach(patches, tracer, context);
  if (!patches.cameras.empty()) return reach.of_cameras_view();
  return reach.of_most_triangles() ? reach.of_surface_fronts() : 0.0;
}

}  // namespace luxel
