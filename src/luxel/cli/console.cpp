// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/console.h"

#include <algorithm>
#include <cmath>
#include <csignal>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "luxel/cli/commands.h"
#include "luxel/cli/settings.h"
#include "luxel/cli/streams.h"
#include "luxel/core/time_left.h"

namespace luxel {
namespace {

using Json = nlohmann::ordered_json;

// A signal handler can reach nothing but a global: the one there is.
volatile std::sig_atomic_t interrupt_requested = 0;

bool is_silent = false;  // the same for all consoles, set once before there are any

void note(const std::string& text) {
  if (!is_silent) print_note(text);
}

void on_interrupt(int signal) {
  interrupt_requested = 1;
  std::signal(signal, SIG_DFL);  // the next one ends the program
}

std::string duration(double seconds) {
  if (seconds < 100.0) return fmt::format("{:.0f} s", seconds);
  if (seconds < 6000.0)
    return fmt::format("{:.0f} min {:02.0f} s", std::floor(seconds / 60.0), std::fmod(seconds, 60.0));
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

constexpr int bar_width = 28;

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
}
void keep_silent() {
  is_silent = true;
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
}
bool interrupted() { return interrupt_requested != 0; }

Console::Console() : Console(RunSettings()) {}
Console::Console(const RunSettings& run)
    : quiet_(run.quiet), as_json_(run.progress == "json"), terminal_(isatty(STDERR_FILENO) == 1) {}
Console::~Console() { clear_bar(); }

void Console::say(const std::string& line) {
  if (quiet_) return;
  clear_bar();
  note(fmt::format("{}\n", line));
}

LogSink Console::log() {
  return [this](const Message& message) {
    clear_bar();
    if (message.severity == Severity::warning)
      note(fmt::format("warning: {}\n", message.text));
    else if (!quiet_)
      note(fmt::format("{}\n", message.text));
  };
}

Monitor Console::monitor(bool heeds_interrupt) {
  return [this, heeds_interrupt](const Progress& progress) {
    if (as_json_)
      tell_program(progress);
    else if (!quiet_)
      show(progress);
    return heeds_interrupt && interrupted() ? Next::stop : Next::go_on;
  };
}

Context Console::reporting(const Context& context, bool heeds_interrupt) {
  return context.with_log(log()).with_monitor(monitor(heeds_interrupt));
}

void Console::announce(const std::string& stage) {
  if (quiet_ || as_json_ || !terminal_) return;
  note(fmt::format("\r\033[K{} ...", stage));
  bar_shown_ = true;
}

void Console::clear_bar() {
  if (!bar_shown_) return;
  note("\r\033[K");
  bar_shown_ = false;
}

void Console::show(const Progress& progress) {
  const auto now = Clock::now();
  if (stage_ != progress.stage) {
    stage_ = progress.stage;
    stage_begin_ = now;
    last_shown_ = now;
    if (!terminal_) return;
  }
  const auto pause = terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(10'000);
  if (now - last_shown_ < pause) return;
  last_shown_ = now;

  const auto seconds = std::chrono::duration<double>(now - stage_begin_).count();
  auto numbers = fmt::format("{:3.0f} %", 100.0 * progress.done);
  if (progress.error > 0.0) numbers += fmt::format("  error {:.2g} %", 100.0 * progress.error);
  if (progress.rays > 0 && seconds > 0.0)
    numbers += fmt::format("  {:.1f} Mray/s", 1e-6 * static_cast<double>(progress.rays) / seconds);
  if (const auto left = time_left(progress.done, seconds))
    numbers += fmt::format("  {} left", duration(*left));
  if (!terminal_) {
    note(fmt::format("{}: {}\n", progress.stage, numbers));
    return;
  }
  const auto filled = static_cast<int>(std::clamp(progress.done, 0.0, 1.0) * bar_width);
  note(fmt::format("\r\033[K{:10} [{:#<{}}{:.<{}}] {}", progress.stage, "", filled, "", bar_width - filled,
                   numbers));
  bar_shown_ = true;
}

namespace {

double rounded(double value, int decimals) {
  const auto unit = std::pow(10.0, decimals);
  return std::round(value * unit) / unit;
}

}  // namespace

// JSON knows no infinity: an error that is not known yet is 0.
void Console::tell_program(const Progress& progress) {
  const auto now = Clock::now();
  const bool is_new = stage_ != progress.stage;
  if (!is_new && now - last_shown_ < std::chrono::milliseconds(200)) return;
  if (is_new) stage_begin_ = now;
  stage_ = progress.stage;
  last_shown_ = now;
  const auto seconds = std::chrono::duration<double>(now - stage_begin_).count();
  const auto left = time_left(progress.done, seconds);
  const Json line = {{"stage", stage_},
                     {"done", rounded(std::clamp(progress.done, 0.0, 1.0), 4)},
                     {"rays", progress.rays},
                     {"error", std::isfinite(progress.error) ? progress.error : 0.0},
                     {"seconds", rounded(seconds, 2)},
                     {"seconds_left", left ? Json(rounded(*left, 2)) : Json()}};
  note(line.dump() + "\n");
}

int stopped_before_light(Console& console) {
  warn(console.log(), "stopped before there was any light to write: no file was written");
  return exit_stopped_early;
}

}  // namespace luxel
