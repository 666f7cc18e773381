// SPDX-License-Identifier: Apache-2.0
// Files installed with the command: manual pages, completions of all commands, and desktop files.
#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cli/run_program.h"

namespace luxel::cli {
namespace {

namespace fs = std::filesystem;

bool has_program(const fs::path& folder, const std::string& name) {
  return cli::run(folder, "command -v " + name).code == 0;
}

// The names of the commands, from the help of the program.
std::vector<std::string> command_names(const fs::path& folder) {
  std::istringstream lines(cli::run(folder, "$LUXEL help").out);
  std::vector<std::string> names;
  bool is_listed = false;
  for (std::string line; std::getline(lines, line);) {
    if (line == "Commands")
      is_listed = true;
    else if (line.empty())
      is_listed = false;
    else if (is_listed && line.size() > 2 && line[2] != ' ')
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  return names;
}

// The options that --help-all lists, with their dashes.
std::vector<std::string> options_of(const fs::path& folder, const std::string& command) {
  std::istringstream lines(cli::run(folder, fmt::format("$LUXEL {} --help-all", command)).out);
  std::vector<std::string> names;
  for (std::string line; std::getline(lines, line);)
    if (const auto at = line.find("--"); at == 6 && (line[2] == '-' || line[2] == ' '))
      names.push_back(line.substr(at, line.find(' ', at) - at));
  return names;
}

std::string without(std::string text, const std::string& part) {
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at))
    text.erase(at, part.size());
  return text;
}

// Text as troff prints it, for names of options.
std::string page(const fs::path& file) {
  return without(without(without(read_file(file), "\\fB"), "\\fR"), "\\");
}

TEST(Manual, has_a_page_for_each_command_with_every_option) {
  const auto folder = fresh_folder("manual");
  ASSERT_EQ(cli::run(folder, "SOURCE_DATE_EPOCH=86400 $LUXEL manual pages/man1").code, 0);
  const auto names = command_names(folder);
  ASSERT_GT(names.size(), 20u);
  const auto program = page(folder / "pages/man1/luxel.1");
  for (const auto& name : names) {
    EXPECT_NE(program.find(fmt::format("\nluxel-{}(1)\n", name)), std::string::npos) << name;
    const auto text = page(folder / fmt::format("pages/man1/luxel-{}.1", name));
    EXPECT_NE(text.find(" 1 1970-01-02 "), std::string::npos) << "the day of SOURCE_DATE_EPOCH";
    const auto options = options_of(folder, name);
    EXPECT_GE(options.size(), 5u) << name;
    for (const auto& option : options)
      EXPECT_TRUE(text.find("\n" + option) != std::string::npos ||
                  text.find(", " + option) != std::string::npos)
          << name << " " << option;
  }
}

TEST(Manual, is_accepted_by_troff_and_found_by_whatis) {
  const auto folder = fresh_folder("manual_lint");
  ASSERT_EQ(cli::run(folder, "$LUXEL manual .").code, 0);
  int checks = 0;
  if (has_program(folder, "groff")) {
    ++checks;
    const auto run =
        cli::run(folder, "for f in luxel*.1; do groff -man -ww -Tutf8 $f > /dev/null || exit 1; done");
    EXPECT_EQ(run.code, 0);
    EXPECT_EQ(run.err, "");
  }
  if (has_program(folder, "mandoc")) {
    ++checks;
    const auto run = cli::run(folder, "mandoc -T lint -W warning luxel*.1");
    EXPECT_EQ(run.code, 0) << run.out;
  }
  if (has_program(folder, "lexgrog")) {
    ++checks;
    const auto run = cli::run(folder, "lexgrog luxel*.1");
    EXPECT_EQ(run.code, 0) << run.out;
    EXPECT_NE(run.out.find("\"luxel-bake - solve the light"), std::string::npos) << run.out;
  }
  if (checks == 0) GTEST_SKIP() << "there is no groff, mandoc or lexgrog";
}

TEST(Manual, escapes_what_troff_would_read) {
  const auto folder = fresh_folder("manual_escapes");
  ASSERT_EQ(cli::run(folder, "$LUXEL manual .").code, 0);
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".1") continue;
    std::istringstream lines(read_file(entry.path()));
    for (std::string line; std::getline(lines, line);) {
      EXPECT_TRUE(std::all_of(line.begin(), line.end(), [](char c) { return c >= ' ' && c <= '~'; })) << line;
      EXPECT_FALSE(line.starts_with("'")) << line;
      EXPECT_TRUE(!line.starts_with('.') || (line.size() > 2 && line[1] >= 'A' && line[1] <= 'Z')) << line;
    }
  }
}

TEST(Manual, refuses_a_folder_that_cannot_be_made) {
  const auto folder = fresh_folder("manual_refused");
  write_file(folder / "file", "");
  const auto run = cli::run(folder, "$LUXEL manual file/pages");
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.err.find("file/pages"), std::string::npos) << run.err;
}

TEST(Completion, of_each_shell_lists_all_commands_with_all_options) {
  const auto folder = fresh_folder("completion_of_all");
  const auto bash = cli::run(folder, "$LUXEL completion bash").out;
  const auto zsh = cli::run(folder, "$LUXEL completion zsh").out;
  const auto fish = cli::run(folder, "$LUXEL completion fish").out;
  for (const auto& name : command_names(folder)) {
    const auto of_bash =
        bash.substr(std::min(bash.find(fmt::format("    '{} '*) options=", name)), bash.size()));
    const auto of_zsh = zsh.substr(std::min(zsh.find(fmt::format("    {})\n", name)), zsh.size()));
    const auto bash_line = of_bash.substr(0, of_bash.find('\n'));
    const auto zsh_case = of_zsh.substr(0, of_zsh.find(";;"));
    EXPECT_NE(zsh.find(fmt::format("    '{}:", name)), std::string::npos) << name;
    EXPECT_NE(fish.find(fmt::format(" -f -a {} ", name)), std::string::npos) << name;
    for (const auto& option : options_of(folder, name)) {
      EXPECT_TRUE(bash_line.find(option + " ") != std::string::npos ||
                  bash_line.find(option + "'") != std::string::npos)
          << name << " " << option;
      EXPECT_NE(zsh_case.find("'*" + option + "["), std::string::npos) << name << " " << option;
      EXPECT_NE(fish.find(fmt::format("'__fish_seen_subcommand_from {}' -l {} ", name, option.substr(2))),
                std::string::npos)
          << name << " " << option;
    }
  }
  EXPECT_NE(zsh.find("'*-o["), std::string::npos);
  EXPECT_EQ(cli::run(folder, "$LUXEL completion tcsh").code, 2);
  for (const std::string shell : {"bash", "zsh", "fish"})
    if (shell == "bash" || has_program(folder, shell)) {
      EXPECT_EQ(cli::run(folder, fmt::format("$LUXEL completion {0} > script && {0} -n script", shell)).code,
                0);
    }
}

TEST(Desktop, files_are_valid_and_open_solutions) {
  const auto folder = fresh_folder("desktop");
  const fs::path source = LUXEL_SOURCE_DIR "/tools/package/desktop";
  const auto entry = read_file(source / "luxel.desktop");
  const auto mime = read_file(source / "luxel.xml");
  const auto metainfo = read_file(source / "local.luxel.luxel.metainfo.xml");
  EXPECT_NE(entry.find("\nExec=luxel view %f\n"), std::string::npos);
  EXPECT_NE(entry.find("application/x-vtkhdf;"), std::string::npos);
  EXPECT_NE(mime.find("<mime-type type=\"application/x-vtkhdf\">"), std::string::npos);
  EXPECT_NE(mime.find("<glob pattern=\"*.vtkhdf\"/>"), std::string::npos);
  EXPECT_NE(metainfo.find("<launchable type=\"desktop-id\">luxel.desktop</launchable>"), std::string::npos);
  if (has_program(folder, "desktop-file-validate")) {
    const auto run =
        cli::run(folder, fmt::format("desktop-file-validate '{}/luxel.desktop'", source.string()));
    EXPECT_EQ(run.code, 0) << run.out << run.err;
  }
  if (has_program(folder, "appstreamcli")) {
    const auto run =
        cli::run(folder, fmt::format("appstreamcli validate --no-net '{}'/*.metainfo.xml", source.string()));
    EXPECT_EQ(run.code, 0) << run.out << run.err;
  }
  if (has_program(folder, "update-mime-database")) {
    fs::create_directories(folder / "mime/packages");
    fs::copy_file(source / "luxel.xml", folder / "mime/packages/luxel.xml");
    EXPECT_EQ(cli::run(folder, "update-mime-database mime").code, 0);
    EXPECT_NE(read_file(folder / "mime/globs").find("application/x-vtkhdf:*.vtkhdf\n"), std::string::npos);
  }
}

}  // namespace
}  // namespace luxel::cli
