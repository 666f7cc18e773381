// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/gauss_seidel.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>

namespace luxel {
namespace {

constexpr std::size_t grain = 8192;  // numbers per chunk
constexpr double slowest_rate = 0.95;
// A sum over rows counts as at least this fraction of the sum of magnitudes; less is rounding.
constexpr double min_sum_part = 1e-4;

// Where the parts begin: blocks of rows, distributed evenly.
std::vector<std::size_t> part_begins(std::span<const std::uint32_t> row_begins, std::size_t parts) {
  const auto blocks = row_begins.size() - 1;
  parts = std::clamp<std::size_t>(parts, 1, std::max<std::size_t>(1, blocks));
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i <= parts; ++i) begins.push_back(row_begins[blocks * i / parts]);
  return begins;
}

// Returns whether each part has both sides of its diffusers, so that it can be finished alone.
bool joins_diffusers(const Scattering& scattering, std::span<const std::size_t> begins) {
  const auto part_of = [&](std::size_t row) { return std::upper_bound(begins.begin(), begins.end(), row); };
  for (std::size_t row = 0; row < scattering.far.size(); ++row)
    if (scattering.far[row] != row && part_of(row) != part_of(scattering.far[row])) return false;
  return true;
}

struct Change {
  double difference = 0.0;
  double whole = 0.0;
  std::vector<double> sum_difference, sum;  // [band], over rows; empty where sums are not tested

  Change& operator+=(const Change& other) {
    difference += other.difference;
    whole += other.whole;
    for (std::size_t b = 0; b < sum.size(); ++b) {
      sum_difference[b] += other.sum_difference[b];
      sum[b] += other.sum[b];
    }
    return *this;
  }
  double relative() const { return whole > 0.0 ? difference / whole : 0.0; }
  double relative_of_sums() const {
    double changed = 0.0;
    double all = 0.0;
    for (std::size_t b = 0; b < sum.size(); ++b) {
      changed += std::abs(sum_difference[b]);
      all += std::abs(sum[b]);
    }
    return changed > 0.0 ? changed / std::max(all, min_sum_part * whole) : 0.0;
  }
};

// Changes decrease geometrically: the remaining ones sum to change * rate / (1 - rate). before: the change of
// the previous sweep; below 0 if there is none.
double distance_after(double change, double before) {
  const auto rate = before >= 0.0 ? std::clamp(change / std::max(before, 1e-30), 0.3, slowest_rate) : 0.9;
  return change * rate / (1.0 - rate);
}

// Rows [begin, end): adds the direct light, reflects, and returns the change. summed: number of bands whose
// sums are tested, or 0.
Change reflect(const GaussSeidelRows& rows, std::size_t bands, std::size_t begin, std::size_t end,
               std::size_t summed, const Context& context) {
  const auto direct = rows.direct;
  const auto& scattering = rows.scattering;
  const auto radiosity = rows.radiosity, irradiance = rows.irradiance;
  const bool transmits = scattering.transmits();
  if (transmits)  // before any row takes the light of another
    context.for_chunks(end - begin, grain, [&](std::size_t b, std::size_t e, int) {
      for (auto i = begin + b; i < begin + e; ++i) irradiance[i] += direct[i];
    });

  const Change zeros{0.0, 0.0, std::vector<double>(summed, 0.0), std::vector<double>(summed, 0.0)};
  std::vector<Change> chunks((end - begin + grain - 1) / grain, zeros);
  context.for_chunks(end - begin, grain, [&](std::size_t b, std::size_t e, int) {
    auto& change = chunks[b / grain];
    for (auto i = begin + b; i < begin + e; ++i) {
      if (!transmits) irradiance[i] += direct[i];
      auto reflected = scattering.reflectance[i] * irradiance[i];
      if (transmits) reflected = scattering.sent_on(irradiance, i, bands);
      const auto difference = static_cast<double>(reflected) - static_cast<double>(radiosity[i]);
      change.difference += std::abs(difference);
      change.whole += std::abs(static_cast<double>(reflected));
      if (summed > 0) {
        change.sum_difference[i % summed] += difference;
        change.sum[i % summed] += static_cast<double>(reflected);
      }
      radiosity[i] = reflected;
    }
  });
  auto sum = zeros;
  for (const auto& c : chunks) sum += c;
  return sum;
}

// Anderson's acceleration of x -> g(x): stores differences of g(x) and of the residual f = g(x) - x.
// Subtracts from g(x) the combination of differences whose residuals approximate f best in the least-squares
// sense.
class Acceleration {
 public:
  Acceleration(std::size_t memory, std::size_t count, const Context& context)
      : memory_(memory), context_(context), before_(memory > 0 ? count : 0) {}

  // Call before a sweep changes x.
  void begin(std::span<const float> x) {
    if (memory_ > 0) std::copy_n(x.begin(), before_.size(), before_.begin());
  }

  // x is g applied to its value at begin(); it is replaced by the accelerated iterate.
  void improve(std::span<float> x) {
    if (memory_ == 0) return;
    const auto n = before_.size();
    const bool is_first = residual_.empty();
    if (is_first) {
      residual_.resize(n);
      image_.resize(n);
    } else {
      if (steps_.size() == memory_) forget_oldest();
      steps_.push_back({std::vector<float>(n), std::vector<float>(n), {}});
    }
    if (!is_first)
      for_all(n, [&, &step = steps_.back()](std::size_t i) {
        step.residual[i] = x[i] - before_[i] - residual_[i];
        step.image[i] = x[i] - image_[i];
      });
    for_all(n, [&](std::size_t i) {
      residual_[i] = x[i] - before_[i];
      image_[i] = x[i];
    });
    if (is_first) return;
    std::vector<float> weights;
    for (const auto w : least_squares()) weights.push_back(static_cast<float>(w));
    for_all(n, [&](std::size_t i) {
      for (std::size_t k = 0; k < weights.size(); ++k) x[i] -= weights[k] * steps_[k].image[i];
    });
  }

 private:
  struct Step {
    std::vector<float> residual, image;  // differences between consecutive steps
    std::vector<double> products;        // of the residual with those of the steps up to this one
  };

  template <typename Body>
  void for_all(std::size_t n, Body body) const {
    context_.for_chunks(n, grain, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = begin; i < end; ++i) body(i);
    });
  }

  void forget_oldest() {
    steps_.erase(steps_.begin());
    for (auto& step : steps_) step.products.erase(step.products.begin());
  }

  static double dot(const std::vector<float>& a, const std::vector<float>& b, std::size_t begin,
                    std::size_t end) {
    constexpr std::size_t lanes = 8;  // independent partial sums, which hide the latency of additions
    std::array<double, lanes> sums{};
    for (; begin + lanes <= end; begin += lanes)
      for (std::size_t k = 0; k < lanes; ++k)
        sums[k] += static_cast<double>(a[begin + k]) * static_cast<double>(b[begin + k]);
    for (; begin < end; ++begin) sums[0] += static_cast<double>(a[begin]) * static_cast<double>(b[begin]);
    return std::accumulate(sums.begin(), sums.end(), 0.0);
  }

  // The products of the newest step with all steps, and of each step with the residual, in one pass over
  // chunks.
  std::vector<double> new_products() const {
    const auto m = steps_.size();
    const auto n = residual_.size();
    std::vector<double> chunks((n + grain - 1) / grain * 2 * m);
    context_.for_chunks(n, grain, [&](std::size_t begin, std::size_t end, int) {
      auto* sums = &chunks[begin / grain * 2 * m];
      for (std::size_t k = 0; k < m; ++k) {
        sums[k] = dot(steps_.back().residual, steps_[k].residual, begin, end);
        sums[m + k] = dot(steps_[k].residual, residual_, begin, end);
      }
    });
    std::vector<double> sums(2 * m, 0.0);
    for (std::size_t i = 0; i < chunks.size(); ++i) sums[i % (2 * m)] += chunks[i];
    return sums;
  }

  // Solves the small normal equations by Cholesky's method. A linearly dependent direction gets weight 0.
  std::vector<double> least_squares() {
    constexpr double min_pivot = 1e-10;
    const auto m = steps_.size();
    const auto middle = static_cast<std::ptrdiff_t>(m);
    auto w = new_products();
    steps_.back().products.assign(w.begin(), w.begin() + middle);
    w.erase(w.begin(), w.begin() + middle);
    std::vector<double> a(m * m);
    for (std::size_t i = 0; i < m; ++i) std::copy_n(steps_[i].products.begin(), i + 1, &a[i * m]);
    for (std::size_t i = 0; i < m; ++i) {
      const auto whole = a[i * m + i];
      for (std::size_t j = 0; j <= i; ++j) {
        for (std::size_t k = 0; k < j; ++k) a[i * m + j] -= a[i * m + k] * a[j * m + k];
        if (j < i) a[i * m + j] *= a[j * m + j];
      }
      // The diagonal holds inverses.
      a[i * m + i] = a[i * m + i] > min_pivot * whole ? 1.0 / std::sqrt(a[i * m + i]) : 0.0;
      for (std::size_t k = 0; k < i; ++k) w[i] -= a[i * m + k] * w[k];
      w[i] *= a[i * m + i];
    }
    for (std::size_t i = m; i-- > 0;) {
      for (std::size_t k = i + 1; k < m; ++k) w[i] -= a[k * m + i] * w[k];
      w[i] *= a[i * m + i];
    }
    return w;
  }

  std::size_t memory_;
  const Context& context_;
  std::vector<float> before_;
  std::vector<float> residual_, image_;  // of the last call
  std::vector<Step> steps_;
};

}  // namespace

GaussSeidelReport gauss_seidel(const TransportOperator& transport, const GaussSeidelRows& rows,
                               const GaussSeidelOptions& options, const Context& context) {
  const auto bands = transport.bands();
  const auto radiosity = rows.radiosity;
  assert(rows.direct.size() == transport.size() * bands);
  assert(rows.scattering.reflectance.size() == rows.direct.size() &&
         rows.irradiance.size() == rows.direct.size());
  assert(radiosity.size() >= rows.direct.size());
  auto begins = part_begins(transport.row_begins(), options.parts);
  if (!joins_diffusers(rows.scattering, begins)) begins = part_begins(transport.row_begins(), 1);
  const auto summed = options.sum_tolerance > 0.0 ? bands : 0;
  Acceleration acceleration(options.memory, transport.size() * bands, context);
  GaussSeidelReport report;
  double change_before = -1.0;
  double sum_change_before = -1.0;
  while (static_cast<int>(report.change.size()) < options.max_sweeps) {
    acceleration.begin(radiosity);
    Change sweep{0.0, 0.0, std::vector<double>(summed, 0.0), std::vector<double>(summed, 0.0)};
    for (std::size_t part = 0; part + 1 < begins.size(); ++part) {
      transport.apply(radiosity, rows.irradiance, begins[part], begins[part + 1], context);
      sweep += reflect(rows, bands, begins[part] * bands, begins[part + 1] * bands, summed, context);
      report.is_stopped = context.report({"light"}) == Next::stop;
      if (report.is_stopped) return report;
    }
    const auto change = sweep.relative();
    const auto sum_change = sweep.relative_of_sums();
    report.change.push_back(change);
    report.distance = distance_after(change, change_before);
    report.sum_distance = distance_after(sum_change, sum_change_before);
    change_before = change;
    sum_change_before = sum_change;
    report.converged =
        report.distance <= options.tolerance && (summed == 0 || report.sum_distance <= options.sum_tolerance);
    if (report.converged) break;
    acceleration.improve(radiosity);
  }
  return report;
}

}  // namespace luxel
