// SPDX-License-Identifier: Apache-2.0
// End-to-end tests of view factors.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/run_program.h"

namespace luxel::cli {
namespace {

using Json = nlohmann::json;
const std::string quick = "$LUXEL viewfactors cornell-box.obj --max-edge 0.1 --error 0.002 ";

TEST(ViewFactors, come_in_three_formats_with_their_laws_reported) {
  const auto folder = fresh_folder("viewfactors");
  const auto run = cli::run(folder, quick + "-o f.h5 -o f.csv -o f.mtx --enforce --json --json-file r.json");
  ASSERT_EQ(run.code, 0) << run.err;
  for (const char* words :
       {"row sums: 1 to within", "reciprocity: off by", "standard errors let expect",
        "bounds: listed factors from", "enforced: factors changed by", "goes to the environment"})
    EXPECT_NE(run.err.find(words), std::string::npos) << words << "\n" << run.err;
  const auto json = Json::parse(run.out);
  EXPECT_EQ(run.out, read_file(folder / "r.json"));
  EXPECT_EQ(json["command"], "viewfactors");
  EXPECT_EQ(json["elements"], 8);
  EXPECT_EQ(json["sampled"]["stop_reason"], "error_reached");
  EXPECT_LE(json["sampled"]["error"], 0.002);
  EXPECT_LT(json["check_after"]["worst_row_sum"], 1e-12);
  EXPECT_LT(json["check_after"]["worst_reciprocity"], 1e-15);
  EXPECT_EQ(json["outputs"].size(), 3u);
  const auto csv = read_file(folder / "f.csv");
  EXPECT_EQ(csv.substr(0, csv.find('\n')), "from,to,factor,standard_error");
  EXPECT_NE(csv.find("\nfloor,ceiling,0."), std::string::npos) << csv;
  EXPECT_NE(csv.find("(environment)"), std::string::npos) << csv;
}

TEST(ViewFactors, are_the_same_bytes_on_any_number_of_threads) {
  const auto folder = fresh_folder("viewfactors_threads");
  for (const char* between : {"groups", "patches"}) {
    const auto ask =
        "$LUXEL viewfactors cornell-box.obj --max-edge 0.2 --rays 256 --quiet --enforce --between " +
        std::string(between);
    ASSERT_EQ(cli::run(folder, ask + " --threads 1 -o 1.h5").code, 0);
    for (const char* threads : {"2", "5"}) {
      ASSERT_EQ(cli::run(folder, ask + " --threads " + threads + " -o n.h5").code, 0);
      EXPECT_EQ(read_file(folder / "1.h5"), read_file(folder / "n.h5")) << between << ' ' << threads;
    }
  }
}

TEST(ViewFactors, of_one_row_have_that_row_alone) {
  const auto folder = fresh_folder("viewfactors_from");
  const auto run = cli::run(folder, quick + "-o f.csv --quiet --from 'tall*'");
  ASSERT_EQ(run.code, 0) << run.err;
  std::istringstream lines(read_file(folder / "f.csv"));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) EXPECT_TRUE(line.starts_with("tall_block,")) << line;
}

TEST(ViewFactors, not_good_enough_within_the_rays_allowed_say_so) {
  const auto folder = fresh_folder("viewfactors_short");
  const auto run =
      cli::run(folder, "$LUXEL viewfactors cornell-box.obj --max-edge 0 --error 1e-6 --rays 64 -o f.h5");
  EXPECT_EQ(run.code, 3) << run.err;
  EXPECT_NE(run.err.find("stopped before the requested error"), std::string::npos) << run.err;
  EXPECT_TRUE(std::filesystem::exists(folder / "f.h5"));
  EXPECT_EQ(
      cli::run(folder, "$LUXEL viewfactors cornell-box.obj --max-edge 0 --rays 64 -o f.h5 --quiet").code, 0)
      << "only rays were requested";
}

TEST(ViewFactors, refuse_in_a_sentence_what_cannot_be) {
  const auto folder = fresh_folder("viewfactors_refusals");
  struct Refusal {
    const char* options;
    int code;
    const char* words;
  };
  for (const auto& [options, code, words] : {
           Refusal{"-o f.txt", 2, "expected one of the extensions .h5 .csv .mtx"},
           {"", 2, "nothing to write"},
           {"-o f.h5 --from atrium", 2,
            "no element between groups is named 'atrium'; there are floor, ceiling"},
           {"-o f.h5 --between objects", 1, "names no objects"},
           {"-o f.h5 --between walls", 2, "expected one of groups|objects|materials|patches"},
           {"-o f.h5 --from floor --enforce", 2, "--enforce needs the rows of all elements"},
           {"-o f.h5 --error 0", 2, "--error 0 sets no target"},
           {"-o f.h5 --error 2", 2, "expected a factor"},
           {"-o f.h5 --exact --rays 5", 2, "--exact uses no rays"},
           {"-o f.h5 --between patches --max-edge 0.05 --memory 1MiB", 1, "MiB are allowed"},
           {"-o f.h5 --exact --max-edge 0.006", 1, "(--max-edge, --force)"},  // days; 10 minutes are allowed
           {"-o nowhere/f.h5", 1, "nowhere"},
       }) {
    const auto run =
        cli::run(folder, std::string("$LUXEL viewfactors cornell-box.obj ") + options +
                             (std::string(options).find("edge") == std::string::npos ? " --max-edge 0" : ""));
    EXPECT_EQ(run.code, code) << options << "\n" << run.err;
    EXPECT_NE(run.err.find(words), std::string::npos) << options << "\n" << run.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "f.h5")) << options;
  }
  if (std::filesystem::exists("/dev/full")) {
    const auto run = cli::run(folder, "ln -s /dev/full full.csv && " + quick + "-o full.csv");
    EXPECT_EQ(run.code, 1);
    EXPECT_NE(run.err.find("full.csv"), std::string::npos) << run.err;
  }
}

}  // namespace
}  // namespace luxel::cli
