// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/dense_operator.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "luxel/classical/row_turns.h"
#include "luxel/form_factors/form_factor.h"
#include "luxel/patch/side.h"
#include "luxel/trace/patch_emitter.h"

namespace luxel {
namespace {

constexpr std::size_t pairs_per_chunk = 64;

// Pairs are numbered (1,0) (2,0) (2,1) (3,0) ...
struct Pair {
  std::size_t high = 1, low = 0;

  explicit Pair(std::size_t number) {
    high = static_cast<std::size_t>((1.0 + std::sqrt(1.0 + 8.0 * static_cast<double>(number))) / 2.0);
    while (high * (high - 1) / 2 > number) --high;
    while ((high + 1) * high / 2 <= number) ++high;
    low = number - high * (high - 1) / 2;
  }
  void next() {
    if (++low == high) {
      ++high;
      low = 0;
    }
  }
};

// The backs of one-sided materials.
std::vector<SideId> dead_sides(const PatchSet& patches) {
  std::vector<SideId> sides;
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (!patches.material_of(p).two_sided) sides.push_back(SideId(p, true));
  return sides;
}

}  // namespace

DenseOperator::DenseOperator(const PatchSet& patches, const Context& context)
    : RowOperator(patches, context), factors_(size() * size(), 0.0f), error_at_backs_(size(), 0.0) {}

std::optional<DenseOperator> DenseOperator::make(const PatchSet& patches, const Tracer& tracer,
                                                 const DenseOptions& options, const Context& context) {
  DenseOperator transport(patches, context);
  const FormFactors form_factors(patches, tracer);
  const auto n = transport.size();
  const auto side = [&](std::size_t receiver) { return transport.sides().side[receiver]; };
  const auto area = [&](std::size_t receiver) {
    return static_cast<double>(patches.area[side(receiver).patch()]);
  };
  auto& escaped = transport.losses().escaped;

  // 1. Pairs of receivers. The factor from the smaller one is the larger of the two, so both are within the
  // tolerance.
  const auto pairs = n * (n - 1) / 2;
  const auto chunks = (pairs + pairs_per_chunk - 1) / pairs_per_chunk;
  std::vector<std::vector<Integrated>> integrated(chunks);
  std::vector<double> exact_error(chunks, 0.0);
  const auto find_pairs = [&](std::size_t begin, std::size_t end) {
    Pair pair(begin);
    for (auto k = begin; k < end; ++k, pair.next()) {
      auto from = pair.high;
      auto to = pair.low;
      if (area(to) < area(from)) std::swap(from, to);
      const auto factor = form_factors.between(side(from), side(to), options.tolerance);
      const auto ratio = area(from) / area(to);
      transport.factors_[from * n + to] = static_cast<float>(factor.value);
      transport.factors_[to * n + from] = static_cast<float>(factor.value * ratio);
      auto& error = exact_error[begin / pairs_per_chunk];
      if (factor.exact)
        error = std::max(error, factor.error);
      else
        integrated[begin / pairs_per_chunk].push_back(
            {static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to),
             static_cast<float>(factor.error), static_cast<float>(factor.error * ratio)});
    }
  };
  if (!for_chunks_in_turns(pairs, pairs_per_chunk, context, find_pairs)) return {};
  for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
    transport.integrated_.insert(transport.integrated_.end(), integrated[chunk].begin(),
                                 integrated[chunk].end());
    transport.exact_error_ = std::max(transport.exact_error_, exact_error[chunk]);
  }

  // 2. The remainder of each row: absorbed at the backs of one-sided materials, or escaped.
  const auto dead = dead_sides(patches);
  const auto find_losses = [&](std::size_t begin, std::size_t end) {
    for (auto receiver = begin; receiver < end; ++receiver) {
      const auto* row = &transport.factors_[receiver * n];
      escaped[receiver] = 1.0 - std::accumulate(row, row + n, 0.0);
      for (const auto back : dead) {
        const auto factor = form_factors.between(side(receiver), back, options.tolerance);
        escaped[receiver] -= factor.value;
        transport.error_at_backs_[receiver] += factor.error;
        transport.losses().at_backs[receiver * patches.materials.size() +
                                    static_cast<std::size_t>(patches.material[back.patch()])] += factor.value;
      }
    }
  };
  if (!for_chunks_in_turns(n, 1, dead.empty() ? context.quiet() : context, find_losses)) return {};
  return transport;
}

void DenseOperator::for_rows(std::size_t begin, std::size_t end, const RowBody& body) const {
  const auto n = size();
  std::vector<Factor> row;
  for (auto receiver = begin; receiver < end; ++receiver) {
    row.clear();
    for (std::size_t other = 0; other < n; ++other)
      if (const auto fraction = factors_[receiver * n + other]; fraction > 0.0f)
        row.push_back({static_cast<std::uint32_t>(other), fraction});
    body(receiver, row);
  }
}

std::vector<double> DenseOperator::irradiance_error(std::span<const float> radiosity) const {
  const auto count = bands();
  // The sky fills the part of the hemisphere that a receiver does not see covered.
  const auto contrast = [&](std::size_t receiver, std::size_t b) {
    return std::abs(double{radiosity[receiver * count + b]} - patches().sky_radiosity(0, b));
  };
  std::vector<double> sum(count, 0.0);
  for (std::size_t i = 0; i < radiosity.size(); ++i) sum[i % count] += contrast(i / count, i % count);
  std::vector<double> error(size() * count);
  for (std::size_t i = 0; i < error.size(); ++i)
    error[i] =
        exact_error_ * sum[i % count] + error_at_backs_[i / count] * patches().sky_radiosity(0, i % count);
  for (const auto& pair : integrated_)
    for (std::size_t b = 0; b < count; ++b) {
      error[pair.receiver * count + b] += double{pair.error} * contrast(pair.other, b);
      error[pair.other * count + b] += double{pair.error_back} * contrast(pair.receiver, b);
    }
  return error;
}

void DenseOperator::join_faces(std::span<const std::uint32_t> face) {
  const auto n = size();
  // Receivers sorted by face and side.
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t receiver) {
    const auto side = sides().side[receiver];
    return 2 * std::uint64_t{face[side.patch()]} + (side.is_back() ? 1 : 0);
  };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
  std::vector<double> mean(n);
  for (std::size_t begin = 0, end = 0; begin < n; begin = end) {
    while (end < n && key(order[end]) == key(order[begin])) ++end;
    if (end - begin == 1) continue;
    std::fill(mean.begin(), mean.end(), 0.0);
    double area = 0.0;
    double escaped = 0.0;
    for (auto k = begin; k < end; ++k) {
      const double own = patches().area[sides().side[order[k]].patch()];
      area += own;
      escaped += own * losses().escaped[order[k]];
      for (std::size_t j = 0; j < n; ++j) mean[j] += own * double{factors_[order[k] * n + j]};
    }
    for (auto k = begin; k < end; ++k) {
      losses().escaped[order[k]] = escaped / area;
      for (std::size_t j = 0; j < n; ++j) factors_[order[k] * n + j] = static_cast<float>(mean[j] / area);
    }
  }
}

}  // namespace luxel
