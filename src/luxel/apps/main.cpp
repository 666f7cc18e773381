// SPDX-License-Identifier: Apache-2.0
#include <exception>
#include <new>

#include <fmt/format.h>

#include "luxel/apps/commands.h"
#include "luxel/apps/console.h"
#include "luxel/apps/streams.h"
#include "luxel/apps/version.h"

namespace {

int run(int argc, char** argv) {
  luxel::CommandLine line(luxel::program_version);
  const std::unique_ptr<luxel::Command> commands[] = {
      luxel::make_bake(line),        luxel::make_resume(line),  luxel::make_relight(line),
      luxel::make_merge(line),       luxel::make_render(line),  luxel::make_export(line),
      luxel::make_reference(line),   luxel::make_compare(line), luxel::make_info(line),
      luxel::make_viewfactors(line), luxel::make_check(line)};
  const auto parsed = line.parse(argc, argv);
  if (!parsed.command) {
    luxel::print_result(parsed.text);
    return luxel::exit_fine;
  }
  luxel::catch_interrupts();
  for (const auto& command : commands)
    if (&command->options() == parsed.command) return command->run();
  return luxel::exit_misused;
}

}  // namespace

int main(int argc, char** argv) {
  luxel::secure_streams();
  try {
    return run(argc, argv);
  } catch (const luxel::UsageError& error) {
    luxel::print_note(fmt::format("luxel: {}\n", error.what()));
    return luxel::exit_misused;
  } catch (const std::bad_alloc&) {
    luxel::print_note("luxel: out of memory; fewer patches (--max-edge) or a smaller picture need less\n");
  } catch (const std::exception& error) {
    luxel::print_note(fmt::format("luxel: {}\n", error.what()));
  }
  return luxel::exit_failed;
}
