// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/core/hint.h"

namespace luxel {

// Receives the reports of a run and can interrupt it: a terminal, or functions of a Python program.
class Reporter {
 public:
  Reporter() = default;
  virtual ~Reporter() = default;
  Reporter(const Reporter&) = delete;
  Reporter& operator=(const Reporter&) = delete;

  // Reports a sentence under a label: "light", "2 lamp materials, 3400 lm together".
  virtual void say(const std::string& label, const std::string& text) = 0;
  // Reports a detail, which is shown only on request.
  virtual void detail(const std::string& label, const std::string& text) = 0;
  // Receives each file that is written whole.
  virtual void wrote(const std::string& /*file*/) {}
  // Begins a stage of unknown progress.
  virtual void announce(const std::string& stage) = 0;
  // Ends that stage.
  virtual void clear_bar() = 0;
  // Returns the sentence with the settings that may help, in the form that this reporter's users need.
  virtual std::string worded(const std::string& sentence, const std::vector<Hint>& hints) const = 0;
  // Returns whether the user has interrupted the run.
  virtual bool is_interrupted() const = 0;
  // From here on nothing is lost that took long to compute: an interrupt may end the program at once.
  virtual void light_is_safe() {}
  // Called after an interrupt, once a file has the light: the program ends a second after the interrupt,
  // whatever is unfinished then. Returns whether that second is over.
  virtual bool is_second_over() { return false; }

  enum class Notes { shown, detailed };
  // Returns a sink for warnings, errors and notes, which are reported as sentences or as details.
  virtual LogSink log_as(Notes notes) = 0;
  // Returns a monitor that receives progress and returns stop after an interrupt. heeds_interrupt: false for
  // a stage that must continue even then, such as writing results.
  virtual Monitor monitor_that(bool heeds_interrupt) = 0;

  LogSink log(Notes notes = Notes::shown) { return log_as(notes); }
  Monitor monitor(bool heeds_interrupt = true) { return monitor_that(heeds_interrupt); }
  // Returns the context with this log and monitor.
  Context reporting(const Context& context, bool heeds_interrupt = true) {
    return context.with_log(log()).with_monitor(monitor(heeds_interrupt));
  }
  // Returns the context with this log and monitor, notes as details.
  Context detailing(const Context& context) {
    return context.with_log(log(Notes::detailed)).with_monitor(monitor());
  }
};

}  // namespace luxel
