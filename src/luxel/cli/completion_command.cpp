// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "luxel/cli/commands.h"
#include "luxel/cli/completion.h"
#include "luxel/cli/streams.h"

namespace luxel {
namespace {

// `completion`: prints a script for a shell.
class Completion final : public Command {
 public:
  Completion(OptionSet& options, const CommandLine& line) : Command(options), line_(line) {
    options.set_positional("SHELL", shell_, "bash|zsh|fish");
    options.set_examples({{"eval \"$(luxel completion bash)\"", "in ~/.bashrc"},
                          {"luxel completion zsh > ~/.zfunc/_luxel", "a folder of $fpath"},
                          {"luxel completion fish > ~/.config/fish/completions/luxel.fish", "for fish"}});
  }

  int run() override {
    struct Shell {
      const char* name;
      std::string (*script)(Commands commands);
    };
    constexpr Shell shells[] = {
        {"bash", bash_completion}, {"zsh", zsh_completion}, {"fish", fish_completion}};
    for (const auto& shell : shells)
      if (shell_ == shell.name) {
        print_result(shell.script(line_.commands()));
        return exit_fine;
      }
    throw UsageError(fmt::format("luxel completion: expected bash, zsh or fish, not '{}'", shell_));
  }

 private:
  const CommandLine& line_;
  std::string shell_;
};

}  // namespace

std::unique_ptr<Command> make_completion(CommandLine& line) {
  return std::make_unique<Completion>(
      line.command("completion", "print a script that completes commands and options in a shell"), line);
}

}  // namespace luxel
