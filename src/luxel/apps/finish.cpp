// SPDX-License-Identifier: Apache-2.0
#include "luxel/apps/finish.h"

#include "luxel/apps/streams.h"
#include "luxel/file/output_file.h"

namespace luxel {

void finish(const RunReport& report, const RunSettings& run, Console& console) {
  console.say(report.record->table());
  if (!run.report.empty()) write_file(run.report, report.as_json());
  if (run.json) return print_result(report.as_json());
  for (const auto& output : report.outputs) print_result(output + "\n");
}

}  // namespace luxel
