// SPDX-License-Identifier: Apache-2.0
// End-to-end tests of the classical methods.
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/run_program.h"

namespace luxel::cli {
namespace {

using Json = nlohmann::json;
const std::string coarse_bake = "$LUXEL bake cornell-box.obj --max-edge 0.3 -o a.vtkhdf ";

Json json_of(const std::filesystem::path& folder, const std::string& options) {
  const auto run = cli::run(folder, coarse_bake + options + " --json");
  EXPECT_EQ(run.code, 0) << run.err;
  return Json::parse(run.out);
}

TEST(Methods, each_says_what_it_is_likely_to_take_and_where_the_power_went) {
  const auto folder = fresh_folder("methods");
  for (const std::string method : {"dense", "hemicube", "lines"}) {
    const auto run =
        cli::run(folder, coarse_bake + "--method " + method +
                             (method == "dense" ? " --factor-tolerance 1e-3" : "") + " --json --verbose");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.err.find("method    " + method + " for "), std::string::npos) << run.err;
    EXPECT_NE(run.err.find(" of memory"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("emitted 1.458 W = absorbed"), std::string::npos) << run.err;
    const auto json = Json::parse(run.out);
    EXPECT_EQ(json["solution"]["method"], method);
    EXPECT_EQ(json["solve"]["error"]["stop_reason"], "converged");
    EXPECT_EQ(json["solve"]["error"].contains("target"), false);
    const auto& power = json["solve"]["power_W"];
    double emitted = 0.0, went = 0.0;
    for (std::size_t b = 0; b < 3; ++b) {
      emitted += power["emitted"][b].get<double>();
      for (const char* part : {"absorbed", "escaped", "lost_at_backs", "unshot"})
        went += power[part][b].get<double>();
    }
    EXPECT_NEAR(went / emitted, 1.0, method == "dense" ? 1e-4 : 0.1) << method;
    EXPECT_EQ(cli::run(folder, "$LUXEL info a.vtkhdf").code, 0);
  }
}

TEST(Methods, each_says_which_error_it_knows) {
  const auto folder = fresh_folder("methods_error");
  const auto dense = json_of(folder, "--method dense --factor-tolerance 1e-3");
  EXPECT_EQ(dense["solve"]["error"]["kind"], "integration");
  EXPECT_LT(dense["solve"]["error"]["reached"], 0.5);
  EXPECT_EQ(dense["solution"]["standard_errors"], true);
  const auto lines = json_of(folder, "--method lines --lines 500");
  EXPECT_EQ(lines["solve"]["error"]["kind"], "noise");
  EXPECT_GT(lines["solve"]["error"]["reached"], 0.01);
  const auto run = cli::run(folder, coarse_bake + "--method hemicube --hemicube-resolution 32 --json");
  const auto hemicube = Json::parse(run.out);
  EXPECT_EQ(hemicube["solve"]["error"]["kind"], "unknown");
  EXPECT_FALSE(hemicube["solve"]["error"].contains("reached"));
  EXPECT_EQ(hemicube["solution"]["standard_errors"], false);
  EXPECT_NE(run.err.find("error     not known: this method has no estimate of it"), std::string::npos)
      << run.err;
}

TEST(Methods, the_solvers_of_dense_agree) {
  const auto folder = fresh_folder("methods_solvers");
  const auto direct = json_of(folder, "--method dense --factor-tolerance 1e-3");
  for (const char* solver : {"jacobi", "gauss-seidel"}) {
    const auto other = json_of(
        folder, std::string("--method dense --factor-tolerance 1e-3 --tolerance 1e-8 --solver ") + solver);
    EXPECT_EQ(other["solve"].contains("steps"), std::string(solver) == "jacobi");
    for (std::size_t b = 0; b < 3; ++b)
      EXPECT_NEAR(other["solve"]["power_W"]["absorbed"][b].get<double>() /
                      direct["solve"]["power_W"]["absorbed"][b].get<double>(),
                  1.0, 1e-6);
  }
}

TEST(Methods, that_would_take_days_are_refused_with_what_they_would_take) {
  const auto folder = fresh_folder("methods_refused");
  const auto run = cli::run(folder, "$LUXEL bake cornell-box.obj --method dense --max-edge 0.01 -o a.vtkhdf");
  EXPECT_EQ(run.code, 1);
  for (const char* words :
       {"luxel: cornell-box.obj: --method dense for ", " patch sides, about ", " days and ",
        " GiB of memory (", "are free): make fewer patches with a larger --max-edge", "or add --force"})
    EXPECT_NE(run.err.find(words), std::string::npos) << words << "\n" << run.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "a.vtkhdf"));
}

// It begins nevertheless, and is stopped at once.
TEST(Methods, force_begins_what_would_be_refused_and_an_interrupt_writes_what_there_is) {
  const auto folder = fresh_folder("methods_force");
  const auto run = run_interrupted(
      folder, "$LUXEL bake cornell-box.obj --method hemicube --max-edge 0.01 --force -o a.vtkhdf",
      "grep -q 'for .* patch sides' stderr.txt");
  EXPECT_EQ(run.code, 3) << run.err;
  EXPECT_NE(run.err.find("no light had left the lamps yet"), std::string::npos) << run.err;
  EXPECT_EQ(run.out, "a.vtkhdf\n");
}

TEST(Methods, a_picture_after_each_step_has_the_exposure_of_the_last) {
  const auto folder = fresh_folder("methods_steps");
  const std::string small =
      " --width 80 --height 60 --steps 3 --each-step steps -o last.png --tolerance 1e-9 ";
  for (const char* method : {"--method hemicube --hemicube-resolution 32", "--method lines",
                             "--method dense --solver jacobi --factor-tolerance 1e-3"}) {
    std::filesystem::remove_all(folder / "steps");
    const auto run = cli::run(folder, coarse_bake + method + small + "--verbose");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.out, "a.vtkhdf\nlast.png\nsteps/step-001.png\nsteps/step-002.png\nsteps/step-003.png\n");
    EXPECT_NE(run.err.find("step limit: "), std::string::npos) << run.err;
    EXPECT_EQ(read_file(folder / "steps/step-003.png"), read_file(folder / "last.png"));
    EXPECT_NE(read_file(folder / "steps/step-001.png"), read_file(folder / "last.png"));
  }
  EXPECT_NE(cli::run(folder, "$LUXEL info a.vtkhdf").out.find("dense: step limit"), std::string::npos);
}

TEST(Methods, options_of_another_method_are_refused) {
  const auto folder = fresh_folder("methods_misused");
  for (const auto& [options, words] :
       {std::pair{"--lines 5", "--lines needs --method lines"},
        std::pair{"--method dense --rays 5", "--rays needs --method sampled|shooting"},
        std::pair{"--method hemicube --seed 5", "--seed needs --method sampled|shooting|lines"},
        std::pair{"--method dense --steps 5", "--steps needs --solver jacobi"},
        std::pair{"--method dense --solver gauss-seidel --each-step x", "--each-step needs --solver jacobi"},
        std::pair{"--method dense --solver cramer", "expected one of direct|jacobi|gauss-seidel"},
        std::pair{"--each-step x", "--each-step needs --method dense|hemicube|lines"}}) {
    const auto run = cli::run(folder, coarse_bake + options);
    EXPECT_EQ(run.code, 2) << options;
    EXPECT_NE(run.err.find(words), std::string::npos) << options << ": " << run.err;
  }
  const auto run = cli::run(folder, coarse_bake + "--method hemicube --hemicube-points 5");
  EXPECT_NE(run.code, 0);
  EXPECT_NE(run.err.find("points"), std::string::npos) << run.err;
}

TEST(Methods, a_folder_that_cannot_be_made_is_refused_before_the_work) {
  const auto folder = fresh_folder("methods_folder");
  const auto run = cli::run(folder, coarse_bake + "--method lines --each-step cornell-box.obj/steps");
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.err.find("--each-step: cannot make the folder"), std::string::npos) << run.err;
}

TEST(Methods, faces_of_the_file_can_be_the_elements) {
  const auto folder = fresh_folder("methods_faces");
  const auto run = cli::run(folder,
                            "$LUXEL bake cornell-box.obj --max-edge 0 --method dense --elements faces "
                            "--factor-tolerance 1e-2 -o a.ply -o a.vtkhdf --json");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(
      Json::parse(run.out)["solution"]["command_line"].get<std::string>().ends_with("--elements faces"));
}

}  // namespace
}  // namespace luxel::cli
