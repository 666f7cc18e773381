// SPDX-License-Identifier: Apache-2.0
// End-to-end tests of skies and suns of bakes.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/run_program.h"

namespace luxel::cli {
namespace {

using Json = nlohmann::json;

class BakeDaylight : public testing::Test {
 protected:
  // The error message of a refused command.
  std::string refused(const std::string& options) const {
    const auto run = cli::run(folder_, "$LUXEL bake room.obj -o x.vtkhdf " + options);
    EXPECT_EQ(run.code, 2) << options;
    return run.err;
  }
  Json baked(const std::string& options) const {
    const auto run =
        cli::run(folder_, "$LUXEL bake room.obj -o x.vtkhdf --error 20% --max-edge 1 --json " + options);
    EXPECT_EQ(run.code, 0) << options << ": " << run.err;
    return Json::parse(run.out);
  }
  // Mean irradiance of the floor from inside, W/m².
  static double floor_light(const Json& json) {
    for (const auto& surface : json["solve"]["surfaces"])
      if (surface["material"] == "floor" && surface["side"] == "front")
        return surface["irradiance_W_per_m2"][1].get<double>();
    return 0.0;
  }
  void SetUp() override {
    const auto run = cli::run(folder_, "$LUXEL room 4x5x3 --window south:1,1,2,1.5 -o room.obj --quiet");
    ASSERT_EQ(run.code, 0) << run.err;
  }

  std::filesystem::path folder_ = fresh_folder("bake_daylight");
};

TEST_F(BakeDaylight, refuses_what_contradicts_itself) {
  EXPECT_NE(refused("--sky cie:17").find("cie:1 to cie:16"), std::string::npos);
  EXPECT_NE(refused("--sky 1 --sun 30,180").find("a sky given by its radiance has no sun"),
            std::string::npos);
  EXPECT_NE(refused("--sky 1 --sky-illuminance 5000").find("--sky-illuminance needs"), std::string::npos);
  EXPECT_NE(refused("--sky cie:12").find("cie:12 needs the sun"), std::string::npos);
  EXPECT_NE(refused("--date 2026-03-21T12:00 --place 52,13").find("has no time zone"), std::string::npos);
  EXPECT_NE(refused("--sky perez --sun 30,180").find("--diffuse-horizontal"), std::string::npos);
  EXPECT_NE(refused("--sun-illuminance 10000").find("needs --sun"), std::string::npos);
  EXPECT_NE(refused("--sky sky.hdr --sun 3,4").find("its own sun"), std::string::npos);
}

TEST_F(BakeDaylight, has_the_illuminance_asked_for_and_a_sun) {
  const auto overcast = baked("--sky cie:16 --sky-illuminance 7000");
  const auto clear = baked("--sky cie:12 --sun 35,180 --sky-illuminance 7000");
  const auto turned = baked("--sky cie:12 --sun 35,180 --sky-illuminance 7000 --north 180");
  EXPECT_GT(floor_light(clear), 2.0 * floor_light(overcast)) << "the sun comes in";
  EXPECT_LT(floor_light(turned), 1.5 * floor_light(overcast)) << "the sun stands behind the room";
}

// Its bright part faces the window, so the picture is not turned or mirrored.
TEST_F(BakeDaylight, of_a_picture_is_like_that_of_its_sky) {
  const auto made = cli::run(folder_, "$LUXEL sky cie:12 --sun 20,180 -o sky.exr");
  ASSERT_EQ(made.code, 0) << made.err;
  const auto light = [this](const std::string& options) { return floor_light(baked(options)); };
  const auto of_sky = light("--sky cie:12 --sun 20,180 --sun-illuminance 0");
  EXPECT_NEAR(light("--sky sky.exr"), of_sky, 0.05 * of_sky);
  EXPECT_LT(light("--sky sky.exr --north 180"), 0.8 * of_sky);
}

}  // namespace
}  // namespace luxel::cli
