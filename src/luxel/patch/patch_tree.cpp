// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/patch_tree.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "luxel/patch/plane_parts.h"

namespace luxel {
namespace {

constexpr float cone_cosine = 0.9f;        // normals of a region lie within 26 degrees of their mean
constexpr float cone_width = 0.9f;         // so no two ends of them are farther apart: 2 sin(26 degrees)
constexpr float thickness_exact = 1e-3f;   // of a plane region's extent: rounding by modelling programs
constexpr std::uint32_t large_plane = 32;  // patches
constexpr std::uint32_t region_unit = 64;
constexpr float normal_weight = 0.5f;  // metres per unit of normal, over the node's extent

// Centroid and normal of a patch.
struct Item {
  std::uint32_t patch = 0;
  std::array<float, 6> at{};  // centroid, normal
};

// A box in the space of centroids and normals.
struct ItemBounds {
  std::array<float, 6> low, high;
  ItemBounds() {
    low.fill(std::numeric_limits<float>::max());
    high.fill(std::numeric_limits<float>::lowest());
  }
  void add(const Item& item) {
    for (std::size_t d = 0; d < 6; ++d) {
      low[d] = std::min(low[d], item.at[d]);
      high[d] = std::max(high[d], item.at[d]);
    }
  }
  float extent(std::size_t d) const { return high[d] - low[d]; }
};

Vec3 place_of(const Item& i) { return {i.at[0], i.at[1], i.at[2]}; }
Vec3 normal_of(const Item& i) { return {i.at[3], i.at[4], i.at[5]}; }

// Returns whether the items lie on one plane, or on one sheet whose thickness its slight curvature explains.
bool is_flat(const Item* begin, const Item* end, const ItemBounds& bounds) {
  for (std::size_t d = 3; d < 6; ++d)
    if (bounds.extent(d) > cone_width) return false;  // a test of each item would fail too
  Vec3 sum(0.0f);
  for (const auto* i = begin; i != end; ++i) sum += normal_of(*i);
  const auto length = glm::length(sum);
  if (!(length > 0.0f)) return false;
  const auto mean = sum / length;
  float cosine = 1.0f;
  float low = std::numeric_limits<float>::max();
  float high = std::numeric_limits<float>::lowest();
  for (const auto* i = begin; i != end; ++i) {
    cosine = std::min(cosine, glm::dot(normal_of(*i), mean));
    const auto height = glm::dot(place_of(*i) - place_of(*begin), mean);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  const Vec3 extent(bounds.extent(0), bounds.extent(1), bounds.extent(2));
  const auto bend = std::sqrt(std::max(0.0f, 1.0f - cosine * cosine));
  return cosine > cone_cosine && high - low <= glm::length(extent) * (thickness_exact + 0.5f * bend);
}

// Returns a size of the first half that is a multiple of a power of two, at most an eighth of the whole.
std::uint32_t aligned_half(std::uint32_t count) {
  std::uint32_t unit = 1;
  while (unit * 16 <= count) unit *= 2;
  return (count / 2 + unit / 2) / unit * unit;
}

class Builder {
 public:
  Builder(const PatchSet& patches, PatchTree& tree) : tree_(tree), items_(patches.size()) {
    for (std::size_t p = 0; p < patches.size(); ++p) {
      const auto c = patches.points(p);
      const auto centre = (c[0] + c[1] + c[2]) * (1.0f / 3.0f);
      const auto& n = patches.normal[p];
      items_[p] = {static_cast<std::uint32_t>(p), {centre.x, centre.y, centre.z, n.x, n.y, n.z}};
    }
    group(plane_parts(patches));
  }

  void build(const Context& context) {
    tree_.nodes.push_back({0, static_cast<std::uint32_t>(items_.size()), 0, false});
    tree_.level_begin = {0};
    // Level by level: nodes of one level are disjoint, so threads can split them independently.
    for (std::size_t begin = 0; begin < tree_.nodes.size();) {
      const auto end = tree_.nodes.size();
      tree_.level_begin.push_back(static_cast<std::uint32_t>(end));
      std::vector<std::uint32_t> left(end - begin);
      context.for_chunks(end - begin, 16, [&](std::size_t b, std::size_t e, int) {
        for (auto i = b; i < e; ++i) left[i] = split(tree_.nodes[begin + i]);
      });
      for (std::size_t i = begin; i < end; ++i) {
        const auto node = tree_.nodes[i];
        const auto l = left[i - begin];
        if (l == 0) continue;
        tree_.nodes[i].child = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes.push_back({node.first, l, 0, node.is_flat});
        tree_.nodes.push_back({node.first + l, node.count - l, 0, node.is_flat});
      }
      begin = end;
    }
    number();
  }

 private:
  // Large planes first, each as a group, in order of occurrence; then all other patches as one.
  void group(const std::vector<std::uint64_t>& planes) {
    std::unordered_map<std::uint64_t, std::uint32_t> size;
    for (const auto plane : planes) ++size[plane];
    std::unordered_map<std::uint64_t, std::uint32_t> begin;
    std::uint32_t at = 0;
    for (const auto plane : planes)
      if (size[plane] >= large_plane && begin.try_emplace(plane, at).second) {
        group_begins_.push_back(at);
        at += size[plane];
      }
    planar_ = at;
    group_begins_.push_back(at);
    std::vector<Item> grouped(items_.size());
    for (const auto& item : items_) {
      const auto found = begin.find(planes[item.patch]);
      grouped[found == begin.end() ? at++ : found->second++] = item;
    }
    items_ = std::move(grouped);
  }

  // Returns where to cut a node with several groups: between two of them, as near its middle as possible. Its
  // end if it has only one.
  std::uint32_t cut_between_groups(const PatchTree::Node& node) const {
    const auto end = node.first + node.count;
    const auto above =
        std::upper_bound(group_begins_.begin(), group_begins_.end(), node.first + node.count / 2);
    auto best = end;
    const auto consider = [&](std::uint32_t cut) {
      const auto off = [&](std::uint32_t c) {
        return std::abs(2.0 * (c - node.first) - static_cast<double>(node.count));
      };
      if (cut > node.first && cut < end && (best == end || off(cut) < off(best))) best = cut;
    };
    if (above != group_begins_.end()) consider(*above);
    if (above != group_begins_.begin()) consider(*(above - 1));
    return best;
  }

  // Determines whether the node is flat, and splits its items. Returns the number of items on the left; 0 for
  // a leaf.
  std::uint32_t split(PatchTree::Node& node) {
    auto* const begin = items_.data() + node.first;
    auto* const end = begin + node.count;
    if (!node.is_flat && node.first < planar_) {
      const auto cut = cut_between_groups(node);
      if (cut < node.first + node.count) return cut - node.first;
      node.is_flat = true;
    }
    ItemBounds bounds;
    for (const auto* i = begin; i != end; ++i) bounds.add(*i);
    if (!node.is_flat) node.is_flat = is_flat(begin, end, bounds);
    if (node.count <= 1 || (node.is_flat && node.count <= PatchTree::leaf_patches)) {
      std::sort(begin, end, [](const Item& a, const Item& b) { return a.patch < b.patch; });
      return 0;
    }

    const auto widest = widest_dimension(bounds, node.is_flat);
    // Ties are ordered by patch, so that the halves are the same sets with every library's nth_element.
    const auto before = [widest](const Item& a, const Item& b) {
      return a.at[widest] != b.at[widest] ? a.at[widest] < b.at[widest] : a.patch < b.patch;
    };
    if (!node.is_flat) {
      // At the middle of the box, which falls between planes more often than the median does.
      const auto middle = 0.5f * (bounds.low[widest] + bounds.high[widest]);
      const auto* cut = std::partition(begin, end, [&](const Item& i) { return i.at[widest] < middle; });
      if (cut != begin && cut != end) return static_cast<std::uint32_t>(cut - begin);
    }
    const auto half = std::max(1u, aligned_half(node.count));
    std::nth_element(begin, begin + half, end, before);
    return half;
  }

  static std::size_t widest_dimension(const ItemBounds& bounds, bool flat) {
    const Vec3 extent(bounds.extent(0), bounds.extent(1), bounds.extent(2));
    const auto scale = normal_weight * glm::length(extent);
    std::size_t widest = 0;
    float best = -1.0f;
    for (std::size_t d = 0; d < (flat ? 3u : 6u); ++d) {
      const auto e = bounds.extent(d) * (d < 3 ? 1.0f : scale);
      if (e > best) {
        best = e;
        widest = d;
      }
    }
    return widest;
  }

  // Numbers the patches, and lists the regions.
  void number() {
    const auto n = items_.size();
    tree_.order.resize(n);
    for (std::size_t i = 0; i < n; ++i) tree_.order[i] = items_[i].patch;
    std::vector<std::uint32_t> open{0};
    while (!open.empty()) {
      const auto k = open.back();
      open.pop_back();
      const auto& node = tree_.nodes[k];
      if (node.is_flat || node.child == 0) {
        tree_.regions.push_back(k);
      } else {
        open.push_back(node.child + 1);
        open.push_back(node.child);
      }
    }
    tree_.position.resize(n);
    std::uint32_t position = 0;
    for (const auto r : tree_.regions) {
      const auto& node = tree_.nodes[r];
      // A small region begins at a multiple of its size, rounded up to a power of two.
      std::uint32_t unit = 1;
      while (unit < region_unit && unit < node.count) unit *= 2;
      position = (position + unit - 1) / unit * unit;
      std::iota(tree_.position.begin() + node.first, tree_.position.begin() + node.first + node.count,
                position);
      position += node.count;
    }
  }

  PatchTree& tree_;
  std::vector<Item> items_;
  std::vector<std::uint32_t> group_begins_;  // of large planes, and where the other patches begin
  std::uint32_t planar_ = 0;                 // items in large planes
};

}  // namespace

PatchTree make_patch_tree(const PatchSet& patches, const Context& context) {
  PatchTree tree;
  Builder(patches, tree).build(context);
  return tree;
}

}  // namespace luxel
