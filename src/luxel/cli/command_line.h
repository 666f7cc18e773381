// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "luxel/runs/option_set.h"

namespace luxel {

// The commands, and the parser that selects one of them and sets its options: first the defaults, then the
// file named by --config, then the flags.
class CommandLine {
 public:
  explicit CommandLine(std::string version);
  ~CommandLine();

  // The reference stays valid.
  OptionSet& command(std::string name, std::string summary);

  // All commands, in their order.
  std::span<const std::unique_ptr<OptionSet>> commands() const { return commands_; }

  // Returns the chosen command. Returns nothing for help, the version or --print-config; `text` is then the
  // text to print. Throws UsageError; InputError for a wrong file.
  struct Parsed {
    OptionSet* command = nullptr;
    std::string text;
  };
  Parsed parse(int argc, const char* const* argv);

 private:
  // Throws UsageError, with the nearest name, where the first word is no command.
  OptionSet& command_named(const std::string& word) const;
  void read_file(OptionSet& chosen, const std::string& path);
  std::string version_;
  std::vector<std::unique_ptr<OptionSet>> commands_;
};

}  // namespace luxel
