// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/cluster_sides.h"

#include <algorithm>
#include <numeric>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "luxel/core/none.h"
#include "luxel/surface/normal_cone.h"

namespace luxel {
namespace {

Vec3d facing(const PatchSet& patches, SideId side) { return Vec3d(patches.normal_of(side)); }

double length_of(const PatchSet& patches, const SideEdge& edge) {
  return static_cast<double>(glm::length(patches.vertices[edge.ends[1]] - patches.vertices[edge.ends[0]]));
}

double perimeter_of(const PatchSet& patches, SideId side) {
  const auto p = patches.points(side.patch());
  return static_cast<double>(glm::length(p[1] - p[0]) + glm::length(p[2] - p[1]) + glm::length(p[0] - p[2]));
}

// Flat regions: the sides reached from a first one that face as it does.
class FlatRegions {
 public:
  explicit FlatRegions(const ClusterInput& input) : input_(input), of_side_(input.is_wanted.size(), none) {
    list_neighbours();
    for (std::size_t i = 0; i < of_side_.size(); ++i)
      if (input.is_wanted[i] && of_side_[i] == none) grow(SideId::at(i));
  }
  // [side]: its region, or none.
  const std::vector<std::uint32_t>& of_side() const { return of_side_; }
  // [region]: the side it began with.
  const std::vector<SideId>& first() const { return first_; }

 private:
  void list_neighbours() {
    begin_.assign(of_side_.size() + 1, 0);
    const auto for_pairs = [&](const auto& body) {
      for (std::size_t e = 0; e < input_.edges.size(); ++e) {
        const auto a = input_.edges[e].halves[0].side.index(), b = input_.edges[e].halves[1].side.index();
        if (!input_.is_crossed[e] || !input_.is_wanted[a] || !input_.is_wanted[b]) continue;
        body(a, b);
        body(b, a);
      }
    };
    for_pairs([&](auto a, auto) { ++begin_[a + 1]; });
    for (std::size_t s = 0; s + 1 < begin_.size(); ++s) begin_[s + 1] += begin_[s];
    neighbour_.resize(begin_.back());
    auto next = begin_;
    for_pairs([&](auto a, auto b) { neighbour_[next[a]++] = b; });
  }

  void grow(SideId seed) {
    constexpr double flat = 1.0 - 1e-6;  // cosine; 0.08 degrees
    const auto region = static_cast<std::uint32_t>(first_.size());
    const auto direction = facing(input_.patches, seed);
    first_.push_back(seed);
    of_side_[seed.index()] = region;
    std::vector<std::uint32_t> open = {seed.index()};
    while (!open.empty()) {
      const auto side = open.back();
      open.pop_back();
      for (auto i = begin_[side]; i < begin_[side + 1]; ++i) {
        const auto other = neighbour_[i];
        if (of_side_[other] != none || glm::dot(facing(input_.patches, SideId::at(other)), direction) < flat)
          continue;
        of_side_[other] = region;
        open.push_back(other);
      }
    }
  }

  const ClusterInput& input_;
  std::vector<std::uint32_t> of_side_;
  std::vector<SideId> first_;
  std::vector<std::size_t> begin_;        // [side]: in neighbour_
  std::vector<std::uint32_t> neighbour_;  // sides across edges that may be crossed
};

class Clustering {
 public:
  Clustering(const ClusterInput& input, const FlatRegions& regions)
      : cos_max_angle_(input.cos_max_angle), parent_(regions.first().size()) {
    std::iota(parent_.begin(), parent_.end(), 0u);
    for (const auto first : regions.first()) clusters_.emplace_back(facing(input.patches, first));
    const auto& region_of = regions.of_side();
    for (std::size_t i = 0; i < region_of.size(); ++i)
      if (region_of[i] != none)
        clusters_[region_of[i]].perimeter += perimeter_of(input.patches, SideId::at(i));
    for (std::size_t e = 0; e < input.edges.size(); ++e) {
      const auto& edge = input.edges[e];
      const auto a = region_of[edge.halves[0].side.index()], b = region_of[edge.halves[1].side.index()];
      if (a == none || b == none || !input.is_crossed[e]) continue;
      const auto length = length_of(input.patches, edge);
      if (a == b) {
        clusters_[a].perimeter -= 2.0 * length;
        continue;
      }
      clusters_[a].shared[b] += length;
      clusters_[b].shared[a] += length;
    }
    for (std::uint32_t a = 0; a < clusters_.size(); ++a)
      for (const auto& [b, length] : clusters_[a].shared)
        if (a < b) offer(a, b);
  }

  // Returns false where the monitor stops the work.
  bool run(const Context& context) {
    constexpr std::size_t steps_per_report = 4096;
    const auto all = static_cast<double>(queue_.size() + 1);
    for (std::size_t step = 0; !queue_.empty(); ++step) {
      if (step % steps_per_report == 0 &&
          context.report({"charts", 0.5 * (1.0 - std::min(1.0, static_cast<double>(queue_.size()) / all))}) ==
              Next::stop)
        return false;
      const auto offered = queue_.top();
      queue_.pop();
      const auto a = root(offered.a), b = root(offered.b);
      if (a == b) continue;
      if (a == offered.a && b == offered.b && clusters_[a].version + clusters_[b].version == offered.version)
        join(a, b);
      else
        offer(a, b);
    }
    return true;
  }

  std::uint32_t cluster_of(std::uint32_t region) { return root(region); }
  const Vec3d& direction(std::uint32_t cluster) const { return clusters_[cluster].cone.axis(); }

 private:
  struct Cluster {
    explicit Cluster(const Vec3d& normal) : cone(normal) {}
    NormalCone cone;
    double perimeter = 0.0;  // m
    std::uint32_t version = 0;
    std::unordered_map<std::uint32_t, double> shared;  // [other cluster]: length of the common border, m
  };
  struct Offer {
    double cost;
    std::uint32_t a, b, version;
    bool operator<(const Offer& other) const {  // the lowest cost is on top
      return std::tuple(other.cost, other.a, other.b) < std::tuple(cost, a, b);
    }
  };

  void offer(std::uint32_t a, std::uint32_t b) {
    const auto &one = clusters_[a], &other = clusters_[b];
    const auto cone = NormalCone::around(one.cone, other.cone);
    if (cone.cos_half_angle() < cos_max_angle_) return;
    const auto bend = (1.0 - cone.cos_half_angle()) / (1.0 - cos_max_angle_);
    const auto border = std::min(one.perimeter, other.perimeter);
    const auto common = border > 0.0 ? std::min(1.0, one.shared.at(b) / border) : 1.0;
    constexpr double weight_of_bend = 2.0;
    queue_.push({weight_of_bend * bend + 1.0 - common, a, b, one.version + other.version});
  }

  void join(std::uint32_t a, std::uint32_t b) {
    // The one with fewer neighbours is added to the other, so that few entries change.
    const auto [whole, part] =
        clusters_[a].shared.size() >= clusters_[b].shared.size() ? std::pair(a, b) : std::pair(b, a);
    auto &kept = clusters_[whole], &gone = clusters_[part];
    kept.cone = NormalCone::around(kept.cone, gone.cone);
    kept.version += gone.version + 1;
    kept.perimeter += gone.perimeter - 2.0 * kept.shared.at(part);
    kept.shared.erase(part);
    for (const auto& [other, length] : gone.shared) {
      if (other == whole) continue;
      auto& of_other = clusters_[other].shared;
      of_other.erase(part);
      of_other[whole] = kept.shared[other] += length;
    }
    gone.shared = {};
    parent_[part] = whole;
  }

  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  double cos_max_angle_;
  std::vector<std::uint32_t> parent_;  // [region]: a region of the cluster it is in
  std::vector<Cluster> clusters_;
  std::priority_queue<Offer> queue_;
};

}  // namespace

std::vector<SideCluster> cluster_sides(const ClusterInput& input, const Context& context) {
  const FlatRegions regions(input);
  Clustering clustering(input, regions);
  if (!clustering.run(context)) return {};
  std::vector<SideCluster> clusters;
  std::vector<std::uint32_t> number(regions.first().size(), none);
  for (std::size_t i = 0; i < regions.of_side().size(); ++i) {
    if (regions.of_side()[i] == none) continue;
    const auto cluster = clustering.cluster_of(regions.of_side()[i]);
    if (number[cluster] == none) {
      number[cluster] = static_cast<std::uint32_t>(clusters.size());
      clusters.push_back({{}, clustering.direction(cluster)});
    }
    clusters[number[cluster]].sides.push_back(SideId::at(i));
  }
  return clusters;
}

}  // namespace luxel
