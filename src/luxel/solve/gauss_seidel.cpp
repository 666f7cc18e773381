// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/gauss_seidel.h"

#include <algorithm>
#include <cmath>

namespace luxel {
namespace {

constexpr std::size_t grain = 8192;  // numbers a chunk

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
      change.whole += static_cast<double>(reflected);
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

}  // namespace

GaussSeidelReport gauss_seidel(const TransportOperator& transport, std::span<const float> direct,
                               std::span<const float> reflectance, std::span<float> radiosity,
                               std::span<float> irradiance, const GaussSeidelOptions& options,
                               const Workers& workers) {
  const auto bands = transport.bands();
  const auto begins = part_begins(transport.row_begins(), options.parts);
  GaussSeidelReport report;
  while (static_cast<int>(report.change.size()) < options.max_sweeps) {
    Change sweep;
    for (std::size_t part = 0; part + 1 < begins.size(); ++part) {
      transport.apply(radiosity, irradiance, begins[part], begins[part + 1], workers);
      const auto change = reflect(direct, reflectance, radiosity, irradiance, begins[part] * bands,
                                  begins[part + 1] * bands, workers);
      sweep.difference += change.difference;
      sweep.whole += change.whole;
    }
    const auto change = sweep.whole > 0.0 ? sweep.difference / sweep.whole : 0.0;
    report.change.push_back(change);
    // Changes fall geometrically: those to come sum to change * rate / (1 - rate).
    const auto n = report.change.size();
    const auto rate =
        n > 1 && report.change[n - 2] > 0.0 ? std::min(0.999, change / report.change[n - 2]) : 0.9;
    report.distance = change * rate / (1.0 - rate);
    report.converged = report.distance <= options.tolerance;
    if (report.converged) break;
  }
  return report;
}

}  // namespace luxel
