// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/core/hint.h"

namespace luxel {

// Where a run reports, and what stops it: the terminal of the command, or functions of a Python program.
class Reporter {
 public:
  Reporter() = default;
  virtual ~Reporter() = default;
  Reporter(const Reporter&) = delete;
  Reporter& operator=(const Reporter&) = delete;

  // A sentence under a label: "light", "2 lamp materials, 3400 lm together".
  virtual void say(const std::string& label, const std::string& text) = 0;
  // The same for those who want to know more.
  virtual void detail(const std::string& label, const std::string& text) = 0;
  // A stage of unknown progress begins.
  virtual void announce(const std::string& stage) = 0;
  // The stage has ended.
  virtual void clear_bar() = 0;
  // The sentence, with the settings that may help, as this reporter's users change them.
  virtual std::string worded(const std::string& sentence, const std::vector<Hint>& hints) const = 0;
  // Whether a person wants the run to end.
  virtual bool is_interrupted() const = 0;
  // From here on nothing is lost that took long to compute: an interrupt may end the program at once.
  virtual void light_is_safe() {}

  enum class Notes { shown, detailed };
  // Warnings and errors; notes are sentences, or details.
  virtual LogSink log_as(Notes notes) = 0;
  // Receives progress, and answers stop once the run shall end. Where a stage must go on even then (writing
  // what there is), heeds_interrupt is false.
  virtual Monitor monitor_that(bool heeds_interrupt) = 0;

  LogSink log(Notes notes = Notes::shown) { return log_as(notes); }
  Monitor monitor(bool heeds_interrupt = true) { return monitor_that(heeds_interrupt); }
  // The same threads and processes, with this log and monitor.
  Context reporting(const Context& context, bool heeds_interrupt = true) {
    return context.with_log(log()).with_monitor(monitor(heeds_interrupt));
  }
  // The same, where notes are details.
  Context detailing(const Context& context) {
    return context.with_log(log(Notes::detailed)).with_monitor(monitor());
  }
};

}  // namespace luxel
