// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "luxel/form_factors/check_view_factors.h"
#include "luxel/form_factors/enforce.h"
#include "luxel/form_factors/exact_view_factors.h"
#include "luxel/form_factors/sample_view_factors.h"
#include "luxel/form_factors/view_factors.h"
#include "luxel/runs/option_set.h"
#include "luxel/runs/run_record.h"

namespace luxel {

// The result of `luxel viewfactors`; docs/json.md lists the keys of its JSON.
struct ViewFactorReport {
  const ViewFactors* factors = nullptr;
  std::string between, sides;
  std::size_t patches = 0;
  std::optional<SampleFactorsReport> sampled = {};
  double error_target = 0.0, row_error_target = 0.0;
  std::uint64_t predicted_memory = 0;  // of the whole program, bytes
  std::optional<ExactFactorsReport> exact = {};
  FactorCheck check = {};  // of the factors before they were enforced
  std::optional<Enforcement> enforcement = {};
  std::optional<FactorCheck> check_after = {};
  std::vector<std::string> outputs = {};
  const OptionSet* options = nullptr;
  const RunRecord* record = nullptr;

  // The report as lines of text, with the factors where there are few elements.
  std::string as_text() const;
  std::string as_json() const;
};

}  // namespace luxel
