// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/limited_process.h"

#include <chrono>
#include <csignal>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace luxel {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

ProcessResult shell(const std::string& line, const ProcessLimits& limits = {}) {
  return run_limited({"/bin/sh", "-c", line}, limits, [] { return true; });
}

TEST(LimitedProcess, returns_output_and_exit_status) {
  const auto result = shell("echo out; echo err >&2; exit 7");
  EXPECT_EQ(result.end, ProcessEnd::exited);
  EXPECT_EQ(result.code, 7);
  EXPECT_EQ(result.output, "out\n");
}

TEST(LimitedProcess, returns_output_that_is_larger_than_a_pipe) {
  const auto result = shell("head -c 900000 /dev/zero");
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.output.size(), 900000u);
}

TEST(LimitedProcess, has_no_input_no_open_files_and_default_signals) {
  std::ofstream other("/dev/null");
  ::signal(SIGPIPE, SIG_IGN);
  const auto result =
      shell("cat; ls /proc/self/fd | tr '\\n' ' '; grep -c 'SigIgn:.*[1-9a-f]' /proc/self/status");
  ::signal(SIGPIPE, SIG_DFL);
  EXPECT_EQ(result.output, "0 1 2 3 0\n") << "3 is the folder that ls reads";
}

TEST(LimitedProcess, reports_a_signal_and_a_missing_program) {
  const auto aborted = shell("kill -ABRT $$");
  EXPECT_EQ(aborted.end, ProcessEnd::killed);
  EXPECT_EQ(aborted.code, SIGABRT);
  const auto missing = run_limited({"/nowhere/luxel-import"}, {}, [] { return true; });
  EXPECT_EQ(missing.end, ProcessEnd::exited);
  EXPECT_EQ(missing.code, 127);
}

TEST(LimitedProcess, is_killed_with_what_it_started_when_its_time_is_over) {
  const auto begin = Clock::now();
  EXPECT_EQ(shell("sleep 100 & sleep 100", {.wall_seconds = 0.3}).end, ProcessEnd::out_of_time);
  EXPECT_EQ(shell("exec >&-; sleep 100", {.wall_seconds = 0.3}).end, ProcessEnd::out_of_time)
      << "output closed";
  EXPECT_EQ(shell("while :; do :; done", {.cpu_seconds = 1}).end, ProcessEnd::out_of_time);
  EXPECT_LT(seconds_since(begin), 20.0);
}

TEST(LimitedProcess, does_not_wait_for_what_the_program_leaves_behind) {
  const auto begin = Clock::now();
  const auto result = shell("echo done; sleep 100 &");
  EXPECT_EQ(result.output, "done\n");
  EXPECT_LT(seconds_since(begin), 20.0);
}

TEST(LimitedProcess, ends_at_its_limits_of_memory_and_output) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  const auto starved =
      shell("head -c 300000000 /dev/zero | tail -c 299999999 | wc -c", {.memory = 100'000'000});
  EXPECT_EQ(starved.output, "0\n") << "tail holds all it reads";
#endif
  EXPECT_EQ(shell("head -c 1000 /dev/zero; sleep 100", {.output = 999}).end, ProcessEnd::too_much);
  EXPECT_EQ(shell("head -c 1000 /dev/zero", {.output = 1000}).end, ProcessEnd::exited);
}

TEST(LimitedProcess, stops_on_request) {
  int calls = 0;
  const auto result = run_limited({"/bin/sh", "-c", "sleep 100"}, {}, [&] { return ++calls < 3; });
  EXPECT_EQ(result.end, ProcessEnd::stopped);
  EXPECT_EQ(calls, 3);
}

TEST(LimitedProcess, is_in_a_process_group_of_its_own) {
  const auto result = shell("ps -o pgid= -p $$ 2>/dev/null || cut -d' ' -f5 /proc/$$/stat");
  EXPECT_NE(std::stoi(result.output), ::getpgrp()) << "Ctrl-C on a terminal does not reach it";
}

}  // namespace
}  // namespace luxel
