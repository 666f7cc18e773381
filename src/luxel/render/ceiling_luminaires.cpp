// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/ceiling_luminaires.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "luxel/core/address.h"
#include "luxel/core/bounds.h"
#include "luxel/render/automatic_camera.h"

namespace luxel {
namespace {

constexpr std::size_t candidates = 512;  // points of the bounding box
constexpr std::size_t max_luminaires = 64;
constexpr double min_gain = 0.02;  // fraction of the points that a further luminaire must light
constexpr float clearance_of_extent = 0.03f;
constexpr float edge_of_width = 0.2f;
constexpr float min_edge_of_extent = 1e-3f;
constexpr float drop_of_edge = 0.02f;
constexpr double as_many = 0.9;  // of the points that a place sees, to be moved to their middle

class Placing {
 public:
  Placing(const PatchSet& patches, const Tracer& tracer, const Context& context)
      : tracer_(tracer), context_(context), up_(automatic_up(patches)), across_(glm::cross(up_, ahead_)) {
    Bounds box;
    for (const auto& corners : patches.corners)
      for (const auto vertex : corners) box.add(patches.vertices[vertex]);
    extent_ = glm::length(box.size());
    find_points(box);
  }

  std::vector<Luminaire> place() {
    std::vector<Luminaire> luminaires;
    while (luminaires.size() < max_luminaires) {
      const auto best = best_candidate();
      if (!best) break;
      const auto centred = luminaire_above(middle(best->sees));
      const auto sees = centred ? dark_points_seen(*centred) : std::vector<std::size_t>();
      const bool is_better =
          static_cast<double>(sees.size()) >= as_many * static_cast<double>(best->sees.size());
      const auto chosen = is_better ? Candidate{*centred, sees} : *best;
      for (const auto i : chosen.sees) is_lit_[i] = true;
      luminaires.push_back(chosen.luminaire);
    }
    return luminaires;
  }

 private:
  struct Candidate {
    Luminaire luminaire;
    std::vector<std::size_t> sees;  // points that see no other luminaire
  };

  // Random points of the box that are enclosed on all sides, away from any surface.
  void find_points(const Bounds& box) {
    std::vector<std::uint8_t> is_inside(candidates, 0);
    const auto at = [&](std::size_t i) {
      const auto u = uniform4(stream_key(seed_of(RandomSeed::luminaires), 0, 0), i);
      return box.low + Vec3(u[0], u[1], u[2]) * box.size();
    };
    context_.for_chunks(candidates, 16, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = begin; i < end; ++i) is_inside[i] = is_enclosed(at(i));
    });
    for (std::size_t i = 0; i < candidates; ++i)
      if (is_inside[i]) points_.push_back(at(i));
    is_lit_.assign(points_.size(), 0);
  }

  bool is_enclosed(const Vec3& at) const {
    const auto directions = {ahead_, -ahead_, across_, -across_, up_, -up_};
    return std::all_of(directions.begin(), directions.end(), [&](const Vec3& d) {
      const auto hit = tracer_.nearest({at, d});
      return hit && hit.distance > clearance_of_extent * extent_;
    });
  }

  std::optional<Candidate> best_candidate() const {
    std::vector<Candidate> found(points_.size());
    context_.for_chunks(points_.size(), 4, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = begin; i < end; ++i) {
        if (is_lit_[i]) continue;
        if (const auto luminaire = luminaire_above(points_[i]))
          found[i] = {*luminaire, dark_points_seen(*luminaire)};
      }
    });
    const auto best = std::max_element(found.begin(), found.end(), [](const auto& a, const auto& b) {
      return a.sees.size() < b.sees.size();
    });
    if (best == found.end() || static_cast<double>(best->sees.size()) <
                                   std::max(1.0, min_gain * static_cast<double>(points_.size())))
      return {};
    return *best;
  }

  Vec3 middle(const std::vector<std::size_t>& which) const {
    Vec3d sum(0.0);
    for (const auto i : which) sum += Vec3d(points_[i]);
    return Vec3(sum / static_cast<double>(which.size()));
  }

  // m to the nearest surface in a direction; nothing where there is none.
  std::optional<float> distance(const Vec3& from, const Vec3& direction) const {
    const auto hit = tracer_.nearest({from, direction});
    return hit ? std::optional(hit.distance) : std::nullopt;
  }

  std::optional<Luminaire> luminaire_above(const Vec3& point) const {
    float edge = std::numeric_limits<float>::infinity();
    for (const auto& axis : {ahead_, across_}) {
      const auto ahead = distance(point, axis), behind = distance(point, -axis);
      if (!ahead || !behind) return {};
      edge = std::min({edge, edge_of_width * (*ahead + *behind), *ahead, *behind});
    }
    if (edge < min_edge_of_extent * extent_) return {};
    // All corners below the ceiling, which may slope.
    const auto along = 0.5f * edge * ahead_, across = 0.5f * edge * across_;
    float height = std::numeric_limits<float>::infinity();
    for (const auto& offset : {Vec3(0.0f), along + across, along - across, -along - across, across - along}) {
      const auto ceiling = distance(point + offset, up_);
      if (!ceiling) return {};
      height = std::min(height, *ceiling);
    }
    height -= drop_of_edge * edge;
    if (height <= 0.0f) return {};
    const auto centre = point + height * up_;
    return Luminaire{centre + along + across, centre + along - across, centre - along - across,
                     centre - along + across};
  }

  std::vector<std::size_t> dark_points_seen(const Luminaire& luminaire) const {
    const auto from = 0.5f * (luminaire[0] + luminaire[2]) - 1e-4f * extent_ * up_;
    std::vector<std::size_t> seen;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (is_lit_[i]) continue;
      const auto line = points_[i] - from;
      const auto length = glm::length(line);
      if (glm::dot(line, up_) < 0.0f && !tracer_.occluded({from, line / length}, length)) seen.push_back(i);
    }
    return seen;
  }

  const Tracer& tracer_;
  const Context& context_;
  Vec3 ahead_ = Vec3(1.0f, 0.0f, 0.0f);
  Vec3 up_, across_;
  float extent_ = 0.0f;
  std::vector<Vec3> points_;
  std::vector<std::uint8_t> is_lit_;  // [point]
};

}  // namespace

std::vector<Luminaire> place_luminaires(const PatchSet& patches, const Tracer& tracer,
                                        const Context& context) {
  return Placing(patches, tracer, context).place();
}

void add_luminaires(const std::vector<Luminaire>& luminaires, const Vec3& flux, Scene& scene) {
  constexpr const char* called = "ceiling luminaire";
  if (!scene.objects.empty()) scene.objects.emplace_back(called);
  scene.groups.emplace_back(called);
  float area = 0.0f;
  for (const auto& c : luminaires) area += glm::length(glm::cross(c[1] - c[0], c[3] - c[0]));
  scene.materials.push_back({.name = called, .emittance = flux / area});
  for (const auto& luminaire : luminaires) {
    const auto first = static_cast<std::uint32_t>(scene.positions.size());
    scene.positions.insert(scene.positions.end(), luminaire.begin(), luminaire.end());
    for (const auto& corners : {std::array{0u, 1u, 2u}, std::array{0u, 2u, 3u}}) {
      scene.triangles.push_back({first + corners[0], first + corners[1], first + corners[2]});
      scene.triangle_material.push_back(MaterialId{static_cast<std::uint32_t>(scene.materials.size() - 1)});
      scene.triangle_line.push_back(0);
      scene.triangle_group.push_back(static_cast<std::uint32_t>(scene.groups.size() - 1));
      if (!scene.objects.empty())
        scene.triangle_object.push_back(static_cast<std::uint32_t>(scene.objects.size() - 1));
      for (auto& uvs : scene.uv_sets) uvs.push_back({});
      if (!scene.corner_colours.empty()) scene.corner_colours.push_back({Vec3(1.0f), Vec3(1.0f), Vec3(1.0f)});
      ++scene.added_triangles;
    }
  }
}

}  // namespace luxel
