// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/table_output.h"

#include "luxel/cli/streams.h"
#include "luxel/core/ending_of.h"
#include "luxel/core/output_file.h"

namespace luxel {

void write_table(const TableResult& result, const RunSettings& run, Console& console) {
  for (const auto& output : run.outputs)
    if (!result.other || !result.other(output))
      write_file(output, ending_of(output) == ".csv" ? result.csv() : result.json({}));
  if (!run.report.empty()) write_file(run.report, result.json(run.outputs));
  console.say(result.label, result.summary);
  for (const auto& warning : result.warnings) warn(console.log(), warning);
  if (run.json) return print_result(result.json(run.outputs));
  for (const auto& output : run.outputs) print_result(output + "\n");
  if (run.outputs.empty()) print_result(result.csv());
}

}  // namespace luxel
