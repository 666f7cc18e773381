// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "luxel/classical/form_factor_row.h"
#include "luxel/classical/operator.h"
#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/gather_sides.h"

namespace luxel {

// Fractions of the light leaving a receiver that reach no other receiver. With the row of factors they sum
// to one, to rounding; where factors are integrated, the escaped fraction may be below zero by their
// error.
struct RowLosses {
  std::vector<double> escaped;   // [receiver]: meets nothing
  std::vector<double> at_backs;  // [receiver][material]: meets the back of that one-sided material
};

// A transport operator that can give its rows, factor by factor: dense, hemicube and lines. Elements are the
// receivers of all_gather_sides().
class RowOperator : public TransportOperator {
 public:
  struct Factor {
    std::uint32_t receiver = 0;
    float fraction = 0.0f;  // [0, 1]
  };
  using RowBody = std::function<void(std::size_t receiver, std::span<const Factor> row)>;

  std::size_t size() const final { return sides_.size(); }
  std::size_t bands() const final { return patches_.band_count(); }
  std::span<const std::uint32_t> row_begins() const final { return row_begins_; }
  void apply(std::span<const float> radiosity, std::span<float> irradiance, std::size_t begin,
             std::size_t end, const Context& context) const final;

  // Calls body for the rows [begin, end), in order; a row is alive during the call. Any number of threads may
  // call.
  virtual void for_rows(std::size_t begin, std::size_t end, const RowBody& body) const = 0;

  const PatchSet& patches() const { return patches_; }
  const GatherSides& sides() const { return sides_; }
  const RowLosses& losses() const { return losses_; }

 protected:
  // Keeps a reference to patches.
  RowOperator(const PatchSet& patches, const Context& context);

  // Returns the factors of such a row to receivers; the rest is stored as losses of the receiver.
  std::vector<Factor> factors_of(const FormFactorRow& row) const;
  void book_losses(std::size_t receiver, const FormFactorRow& row);
  RowLosses& losses() { return losses_; }

 private:
  const PatchSet& patches_;
  GatherSides sides_;
  std::vector<std::uint32_t> row_begins_;
  RowLosses losses_;
};

}  // namespace luxel
