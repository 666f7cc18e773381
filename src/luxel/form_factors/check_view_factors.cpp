// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/check_view_factors.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "luxel/form_factors/reverse_rows.h"

namespace luxel {
namespace {

// Partial result of some rows: sums and extremes, joined in the order of rows.
struct Part {
  FactorCheck check;
  double squares = 0.0, expected = 0.0, area = 0.0;
  std::uint64_t pairs = 0;
};

// Counts each pair once: at its lower element, where that row is known.
void add_pair(const ViewFactors& f, std::uint32_t i, std::uint32_t j, std::uint64_t at,
              const ReverseRows::Entry* back, Part& part) {
  if (j <= i || !f.is_known[j]) return;
  const bool is_listed = at < f.count();
  const auto scale = 1.0 / std::max(f.area[i], f.area[j]);
  const auto a = f.area[i] * scale;
  const auto b = f.area[j] * scale;
  const auto difference = (is_listed ? a * f.factor[at] : 0.0) - (back ? b * back->factor : 0.0);
  const auto own = is_listed ? a * static_cast<double>(f.standard_error[at]) : 0.0;
  const auto other = back ? b * static_cast<double>(back->standard_error) : 0.0;
  part.squares += difference * difference;
  part.expected += own * own + other * other;
  if (std::fabs(difference) > part.check.worst_reciprocity) {
    part.check.worst_reciprocity = std::fabs(difference);
    part.check.worst_pair = {i, j};
  }
  ++part.pairs;
}

void add_row(const ViewFactors& f, const ReverseRows& reverse, std::uint32_t i, Part& part) {
  auto& check = part.check;
  double sum = 0.0;
  for (auto at = f.row_begin[i]; at < f.row_begin[i + 1]; ++at) {
    sum += f.factor[at];
    check.smallest = std::min(check.smallest, f.factor[at]);
    check.largest = std::max(check.largest, f.factor[at]);
  }
  reverse.for_row(f, i, [&](std::uint32_t j, std::uint64_t at, const ReverseRows::Entry* back) {
    add_pair(f, i, j, at, back, part);
  });
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
  if (part.check.worst_reciprocity > check.worst_reciprocity) {
    check.worst_reciprocity = part.check.worst_reciprocity;
    check.worst_pair = part.check.worst_pair;
  }
  check.environment += part.check.environment;
  check.backs += part.check.backs;
  check.dropped += part.check.dropped;
  all.squares += part.squares;
  all.expected += part.expected;
  all.area += part.area;
  all.pairs += part.pairs;
}

}  // namespace

FactorCheck check_view_factors(const ViewFactors& factors, const Context& context) {
  const auto grain = ReverseRows::rows_per_run(factors);
  const auto runs = (factors.size() + grain - 1) / grain;
  Part start;
  start.check.smallest = 1.0;
  std::vector<Part> parts(runs, start);
  std::vector<ReverseRows> reverse(static_cast<std::size_t>(context.threads()));
  // Processed in turns; the monitor is polled between them.
  const auto turn = static_cast<std::size_t>(context.threads());
  std::size_t done = 0;
  for (; done < runs; done += turn) {
    if (context.report({"check", static_cast<double>(done) / static_cast<double>(runs)}) == Next::stop) break;
    context.for_chunks(std::min(turn, runs - done), 1, [&](std::size_t begin, std::size_t end, int thread) {
      auto& own = reverse[static_cast<std::size_t>(thread)];
      for (auto run = done + begin; run < done + end; ++run) {
        const auto first = run * grain, last = std::min(factors.size(), first + grain);
        own.fill(factors, first, last);
        for (auto i = first; i < last; ++i)
          if (factors.is_known[i]) add_row(factors, own, static_cast<std::uint32_t>(i), parts[run]);
      }
    });
  }
  Part all = start;
  for (const auto& part : parts) join(part, all);
  auto check = all.check;
  check.is_whole = done >= runs;
  check.count = factors.count();
  if (all.pairs > 0) {
    check.reciprocity = std::sqrt(all.squares / static_cast<double>(all.pairs));
    check.expected_reciprocity = std::sqrt(all.expected / static_cast<double>(all.pairs));
  }
  if (all.area > 0.0)
    for (auto* fraction : {&check.environment, &check.backs, &check.dropped}) *fraction /= all.area;
  if (check.smallest > check.largest) check.smallest = 0.0;
  return check;
}

}  // namespace luxel
