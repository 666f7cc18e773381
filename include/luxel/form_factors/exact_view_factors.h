// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/form_factors/view_elements.h"
#include "luxel/form_factors/view_factors.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct ExactFactorsOptions {
  double tolerance = 1e-5;  ///< absolute, of each factor between two patches that only partly see each other
  double min_factor = 0.0;  ///< factors below are dropped; their sum is kept
  double seconds = 600.0;   ///< predicted time beyond which it is refused; 0: never
};

struct ExactFactorsReport {
  std::uint64_t pairs = 0;         ///< of patch sides
  double predicted_seconds = 0.0;  ///< on these threads
};

/// View factors in closed form where two patches see each other fully, integrated adaptively where they are
/// partly occluded (form_factors/form_factor.h), each pair once: so reciprocity is exact. Standard errors are
/// the estimated errors of integration. The rest of a row to 1 counts as environment, which therefore
/// carries the error of the row.
///
/// Quadratic: one factor for every pair of patch sides. Throws InputError with the predicted time where that
/// is more than options.seconds; it is measured on some pairs first. Memory: 28 bytes per pair of elements.
/// Empty if the monitor stopped it. The same bits on any number of threads.
std::optional<ViewFactors> exact_view_factors(const PatchSet& patches, const Tracer& tracer,
                                              const ViewElements& elements,
                                              const ExactFactorsOptions& options, ExactFactorsReport& report,
                                              const Context& context = {});

}  // namespace luxel
