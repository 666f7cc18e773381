// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/finish.h"

#include "luxel/cli/commands.h"
#include "luxel/cli/streams.h"
#include "luxel/core/output_file.h"

namespace luxel {

void finish(const RunReport& report, const RunSettings& run, Console& console) {
  console.say(report.record->summary(run.verbose));
  if (!run.report.empty()) write_file(run.report, report.as_json());
  if (run.json) return print_result(report.as_json());
  for (const auto& output : report.outputs) print_result(output + "\n");
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
