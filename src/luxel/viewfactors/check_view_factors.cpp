// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewfactors/check_view_factors.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace luxel {
namespace {

constexpr std::size_t rows_a_chunk = 1024;

// Where F_ij stands, or count().
std::uint64_t find(const ViewFactors& f, std::uint32_t i, std::uint32_t j) {
  const auto begin = f.column.begin() + static_cast<std::ptrdiff_t>(f.row_begin[i]);
  const auto end = f.column.begin() + static_cast<std::ptrdiff_t>(f.row_begin[i + 1]);
  const auto at = std::lower_bound(begin, end, j);
  return at != end && *at == j ? static_cast<std::uint64_t>(at - f.column.begin()) : f.count();
}

// Of some rows: sums and extremes, to be joined in their order.
struct Part {
  FactorCheck check;
  double squares = 0.0, expected = 0.0, area = 0.0;
  std::uint64_t pairs = 0;
};

void add_pair(const ViewFactors& f, std::uint32_t i, std::uint64_t at, Part& part) {
  const auto j = f.column[at];
  if (j == i || !f.is_known[j]) return;
  const auto back = find(f, j, i);
  const bool is_listed = back < f.count();
  if (is_listed && j < i) return;  // the other row saw to it
  const auto scale = 1.0 / std::max(f.area[i], f.area[j]);
  const auto a = f.area[i] * scale;
  const auto b = f.area[j] * scale;
  const auto difference = a * f.factor[at] - (is_listed ? b * f.factor[back] : 0.0);
  const auto own = a * static_cast<double>(f.standard_error[at]);
  const auto other = is_listed ? b * static_cast<double>(f.standard_error[back]) : 0.0;
  part.squares += difference * difference;
  part.expected += own * own + other * other;
  part.check.worst_reciprocity = std::max(part.check.worst_reciprocity, std::fabs(difference));
  ++part.pairs;
}

void add_row(const ViewFactors& f, std::uint32_t i, Part& part) {
  auto& check = part.check;
  double sum = 0.0;
  for (auto at = f.row_begin[i]; at < f.row_begin[i + 1]; ++at) {
    sum += f.factor[at];
    check.smallest = std::min(check.smallest, f.factor[at]);
    check.largest = std::max(check.largest, f.factor[at]);
    add_pair(f, i, at, part);
  }
  for (const auto& sink : f.sink) sum += sink.factor[i];
  if (std::fabs(sum - 1.0) > check.worst_row_sum) {
    check.worst_row_sum = std::fabs(sum - 1.0);
    check.worst_row = i;
  }
  ++check.rows;
  part.area += f.area[i];
  check.environment += f.area[i] * f.sink[ViewFactors::environment].factor[i];
  check.backs += f.area[i] * f.sink[ViewFactors::backs].factor[i];
  check.dropped += f.area[i] * f.sink[ViewFactors::dropped].factor[i];
}

void join(const Part& part, Part& all) {
  auto& check = all.check;
  if (part.check.worst_row_sum > check.worst_row_sum) {
    check.worst_row_sum = part.check.worst_row_sum;
    check.worst_row = part.check.worst_row;
  }
  check.rows += part.check.rows;
  check.smallest = std::min(check.smallest, part.check.smallest);
  check.largest = std::max(check.largest, part.check.largest);
  check.worst_reciprocity = std::max(check.worst_reciprocity, part.check.worst_reciprocity);
  check.environment += part.check.environment;
  check.backs += part.check.backs;
  check.dropped += part.check.dropped;
  all.squares += part.squares;
  all.expected += part.expected;
  all.area += part.area;
  all.pairs += part.pairs;
}

}  // namespace

FactorCheck check_view_factors(const ViewFactors& factors, const Workers& workers) {
  Part start;
  start.check.smallest = 1.0;
  std::vector<Part> parts((factors.size() + rows_a_chunk - 1) / rows_a_chunk, start);
  workers.for_chunks(factors.size(), rows_a_chunk, [&](std::size_t begin, std::size_t end, int) {
    for (auto i = begin; i < end; ++i)
      if (factors.is_known[i]) add_row(factors, static_cast<std::uint32_t>(i), parts[begin / rows_a_chunk]);
  });
  Part all = start;
  for (const auto& part : parts) join(part, all);
  auto check = all.check;
  if (all.pairs > 0) {
    check.reciprocity = std::sqrt(all.squares / static_cast<double>(all.pairs));
    check.expected_reciprocity = std::sqrt(all.expected / static_cast<double>(all.pairs));
  }
  if (all.area > 0.0)
    for (auto* share : {&check.environment, &check.backs, &check.dropped}) *share /= all.area;
  if (factors.count() == 0) check.smallest = 0.0;
  return check;
}

}  // namespace luxel
