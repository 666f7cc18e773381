// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/share_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "luxel/random/warp.h"

namespace luxel {
namespace {

constexpr std::uint32_t task_patches = 4096;  // nodes of at most that many are one thread's work
constexpr std::uint32_t linear_slots = 6;     // fewer carry a constant only
constexpr double least_pivot = 1e-7;          // of the Gram matrix: below it the places lie on a line
constexpr double unseen = 4.0 / 3.0;          // bias in all, over what fits two levels down can see
constexpr double caution = 3.0;  // a fit is dropped where it is wrong by so much more than noise explains

// The place of a patch in its region: two coordinates in the plane, about one region across.
struct Chart {
  Vec3 origin{0.0f};
  Vec3 u{0.0f}, v{0.0f};  // axes over the region's size
};

// Sums over the slots of a node, for the fit of c0 + c1 u + c2 v.
struct Moments {
  std::array<double, 6> gram{};  // of 1, u, v: upper triangle, row by row
  std::vector<double> right;     // [replicate][band][3]
  std::uint32_t slots = 0;

  void add(const Moments& other) {
    for (std::size_t i = 0; i < gram.size(); ++i) gram[i] += other.gram[i];
    for (std::size_t i = 0; i < right.size(); ++i) right[i] += other.right[i];
    slots += other.slots;
  }
};

// What a set of replicates says of a sum of squares: an estimate of the square of the mean, free of noise,
// and the variance of the mean.
struct Energy {
  std::vector<double> signal;  // [band]
  double noise = 0.0;          // all bands

  void add(const Energy& other) {
    for (std::size_t b = 0; b < signal.size(); ++b) signal[b] += other.signal[b];
    noise += other.noise;
  }
  // From sums over replicates: |sum of x_r|² and sum of |x_r|².
  void add_sums(std::size_t band, double of_sum, double of_squares, double replicates) {
    const auto pairs = replicates * (replicates - 1.0);
    signal[band] += (of_sum - of_squares) / pairs;
    noise += (of_squares - of_sum / replicates) / pairs;
  }
};

// One half of the replicates.
struct Half {
  std::size_t first = 0, count = 0;
};

// The best representation found for a node, and what it takes to fit the node above.
struct Best {
  Moments moments;
  Energy energy;

  void add(const Best& other) {
    moments.add(other.moments);
    energy.add(other.energy);
  }
};

// Least squares with the Gram matrix G = L D L'.
class Fit {
 public:
  explicit Fit(const Moments& m) {
    const auto& g = m.gram;
    inverse_[0] = g[0] > 0.0 ? 1.0 / g[0] : 0.0;
    rank_ = 1;
    if (m.slots < linear_slots) return;
    lower_[0] = g[1] * inverse_[0];
    lower_[1] = g[2] * inverse_[0];
    const auto d1 = g[3] - lower_[0] * g[1];
    const auto cross = g[4] - lower_[0] * g[2];
    const auto d2_whole = g[5] - lower_[1] * g[2];
    if (!(d1 > 0.0 && d2_whole > 0.0)) return;
    lower_[2] = cross / d1;
    const auto d2 = d2_whole - lower_[2] * cross;
    if (!(d2 > least_pivot * d2_whole)) return;
    inverse_[1] = 1.0 / d1;
    inverse_[2] = 1.0 / d2;
    rank_ = 3;
  }

  // The right side on orthogonal axes, each divided by its length: their squares add up to the fit's energy.
  std::array<double, 3> reduced(const double* right) const {
    if (rank_ == 1) return {right[0], 0.0, 0.0};
    const auto y1 = right[1] - lower_[0] * right[0];
    return {right[0], y1, right[2] - lower_[1] * right[0] - lower_[2] * y1};
  }
  double energy(const std::array<double, 3>& reduced) const {
    return reduced[0] * reduced[0] * inverse_[0] + reduced[1] * reduced[1] * inverse_[1] +
           reduced[2] * reduced[2] * inverse_[2];
  }
  std::array<double, 3> coefficients(const double* right) const {
    const auto y = reduced(right);
    std::array<double, 3> c = {y[0] * inverse_[0], y[1] * inverse_[1], y[2] * inverse_[2]};
    if (rank_ == 1) return c;
    c[1] -= lower_[2] * c[2];
    c[0] -= lower_[0] * c[1] + lower_[1] * c[2];
    return c;
  }

 private:
  std::array<double, 3> lower_{};    // L10, L20, L21
  std::array<double, 3> inverse_{};  // of D
  int rank_ = 1;
};

// The sides that face one way of all patches.
class Sharing {
 public:
  Sharing(const PatchSet& patches, const PatchTree& tree, const GatherSides& sides, bool back,
          std::span<std::vector<float>> values, std::span<float> bias, const Workers& workers)
      : patches_(patches),
        tree_(tree),
        sides_(sides),
        values_(values),
        bias_(bias),
        workers_(workers),
        bands_(patches.band_count()) {
    slot_before_.reserve(tree.order.size() + 1);
    auto slot = static_cast<std::uint32_t>(back ? sides.fronts : 0);
    for (const auto patch : tree.order) {
      slot_before_.push_back(slot);
      if (sides.slot_of_side[2 * patch + (back ? 1 : 0)] != GatherSides::none) ++slot;
    }
    slot_before_.push_back(slot);
  }

  void run() {
    charts_.resize(tree_.regions.size());
    for (std::size_t r = 0; r < tree_.regions.size(); ++r)
      charts_[r] = chart_of(tree_.nodes[tree_.regions[r]]);
    const Half low{0, values_.size() / 2};
    const Half high{low.count, values_.size() - low.count};
    const auto chosen_by_low = choose(low);
    const auto chosen_by_high = choose(high);
    apply(chosen_by_low, high);
    apply(chosen_by_high, low);
  }

 private:
  struct Task {
    std::uint32_t node = 0;
    std::uint32_t region = 0;
  };

  // The nodes whose fits take the place of the patches' own numbers.
  std::vector<Task> choose(const Half& half) {
    half_ = half;
    kept_.assign(tree_.nodes.size(), 0);
    // Small nodes first, side by side; then what joins them.
    std::vector<Task> tasks;
    for (std::uint32_t r = 0; r < tree_.regions.size(); ++r) collect_tasks(tree_.regions[r], r, tasks);
    std::vector<Best> best(tasks.size());
    workers_.for_chunks(tasks.size(), 1, [&](std::size_t begin, std::size_t end, int) {
      for (auto t = begin; t < end; ++t) best[t] = represent(tasks[t].node, charts_[tasks[t].region]);
    });
    std::size_t next = 0;
    for (std::uint32_t r = 0; r < tree_.regions.size(); ++r) join(tree_.regions[r], tasks, best, next);
    std::vector<Task> fits;
    for (std::uint32_t r = 0; r < tree_.regions.size(); ++r) collect_fits(tree_.regions[r], r, fits);
    return fits;
  }

  void apply(const std::vector<Task>& fits, const Half& half) {
    half_ = half;
    workers_.for_chunks(fits.size(), 1, [&](std::size_t begin, std::size_t end, int) {
      for (auto f = begin; f < end; ++f) replace(fits[f].node, charts_[fits[f].region]);
    });
  }

  std::uint32_t first_slot(const PatchTree::Node& n) const { return slot_before_[n.first]; }
  std::uint32_t end_slot(const PatchTree::Node& n) const { return slot_before_[n.first + n.count]; }

  Vec3 centroid(std::uint32_t slot) const {
    const auto p = patches_.points(sides_.side[slot] / 2);
    return (p[0] + p[1] + p[2]) * (1.0f / 3.0f);
  }
  double area(std::uint32_t slot) const { return patches_.area[sides_.side[slot] / 2]; }
  // Of a replicate of the half.
  float& value(std::size_t replicate, std::uint32_t slot, std::size_t band) const {
    return values_[half_.first + replicate][slot * bands_ + band];
  }

  Chart chart_of(const PatchTree::Node& node) const {
    const auto first = first_slot(node);
    const auto end = end_slot(node);
    if (first == end) return {};
    Vec3d sum(0.0);
    Vec3d normal(0.0);
    for (auto s = first; s < end; ++s) {
      sum += Vec3d(centroid(s));
      normal += Vec3d(patches_.normal[sides_.side[s] / 2]);
    }
    Chart chart;
    chart.origin = Vec3(sum / static_cast<double>(end - first));
    float size = 0.0f;
    for (auto s = first; s < end; ++s) size = std::max(size, glm::distance(centroid(s), chart.origin));
    const Frame frame(Vec3(glm::normalize(normal)));
    const float scale = size > 0.0f ? 1.0f / size : 0.0f;
    chart.u = frame.s * scale;
    chart.v = frame.t * scale;
    return chart;
  }

  Moments moments_of(std::uint32_t first, std::uint32_t end, const Chart& chart) const {
    Moments m;
    m.right.assign(half_.count * bands_ * 3, 0.0);
    m.slots = end - first;
    for (auto s = first; s < end; ++s) {
      const auto place = centroid(s) - chart.origin;
      const double a = area(s);
      const double u = glm::dot(place, chart.u);
      const double v = glm::dot(place, chart.v);
      const std::array<double, 6> terms = {a, a * u, a * v, a * u * u, a * u * v, a * v * v};
      for (std::size_t i = 0; i < 6; ++i) m.gram[i] += terms[i];
      auto* right = m.right.data();
      for (std::size_t r = 0; r < half_.count; ++r)
        for (std::size_t b = 0; b < bands_; ++b, right += 3) {
          const double y = value(r, s, b);
          right[0] += y * terms[0];
          right[1] += y * terms[1];
          right[2] += y * terms[2];
        }
    }
    return m;
  }

  // The patches' own numbers.
  Energy raw_energy(std::uint32_t first, std::uint32_t end) const {
    Energy e;
    e.signal.assign(bands_, 0.0);
    for (auto s = first; s < end; ++s)
      for (std::size_t b = 0; b < bands_; ++b) {
        double sum = 0.0;
        double squares = 0.0;
        for (std::size_t r = 0; r < half_.count; ++r) {
          const double y = value(r, s, b);
          sum += y;
          squares += y * y;
        }
        e.add_sums(b, area(s) * sum * sum, area(s) * squares, static_cast<double>(half_.count));
      }
    return e;
  }

  Energy fit_energy(const Moments& m, const Fit& fit) const {
    Energy e;
    e.signal.assign(bands_, 0.0);
    for (std::size_t b = 0; b < bands_; ++b) {
      std::array<double, 3> sum{};
      double squares = 0.0;
      for (std::size_t r = 0; r < half_.count; ++r) {
        const auto y = fit.reduced(&m.right[(r * bands_ + b) * 3]);
        for (std::size_t i = 0; i < 3; ++i) sum[i] += y[i];
        squares += fit.energy(y);
      }
      e.add_sums(b, fit.energy(sum), squares, static_cast<double>(half_.count));
    }
    return e;
  }

  // Decides whether the node's own fit takes the place of the best of the nodes below.
  void consider(std::uint32_t node, Best& best) {
    if (best.moments.slots < 2) return;
    const auto energy = fit_energy(best.moments, Fit(best.moments));
    double wrong = 0.0;
    for (std::size_t b = 0; b < bands_; ++b) wrong += best.energy.signal[b] - energy.signal[b];
    if (wrong > caution * (best.energy.noise - energy.noise) || best.energy.noise <= energy.noise) return;
    kept_[node] = 1;
    best.energy = energy;
  }

  Best represent(std::uint32_t k, const Chart& chart) {
    const auto& node = tree_.nodes[k];
    Best best;
    if (node.child == 0) {
      best.moments = moments_of(first_slot(node), end_slot(node), chart);
      best.energy = raw_energy(first_slot(node), end_slot(node));
    } else {
      best = represent(node.child, chart);
      best.add(represent(node.child + 1, chart));
    }
    consider(k, best);
    return best;
  }

  void collect_tasks(std::uint32_t k, std::uint32_t region, std::vector<Task>& tasks) const {
    const auto& node = tree_.nodes[k];
    if (node.count <= task_patches || node.child == 0) return tasks.push_back({k, region});
    collect_tasks(node.child, region, tasks);
    collect_tasks(node.child + 1, region, tasks);
  }

  // The same walk as collect_tasks; next: the first task not yet met.
  Best join(std::uint32_t k, const std::vector<Task>& tasks, std::vector<Best>& best, std::size_t& next) {
    if (tasks[next].node == k) return std::move(best[next++]);
    auto whole = join(tree_.nodes[k].child, tasks, best, next);
    whole.add(join(tree_.nodes[k].child + 1, tasks, best, next));
    consider(k, whole);
    return whole;
  }

  void collect_fits(std::uint32_t k, std::uint32_t region, std::vector<Task>& fits) const {
    if (kept_[k]) return fits.push_back({k, region});
    if (tree_.nodes[k].child == 0) return;
    collect_fits(tree_.nodes[k].child, region, fits);
    collect_fits(tree_.nodes[k].child + 1, region, fits);
  }

  // What finer fits, two levels down where both extents are halved, see that this one does not; and what
  // still finer ones would: the square of the bias falls to a sixteenth by that where light is smooth, to a
  // half at an edge. (Comparing with the patches' own numbers would need no such guess, but their noise
  // drowns it.)
  Energy bias_of_fit(std::uint32_t k, const Chart& chart, const Energy& fitted) const {
    Energy finer;
    finer.signal.assign(bands_, 0.0);
    add_finer(k, 2, chart, finer);
    for (std::size_t b = 0; b < bands_; ++b) finer.signal[b] = unseen * (finer.signal[b] - fitted.signal[b]);
    return finer;
  }
  void add_finer(std::uint32_t k, int levels, const Chart& chart, Energy& energy) const {
    const auto& node = tree_.nodes[k];
    const auto first = first_slot(node);
    const auto end = end_slot(node);
    if (first == end) return;
    if (node.child == 0 || end - first < linear_slots) return energy.add(raw_energy(first, end));
    if (levels > 0) {
      add_finer(node.child, levels - 1, chart, energy);
      return add_finer(node.child + 1, levels - 1, chart, energy);
    }
    const auto m = moments_of(first, end, chart);
    energy.add(fit_energy(m, Fit(m)));
  }

  void replace(std::uint32_t k, const Chart& chart) {
    const auto& node = tree_.nodes[k];
    const auto first = first_slot(node);
    const auto end = end_slot(node);
    const auto m = moments_of(first, end, chart);
    const Fit fit(m);
    const auto wrong = bias_of_fit(k, chart, fit_energy(m, fit));
    for (std::size_t b = 0; b < bands_; ++b)
      for (auto s = first; s < end; ++s)
        bias_[s * bands_ + b] +=
            static_cast<float>(0.5 * wrong.signal[b] / m.gram[0]);  // the other half adds its own
    std::vector<std::array<double, 3>> c(half_.count * bands_);
    for (std::size_t i = 0; i < c.size(); ++i) c[i] = fit.coefficients(&m.right[3 * i]);
    for (auto s = first; s < end; ++s) {
      const auto place = centroid(s) - chart.origin;
      const double u = glm::dot(place, chart.u);
      const double v = glm::dot(place, chart.v);
      for (std::size_t r = 0; r < half_.count; ++r)
        for (std::size_t b = 0; b < bands_; ++b) {
          const auto& f = c[r * bands_ + b];
          value(r, s, b) = static_cast<float>(f[0] + f[1] * u + f[2] * v);
        }
    }
  }

  const PatchSet& patches_;
  const PatchTree& tree_;
  const GatherSides& sides_;
  std::span<std::vector<float>> values_;
  std::span<float> bias_;
  const Workers& workers_;
  std::size_t bands_;
  Half half_;                               // that the numbers are taken from
  std::vector<std::uint32_t> slot_before_;  // [place]
  std::vector<Chart> charts_;               // [region]
  std::vector<std::uint8_t> kept_;          // [node]: its fit is better than what is below
};

}  // namespace

void share_light(const PatchSet& patches, const PatchTree& tree, const GatherSides& sides,
                 std::span<std::vector<float>> values, std::span<float> bias, const Workers& workers) {
  for (const bool back : {false, true}) Sharing(patches, tree, sides, back, values, bias, workers).run();
}

}  // namespace luxel
