// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/light_sheets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>

#include "luxel/core/disjoint_sets.h"
#include "luxel/core/none.h"
#include "luxel/core/warp.h"
#include "luxel/patch/plane_parts.h"
#include "luxel/patch/side.h"

namespace luxel {
namespace {

// Sides that meet at a sharper angle belong to different surfaces: 30 degrees, as in SmoothOptions.
constexpr float min_edge_cosine = 0.866f;
// Where the heights of a plane's patches have a wider gap, the patches above it are another layer, such as
// tiles over the mortar that they hide. Relative to the largest coordinate; wide enough for coordinates
// written with five digits.
constexpr double max_layer_gap = 1e-5;
// A sheet is flat where normals are within 2.5 degrees of their mean and it is this thin.
constexpr float min_flat_cosine = 0.999f;
constexpr float max_flat_thickness = 0.01f;  // relative to the distance of its farthest point from its middle

struct EdgeUse {
  std::uint32_t low = 0, high = 0;  // vertices
  std::uint32_t patch = 0;
  bool is_forward = false;  // from low to high

  friend bool operator<(const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.patch) < std::tie(b.low, b.high, b.patch);
  }
  bool has_edge_of(const EdgeUse& other) const { return low == other.low && high == other.high; }
};

std::vector<EdgeUse> sorted_edge_uses(const PatchSet& patches) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * patches.size());
  for (std::uint32_t p = 0; p < patches.size(); ++p)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = patches.corners[p][k];
      const auto b = patches.corners[p][(k + 1) % 3];
      uses.push_back({std::min(a, b), std::max(a, b), p, a < b});
    }
  std::sort(uses.begin(), uses.end());
  return uses;
}

void join_across_edges(const PatchSet& patches, DisjointSets& sheets) {
  const auto uses = sorted_edge_uses(patches);
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    while (end < uses.size() && uses[end].has_edge_of(uses[begin])) ++end;
    if (end - begin != 2) continue;
    const auto& a = uses[begin];
    const auto& b = uses[begin + 1];
    const bool same_winding = a.is_forward != b.is_forward;
    const auto cosine = glm::dot(patches.normal[a.patch], patches.normal[b.patch]);
    if ((same_winding ? cosine : -cosine) < min_edge_cosine) continue;
    for (const bool back : {false, true})
      sheets.join(SideId(a.patch, back).index(), SideId(b.patch, same_winding ? back : !back).index());
  }
}

struct PatchHeight {
  double height = 0.0;  // m, of the centroid along the region's mean normal
  std::uint32_t patch = 0;

  friend bool operator<(const PatchHeight& a, const PatchHeight& b) {
    return std::tie(a.height, a.patch) < std::tie(b.height, b.patch);
  }
};

// The patches of a region, the lowest first; all at one height where the region bends.
std::vector<PatchHeight> heights_of(const PatchSet& patches, std::span<const std::uint32_t> region) {
  Vec3d normals(0.0);
  for (const auto p : region) normals += Vec3d(patches.normal[p]) * static_cast<double>(patches.area[p]);
  const auto length = glm::length(normals);
  const auto mean = length > 0.0 ? normals / length : Vec3d(0.0);
  const auto is_plane = std::all_of(region.begin(), region.end(), [&](std::uint32_t p) {
    return glm::dot(Vec3d(patches.normal[p]), mean) > static_cast<double>(min_flat_cosine);
  });
  std::vector<PatchHeight> heights;
  for (const auto p : region)
    heights.push_back({is_plane ? glm::dot(Vec3d(patches.centroid(p)), mean) : 0.0, p});
  std::sort(heights.begin(), heights.end());
  return heights;
}

void join_planes(const PatchSet& patches, const PatchTree& tree, DisjointSets& sheets) {
  const auto max_gap = max_layer_gap * static_cast<double>(largest_coordinate(patches));
  for (const auto region : tree.regions) {
    const auto& node = tree.nodes[region];
    const auto heights = heights_of(patches, std::span(tree.order).subspan(node.first, node.count));
    for (std::size_t i = 1; i < heights.size(); ++i)
      if (heights[i].height - heights[i - 1].height <= max_gap)
        for (const bool back : {false, true})
          sheets.join(SideId(heights[i - 1].patch, back).index(), SideId(heights[i].patch, back).index());
  }
}

// Transforms the receivers of a sheet into its frame.
void place_sheet(const PatchSet& patches, const GatherSides& sides, LightSheet& sheet) {
  Vec3d centre(0.0);
  Vec3d normals(0.0);
  for (const auto receiver : sheet.receivers) {
    const auto side = sides.side[receiver];
    centre += Vec3d(patches.centroid(side.patch()));
    normals += Vec3d(patches.normal_of(side)) * static_cast<double>(patches.area[side.patch()]);
  }
  const Vec3 origin(centre / static_cast<double>(sheet.size()));
  const auto length = glm::length(normals);
  const auto mean = length > 0.0 ? Vec3(normals / length) : Vec3(0.0f, 0.0f, 1.0f);
  float radius = 0.0f;
  float thickness = 0.0f;
  float cosine = 1.0f;
  for (const auto receiver : sheet.receivers) {
    const auto at = patches.centroid(sides.side[receiver].patch()) - origin;
    radius = std::max(radius, glm::length(at));
    thickness = std::max(thickness, std::abs(glm::dot(at, mean)));
    cosine = std::min(cosine, glm::dot(patches.normal_of(sides.side[receiver]), mean));
  }
  const bool is_flat = cosine > min_flat_cosine && thickness <= max_flat_thickness * radius;
  const Frame frame(is_flat ? mean : Vec3(0.0f, 0.0f, 1.0f));
  const auto in_frame = [&](const Vec3& v) {
    return Vec3(glm::dot(v, frame.s), glm::dot(v, frame.t), glm::dot(v, frame.n));
  };
  for (const auto receiver : sheet.receivers) {
    const auto side = sides.side[receiver];
    auto at = in_frame(patches.centroid(side.patch()) - origin);
    if (is_flat) at.z = 0.0f;
    sheet.place.push_back(at);
    if (!is_flat) sheet.normal.push_back(in_frame(patches.normal_of(side)));
    sheet.area.push_back(patches.area[side.patch()]);
  }
  sheet.low = sheet.place[0];
  auto high = sheet.low;
  for (const auto& at : sheet.place) {
    sheet.low = glm::min(sheet.low, at);
    high = glm::max(high, at);
  }
  const auto box = high - sheet.low;
  sheet.extent = std::max({box.x, box.y, box.z});
}

}  // namespace

std::vector<LightSheet> make_light_sheets(const PatchSet& patches, const PatchTree& tree,
                                          const GatherSides& sides) {
  DisjointSets joined(side_count(patches.size()));
  join_planes(patches, tree, joined);
  join_across_edges(patches, joined);
  std::vector<std::uint32_t> sheet_of(side_count(patches.size()), none);
  std::vector<LightSheet> sheets;
  for (std::uint32_t receiver = 0; receiver < sides.size(); ++receiver) {
    auto& sheet = sheet_of[joined.of(sides.side[receiver].index())];
    if (sheet == none) {
      sheet = static_cast<std::uint32_t>(sheets.size());
      sheets.emplace_back();
    }
    sheets[sheet].receivers.push_back(receiver);
  }
  for (auto& sheet : sheets) place_sheet(patches, sides, sheet);
  return sheets;
}

}  // namespace luxel
