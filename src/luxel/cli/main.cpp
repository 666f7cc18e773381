// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <exception>
#include <new>
#include <string>
#include <thread>

#include <fmt/format.h>

#include "luxel/cli/commands.h"
#include "luxel/cli/console.h"
#include "luxel/cli/flags.h"
#include "luxel/cli/streams.h"
#include "luxel/cli/terminal.h"
#include "luxel/core/process_usage.h"
#include "luxel/core/ranks.h"
#include "luxel/core/standard_streams.h"
#include "luxel/core/utf8.h"
#include "luxel/version.h"

namespace {

void print_error(const std::string& sentence) {
  const auto paint = luxel::paint_for(luxel::error_output);
  luxel::print_note(
      fmt::format("{} {}\n", paint(luxel::Style::error, "luxel:"), luxel::printable(sentence, false)));
}

std::string sentence_of(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
    return "out of memory; fewer patches (--max-edge) or a smaller picture need less";
  return luxel::with_flags(error);
}

// Only a solve needs several ranks; only the first one writes to the terminal.
int run(luxel::Command& command) {
  const auto ranks = luxel::join_ranks();
  const bool is_first = !ranks || ranks->rank() == 0;
  if (!is_first && !command.takes_ranks()) return luxel::exit_fine;
  if (!is_first) luxel::keep_silent();
  command.set_ranks(ranks.get());
  try {
    luxel::keep_inputs(command.options());
    if (const auto removed = luxel::remove_leftovers_of(command.options()); is_first && !removed.empty())
      luxel::print_note(removed + "\n");
    const auto code = command.run();
    // The other ranks may still wait for this one.
    if (ranks && luxel::interrupted()) luxel::leave_ranks(code);
    return code;
  } catch (const std::exception& error) {
    if (!ranks) throw;
    // An error in a file is the same for all ranks: the first one reports it and ends the others.
    if (!is_first) std::this_thread::sleep_for(std::chrono::seconds(1));
    print_error(is_first ? sentence_of(error)
                         : fmt::format("rank {}: {}", ranks->rank(), sentence_of(error)));
    luxel::leave_ranks(luxel::exit_failed);
    throw;
  }
}

int run(int argc, char** argv) {
  luxel::CommandLine line(LUXEL_VERSION);
  const std::unique_ptr<luxel::Command> commands[] = {
      luxel::make_bake(line),
      luxel::make_resume(line),
      luxel::make_relight(line),
      luxel::make_merge(line),
      luxel::make_render(line),
      luxel::make_export(line),
      luxel::make_lightmap_command(line),
      luxel::make_probe(line),
      luxel::make_daylight(line),
      luxel::make_measure(line),
      luxel::make_ugr(line),
      luxel::make_ugr_table(line),
      luxel::make_report(line),
      luxel::make_photometry(line),
      luxel::make_sky(line),
      luxel::make_weather(line),
      luxel::make_room(line),
      luxel::make_reference(line),
      luxel::make_compare(line),
      luxel::make_info(line),
      luxel::make_viewfactors(line),
      luxel::make_check(line),
      luxel::make_completion(line),
      luxel::make_manual(line),
#ifdef LUXEL_HAS_VIEWER
      luxel::make_view(line),
#endif
  };
  const auto parsed = line.parse(argc, argv);
  if (!parsed.command) {
    luxel::print_styled(parsed.text);
    return luxel::exit_fine;
  }
  luxel::catch_interrupts("stopped: no further file is written\n", luxel::exit_stopped_early);
  for (const auto& command : commands)
    if (&command->options() == parsed.command) return run(*command);
  return luxel::exit_misused;
}

}  // namespace

int main(int argc, char** argv) {
  luxel::keep_freed_memory();
  luxel::secure_streams();
  luxel::set_colour_mode(luxel::colour_mode_of(argc, argv));
  try {
    return run(argc, argv);
  } catch (const luxel::UsageError& error) {
    print_error(luxel::with_flags(error));
    return luxel::exit_misused;
  } catch (const std::exception& error) {
    print_error(sentence_of(error));
  }
  return luxel::exit_failed;
}
