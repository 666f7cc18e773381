// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/lamps.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "luxel/core/none.h"
#include "luxel/core/triangle.h"
#include "luxel/lamps/join_lamps.h"
#include "luxel/patch/side.h"

namespace luxel {
namespace {

constexpr double area_tolerance = 1e-4;    // relative; covers the rounding of split corners
constexpr double colour_tolerance = 1e-6;  // relative; covers the rounding of floats

// The triangle that patches [begin, end) of one input triangle fill: the point farthest from any point of a
// triangle is a corner, and the point farthest from a line through two corners is the third corner.
std::array<Vec3, 3> joined(const PatchSet& patches, std::size_t begin, std::size_t end) {
  Vec3d centre(0.0);
  for (auto p = begin; p < end; ++p)
    for (const auto& v : patches.points(p)) centre += Vec3d(v);
  centre /= 3.0 * static_cast<double>(end - begin);
  const auto farthest = [&](const auto& distance) {
    Vec3 best(0.0f);
    double most = -1.0;
    for (auto p = begin; p < end; ++p)
      for (const auto& v : patches.points(p))
        if (const auto d = distance(Vec3d(v)); d > most) {
          most = d;
          best = v;
        }
    return best;
  };
  const auto a = farthest([&](const Vec3d& v) { return glm::length(v - centre); });
  const auto b = farthest([&](const Vec3d& v) { return glm::length(v - Vec3d(a)); });
  const auto along = Vec3d(b) - Vec3d(a);
  const auto c = farthest([&](const Vec3d& v) { return glm::length(glm::cross(along, v - Vec3d(a))); });
  if (glm::dot(area_vector2(a, b, c), Vec3d(patches.normal[begin])) < 0.0) return {a, c, b};
  return {a, b, c};
}

// Returns whether all patches of the material emit equally.
bool shines_evenly(const BandMaterial& material) {
  return !material.textures.emittance && !material.textures.cutout;
}

bool shines(const PatchSet& patches, std::size_t patch) {
  for (std::size_t b = 0; b < patches.band_count(); ++b)
    if (patches.emittance(patch, b) > 0.0f) return true;
  return false;
}

// The lamps of the mesh: input triangles where patches of uniform emission fill them, else single patches.
struct Facets {
  std::vector<LampFacet> facets;
  std::vector<std::uint32_t> patches;    // all that emit
  std::vector<std::uint32_t> facet;      // [i], of patches[i]
  std::vector<std::size_t> first_patch;  // [facet]

  explicit Facets(const PatchSet& all) {
    for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
      for (end = begin + 1; end < all.size() && all.triangle[end] == all.triangle[begin] &&
                            all.material[end] == all.material[begin];)
        ++end;
      if (!all.material_of(begin).is_lamp()) continue;
      const auto area = std::accumulate(all.area.data() + begin, all.area.data() + end, 0.0);
      const auto whole = joined(all, begin, end);
      if (shines_evenly(all.material_of(begin)) &&
          std::fabs(triangle_area(whole[0], whole[1], whole[2]) - area) <= area_tolerance * area) {
        add(all, whole, begin, end);
      } else {
        for (auto p = begin; p < end; ++p) add(all, all.points(p), p, p + 1);
      }
    }
  }

 private:
  void add(const PatchSet& all, const std::array<Vec3, 3>& corner, std::size_t begin, std::size_t end) {
    if (!(triangle_area(corner[0], corner[1], corner[2]) > 0.0)) return;
    const auto material = static_cast<std::size_t>(all.material[begin]);
    // Textured emitters are surfaces of their own.
    const bool is_even = shines_evenly(all.materials[material]);
    if (!is_even && !shines(all, begin)) return;
    for (auto p = begin; p < end; ++p) {
      patches.push_back(static_cast<std::uint32_t>(p));
      facet.push_back(static_cast<std::uint32_t>(facets.size()));
    }
    facets.push_back({corner, is_even ? material : all.materials.size() + begin});
    first_patch.push_back(begin);
  }
};

// W/m² per band, averaged over a facet with holes: the emission of the remaining surface counts for the whole
// area.
std::vector<float> emittance_of(const PatchSet& patches, std::size_t patch) {
  std::vector<float> emittance;
  const auto [a, b, c] = patches.points(patch);
  const auto& material = patches.material_of(patch);
  const auto covered =
      material.textures.cutout ? patches.area[patch] / static_cast<float>(triangle_area(a, b, c)) : 1.0f;
  for (std::size_t band = 0; band < patches.band_count(); ++band)
    emittance.push_back(covered * patches.emittance(patch, band));
  return emittance;
}

}  // namespace

Lamps::Lamps(const PatchSet& patches)
    : lamp_of_patch_(patches.size(), none), bands_(patches.band_count()), groups_(patches.group_count()) {
  const Facets found(patches);
  std::vector<std::uint32_t> lamp_of_facet(found.facets.size());
  for (const auto& lamp : join_lamps(found.facets)) {
    for (const auto p : lamp.facets) lamp_of_facet[p] = static_cast<std::uint32_t>(triangles_.size());
    const auto first = found.first_patch[lamp.facets[0]];
    const auto emittance = emittance_of(patches, first);
    for (std::size_t i = 2; i < lamp.corners.size(); ++i) {
      add({lamp.corners[0], lamp.corners[i - 1], lamp.corners[i]}, emittance,
          groups_ > 1 ? patches.material_of(first).light_group : 0);
      triangles_.back().has_holes = patches.material_of(first).textures.cutout.has_value();
      triangles_.back().fan_goes_on = i + 1 < lamp.corners.size();
    }
  }
  for (std::size_t i = 0; i < found.patches.size(); ++i)
    lamp_of_patch_[found.patches[i]] = lamp_of_facet[found.facet[i]];
  if (patches.has_sky()) add_portals(patches);
}

void Lamps::add_portals(const PatchSet& patches) {
  std::vector<float> emittance;
  const auto sky = patches.mean_sky();
  for (const auto radiance : sky)
    emittance.push_back(static_cast<float>(std::numbers::pi * static_cast<double>(radiance)));
  if (!patches.has_even_sky())
    for (std::size_t i = 0; i < patches.sky.size(); ++i)
      sky_difference_.push_back(patches.sky[i] - sky[i % bands_]);
  lamp_of_portal_.assign(2 * patches.portals.size(), none);
  for (std::size_t i = 0; i < lamp_of_portal_.size(); ++i) {
    const auto side = SideId::at(i);  // of a portal
    const auto& portal = patches.portals[side.patch()];
    const auto [a, b, c] = portal.corner;
    const bool is_back = side.is_back();
    if ((is_back && !portal.both_ways) || !(triangle_area(a, b, c) > 0.0)) continue;
    lamp_of_portal_[i] = static_cast<std::uint32_t>(triangles_.size());
    add({a, is_back ? c : b, is_back ? b : c}, emittance, static_cast<std::uint32_t>(groups_ - 1));
    triangles_.back().portal = side.index();
  }
}

std::uint32_t Lamps::lamp_at(std::size_t patch, const Vec3& point) const {
  auto lamp = lamp_of_patch_[patch];
  if (lamp == none) return lamp;
  // Whether the point lies past the third corner, seen from the first.
  for (; triangles_[lamp].fan_goes_on; ++lamp) {
    const auto& t = triangles_[lamp];
    if (glm::dot(t.normal, area_vector2(t.corner[0], t.corner[2], point)) <= 0.0) break;
  }
  return lamp;
}

void Lamps::add(const std::array<Vec3, 3>& corner, std::span<const float> emittance, std::uint32_t group) {
  LampTriangle lamp;
  lamp.corner = corner;
  const auto [a, b, c] = corner;
  const auto normal2 = area_vector2(a, b, c);
  lamp.area = 0.5 * glm::length(normal2);
  lamp.normal = normal2 / (2.0 * lamp.area);
  lamp.longest_edge = std::max(
      {glm::length(Vec3d(b) - Vec3d(a)), glm::length(Vec3d(c) - Vec3d(b)), glm::length(Vec3d(a) - Vec3d(c))});
  for (const auto own : emittance) {
    radiance_.push_back(static_cast<float>(static_cast<double>(own) / std::numbers::pi));
    lamp.weight += static_cast<double>(own) / std::numbers::pi;
  }
  if (triangles_.empty())
    for (const auto own : emittance)
      colour_.push_back(static_cast<double>(own) / (std::numbers::pi * lamp.weight));
  for (std::size_t band = 0; band < bands_; ++band) {
    const auto fraction = static_cast<double>(emittance[band]) / (std::numbers::pi * lamp.weight);
    if (std::fabs(fraction - colour_[band]) > colour_tolerance) one_colour_ = false;
  }
  triangles_.push_back(lamp);
  group_.push_back(group);
}

}  // namespace luxel
