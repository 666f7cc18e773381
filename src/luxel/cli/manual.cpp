// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "luxel/cli/commands.h"
#include "luxel/cli/file_date.h"
#include "luxel/cli/man_page.h"
#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/version.h"

namespace luxel {
namespace {

// `manual`: writes the manual pages.
class Manual final : public Command {
 public:
  Manual(OptionSet& options, const CommandLine& line) : Command(options), line_(line) {
    options.set_positional("DIR", folder_, "the folder of the pages, made where it is missing");
    options.set_examples(
        {{"luxel manual ~/.local/share/man/man1", "Then 'man luxel-bake' finds the page of 'luxel bake'."}});
  }

  int run() override {
    const std::filesystem::path folder(folder_);
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
      throw DeviceError(fmt::format("{}: cannot make this folder: {}", folder_, error.message()), folder_);
    const ManFooter footer{LUXEL_VERSION, today()};
    write_file(folder / "luxel.1", man_page(line_.commands(), footer));
    for (const auto& command : line_.commands())
      write_file(folder / fmt::format("luxel-{}.1", command->name()), man_page(*command, footer));
    return exit_fine;
  }

 private:
  const CommandLine& line_;
  std::string folder_;
};

}  // namespace

std::unique_ptr<Command> make_manual(CommandLine& line) {
  return std::make_unique<Manual>(line.command("manual", "write the manual pages of all commands for 'man'"),
                                  line);
}

}  // namespace luxel
