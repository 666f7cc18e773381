// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "luxel/parallel/workers.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct FormFactor {
  double value = 0.0;  // [0, 1]
  double error = 0.0;  // absolute, estimated; see FormFactors
  bool exact = true;   // closed form: nothing lies between, or nothing can be seen
};

// Form factors between two patch sides, with what stands between them. Side 2p is the front of patch p,
// 2p + 1 its back. Read-only after it was made; any number of threads may ask, and the answer depends on the
// question alone.
class FormFactors {
 public:
  // Keeps references to patches and tracer. About 0.4 s and 100 MB a million patches.
  FormFactors(const PatchSet& patches, const Tracer& tracer, const Workers& workers);

  // The share of the power leaving `from` that arrives at `to`, to the absolute tolerance asked for as far as
  // can be: `error` says what was reached.
  FormFactor between(std::size_t from, std::size_t to, double tolerance) const;

 private:
  const PatchSet& patches_;
  const Tracer& tracer_;
};

}  // namespace luxel
