// SPDX-License-Identifier: Apache-2.0
// End-to-end tests of the production solver.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/run_program.h"

namespace luxel::cli {
namespace {

using Json = nlohmann::json;
const std::string plain_bake = "$LUXEL bake cornell-box.obj --max-edge 0.1 ";

TEST(Sampled, is_the_default_and_stops_at_the_error_asked_for) {
  const auto folder = fresh_folder("sampled_error");
  const auto run = cli::run(folder, plain_bake + "--error 3% -o a.vtkhdf --json --seed 3 --verbose");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.err.find("error reached: seen error"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("first light"), std::string::npos) << run.err;
  const auto json = Json::parse(run.out);
  EXPECT_EQ(json["solution"]["method"], "sampled");
  EXPECT_EQ(json["solution"]["seed"], 3);
  EXPECT_EQ(json["solution"]["standard_errors"], true);
  EXPECT_EQ(json["solution"]["command_line"],
            "luxel bake cornell-box.obj --max-edge 0.1 --seed 3 --error 3%");
  const auto& solve = json["solve"];
  EXPECT_EQ(solve["error"]["target"], 0.03);
  EXPECT_EQ(solve["error"]["stop_reason"], "error_reached");
  EXPECT_EQ(solve["error"]["measure"], "seen");
  const auto reached = solve["error"]["reached"].get<double>();
  EXPECT_EQ(json["solution"]["seen_error"], reached);
  EXPECT_LE(reached * (1.0 + solve["error"]["uncertainty"].get<double>()), 0.03);
  EXPECT_EQ(solve["error"]["power"], json["solution"]["predicted_error"]);
  EXPECT_GE(solve["error"]["views"], 100);
  EXPECT_GT(solve["error"]["places"], 0.9);
  EXPECT_GT(reached, 0.0);
  EXPECT_LE(reached, 0.03);
  EXPECT_GT(solve["error"]["percentile_95"], 0.0);
  ASSERT_FALSE(solve["rounds"].empty());
  EXPECT_EQ(solve["rounds"].back()["error"], reached);
  EXPECT_EQ(solve["rounds"].back()["rays"], json["solution"]["rays"]);
  const auto bands = json["solution"]["bands"].size();
  ASSERT_FALSE(solve["surfaces"].empty());
  for (const auto& surface : solve["surfaces"]) {
    EXPECT_GT(surface["area_m2"], 0.0);
    EXPECT_TRUE(surface["side"] == "front" || surface["side"] == "back") << surface["material"];
    EXPECT_EQ(surface["irradiance_W_per_m2"].size(), bands);
    EXPECT_EQ(surface["standard_error_W_per_m2"].size(), bands);
  }
  const auto& received = solve["received_W"];
  ASSERT_EQ(received["power"].size(), bands);
  ASSERT_EQ(received["standard_error"].size(), bands);
  for (std::size_t b = 0; b < bands; ++b)
    EXPECT_LT(received["standard_error"][b], 0.03 * received["power"][b].get<double>());
  for (const char* key : {"unreached_sides", "streamed", "predicted_memory_bytes"})
    EXPECT_TRUE(solve.contains(key)) << key;
  EXPECT_FALSE(solve.contains("steps")) << "shooting has those";
  EXPECT_GT(json["first_light_s"], json["first_light_after_load_s"].get<double>());
}

TEST(Sampled, gives_the_same_bytes_on_any_number_of_threads_and_with_any_memory) {
  const auto folder = fresh_folder("sampled_same");
  ASSERT_EQ(cli::run(folder, plain_bake + "--error 3% -o 1.vtkhdf --quiet --threads 1").code, 0);
  for (const char* how : {"--threads 2", "--threads 5", "--memory 1MiB"}) {
    const auto run = cli::run(folder, plain_bake + "--error 3% -o 2.vtkhdf --quiet " + how);
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(read_file(folder / "1.vtkhdf"), read_file(folder / "2.vtkhdf")) << how;
  }
}

TEST(Sampled, says_which_limit_ended_it_before_it_was_good_enough) {
  const auto folder = fresh_folder("sampled_limit");
  for (const auto& [limit, name] : {std::pair{"--rays 1M", "ray"}, std::pair{"--time 0.2s", "time"}}) {
    const auto run = cli::run(folder, plain_bake + "--error 0.001% -o a.vtkhdf --json " + limit);
    EXPECT_EQ(run.code, 3) << run.err;
    const auto json = Json::parse(run.out);
    EXPECT_EQ(json["solve"]["error"]["stop_reason"], name + std::string("_limit"));
    EXPECT_GT(json["solve"]["error"]["reached"], 1e-5);
    EXPECT_NE(run.err.find(std::string("stopped by the ") + name +
                           " limit before --error 0.001% was reached; writing the light so far"),
              std::string::npos)
        << run.err;
  }
}

TEST(Sampled, with_the_power_as_measure_stops_at_its_error) {
  const auto folder = fresh_folder("sampled_power");
  const auto run = cli::run(folder, plain_bake + "--error 3% --error-measure power -o a.vtkhdf --json");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.err.find(" % on average over all surfaces; 3 % requested"), std::string::npos) << run.err;
  const auto json = Json::parse(run.out);
  EXPECT_EQ(json["solve"]["error"]["measure"], "power");
  EXPECT_LE(json["solution"]["predicted_error"], 0.03);
  EXPECT_EQ(json["solve"]["error"]["reached"], json["solution"]["predicted_error"]);
  EXPECT_EQ(cli::run(folder, plain_bake + "--error-measure eye -o a.vtkhdf").code, 2);
}

TEST(Sampled, may_focus_on_what_a_camera_sees_or_on_a_material) {
  const auto folder = fresh_folder("sampled_focus");
  const std::string coarse = plain_bake + "--error 10% -o a.vtkhdf --json ";
  const auto seen = [](const Outcome& run) {
    return Json::parse(run.out)["solution"]["seen_error"].get<double>();
  };
  const auto camera = cli::run(folder, coarse + "--focus camera --eye 0,0.27,1.1 --target 0,0.27,-0.28");
  ASSERT_EQ(camera.code, 0) << camera.err;
  EXPECT_GT(seen(camera), 0.0);
  // The file keeps the camera.
  EXPECT_EQ(cli::run(folder, "$LUXEL resume a.vtkhdf -o b.png").code, 1) << "no samples were kept";
  const auto floor = cli::run(folder, coarse + "--focus 'whi*'");
  EXPECT_EQ(floor.code, 0) << floor.err;
  const auto nothing = cli::run(folder, coarse + "--focus sofa");
  EXPECT_EQ(nothing.code, 1);
  EXPECT_NE(nothing.err.find("no material, object or group is called 'sofa'"), std::string::npos)
      << nothing.err;
}

// Without --focus camera a picture's camera must not change the light.
TEST(Sampled, a_camera_changes_no_byte_of_the_light) {
  const auto folder = fresh_folder("sampled_camera");
  const auto json = [&](const std::string& more) {
    auto run = Json::parse(cli::run(folder, plain_bake + "--error 5% -o a.vtkhdf --json " + more).out);
    return run["solution"];
  };
  const auto one = json("");
  const auto other = json("--eye 0.1,0.3,0.2 --target 0,0.1,-0.2");
  for (const char* key : {"seen_error", "predicted_error", "error_95th", "rays"})
    EXPECT_EQ(one[key], other[key]);
}

TEST(Sampled, without_a_target_a_limit_is_what_was_asked_for) {
  const auto folder = fresh_folder("sampled_no_target");
  const auto run = cli::run(folder, plain_bake + "--error 0 --rays 1M -o a.vtkhdf --json");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err.find("warning"), std::string::npos) << run.err;
  const auto json = Json::parse(run.out);
  EXPECT_EQ(json["solve"]["error"]["stop_reason"], "ray_limit");
  EXPECT_LE(json["solution"]["rays"], 1'000'000);
}

TEST(Sampled, takes_every_switch) {
  const auto folder = fresh_folder("sampled_switches");
  for (const char* option : {"--low-discrepancy off", "--stratified off", "--importance off",
                             "--control-variate off", "--mis on", "--smoothing off", "--replicates 4"}) {
    const auto run = cli::run(folder, plain_bake + "--error 5% -o a.vtkhdf --json " + option);
    ASSERT_EQ(run.code, 0) << run.err;
    const auto command = Json::parse(run.out)["solution"]["command_line"].get<std::string>();
    EXPECT_TRUE(command.ends_with(option)) << command;
  }
}

TEST(Sampled, info_says_that_each_patch_has_its_error) {
  const auto folder = fresh_folder("sampled_info");
  ASSERT_EQ(cli::run(folder, plain_bake + "--error 3% -o a.vtkhdf --quiet").code, 0);
  const auto info = cli::run(folder, "$LUXEL info a.vtkhdf");
  EXPECT_NE(info.out.find("for 95 % of the lit sides"), std::string::npos) << info.out;
  EXPECT_NE(info.out.find("with the standard error of every patch side"), std::string::npos) << info.out;
  // A copy of the file keeps them.
  ASSERT_EQ(cli::run(folder, "$LUXEL export a.vtkhdf -o b.vtkhdf --quiet").code, 0);
  EXPECT_EQ(read_file(folder / "a.vtkhdf"), read_file(folder / "b.vtkhdf"));
}

// The interrupt is sent once the light is on its way: the lamp is reported right before it.
TEST(Sampled, that_is_interrupted_writes_what_it_has_and_says_so) {
  const auto folder = fresh_folder("sampled_interrupt");
  const auto run = run_interrupted(folder, plain_bake + "--error 0.001% -o a.glb -o a.vtkhdf",
                                   "grep -q lamp stderr.txt", "1");
  EXPECT_NE(run.err.find("warning: stopped before --error 0.001% was reached"), std::string::npos) << run.err;
  expect_light_is_kept(folder, run);
}

}  // namespace
}  // namespace luxel::cli
