// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "luxel/core/log.h"
#include "luxel/core/progress.h"

namespace luxel {

class Ranks;
class ThreadPool;

struct ContextOptions {
  int threads = 0;  ///< 0: every core the process may use. Fewer run where the system starts no more
  const Ranks* ranks = nullptr;  ///< processes that share the work; must outlive the context. Null: none
  LogSink log = {};              ///< receives warnings; may be empty
  Monitor monitor = {};          ///< receives progress and may stop the work; may be empty
};

/// Execution context of a call: a fixed number of threads, the processes that share the work, a log for
/// warnings and a monitor for progress. Results depend neither on the number of threads nor of processes:
/// loops are cut into the same chunks for one thread and for sixty-four.
///
/// A copy shares the threads and costs less than a microsecond, and so do with_log(), with_monitor() and
/// quiet(). Several threads may use one context at the same time, if its log and its monitor allow it.
class Context {
 public:
  Context() : Context(ContextOptions{}) {}  ///< every core, alone, quiet
  /// threads: 0 takes every core the process may use.
  explicit Context(int threads) : Context(ContextOptions{.threads = threads}) {}
  /// All processes call the same functions with the same values, and divide the work of those documented so.
  explicit Context(ContextOptions options);

  int threads() const;
  const Ranks* ranks() const { return ranks_; }  ///< null where this process is alone
  const LogSink& log() const { return log_; }
  const Monitor& monitor() const { return monitor_; }

  Context with_log(LogSink log) const;          ///< the same threads and processes, another log
  Context with_monitor(Monitor monitor) const;  ///< the same threads and processes, another monitor
  Context quiet() const;                        ///< the same threads and processes, no log, no monitor

  /// Sends a warning to the log, where there is one. Call from the thread that called the library.
  void warn(std::string text, std::vector<Hint> hints = {}) const {
    luxel::warn(log_, std::move(text), std::move(hints));
  }
  /// Sends a note, for information.
  void note(std::string text) const {
    if (log_) log_({.severity = Severity::note, .text = std::move(text)});
  }
  /// Reports progress to the monitor and returns its reply; Next::go_on without a monitor.
  Next report(const Progress& progress) const { return tell(monitor_, progress); }

  /// Calls body(begin, end, thread) for [0, count) cut at multiples of grain; a body may call it too. thread:
  /// in [0, threads()), never the same for two calls at one time. Rethrows an exception of a body.
  void for_chunks(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t begin, std::size_t end, int thread)>& body) const;

  /// Runs body on these threads, so that a library that uses TBB inside (Embree's builder) keeps to their
  /// number.
  void run(const std::function<void()>& body) const;

 private:
  std::shared_ptr<const ThreadPool> threads_;
  const Ranks* ranks_;
  LogSink log_;
  Monitor monitor_;
};

/// Sum over [0, count) of term(i), in double: per fixed chunk, chunks added in order, so the bits do not
/// depend on threads.
double ordered_sum(const Context& context, std::size_t count, const std::function<double(std::size_t)>& term);

}  // namespace luxel
