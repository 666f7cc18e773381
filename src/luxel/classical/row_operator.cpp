// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/row_operator.h"

#include <algorithm>

#include "luxel/core/none.h"

namespace luxel {
namespace {

constexpr std::size_t rows_per_block = 4;

}  // namespace

RowOperator::RowOperator(const PatchSet& patches, const Context& context)
    : patches_(patches), sides_(all_gather_sides(patches, make_patch_tree(patches, context))) {
  for (std::size_t row = 0; row < size(); row += rows_per_block)
    row_begins_.push_back(static_cast<std::uint32_t>(row));
  row_begins_.push_back(static_cast<std::uint32_t>(size()));
  losses_.escaped.assign(size(), 0.0);
  losses_.at_backs.assign(size() * patches.materials.size(), 0.0);
}

void RowOperator::apply(std::span<const float> radiosity, std::span<float> irradiance, std::size_t begin,
                        std::size_t end, const Context& context) const {
  const auto bands = patches_.band_count();
  context.for_chunks(end - begin, rows_per_block, [&](std::size_t first, std::size_t last, int) {
    std::vector<double> sum(bands);
    for_rows(begin + first, begin + last, [&](std::size_t receiver, std::span<const Factor> row) {
      std::fill(sum.begin(), sum.end(), 0.0);
      for (const auto& factor : row)
        for (std::size_t b = 0; b < bands; ++b)
          sum[b] += static_cast<double>(factor.fraction) *
                    static_cast<double>(radiosity[factor.receiver * bands + b]);
      for (std::size_t b = 0; b < bands; ++b) irradiance[receiver * bands + b] = static_cast<float>(sum[b]);
    });
  });
}

std::vector<RowOperator::Factor> RowOperator::factors_of(const FormFactorRow& row) const {
  std::vector<Factor> factors;
  factors.reserve(row.entries.size());
  for (const auto& entry : row.entries)
    if (const auto receiver = sides_.receiver_of_side[entry.side.index()]; receiver != none)
      factors.push_back({receiver, entry.factor});
  return factors;
}

void RowOperator::book_losses(std::size_t receiver, const FormFactorRow& row) {
  losses_.escaped[receiver] = row.escaped;
  for (const auto& entry : row.entries)
    if (sides_.receiver_of_side[entry.side.index()] == none)
      losses_.at_backs[receiver * patches_.materials.size() +
                       static_cast<std::size_t>(patches_.material[entry.side.patch()])] +=
          static_cast<double>(entry.factor);
}

}  // namespace luxel
