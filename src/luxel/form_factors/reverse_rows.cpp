// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/reverse_rows.h"

namespace luxel {
namespace {

// Calls body(j, place) for the factors of columns [begin, end), rows rising.
template <typename Body>
void for_columns(const ViewFactors& f, std::size_t begin, std::size_t end, Body body) {
  for (std::uint32_t j = 0; j < f.size(); ++j) {
    const auto* last = f.column.data() + f.row_begin[j + 1];
    const auto* at = std::lower_bound(f.column.data() + f.row_begin[j], last, begin);
    for (; at < last && *at < end; ++at) body(j, static_cast<std::size_t>(at - f.column.data()));
  }
}

}  // namespace

void ReverseRows::fill(const ViewFactors& factors, std::size_t begin, std::size_t end) {
  first_ = begin;
  begin_.assign(end - begin + 1, 0);
  for_columns(factors, begin, end,
              [&](std::uint32_t, std::size_t at) { ++begin_[factors.column[at] - begin + 1]; });
  for (std::size_t i = 0; i < end - begin; ++i) begin_[i + 1] += begin_[i];
  next_.assign(begin_.begin(), begin_.end() - 1);
  entries_.resize(begin_.back());
  for_columns(factors, begin, end, [&](std::uint32_t j, std::size_t at) {
    entries_[next_[factors.column[at] - begin]++] = {j, factors.standard_error[at], factors.factor[at]};
  });
}

}  // namespace luxel
