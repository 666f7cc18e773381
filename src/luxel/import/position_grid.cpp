// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/position_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "luxel/import/gltf_array.h"
#include "luxel/import/placed_nodes.h"

namespace luxel {
namespace {

constexpr double flat = 1e-12;  // smaller determinants, relative to the scale, have no inverse

// Meshes that share arrays of positions.
struct Cluster {
  Vec3d low = Vec3d(std::numeric_limits<double>::infinity());
  Vec3d high = -low;
  double stretch = 0.0;                // largest scale of the nodes that show them
  glm::dmat4 world = glm::dmat4(1.0);  // of the first of these nodes

  double size() const { return stretch * std::max({high.x - low.x, high.y - low.y, high.z - low.z}); }
  bool is_usable() const {
    return stretch > 0.0 && std::isfinite(size()) &&
           std::abs(glm::determinant(glm::dmat3(world))) > flat * stretch * stretch * stretch;
  }
};

// [mesh]: number of its cluster, which is that of one of its meshes.
std::vector<std::size_t> clusters_of(const JsonValue& meshes, const std::vector<bool>& may_have) {
  std::vector<std::size_t> parent(meshes.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root_of = [&](std::size_t mesh) {
    while (parent[mesh] != mesh) mesh = parent[mesh] = parent[parent[mesh]];
    return mesh;
  };
  std::map<std::size_t, std::size_t> mesh_of;  // [accessor of positions]
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const auto primitives = meshes[m]["primitives"];
    for (std::size_t p = 0; may_have[m] && p < primitives.size(); ++p) {
      const auto [found, is_new] = mesh_of.try_emplace(primitives[p]["attributes"]["POSITION"].whole(), m);
      if (!is_new) parent[root_of(m)] = root_of(found->second);
    }
  }
  for (std::size_t m = 0; m < parent.size(); ++m) parent[m] = root_of(m);
  return parent;
}

double power_of_two_above(double x) {
  int exponent = 0;
  const auto mantissa = std::frexp(x, &exponent);
  return std::ldexp(1.0, mantissa == 0.5 ? exponent - 1 : exponent);
}

// The smallest step in which every mesh fits that fits at all; 0: none does.
double common_step(const std::vector<Cluster>& clusters, const GltfPacking& packing) {
  const auto max_step = packing.max_step, max_steps = packing.max_steps();
  double step = 0.0;
  for (const auto& cluster : clusters)
    if (cluster.is_usable() && cluster.size() <= max_steps * max_step)
      step = std::max(step, cluster.size() > 0.0 ? power_of_two_above(cluster.size() / max_steps) : max_step);
  return std::min(step, max_step);
}

// Aligned with the scene's zero.
PositionGrid grid_of(const Cluster& cluster, double step, double max_steps) {
  PositionGrid grid;
  grid.step = step / cluster.stretch;
  const auto phase = -(glm::inverse(glm::dmat3(cluster.world)) * Vec3d(cluster.world[3]));
  grid.origin = phase + grid.step * glm::floor((cluster.low - phase) / grid.step);
  grid.as_floats = cluster.size() > max_steps * step;
  return grid;
}

}  // namespace

std::vector<std::optional<PositionGrid>> position_grids(GltfFile& file, const std::vector<bool>& may_have,
                                                        const GltfPacking& packing) {
  const auto meshes = file.root()["meshes"];
  const auto cluster_of = clusters_of(meshes, may_have);
  std::vector<Cluster> clusters(meshes.size());
  for (const auto& placed : placed_nodes(file)) {
    if (!placed.node["mesh"] || !may_have[placed.node["mesh"].whole()]) continue;
    auto& cluster = clusters[cluster_of[placed.node["mesh"].whole()]];
    if (cluster.stretch == 0.0) cluster.world = placed.world;
    for (int axis = 0; axis < 3; ++axis)
      cluster.stretch = std::max(cluster.stretch, glm::length(Vec3d(placed.world[axis])));
  }
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const auto primitives = meshes[m]["primitives"];
    for (std::size_t p = 0; may_have[m] && p < primitives.size(); ++p) {
      const GltfArray positions(file, primitives[p]["attributes"]["POSITION"], 3, 3);
      auto& cluster = clusters[cluster_of[m]];
      for (std::size_t v = 0; v < positions.size(); ++v) {
        const auto at = positions.at(v);
        cluster.low = glm::min(cluster.low, Vec3d(at[0], at[1], at[2]));
        cluster.high = glm::max(cluster.high, Vec3d(at[0], at[1], at[2]));
        if (std::isnan(at[0] + at[1] + at[2])) cluster.high = Vec3d(std::numeric_limits<double>::infinity());
      }
    }
  }
  std::vector<std::optional<PositionGrid>> grids(meshes.size());
  const auto step = common_step(clusters, packing);
  for (std::size_t m = 0; step > 0.0 && m < grids.size(); ++m)
    if (const auto& cluster = clusters[cluster_of[m]]; may_have[m] && cluster.is_usable())
      grids[m] = grid_of(cluster, step, packing.max_steps());
  return grids;
}

}  // namespace luxel
