// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/console.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string_view>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "luxel/cli/commands.h"
#include "luxel/cli/flags.h"
#include "luxel/cli/streams.h"
#include "luxel/cli/wrapped_text.h"
#include "luxel/core/standard_streams.h"
#include "luxel/core/startable_threads.h"
#include "luxel/core/utf8.h"
#include "luxel/runs/quantity.h"
#include "luxel/runs/settings.h"

namespace luxel {
namespace {

using Json = nlohmann::ordered_json;

bool is_silent = false;  // the same for all consoles, set once before any exists

void note(const std::string& text) {
  if (!is_silent) print_note(text);
}

constexpr int bar_width = 28;
constexpr std::size_t label_width = 10;

// "41 %   error 2.1 %   12 s left". The light has no error before the first answer; then it is a picture.
std::string numbers_of(const Progress& progress, std::optional<double> left) {
  auto text = fmt::format("{:3.0f} %", 100.0 * std::clamp(progress.done, 0.0, 1.0));
  if (is_known_error(progress.error))
    text += fmt::format("   error {}", percent_of(progress.error));
  else if (progress.stage == "light")
    text += "   first light";
  if (left) text += fmt::format("   {} left", rough_duration(*left));
  return text;
}

}  // namespace

void keep_silent() {
  is_silent = true;
  ignore_interrupts();
}

Console::Console() : Console(RunSettings()) {}
Console::Console(const RunSettings& run)
    : quiet_(run.quiet),
      verbose_(run.verbose),
      as_json_(run.progress == "json"),
      terminal_(is_terminal(error_output)),
      lists_files_(!quiet_ && !run.json && !(is_read() && is_terminal_device(standard_output))),
      paint_(paint_for(error_output)) {
  const auto wanted = run.threads > 0 ? run.threads : static_cast<int>(std::thread::hardware_concurrency());
  if (const auto started = startable_threads(wanted); started < wanted)
    warn(log(),
         fmt::format("only {} of {} threads can be started, as a limit on processes or memory prevents "
                     "more; the result does not depend on it",
                     started, wanted));
}
Console::~Console() { clear_bar(); }

void Console::say(const std::string& label, const std::string& text) {
  if (quiet_ || as_json_) return;
  clear_bar();
  std::istringstream lines(printable(text));
  std::string head = label;
  for (std::string line; std::getline(lines, line); head.clear()) {
    const std::string blanks(label_width - std::min(label_width - 1, width_of(head)), ' ');
    note(fmt::format("{}{}{}\n", paint_(Style::label, head), blanks, line));
  }
}

void Console::detail(const std::string& label, const std::string& text) {
  if (verbose_) say(label, text);
}

void Console::wrote(const std::string& file) {
  if (!lists_files_) return;
  clear_bar();
  print_result(file + "\n");
}

LogSink Console::log_as(Notes notes) {
  return [this, notes](const Message& message) {
    if (message.severity == Severity::note) {
      const auto text = with_flags(message.text, message.hints);
      notes == Notes::shown ? say("note", text) : detail("note", text);
      return;
    }
    const bool is_error = message.severity == Severity::error;
    if (quiet_ && !is_error) return;
    clear_bar();
    const auto head = is_error ? paint_(Style::error, "error:") : paint_(Style::warning, "warning:");
    note(fmt::format("{} {}\n", head, printable(with_flags(message.text, message.hints), false)));
  };
}

Monitor Console::monitor_that(bool heeds_interrupt) {
  return [this, heeds_interrupt](const Progress& progress) {
    const bool has_light = progress.stage == "refine" && is_known_error(progress.error);
    if (progress.stage == "light" || has_light) let_interrupts_wait(true);  // they write the light so far
    if (as_json_)
      tell_program(progress);
    else if (!quiet_)
      show(progress);
    return heeds_interrupt && interrupted() ? Next::stop : Next::go_on;
  };
}

std::string Console::worded(const std::string& sentence, const std::vector<Hint>& hints) const {
  return with_flags(sentence, hints);
}

void Console::light_is_safe() { let_interrupts_wait(false); }
bool Console::is_second_over() { return end_in_its_second(); }
bool Console::is_interrupted() const { return interrupted(); }

void Console::announce(const std::string& stage) {
  if (quiet_ || as_json_ || !terminal_) return;
  note(fmt::format("\r\033[K{} ...", paint_(Style::label, stage)));
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

  const auto numbers = numbers_of(
      progress, time_left_.note(progress, std::chrono::duration<double>(now - stage_begin_).count(), now));
  if (!terminal_) {
    note(fmt::format("{:<{}}{}\n", progress.stage, label_width, numbers));
    return;
  }
  const auto filled = static_cast<int>(std::clamp(progress.done, 0.0, 1.0) * bar_width);
  const auto label = fmt::format("{:<{}}", progress.stage, label_width);
  note(fmt::format("\r\033[K{}[{}{:.<{}}] {}", paint_(Style::label, label),
                   paint_(Style::good, std::string(static_cast<std::size_t>(filled), '#')), "",
                   bar_width - filled, numbers));
  bar_shown_ = true;
}

namespace {

double rounded(double value, int decimals) {
  const auto unit = std::pow(10.0, decimals);
  return std::round(value * unit) / unit;
}

}  // namespace

// JSON has no infinity: an error that is not known yet is 0.
void Console::tell_program(const Progress& progress) {
  const auto now = Clock::now();
  const bool is_new = stage_ != progress.stage;
  if (!is_new && now - last_shown_ < std::chrono::milliseconds(200)) return;
  if (is_new) stage_begin_ = now;
  stage_ = progress.stage;
  last_shown_ = now;
  const auto seconds = std::chrono::duration<double>(now - stage_begin_).count();
  const auto left = time_left_.note(progress, seconds, now);
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
