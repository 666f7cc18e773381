// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/runs/option_set.h"
#include "luxel/runs/run_record.h"
#include "luxel/session/diagnose.h"

namespace luxel {

// The output of `luxel check`; docs/json.md lists the keys of its JSON.
struct CheckText {
  const Scene* scene = nullptr;
  const CheckReport* report = nullptr;
  std::vector<std::string> outputs = {};
  const OptionSet* options = nullptr;
  const RunRecord* record = nullptr;

  std::string as_text() const;
  std::string as_json() const;
};

}  // namespace luxel
