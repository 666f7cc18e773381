// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/share_light.h"

#include <algorithm>
#include <deque>
#include <utility>

#include "luxel/random/warp.h"
#include "luxel/solve/polynomial_fit.h"
#include "luxel/solve/replicate_half.h"
#include "luxel/transport/patch_emitter.h"

namespace luxel {
namespace {

constexpr std::uint32_t task_patches = 4096;  // nodes of at most that many are one thread's work
constexpr std::size_t tasks_grain = 8;        // tasks a chunk; many regions are small
constexpr std::size_t regions_grain = 64;     // regions a chunk
// Bias in all, over what fits two levels down can see: a little more in either half (a fifteenth where light
// is smooth, as much again at an edge), but less in the mean of the two.
constexpr double unseen = 1.0;
constexpr double caution = 3.0;  // a fit is dropped where it is wrong by so much more than noise explains

// The coordinates of a region's patches, written at their slots.
class Chart {
 public:
  Chart(const PatchSet& patches, std::span<const std::uint32_t> region) : patches_(patches) {
    Vec3d sum(0.0);
    Vec3d normal(0.0);
    for (const auto p : region) {
      sum += Vec3d(centroid(p));
      normal += Vec3d(patches.normal[p]);
    }
    origin_ = Vec3(sum / static_cast<double>(region.size()));
    float size = 0.0f;
    for (const auto p : region) size = std::max(size, glm::distance(centroid(p), origin_));
    const Frame frame(Vec3(glm::normalize(normal)));
    const float scale = size > 0.0f ? 1.0f / size : 0.0f;
    u_ = frame.s * scale;
    v_ = frame.t * scale;
  }
  FitPlace place(std::uint32_t patch) const {
    const auto from_origin = centroid(patch) - origin_;
    return {glm::dot(from_origin, u_), glm::dot(from_origin, v_), patches_.area[patch]};
  }

 private:
  Vec3 centroid(std::uint32_t patch) const {
    const auto p = patches_.points(patch);
    return (p[0] + p[1] + p[2]) * (1.0f / 3.0f);
  }

  const PatchSet& patches_;
  Vec3 origin_, u_, v_;
};

// The best representation found for a node, and what it takes to fit the node above.
struct Best {
  Moments moments;
  Energy energy;

  explicit Best(Columns columns) : moments(columns), energy(columns) {}
  void clear() {
    moments.clear();
    energy.clear();
  }
  void add(const Best& other) {
    moments.add(other.moments);
    energy.add(other.energy);
  }
  // Calls body with each of its numbers, to read it or to put another there.
  template <typename Body>
  void for_each(Body body) {
    for (auto& x : moments.gram) body(x);
    for (auto& x : moments.right) body(x);
    double places = moments.places;
    body(places);
    moments.places = static_cast<std::uint32_t>(places);
    for (auto& x : energy.signal) body(x);
    body(energy.noise);
  }
};

struct NodeFit {
  std::uint32_t node = 0;
  int degree = 0;
};

// Chooses nodes by one half of the replicates, and fits them to the other: for the sides that face one way.
class Sharing {
 public:
  Sharing(const PatchTree& tree, std::span<const std::uint32_t> first_slot, const Workers& workers,
          const LoopShare& mine)
      : tree_(tree), first_slot_(first_slot), workers_(workers), mine_(mine) {}

  // The nodes whose fits take the place of the patches' own numbers.
  std::vector<NodeFit> choose(const ReplicateHalf& half) {
    kept_.assign(tree_.nodes.size(), 0);
    // Small nodes first, side by side; then what joins them.
    std::vector<Task> tasks;
    for (const auto region : tree_.regions) collect_tasks(region, region, tasks);
    std::vector<Best> best(tasks.size(), Best({}));
    workers_.for_chunks(tasks.size(), tasks_grain, [&](std::size_t begin, std::size_t end, int) {
      std::deque<Best> levels(1, Best(half.columns()));
      for (auto t = begin; t < end; ++t) {
        if (!is_mine(tasks[t])) continue;
        represent(half, tasks[t].node, 0, levels);
        if (tasks[t].is_joined) best[t] = levels[0];
      }
    });
    if (mine_.ranks()) share_tasks(*mine_.ranks(), half, tasks, best);
    std::size_t next = 0;
    for (const auto region : tree_.regions) join(half, region, tasks, best, next);
    std::vector<NodeFit> fits;
    for (const auto region : tree_.regions) collect_fits(region, fits);
    return fits;
  }

  void apply(std::span<const NodeFit> fits, const ReplicateHalf& half, std::span<float> bias) const {
    workers_.for_chunks(fits.size(), tasks_grain, [&](std::size_t begin, std::size_t end, int) {
      Scratch scratch(half.columns());
      for (auto f = begin; f < end; ++f)
        if (const auto& node = tree_.nodes[fits[f].node];
            first_slot(node) < mine_.end() && end_slot(node) > mine_.begin())
          replace(half, fits[f], bias, scratch);
    });
  }

 private:
  struct Task {
    std::uint32_t node = 0;
    bool is_joined = false;  // a part of a region
  };
  struct Scratch {
    Moments whole, part;
    Energy finer, fitted;
    std::vector<float> finer_values;  // means over replicates, [slot - first][band]
    explicit Scratch(Columns columns) : whole(columns), part(columns), finer(columns), fitted(columns) {}
  };

  // A task without slots is somebody's too.
  bool is_mine(const Task& task) const {
    return mine_.contains(std::min(first_slot(tree_.nodes[task.node]), first_slot_.back() - 1));
  }

  std::uint32_t first_slot(const PatchTree::Node& n) const { return first_slot_[n.first]; }
  std::uint32_t end_slot(const PatchTree::Node& n) const { return first_slot_[n.first + n.count]; }

  void collect_tasks(std::uint32_t k, std::uint32_t region, std::vector<Task>& tasks) const {
    const auto& node = tree_.nodes[k];
    if (node.count <= task_patches || node.child == 0) return tasks.push_back({k, k != region});
    collect_tasks(node.child, region, tasks);
    collect_tasks(node.child + 1, region, tasks);
  }

  // Decides whether the node's own fit takes the place of the best of the nodes below; or then a simpler one.
  void consider(const ReplicateHalf& half, std::uint32_t node, Best& best, Energy& own) {
    if (best.moments.places < 2) return;
    for (int degree = most_degree; degree > 0; --degree)
      if (degree == 1 || best.moments.places >= PolynomialFit::least_places[static_cast<std::size_t>(degree)])
        consider(half, node, degree, best, own);
  }
  void consider(const ReplicateHalf& half, std::uint32_t node, int degree, Best& best, Energy& own) {
    own.clear();
    PolynomialFit(best.moments, degree).add_energy(best.moments, half.columns(), own);
    double wrong = 0.0;
    for (std::size_t b = 0; b < own.signal.size(); ++b) wrong += best.energy.signal[b] - own.signal[b];
    if (wrong > caution * (best.energy.noise - own.noise) || best.energy.noise <= own.noise) return;
    kept_[node] = static_cast<std::uint8_t>(degree);
    std::swap(best.energy, own);
  }

  // The best of a node, in levels[level]; levels below are used on the way.
  void represent(const ReplicateHalf& half, std::uint32_t k, std::size_t level, std::deque<Best>& levels) {
    const auto& node = tree_.nodes[k];
    if (levels.size() < level + 2) levels.emplace_back(half.columns());
    auto& best = levels[level];
    auto& below = levels[level + 1];
    if (node.child == 0) {
      best.clear();
      half.add(first_slot(node), end_slot(node), best.moments, &best.energy);
    } else {
      represent(half, node.child, level, levels);
      represent(half, node.child + 1, level + 1, levels);
      best.add(below);
    }
    consider(half, k, best, below.energy);
  }

  // What each rank found in its own tasks becomes known to all.
  void share_tasks(const Ranks& ranks, const ReplicateHalf& half, std::span<const Task> tasks,
                   std::vector<Best>& best) {
    std::vector<NodeFit> fits;
    std::vector<double> numbers;
    for (std::size_t t = 0; t < tasks.size(); ++t) {
      if (!is_mine(tasks[t])) continue;
      collect_fits(tasks[t].node, fits);
      if (tasks[t].is_joined) best[t].for_each([&](double& x) { numbers.push_back(x); });
    }
    for (const auto& fit : joined(ranks, fits)) kept_[fit.node] = static_cast<std::uint8_t>(fit.degree);
    // Tasks lie in the order of their slots, and so of the ranks.
    const auto of_all = joined(ranks, numbers);
    auto next = of_all.begin();
    for (std::size_t t = 0; t < tasks.size(); ++t) {
      if (!tasks[t].is_joined) continue;
      best[t] = Best(half.columns());
      best[t].for_each([&](double& x) { x = *next++; });
    }
  }

  // The same walk as collect_tasks; next: the first task not yet met.
  Best join(const ReplicateHalf& half, std::uint32_t k, std::span<const Task> tasks, std::vector<Best>& best,
            std::size_t& next) {
    if (tasks[next].node == k) return std::move(best[next++]);
    auto whole = join(half, tree_.nodes[k].child, tasks, best, next);
    whole.add(join(half, tree_.nodes[k].child + 1, tasks, best, next));
    Energy own(half.columns());
    consider(half, k, whole, own);
    return whole;
  }

  void collect_fits(std::uint32_t k, std::vector<NodeFit>& fits) const {
    if (kept_[k] > 0) return fits.push_back({k, kept_[k]});
    if (tree_.nodes[k].child == 0) return;
    collect_fits(tree_.nodes[k].child, fits);
    collect_fits(tree_.nodes[k].child + 1, fits);
  }

  // Adds up a node's moments and the energy of finer fits, `levels` down or where there are few slots, and
  // keeps their values.
  void add_finer(const ReplicateHalf& half, const NodeFit& chosen, int levels, Scratch& scratch) const {
    const auto [k, degree] = chosen;
    const auto& node = tree_.nodes[k];
    const auto first = first_slot(node);
    const auto end = end_slot(node);
    if (first == end) return;
    if (node.child == 0 || end - first < PolynomialFit::least_places[1]) {
      half.append_means(first, end, scratch.finer_values);
      return half.add(first, end, scratch.whole, &scratch.finer);
    }
    if (levels > 0) {
      add_finer(half, {node.child, degree}, levels - 1, scratch);
      return add_finer(half, {node.child + 1, degree}, levels - 1, scratch);
    }
    scratch.part.clear();
    half.add(first, end, scratch.part, nullptr);
    const PolynomialFit fit(scratch.part, degree);
    fit.add_energy(scratch.part, half.columns(), scratch.finer);
    half.append_means(first, end, scratch.part, fit, scratch.finer_values);
    scratch.whole.add(scratch.part);
  }

  // The bias is what finer fits, two levels down where both extents are halved, see that this one does not;
  // and what still finer ones would: the square of the bias falls to a sixteenth by that where light is
  // smooth, to a half at an edge. (Comparing with the patches' own numbers would need no such guess, but
  // their noise drowns it.)
  void replace(const ReplicateHalf& half, const NodeFit& chosen, std::span<float> bias,
               Scratch& scratch) const {
    scratch.whole.clear();
    scratch.finer.clear();
    scratch.fitted.clear();
    scratch.finer_values.clear();
    add_finer(half, chosen, 2, scratch);
    const auto& m = scratch.whole;
    const PolynomialFit fit(m, chosen.degree);
    fit.add_energy(m, half.columns(), scratch.fitted);
    const auto first = first_slot(tree_.nodes[chosen.node]);
    const auto end = end_slot(tree_.nodes[chosen.node]);
    const auto bands = half.columns().bands;
    half.replace(first, end, m, fit);

    // The slots' parts of it: half alike, half by how far the finer fits are from this one there.
    std::vector<float> values;
    half.append_means(first, end, values);
    for (std::size_t b = 0; b < bands; ++b) {
      // The other half of the replicates adds its own.
      const auto wrong = 0.5 * unseen * (scratch.finer.signal[b] - scratch.fitted.signal[b]);
      double squares = 0.0;
      const auto square = [&](std::size_t i) {
        const auto d = static_cast<double>(scratch.finer_values[i * bands + b] - values[i * bands + b]);
        return d * d;
      };
      for (auto s = first; s < end; ++s) squares += half.area(s) * square(s - first);
      for (auto s = first; s < end; ++s) {
        const auto alike = 1.0 / m.gram[0];
        const auto own = squares > 0.0 ? square(s - first) / squares : alike;
        bias[s * bands + b] += static_cast<float>(wrong * 0.5 * (alike + own));
      }
    }
  }

  const PatchTree& tree_;
  std::span<const std::uint32_t> first_slot_;
  const Workers& workers_;
  const LoopShare& mine_;
  std::vector<std::uint8_t> kept_;  // [node]: degree of its fit, if that is better than what is below; or 0
};

}  // namespace

LightSharing::LightSharing(const PatchSet& patches, const PatchTree& tree, const GatherSides& sides,
                           const Workers& workers)
    : tree_(tree), bands_(patches.band_count()), places_(sides.size()) {
  for (const bool back : {false, true}) {
    auto& first = first_slot_[back ? 1 : 0];
    first.reserve(tree.order.size() + 1);
    auto slot = static_cast<std::uint32_t>(back ? sides.fronts : 0);
    for (const auto patch : tree.order) {
      first.push_back(slot);
      if (sides.slot_of_side[side_of(patch, back)] != GatherSides::none) ++slot;
    }
    first.push_back(slot);
  }
  workers.for_chunks(tree.regions.size(), regions_grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto r = begin; r < end; ++r) {
      const auto& node = tree.nodes[tree.regions[r]];
      const auto region = std::span(tree.order).subspan(node.first, node.count);
      const Chart chart(patches, region);
      for (const auto patch : region) {
        const auto place = chart.place(patch);
        for (const bool back : {false, true})
          if (const auto slot = sides.slot_of_side[side_of(patch, back)]; slot != GatherSides::none)
            places_[slot] = place;
      }
    }
  });
}

void LightSharing::share(std::span<std::vector<float>> values, std::span<float> bias, const Workers& workers,
                         const LoopShare& mine) const {
  const auto count = values.size() / 2;
  const ReplicateHalf low(values.first(count), bands_, places_);
  const ReplicateHalf high(values.subspan(count), bands_, places_);
  for (const auto& first_slot : first_slot_) {
    if (first_slot.front() == first_slot.back()) continue;
    Sharing sharing(tree_, first_slot, workers, mine);
    const auto chosen_by_low = sharing.choose(low);
    const auto chosen_by_high = sharing.choose(high);
    sharing.apply(chosen_by_low, high, bias);
    sharing.apply(chosen_by_high, low, bias);
  }
}

void share_light(const PatchSet& patches, const PatchTree& tree, const GatherSides& sides,
                 std::span<std::vector<float>> values, std::span<float> bias, const Workers& workers) {
  LightSharing(patches, tree, sides, workers).share(values, bias, workers, {nullptr, sides.size(), 1});
}

}  // namespace luxel
