// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <exception>
#include <new>
#include <thread>

#include <fmt/format.h>

#include "luxel/cli/commands.h"
#include "luxel/cli/console.h"
#include "luxel/cli/flags.h"
#include "luxel/cli/streams.h"
#include "luxel/core/mpi_ranks.h"
#include "luxel/version.h"

namespace {

// Of several ranks only those of a solve are needed, and only the first one speaks.
int run(luxel::Command& command) {
  const auto ranks = luxel::join_ranks();
  const bool is_first = !ranks || ranks->rank() == 0;
  if (!is_first && !command.takes_ranks()) return luxel::exit_fine;
  if (!is_first) luxel::keep_silent();
  command.set_ranks(ranks.get());
  try {
    const auto code = command.run();
    // The others may still wait for this one.
    if (ranks && luxel::interrupted()) luxel::leave_ranks(code);
    return code;
  } catch (const std::exception& error) {
    if (!ranks) throw;
    // What is wrong with a file is wrong for all: the first one says it and ends the others.
    if (!is_first) std::this_thread::sleep_for(std::chrono::seconds(1));
    luxel::print_note(is_first
                          ? fmt::format("luxel: {}\n", luxel::with_flags(error))
                          : fmt::format("luxel: rank {}: {}\n", ranks->rank(), luxel::with_flags(error)));
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
      luxel::make_reference(line),
      luxel::make_compare(line),
      luxel::make_info(line),
      luxel::make_viewfactors(line),
      luxel::make_check(line),
#ifdef LUXEL_HAS_VIEWER
      luxel::make_view(line),
#endif
  };
  const auto parsed = line.parse(argc, argv);
  if (!parsed.command) {
    luxel::print_result(parsed.text);
    return luxel::exit_fine;
  }
  luxel::catch_interrupts();
  for (const auto& command : commands)
    if (&command->options() == parsed.command) return run(*command);
  return luxel::exit_misused;
}

}  // namespace

int main(int argc, char** argv) {
  luxel::secure_streams();
  try {
    return run(argc, argv);
  } catch (const luxel::UsageError& error) {
    luxel::print_note(fmt::format("luxel: {}\n", luxel::with_flags(error)));
    return luxel::exit_misused;
  } catch (const std::bad_alloc&) {
    luxel::print_note("luxel: out of memory; fewer patches (--max-edge) or a smaller picture need less\n");
  } catch (const std::exception& error) {
    luxel::print_note(fmt::format("luxel: {}\n", luxel::with_flags(error)));
  }
  return luxel::exit_failed;
}
