// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>

#include "luxel/runs/reporter.h"

namespace luxel {

// Reports to functions of a Python program. Ctrl-C, and a progress function that returns False or raises, end
// the run. It lives while Python's lock is held, and is called from the calling thread with or without it.
class PythonReporter final : public Reporter {
 public:
  // progress: called with stage, fraction done, rays and error, or None. log: with a level of Python's
  // logging, a sentence, and settings that may help as pairs.
  PythonReporter(pybind11::object progress, pybind11::object log)
      : progress_(std::move(progress)), log_(std::move(log)) {}

  void say(const std::string& label, const std::string& text) override;
  void detail(const std::string& label, const std::string& text) override;
  void announce(const std::string& stage) override;
  void clear_bar() override {}
  std::string worded(const std::string& sentence, const std::vector<Hint>& hints) const override;
  bool is_interrupted() const override { return is_stopped_ || error_.has_value(); }
  LogSink log_as(Notes notes) override;
  Monitor monitor_that(bool heeds_interrupt) override;

  // Runs work without Python's lock, so that other threads of the program continue. Raises what a function of
  // the program raised, or KeyboardInterrupt, once work has ended.
  template <typename Work>
  std::invoke_result_t<Work> run(Work work) {
    try {
      if constexpr (std::is_void_v<std::invoke_result_t<Work>>) {
        {
          const pybind11::gil_scoped_release unlocked;
          work();
        }
        finish();
      } else {
        std::optional<std::invoke_result_t<Work>> result;
        {
          const pybind11::gil_scoped_release unlocked;
          result.emplace(work());
        }
        finish();
        return std::move(*result);
      }
    } catch (const pybind11::error_already_set&) {
      throw;
    } catch (...) {
      finish();
      throw;
    }
  }

 private:
  Next report(const Progress& progress);
  void send(int level, const std::string& text, const std::vector<Hint>& hints);
  bool poll_signals();
  void finish();

  pybind11::object progress_, log_;
  std::optional<pybind11::error_already_set> error_;  // raised by a function of the program
  bool is_stopped_ = false;                           // progress returned False
};

// Settings as pairs of the option's name in Python and the new value.
pybind11::list as_pairs(const std::vector<Hint>& hints);

}  // namespace luxel
