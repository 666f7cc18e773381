// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>

#include "luxel/core/log.h"
#include "luxel/core/progress.h"

namespace luxel {

struct RunSettings;

// What the program says while it works, on the standard error stream: sentences, and a progress bar on a
// terminal or a line now and then where there is none; with --progress json a line of JSON for another
// program. Results go to the standard output and never through here.
class Console {
 public:
  Console();
  explicit Console(const RunSettings& run);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  void say(const std::string& line);
  LogSink log();
  // Draws progress; answers stop once Ctrl-C was pressed. Where a stage must go on even then (writing what
  // there is), give heeds_interrupt = false.
  Monitor monitor(bool heeds_interrupt = true);
  // On a terminal: names a stage that cannot say how far it has come, until the next word or bar.
  void announce(const std::string& stage);
  // Takes the bar off the screen.
  void clear_bar();

 private:
  using Clock = std::chrono::steady_clock;
  void show(const Progress& progress);
  void tell_program(const Progress& progress);

  bool quiet_;
  bool as_json_;
  bool terminal_;
  bool bar_shown_ = false;
  std::string stage_;
  Clock::time_point stage_begin_;
  Clock::time_point last_shown_;
};

// From now on consoles say nothing and signals are left to another one: of several processes, the first
// speaks.
void keep_silent();

// What a command says that is stopped before it has anything to write; its exit code.
int stopped_before_light(Console& console);

// Makes Ctrl-C (SIGINT) and SIGTERM a request that interrupted() answers; a second one ends the program at
// once.
void catch_interrupts();
bool interrupted();

}  // namespace luxel
