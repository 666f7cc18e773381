// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/apps/option_set.h"
#include "luxel/apps/run_record.h"
#include "luxel/check/diagnose.h"

namespace luxel {

// What `luxel check` says; docs/report.md lists the keys of its JSON.
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
