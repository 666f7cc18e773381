// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace luxel {

struct ProcessLimits {
  std::uint64_t memory = 0;        // bytes of address space; 0: no limit. Without effect under sanitizers
  std::uint64_t cpu_seconds = 60;  // of processor time
  double wall_seconds = 120.0;     // until the process is killed
  std::uint64_t output = 1 << 20;  // bytes that the process may write to its standard output
};

enum class ProcessEnd {
  exited,       // code is the exit status; 127: the program could not be started
  killed,       // code is the signal that ended it
  out_of_time,  // beyond cpu_seconds or wall_seconds
  too_much,     // beyond `output`
  stopped,      // by goes_on
};

struct ProcessResult {
  ProcessEnd end = ProcessEnd::exited;
  int code = 0;
  std::string output;  // of standard output
};

// Runs a program under limits and returns when it has ended. command: the path of the program, then its
// arguments. The program has an empty standard input, its error output is discarded, it leaves no core file,
// and it inherits no other open file. It runs in a process group of its own, so that Ctrl-C reaches this
// process alone; the group is killed at a limit, when goes_on() returns false (called at least ten times per
// second), and at the latest when the calling thread ends. Throws DeviceError where the system cannot start a
// process. Linux only. Several threads may call it at the same time.
ProcessResult run_limited(const std::vector<std::string>& command, const ProcessLimits& limits,
                          const std::function<bool()>& goes_on);

}  // namespace luxel
