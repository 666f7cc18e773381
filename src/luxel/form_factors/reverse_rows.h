// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "luxel/core/none.h"
#include "luxel/form_factors/view_factors.h"

namespace luxel {

// Factors towards a run of elements: the columns [begin, end) transposed to rows. The whole transpose would
// need as much memory again; one run at a time needs that of a run, and runs can be made in parallel.
class ReverseRows {
 public:
  // Rows of one run; the last run has fewer. At most some hundred runs whatever the size, since each run
  // reads every row.
  static std::size_t rows_per_run(const ViewFactors& factors) {
    constexpr std::size_t least = 256, max_runs = 128;
    return std::max(least, (factors.size() + max_runs - 1) / max_runs);
  }

  // Replaces the previous content. Cost: each factor of these columns is read twice, plus a binary search per
  // row.
  void fill(const ViewFactors& factors, std::size_t begin, std::size_t end);

  // F_ji and its standard error.
  struct Entry {
    std::uint32_t row = 0;  // j
    float standard_error = 0.0f;
    double factor = 0.0;
  };

  // Calls body(j, place of F_ij, entry of F_ji) for every j, rising, that i sees or that sees i; the place is
  // factors.count(), the entry null where there is none.
  template <typename Body>
  void for_row(const ViewFactors& factors, std::size_t i, Body body) const {
    auto at = factors.row_begin[i];
    const auto end = factors.row_begin[i + 1];
    auto entry = entries_.data() + begin_[i - first_];
    const auto last = entries_.data() + begin_[i - first_ + 1];
    while (at < end || entry < last) {
      const auto to = at < end ? factors.column[at] : none;
      const auto from = entry < last ? entry->row : none;
      const auto j = std::min(to, from);
      body(j, to == j ? at++ : factors.count(), from == j ? entry++ : nullptr);
    }
  }

 private:
  std::size_t first_ = 0;
  std::vector<std::uint64_t> begin_;  // [row of the run + 1]
  std::vector<Entry> entries_;        // rows rising within one of the run
  std::vector<std::uint64_t> next_;   // [row of the run], while it is filled
};

}  // namespace luxel
