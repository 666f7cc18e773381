// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/interrupts.h"

#include <csignal>
#include <cstring>

#include <unistd.h>

namespace luxel {
namespace {

constexpr unsigned grace_seconds = 1;

// A signal handler can access nothing but globals; these are the only ones.
volatile std::sig_atomic_t interrupt_requested = 0;
volatile std::sig_atomic_t interrupts_wait = 0;
const char* overdue_sentence = "";
int overdue_status = 0;

void on_interrupt(int signal) {
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
  ::alarm(0);  // noticed: what follows is the end
  return true;
}

}  // namespace luxel
