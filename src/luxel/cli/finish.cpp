// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/finish.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "luxel/cli/accuracy_text.h"
#include "luxel/cli/commands.h"
#include "luxel/cli/desktop.h"
#include "luxel/cli/streams.h"
#include "luxel/core/output_file.h"

namespace luxel {

void report_end(const RunRecord& record, const std::vector<std::string>& files, const std::string& accuracy,
                Console& console) {
  console.detail("stages", record.table());
  if (!files.empty()) console.say("wrote", fmt::format("{}", fmt::join(files, ", ")));
  if (!accuracy.empty()) console.say("error", accuracy);
  console.say("time", record.summary());
}

void finish(const RunReport& report, const RunSettings& run, Console& console) {
  report_end(*report.record, report.outputs, accuracy_text(report), console);
  // One text for both: it states the memory of this moment.
  const auto json = report.as_json();
  if (!run.report.empty()) write_file(run.report, json);
  if (run.json) print_result(json);
  if (run.opens) open_one_of(report.outputs, console);
}

int write_and_finish(const Baked& baked, const Tracer* tracer, const OptionSet& options,
                     const OutputSettings& settings, const Workplace& place, const StoredSamples& samples) {
  const auto written = write_outputs(baked, tracer, settings, place, samples);
  finish({.command = options.name(),
          .baked = &baked,
          .pages = written.pages,
          .camera = written.camera,
          .origin = baked.patches.origin,
          .outputs = written.files,
          .options = &options,
          .record = &place.record},
         settings.run, place.console);
  return written.stopped ? exit_stopped_early : exit_fine;
}

}  // namespace luxel
