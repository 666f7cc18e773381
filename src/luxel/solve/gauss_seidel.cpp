// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/gauss_seidel.h"

#include <algorithm>
#include <cmath>

namespace luxel {
namespace {

constexpr std::size_t grain = 8192;  // numbers a chunk
constexpr double slowest_rate = 0.95;

// Where the parts begin: blocks of rows, shared out evenly.
std::vector<std::size_t> part_begins(std::span<const std::uint32_t> row_begins, std::size_t parts) {
  const auto blocks = row_begins.size() - 1;
  parts = std::clamp<std::size_t>(parts, 1, std::max<std::size_t>(1, blocks));
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i <= parts; ++i) begins.push_back(row_begins[blocks * i / parts]);
  return begins;
}

struct Change {
  double difference = 0.0;
  double whole = 0.0;
};

// Rows [begin, end): adds the direct light, reflects, and says how much that changed.
Change reflect(std::span<const float> direct, std::span<const float> reflectance, std::span<float> radiosity,
               std::span<float> irradiance, std::size_t begin, std::size_t end, const Workers& workers) {
  std::vector<Change> chunks((end - begin + grain - 1) / grain);
  workers.for_chunks(end - begin, grain, [&](std::size_t b, std::size_t e, int) {
    Change change;
    for (auto i = begin + b; i < begin + e; ++i) {
      irradiance[i] += direct[i];
      const auto reflected = reflectance[i] * irradiance[i];
      change.difference += std::abs(static_cast<double>(reflected) - static_cast<double>(radiosity[i]));
      change.whole += std::abs(static_cast<double>(reflected));
      radiosity[i] = reflected;
    }
    chunks[b / grain] = change;
  });
  Change sum;
  for (const auto& c : chunks) {
    sum.difference += c.difference;
    sum.whole += c.whole;
  }
  return sum;
}

// Anderson's acceleration of x -> g(x): remembers differences of g(x) and of the residual f = g(x) - x, and
// takes from g(x) the combination whose differences of f make up f best, in the least squares.
class Acceleration {
 public:
  Acceleration(std::size_t memory, std::size_t count, const Workers& workers)
      : memory_(memory), workers_(workers), before_(memory > 0 ? count : 0) {}

  // Call before a sweep changes x.
  void begin(std::span<const float> x) {
    if (memory_ > 0) std::copy_n(x.begin(), before_.size(), before_.begin());
  }

  // x is g of what it was at begin(); it becomes the better guess.
  void improve(std::span<float> x) {
    if (memory_ == 0) return;
    const auto n = before_.size();
    std::vector<float> residual(n);
    for_all(n, [&](std::size_t i) { residual[i] = x[i] - before_[i]; });
    std::vector<float> image(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(n));
    if (!last_residual_.empty()) {
      if (steps_.size() == memory_) steps_.erase(steps_.begin());
      auto& step = steps_.emplace_back();
      step.residual.resize(n);
      step.image.resize(n);
      for_all(n, [&](std::size_t i) {
        step.residual[i] = residual[i] - last_residual_[i];
        step.image[i] = image[i] - last_image_[i];
      });
      const auto weights = least_squares(residual);
      for (std::size_t k = 0; k < steps_.size(); ++k) {
        const auto w = static_cast<float>(weights[k]);
        for_all(n, [&](std::size_t i) { x[i] -= w * steps_[k].image[i]; });
      }
    }
    last_residual_ = std::move(residual);
    last_image_ = std::move(image);
  }

 private:
  struct Step {
    std::vector<float> residual, image;  // differences
  };

  template <typename Body>
  void for_all(std::size_t n, Body body) const {
    workers_.for_chunks(n, grain, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = begin; i < end; ++i) body(i);
    });
  }

  double dot(const std::vector<float>& a, const std::vector<float>& b) const {
    std::vector<double> chunks((a.size() + grain - 1) / grain, 0.0);
    workers_.for_chunks(a.size(), grain, [&](std::size_t begin, std::size_t end, int) {
      double sum = 0.0;
      for (auto i = begin; i < end; ++i) sum += static_cast<double>(a[i]) * static_cast<double>(b[i]);
      chunks[begin / grain] = sum;
    });
    double sum = 0.0;
    for (const auto c : chunks) sum += c;
    return sum;
  }

  // The normal equations, a few by a few, by Cholesky's method. A direction that adds nothing gets no weight.
  std::vector<double> least_squares(const std::vector<float>& residual) const {
    constexpr double least_pivot = 1e-10;
    const auto m = steps_.size();
    std::vector<double> a(m * m);
    std::vector<double> w(m);
    for (std::size_t i = 0; i < m; ++i) {
      for (std::size_t j = 0; j <= i; ++j) a[i * m + j] = dot(steps_[i].residual, steps_[j].residual);
      w[i] = dot(steps_[i].residual, residual);
    }
    for (std::size_t i = 0; i < m; ++i) {
      const auto whole = a[i * m + i];
      for (std::size_t j = 0; j <= i; ++j) {
        for (std::size_t k = 0; k < j; ++k) a[i * m + j] -= a[i * m + k] * a[j * m + k];
        if (j < i) a[i * m + j] *= a[j * m + j];
      }
      // The diagonal holds inverses.
      a[i * m + i] = a[i * m + i] > least_pivot * whole ? 1.0 / std::sqrt(a[i * m + i]) : 0.0;
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
  const Workers& workers_;
  std::vector<float> before_;
  std::vector<float> last_residual_, last_image_;
  std::vector<Step> steps_;
};

}  // namespace

GaussSeidelReport gauss_seidel(const TransportOperator& transport, std::span<const float> direct,
                               std::span<const float> reflectance, std::span<float> radiosity,
                               std::span<float> irradiance, const GaussSeidelOptions& options,
                               const Workers& workers, const Monitor& monitor) {
  const auto bands = transport.bands();
  const auto begins = part_begins(transport.row_begins(), options.parts);
  Acceleration acceleration(options.memory, transport.size() * bands, workers);
  GaussSeidelReport report;
  while (static_cast<int>(report.change.size()) < options.max_sweeps) {
    acceleration.begin(radiosity);
    Change sweep;
    for (std::size_t part = 0; part + 1 < begins.size(); ++part) {
      transport.apply(radiosity, irradiance, begins[part], begins[part + 1], workers);
      const auto change = reflect(direct, reflectance, radiosity, irradiance, begins[part] * bands,
                                  begins[part + 1] * bands, workers);
      sweep.difference += change.difference;
      sweep.whole += change.whole;
      report.is_stopped = tell(monitor, {"light"}) == Next::stop;
      if (report.is_stopped) return report;
    }
    const auto change = sweep.whole > 0.0 ? sweep.difference / sweep.whole : 0.0;
    report.change.push_back(change);
    // Changes fall geometrically: those to come sum to change * rate / (1 - rate).
    const auto n = report.change.size();
    const auto rate =
        n > 1 ? std::clamp(change / std::max(report.change[n - 2], 1e-30), 0.3, slowest_rate) : 0.9;
    report.distance = change * rate / (1.0 - rate);
    report.converged = report.distance <= options.tolerance;
    if (report.converged) break;
    acceleration.improve(radiosity);
  }
  return report;
}

}  // namespace luxel
