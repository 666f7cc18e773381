// SPDX-License-Identifier: Apache-2.0
#include "luxel/apps/finish.h"

#include <fmt/format.h>

#include "luxel/file/output_file.h"

namespace luxel {

void finish(const RunReport& report, const RunSettings& run, Console& console) {
  console.say(report.record->table());
  if (!run.report.empty()) write_file(run.report, report.as_json());
  if (run.json) return fmt::print("{}", report.as_json());
  for (const auto& output : report.outputs) fmt::print("{}\n", output);
}

}  // namespace luxel
