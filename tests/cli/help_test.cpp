// SPDX-License-Identifier: Apache-2.0
// Help, completion and colours of the command.
#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cli/run_program.h"

namespace luxel::cli {
namespace {

constexpr const char* commands[] = {"bake",        "resume",   "relight",   "merge",     "render",
                                    "export",      "lightmap", "reference", "compare",   "info",
                                    "viewfactors", "check",    "ugr",       "ugr-table", "room",
                                    "photometry",  "report",   "sky",       "weather"};

// The options that a help text describes: lines that begin with one.
std::vector<std::string> options_in(const std::string& help) {
  std::vector<std::string> names;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    const auto at = line.find("--");
    if (at != 6 || (line[2] != '-' && line[2] != ' ')) continue;
    names.push_back(line.substr(at, line.find(' ', at) - at));
  }
  return names;
}

TEST(Help, is_short_first_and_whole_on_request) {
  const auto folder = fresh_folder("help_lengths");
  for (const std::string command : commands) {
    const auto brief = cli::run(folder, fmt::format("$LUXEL {} --help", command));
    const auto whole = cli::run(folder, fmt::format("$LUXEL {} --help-all", command));
    ASSERT_EQ(brief.code + whole.code, 0) << brief.err << whole.err;
    EXPECT_NE(brief.out.find("\nExamples\n  luxel " + command), std::string::npos) << brief.out;
    const auto first = options_in(brief.out);
    const auto all = options_in(whole.out);
    EXPECT_LE(first.size(), 12u) << command;
    EXPECT_GT(all.size(), first.size() - 1) << command;
    for (const auto& option : first)
      EXPECT_NE(std::find(all.begin(), all.end(), option), all.end()) << option;
    std::istringstream lines(whole.out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 110u) << line;
  }
  const auto bake = cli::run(folder, "$LUXEL bake --help").out;
  EXPECT_NE(bake.find("--quality"), std::string::npos);
  EXPECT_EQ(bake.find("--replicates"), std::string::npos);
  const auto whole = cli::run(folder, "$LUXEL bake --help-all").out;
  EXPECT_NE(whole.find("--replicates <count> [8]"), std::string::npos);
  EXPECT_NE(whole.find("Settings of --quality"), std::string::npos);
}

TEST(Help, names_the_exit_codes) {
  const auto folder = fresh_folder("help_codes");
  const auto help = cli::run(folder, "$LUXEL help").out;
  for (const char* code : {"0 fine", "1 failed", "2 misused", "3 stopped before the requested accuracy"})
    EXPECT_NE(help.find(code), std::string::npos) << help;
}

TEST(Help, ends_well_when_its_reader_does) {
  const auto folder = fresh_folder("help_pipe");
  const auto run = cli::run(folder, "bash -c 'set -o pipefail; $LUXEL bake --help-all | head -1'");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.out, "Usage: luxel bake SCENE [options]\n");
  EXPECT_EQ(run.err, "");
}

TEST(Help, has_colours_only_where_they_are_wanted) {
  const auto folder = fresh_folder("help_colours");
  const auto has_colour = [](const std::string& text) { return text.find("\033[") != std::string::npos; };
  EXPECT_FALSE(has_colour(cli::run(folder, "$LUXEL bake --help").out)) << "no terminal";
  EXPECT_TRUE(has_colour(cli::run(folder, "$LUXEL bake --help --color always").out));
  EXPECT_FALSE(has_colour(cli::run(folder, "$LUXEL bake --help --color=never").out));
  EXPECT_TRUE(has_colour(cli::run(folder, "$LUXEL bake none.obj --color always").err));
  EXPECT_FALSE(has_colour(cli::run(folder, "$LUXEL bake none.obj").err));
  EXPECT_EQ(cli::run(folder, "$LUXEL bake --color blue cornell-box.obj").code, 2);
}

// On a pseudo-terminal, which `script` (util-linux) makes.
TEST(Help, on_a_terminal_has_colours_unless_the_environment_forbids_them) {
  const auto folder = fresh_folder("help_terminal");
  if (cli::run(folder, "command -v script").code != 0) GTEST_SKIP() << "there is no program 'script'";
  const auto has_colour = [&](const std::string& variables) {
    const auto run = cli::run(
        folder, fmt::format("env -u NO_COLOR TERM=xterm {} script -qec \"$LUXEL bake --help\" /dev/null < "
                            "/dev/null",
                            variables));
    EXPECT_NE(run.out.find("Usage:"), std::string::npos) << run.out << run.err;
    return run.out.find("\033[") != std::string::npos;
  };
  EXPECT_TRUE(has_colour(""));
  EXPECT_FALSE(has_colour("NO_COLOR=1"));
  EXPECT_FALSE(has_colour("TERM=dumb"));
}

// Completions of bash after these words, the last of which is incomplete.
std::string offered(const std::filesystem::path& folder, const std::string& words) {
  write_file(folder / "complete.sh", "source completion.bash\nCOMP_WORDS=(" + words +
                                         ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_luxel\n"
                                         "echo \"${COMPREPLY[*]}\"\n");
  const auto run = cli::run(folder, "bash complete.sh");
  EXPECT_EQ(run.err, "");
  return run.out.empty() ? "" : run.out.substr(0, run.out.size() - 1);
}

TEST(Completion, in_bash_offers_commands_options_words_and_files) {
  const auto folder = fresh_folder("completion");
  ASSERT_EQ(cli::run(folder, "$LUXEL completion bash > completion.bash").code, 0);
  EXPECT_EQ(cli::run(folder, "bash -c '. ./completion.bash; complete -p luxel'").out,
            "complete -F _luxel luxel\n");
  EXPECT_EQ(offered(folder, "luxel ba"), "bake");
  EXPECT_EQ(offered(folder, "luxel help rel"), "relight");
  EXPECT_EQ(offered(folder, "luxel bake --qual"), "--quality");
  EXPECT_EQ(offered(folder, "luxel bake --help-"), "--help-all");
  EXPECT_EQ(offered(folder, "luxel render --repl"), "") << "an option of another command";
  EXPECT_EQ(offered(folder, "luxel bake --quality ''"), "draft medium final");
  EXPECT_EQ(offered(folder, "luxel bake --tone = rein"), "reinhard reinhard-local") << "--tone=rein";
  EXPECT_EQ(offered(folder, "luxel bake --smoothing o"), "on off");
  EXPECT_EQ(offered(folder, "luxel bake corn"), "cornell-box.obj") << "not its .mtl";
  write_file(folder / "corner.png", "");
  EXPECT_EQ(offered(folder, "luxel bake cornell-box.obj -o corn"), "corner.png");
  EXPECT_EQ(offered(folder, "luxel completion z"), "zsh");
}

}  // namespace
}  // namespace luxel::cli
