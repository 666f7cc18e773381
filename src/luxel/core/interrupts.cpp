// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/interrupts.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <ctime>

#include <unistd.h>

namespace luxel {
namespace {

constexpr unsigned grace_seconds = 1;
constexpr std::int64_t max_ualarm = 999'999;  // µs

// A signal handler can access nothing but globals; these are the only ones.
volatile std::sig_atomic_t interrupt_requested = 0;
volatile std::sig_atomic_t interrupts_wait = 0;
volatile std::sig_atomic_t end_is_set = 0;
std::atomic<std::int64_t> interrupt_time = 0;  // µs
static_assert(std::atomic<std::int64_t>::is_always_lock_free);
const char* overdue_sentence = "";
int overdue_status = 0;

std::int64_t microseconds() {
  std::timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000 + now.tv_nsec / 1'000;
}

void on_interrupt(int signal) {
  interrupt_time = microseconds();
  interrupt_requested = 1;
  std::signal(signal, SIG_DFL);  // the next signal ends the program
  if (!interrupts_wait) ::alarm(grace_seconds);
}

// No stage has noticed the interrupt in time. Files are complete or absent, whenever the program ends.
void on_overdue(int) {
  [[maybe_unused]] const auto written =
      ::write(STDERR_FILENO, overdue_sentence, std::strlen(overdue_sentence));
  ::_exit(overdue_status);
}

}  // namespace

void catch_interrupts(const char* sentence, int exit_status) {
  overdue_sentence = sentence;
  overdue_status = exit_status;
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  std::signal(SIGALRM, on_overdue);
}

void let_interrupts_wait(bool wait) { interrupts_wait = wait ? 1 : 0; }

void ignore_interrupts() {
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
}

bool interrupted() {
  if (interrupt_requested == 0) return false;
  if (!end_is_set) ::alarm(0);  // noticed: what follows is the end
  return true;
}

bool end_in_its_second() {
  const auto left = interrupt_time + grace_seconds * std::int64_t{1'000'000} - microseconds();
  if (left <= 0) return true;
  end_is_set = 1;
  ::ualarm(static_cast<useconds_t>(std::min(left, max_ualarm)), 0);
  return false;
}

}  // namespace luxel
