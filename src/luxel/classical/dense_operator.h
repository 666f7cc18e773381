// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "luxel/classical/method_options.h"
#include "luxel/classical/row_operator.h"
#include "luxel/core/context.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Transport as the whole matrix of form factors (Goral et al. 1984; closed forms of Schröder and Hanrahan
// 1993): n² factors for n receivers. Reciprocal to rounding: the factor of each pair is found once. Memory: 4
// n² bytes, and 16 for each pair that had to be integrated. Cost: n² / 2 form factors.
class DenseOperator final : public RowOperator {
 public:
  // Keeps a reference to patches. Returns nothing if the monitor stops the work.
  static std::optional<DenseOperator> make(const PatchSet& patches, const Tracer& tracer,
                                           const DenseOptions& options, const Context& context = {});

  void for_rows(std::size_t begin, std::size_t end, const RowBody& body) const override;

  // [receiver][receiver], row by row.
  std::span<const float> factors() const { return factors_; }
  // Pairs whose factor is integrated, not in closed form.
  std::size_t integrated_pairs() const { return integrated_.size(); }
  // Maximum error of the irradiance F radiosity, and of the sky's light through the remainders of the rows of
  // F, if the errors of all factors have the same sign: [receiver][band], W/m².
  std::vector<double> irradiance_error(std::span<const float> radiosity) const;

  // Makes all sides of a face receive the same light: each row and its remainder become the mean of those of
  // the face, weighted by area. The solution is then constant over each face, exactly as if faces were the
  // elements. face: [patch]. Patches of one face lie on one plane and have one material.
  void join_faces(std::span<const std::uint32_t> face);

 private:
  struct Integrated {
    std::uint32_t receiver = 0, other = 0;
    float error = 0.0f,
          error_back = 0.0f;  // of the factor from receiver to other, and from other to receiver
  };

  DenseOperator(const PatchSet& patches, const Context& context);

  std::vector<float> factors_;
  std::vector<Integrated> integrated_;
  double exact_error_ = 0.0;            // the most that a factor in closed form may be off by
  std::vector<double> error_at_backs_;  // [receiver]: how far the sum of its factors to backs may be off
};

}  // namespace luxel
