// SPDX-License-Identifier: Apache-2.0
#include "luxel/python/python_reporter.h"

#include <cmath>

#include <fmt/format.h>

#include "luxel/runs/setting_options.h"

namespace py = pybind11;

namespace luxel {
namespace {

constexpr int level_debug = 10, level_info = 20, level_warning = 30, level_error = 40;  // Python's logging

}  // namespace

py::list as_pairs(const std::vector<Hint>& hints) {
  py::list pairs;
  for (const auto& hint : hints)
    pairs.append(py::make_tuple(std::string(option_of(hint.setting)), hint.value));
  return pairs;
}

void PythonReporter::say(const std::string& label, const std::string& text) {
  send(level_info, fmt::format("{}: {}", label, text), {});
}

void PythonReporter::detail(const std::string& label, const std::string& text) {
  send(level_debug, fmt::format("{}: {}", label, text), {});
}

void PythonReporter::announce(const std::string& stage) { report({.stage = stage}); }

std::string PythonReporter::worded(const std::string& sentence, const std::vector<Hint>& hints) const {
  std::string text;
  for (const auto& hint : hints)
    text += fmt::format("{}--{}{}{}", text.empty() ? "" : ", ", option_of(hint.setting),
                        hint.value.empty() ? "" : " ", hint.value);
  return text.empty() ? sentence : fmt::format("{} ({})", sentence, text);
}

LogSink PythonReporter::log_as(Notes notes) {
  return [this, notes](const Message& message) {
    const auto level = message.severity == Severity::error     ? level_error
                       : message.severity == Severity::warning ? level_warning
                       : notes == Notes::shown                 ? level_info
                                                               : level_debug;
    send(level, message.text, message.hints);
  };
}

Monitor PythonReporter::monitor_that(bool heeds_interrupt) {
  return [this, heeds_interrupt](const Progress& progress) {
    const auto next = report(progress);
    return heeds_interrupt ? next : Next::go_on;
  };
}

Next PythonReporter::report(const Progress& progress) {
  const py::gil_scoped_acquire locked;
  if (is_interrupted() || !poll_signals()) return Next::stop;
  if (progress_.is_none()) return Next::go_on;
  try {
    const auto error = std::isfinite(progress.error) ? progress.error : 0.0;
    const auto answer = progress_(std::string(progress.stage), progress.done, progress.rays, error);
    is_stopped_ = answer.ptr() == Py_False;
  } catch (py::error_already_set& raised) {
    error_.emplace(raised);
  }
  return is_interrupted() ? Next::stop : Next::go_on;
}

bool PythonReporter::poll_signals() {
  if (PyErr_CheckSignals() == 0) return true;
  error_.emplace();
  return false;
}

void PythonReporter::send(int level, const std::string& text, const std::vector<Hint>& hints) {
  const py::gil_scoped_acquire locked;
  if (error_ || log_.is_none()) return;
  try {
    log_(level, text, as_pairs(hints));
  } catch (py::error_already_set& raised) {
    error_.emplace(raised);
  }
}

void PythonReporter::finish() {
  if (error_) throw py::error_already_set(*error_);
}

}  // namespace luxel
