// SPDX-License-Identifier: Apache-2.0
#include "luxel/trace/place_views.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "luxel/core/address.h"
#include "luxel/core/bounds.h"
#include "luxel/core/discrete_distribution.h"
#include "luxel/core/warp.h"
#include "luxel/patch/side.h"
#include "luxel/trace/collect_views.h"
#include "luxel/trace/look_around.h"
#include "luxel/trace/open_space.h"
#include "luxel/trace/place_weights.h"
#include "luxel/trace/start_sides.h"

namespace luxel {
namespace {

constexpr auto seed = seed_of(RandomSeed::views);  // views are independent of the seed of a solve
enum Stage : std::uint32_t { scout_start, scout_look, scout_path, view_start, view_look, eye_look };

constexpr float clearance_of_extent =
    0.03f;  // measured: without clearance, the insides of furniture dominate the error
constexpr float max_clearance = 0.3f;  // m; about the space that a person's head needs, in rooms of any size
constexpr double min_surface_fraction = 1.0 / 16.0;
constexpr double min_focus_fraction = 1.0 / 256.0;
constexpr int tries = 8;  // starts of a view per scout before the scout is skipped

// Directions of nearly equal solid angle in the picture: a grid on the picture plane.
Panorama look_through(const PatchSet& patches, const Tracer& tracer, const Camera& camera,
                      std::uint64_t key) {
  constexpr std::size_t width = 72, height = 54;
  const auto aspect = camera.aspect > 0.0f ? camera.aspect : 4.0f / 3.0f;
  const auto forward = glm::normalize(camera.target - camera.eye);
  const auto right = glm::normalize(glm::cross(forward, camera.up));
  const auto up = glm::cross(right, forward);
  const auto half = std::tan(0.5f * camera.vertical_fov * pi / 180.0f);
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < width * height; ++i) {
    const auto u = uniform4(key, i);
    const auto x = 2.0f * (static_cast<float>(i % width) + u[0]) / static_cast<float>(width) - 1.0f;
    const auto y = 2.0f * (static_cast<float>(i / width) + u[1]) / static_cast<float>(height) - 1.0f;
    rays.push_back({camera.eye, glm::normalize(forward + half * (x * aspect * right + y * up))});
  }
  std::vector<Hit> hits(rays.size());
  tracer.nearest(rays, hits);
  Panorama look{camera.eye, {}, {}};
  for (const auto& hit : hits) {
    look.side.push_back(side_met(patches, hit));
    look.distance.push_back(hit.distance);
  }
  return look;
}

class Placing {
 public:
  Placing(const PatchSet& patches, const Tracer& tracer, const Context& context, const ViewOptions& options)
      : patches_(patches),
        tracer_(tracer),
        context_(context),
        options_(options),
        grid_(options.grid),
        scout_grid_(options.scout_grid) {
    Bounds box;
    for (const auto& corners : patches.corners)
      for (const auto vertex : corners) box.add(patches.vertices[vertex]);
    extent_ = glm::length(box.size());
    clearance_ = std::min(clearance_of_extent * extent_, max_clearance);
  }

  ViewSets place() {
    send_scouts();
    const auto weights = place_weights(scouts_, tracer_, context_);
    ViewSets sets;
    sets.places = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (const auto is_stating : {0u, 1u}) {
      auto looks = look_from(weights, is_stating, sets.places);
      auto& views = is_stating ? sets.stating : sets.dealing;
      views = collect_views(patches_, looks, view_weights(looks, sets.places), looks_of_cameras());
    }
    return sets;
  }

 private:
  void send_scouts() {
    const StartSides starts(patches_, patches_.focus);
    if (starts.empty()) return;
    std::vector<std::optional<Panorama>> found(options_.scouts);
    context_.for_chunks(found.size(), 4, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = begin; i < end; ++i) {
        const auto element = static_cast<std::uint32_t>(i);
        const auto u = uniform4(stream_key(seed, scout_start, element), tries);
        const auto side = starts.pick((static_cast<float>(i) + u[0]) / static_cast<float>(found.size()));
        auto look = look_near(side, stream_key(seed, scout_start, element),
                              stream_key(seed, scout_look, element), scout_grid_);
        if (look &&
            is_open_space(patches_, tracer_, *look, patches_.eyes(), stream_key(seed, scout_path, element)))
          found[i] = std::move(look);
      }
    });
    for (auto& look : found)
      if (look) scouts_.push_back(std::move(*look));
  }

  // Looks around from a random point of a random cosine-distributed ray of the side; nothing if all tries end
  // too near a surface or see too little.
  std::optional<Panorama> look_near(SideId side, std::uint64_t start_key, std::uint64_t look_key,
                                    const LookGrid& grid) const {
    for (std::uint32_t t = 0; t < tries; ++t) {
      const auto ray = ray_from_side(patches_, side, uniform4(start_key, 2 * t + 100));
      const auto hit = tracer_.nearest(ray);
      if (side_met(patches_, hit) == Panorama::absorbed) continue;
      const auto length = std::min(hit.distance, 0.5f * extent_);
      const auto eye = ray.origin + uniform4(start_key, 2 * t + 101)[0] * length * ray.direction;
      if (!may_stand(eye)) continue;
      auto look = look_around(patches_, tracer_, eye, grid, look_key);
      if (look.clearance() >= clearance_ && look.surface_fraction() >= min_surface_fraction &&
          focus_fraction(look) >= min_focus_fraction)
        return look;
    }
    return {};
  }

  // Traces a few rays first, which reject most places without clearance before the whole view is traced.
  bool may_stand(const Vec3& eye) const {
    for (const auto& d :
         {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
      if (tracer_.occluded({eye, d}, clearance_)) return false;
    return true;
  }

  double focus_fraction(const Panorama& look) const {
    if (patches_.focus.empty()) return 1.0;
    const auto count = std::count_if(look.side.begin(), look.side.end(), [&](SideId side) {
      return Panorama::is_side(side) && patches_.focus[side.patch()] != 0;
    });
    return static_cast<double>(count) / static_cast<double>(look.side.size());
  }

  std::vector<Panorama> look_from(const std::vector<float>& weights, std::uint32_t is_stating,
                                  double places) {
    DiscreteDistribution scouts;
    for (const auto weight : weights) scouts.add(static_cast<double>(weight));
    const auto wanted =
        options_.min_views +
        static_cast<std::size_t>(std::max(0.0, places - 1.0) * static_cast<double>(options_.more_per_place));
    const auto count = scouts_.empty() ? 0 : std::min(options_.max_views, wanted);
    std::vector<std::optional<Panorama>> found(count);
    context_.for_chunks(count, 4, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = begin; i < end; ++i) {
        const auto element = 2 * static_cast<std::uint32_t>(i) + is_stating;
        const auto key = stream_key(seed, view_start, element);
        const auto u = uniform4(key, 0);
        const auto at = (static_cast<double>(i) + static_cast<double>(u[0])) / static_cast<double>(count);
        const auto side = side_seen(scouts_[scouts.choose(at)], u[1]);
        found[i] = look_near(side, key, stream_key(seed, view_look, element), grid_);
      }
    });
    std::vector<Panorama> looks;
    for (auto& look : found)
      if (look) looks.push_back(std::move(*look));
    const auto key = [&] { return stream_key(seed, eye_look, static_cast<std::uint32_t>(looks.size())); };
    for (const auto& eye : patches_.eyes())
      looks.push_back(look_around(patches_, tracer_, eye, grid_, key()));
    for (const auto& camera : patches_.cameras)
      looks.push_back(look_through(patches_, tracer_, camera, key()));
    return looks;
  }

  // Returns a random side that a look meets, in the focus if there is one.
  SideId side_seen(const Panorama& look, float u) const {
    std::vector<SideId> sides;
    for (const auto side : look.side)
      if (Panorama::is_side(side) && (patches_.focus.empty() || patches_.focus[side.patch()] != 0))
        sides.push_back(side);
    return sides[std::min(sides.size() - 1, static_cast<std::size_t>(u * static_cast<float>(sides.size())))];
  }

  std::size_t looks_of_cameras() const { return 2 * patches_.cameras.size(); }  // around, and of pictures

  std::vector<float> view_weights(const std::vector<Panorama>& looks, double places) const {
    const auto of_cameras = looks_of_cameras();
    const auto others = looks.size() - of_cameras;
    std::vector<float> weight(looks.size(), 1.0f);
    const auto place = others == 0 ? 1.0 : static_cast<double>(others) / std::max(1.0, places);
    std::fill(weight.begin() + static_cast<std::ptrdiff_t>(others), weight.end(),
              static_cast<float>(place / static_cast<double>(std::max<std::size_t>(1, of_cameras))));
    return weight;
  }

  const PatchSet& patches_;
  const Tracer& tracer_;
  const Context& context_;
  const ViewOptions& options_;
  LookGrid grid_, scout_grid_;
  float extent_ = 0.0f, clearance_ = 0.0f;  // m
  std::vector<Panorama> scouts_;
};

}  // namespace

ViewSets camera_views(const PatchSet& patches, const Tracer& tracer, const Context& context) {
  ViewSets sets;
  sets.places = 1.0;
  for (const auto is_stating : {0u, 1u}) {
    std::vector<Panorama> looks(patches.cameras.size());
    context.for_chunks(looks.size(), 1, [&](std::size_t i, std::size_t, int) {
      const auto element = 2 * static_cast<std::uint32_t>(i) + is_stating;
      looks[i] = look_through(patches, tracer, patches.cameras[i], stream_key(seed, eye_look, element));
    });
    (is_stating ? sets.stating : sets.dealing) =
        collect_views(patches, looks, std::vector<float>(looks.size(), 1.0f), looks.size());
  }
  return sets;
}

Views camera_view(const PatchSet& patches, const Tracer& tracer, const Camera& camera) {
  const std::vector<Panorama> looks{look_through(patches, tracer, camera, stream_key(seed, eye_look, 1))};
  return collect_views(patches, looks, std::vector{1.0f}, 1);
}

ViewSets place_views(const PatchSet& patches, const Tracer& tracer, const Context& context,
                     const ViewOptions& options) {
  if (patches.focuses_on_cameras) return camera_views(patches, tracer, context);
  return Placing(patches, tracer, context, options).place();
}

}  // namespace luxel
