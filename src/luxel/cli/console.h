// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>

#include "luxel/cli/terminal.h"
#include "luxel/core/context.h"
#include "luxel/core/interrupts.h"
#include "luxel/core/progress.h"
#include "luxel/core/time_left.h"
#include "luxel/runs/reporter.h"

namespace luxel {

struct RunSettings;

// Messages of the program while it works, on the standard error stream: short lines that begin with a
// label, and a progress bar on a terminal or occasional lines elsewhere; with --progress json one line
// of JSON per message for other programs. With --quiet only errors. Of results, which go to the standard
// output, only the names of written files come from here.
class Console final : public Reporter {
 public:
  Console();
  explicit Console(const RunSettings& run);
  ~Console() override;

  // Prints a line with a label in a separate column: "scene     room.obj: 32 triangles". Further lines of the
  // text are indented to that column.
  void say(const std::string& label, const std::string& text) override;
  // Prints such a line with --verbose only.
  void detail(const std::string& label, const std::string& text) override;
  // Prints the name of a file to the standard output, for programs; not with --quiet or --json, nor where the
  // same terminal shows it at the end of the run.
  void wrote(const std::string& file) override;
  // Shows a stage of unknown progress on a terminal, until the next message or bar.
  void announce(const std::string& stage) override;
  // Removes the bar from the screen.
  void clear_bar() override;
  // Returns the sentence with the options that may help.
  std::string worded(const std::string& sentence, const std::vector<Hint>& hints) const override;
  bool is_interrupted() const override;
  void light_is_safe() override;
  bool is_second_over() override;
  // Returns a sink for warnings and errors; notes are lines or details.
  LogSink log_as(Notes notes) override;
  // Returns a monitor that draws progress and returns stop after Ctrl-C. heeds_interrupt: false for a stage
  // that must continue even then, such as writing results.
  Monitor monitor_that(bool heeds_interrupt) override;
  // Returns whether messages go to a terminal, where people read them.
  bool is_read() const { return terminal_ && !quiet_ && !as_json_; }

 private:
  using Clock = std::chrono::steady_clock;
  void show(const Progress& progress);
  void tell_program(const Progress& progress);

  bool quiet_;
  bool verbose_;
  bool as_json_;
  bool terminal_;
  bool lists_files_;
  TextPaint paint_;
  bool bar_shown_ = false;
  std::string stage_;
  Clock::time_point stage_begin_;
  Clock::time_point last_shown_;
  TimeLeft time_left_;
};

// Silences consoles from now on and leaves signals to another process: of several processes, only the first
// prints.
void keep_silent();

// The message of a command that is stopped before it has results to write; its exit code.
int stopped_before_light(Console& console);

}  // namespace luxel
