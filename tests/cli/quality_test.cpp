// SPDX-License-Identifier: Apache-2.0
// --quality: values of several options under one word.
#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/run_program.h"

namespace luxel::cli {
namespace {

// name -> value and origin, as --print-config has them.
std::map<std::string, std::string> configuration(const std::filesystem::path& folder,
                                                 const std::string& more) {
  const auto run = cli::run(folder, "$LUXEL " + more + " --print-config");
  EXPECT_EQ(run.code, 0) << run.err;
  std::map<std::string, std::string> result;
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);)
    if (const auto equals = line.find(" = "); equals != std::string::npos && line[0] != '#')
      result[line.substr(0, equals)] = line.substr(equals + 3);
  return result;
}

// The rows of the table in the document: option, then its value by quality.
std::map<std::string, std::vector<std::string>> documented_table() {
  std::istringstream lines(read_file(LUXEL_SOURCE_DIR "/docs/command-line.md"));
  std::map<std::string, std::vector<std::string>> rows;
  bool is_inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("| `--quality` | `draft`")) is_inside = true;
    if (!is_inside || !line.starts_with("| `--")) {
      if (is_inside && line.empty()) break;
      continue;
    }
    std::istringstream cells(line.substr(1));
    std::vector<std::string> row;
    for (std::string cell; std::getline(cells, cell, '|');) row.push_back(cell);
    const auto begin = row[0].find("--") + 2;
    const auto name = row[0].substr(begin, row[0].find('`', begin) - begin);
    for (std::size_t i = 1; i < row.size(); ++i) {
      std::erase(row[i], ' ');
      if (name != "quality") rows[name].push_back(row[i]);
    }
  }
  return rows;
}

TEST(Quality, medium_is_the_default_and_the_others_set_what_the_document_lists) {
  const auto folder = fresh_folder("quality");
  const std::string bake = "bake cornell-box.obj";
  auto medium = configuration(folder, bake + " --quality medium");
  auto plain = configuration(folder, bake);
  EXPECT_NE(medium["quality"].find("command line"), std::string::npos);
  medium.erase("quality");
  plain.erase("quality");
  EXPECT_EQ(medium, plain);

  const auto table = documented_table();
  ASSERT_EQ(table.size(), 6u);
  const char* levels[] = {"draft", "medium", "final"};
  for (std::size_t i = 0; i < 3; ++i) {
    auto set = configuration(folder, fmt::format("{} --quality {}", bake, levels[i]));
    for (const auto& [option, values] : table) {
      EXPECT_TRUE(set[option].starts_with(fmt::format("\"{}\"", values[i]))) << option << " " << set[option];
      if (values[i] == values[1]) continue;
      EXPECT_NE(set[option].find("; quality"), std::string::npos) << option << " " << set[option];
    }
  }
}

TEST(Quality, yields_to_what_a_person_gives_on_the_command_line_or_in_a_file) {
  const auto folder = fresh_folder("quality_given");
  write_file(folder / "luxel.toml", "samples = 7\n");
  auto set = configuration(folder, "bake cornell-box.obj --config luxel.toml --quality draft --error 9%");
  EXPECT_EQ(set["error"], "\"9%\"  # fraction; command line");
  EXPECT_EQ(set["samples"], "\"7\"  # count; file");
  EXPECT_EQ(set["final-gather"].substr(0, 4), "\"5%\"");
  // A given error takes precedence: the rays of a quality are then no bound, unless they are given too.
  EXPECT_TRUE(set["ray-budget"].starts_with("\"400M\"  # count; default")) << set["ray-budget"];
  set = configuration(folder, "bake cornell-box.obj --quality draft --error 9% --ray-budget 5M");
  EXPECT_EQ(set["ray-budget"], "\"5M\"  # count; command line");
}

TEST(Quality, leaves_its_values_in_the_solution_and_not_its_name) {
  const auto folder = fresh_folder("quality_recorded");
  const auto run =
      cli::run(folder, "$LUXEL bake cornell-box.obj --max-edge 0.2 --quality draft -o a.vtkhdf --quiet");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto info = nlohmann::json::parse(cli::run(folder, "$LUXEL info a.vtkhdf --json").out);
  EXPECT_EQ(info["solution"]["command_line"],
            "luxel bake cornell-box.obj --max-edge 0.2 --mesh-error none --error 6% --ray-budget 100M "
            "--cheap-rays 10M "
            "--samples 2");
  EXPECT_EQ(cli::run(folder, "$LUXEL bake cornell-box.obj --quality best").code, 2);
}

}  // namespace
}  // namespace luxel::cli
