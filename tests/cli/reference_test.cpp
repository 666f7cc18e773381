// SPDX-License-Identifier: Apache-2.0
// End-to-end tests of `luxel reference` and `luxel compare`.
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "luxel/image/image_file.h"

#include "cli/run_program.h"

namespace luxel::cli {
namespace {

using Json = nlohmann::json;
const std::string quiet_bake = "$LUXEL bake cornell-box.obj --max-edge 0.2 --quiet ";
const std::string trace = "$LUXEL reference cornell-box.obj --max-edge 0.2 --quiet ";
const std::string small = "--width 32 --height 24 ";

TEST(Reference, agrees_with_the_solver_on_the_same_patches) {
  const auto folder = fresh_folder("reference_agrees");
  const auto run = cli::run(
      folder, quiet_bake + "--error 2% -o solved.vtkhdf && $LUXEL reference solved.vtkhdf --error 3% " +
                  "--bounces-from patches -o truth.vtkhdf --quiet && " +
                  "$LUXEL compare truth.vtkhdf solved.vtkhdf --json -o diff.png " + small);
  ASSERT_EQ(run.code, 0) << run.err;
  const auto json = Json::parse(run.out.substr(run.out.find('{')));
  EXPECT_EQ(json["command"], "compare");
  EXPECT_EQ(json["agree"], true) << run.out;
  EXPECT_LT(json["relative_rms"].get<double>(), 0.06);
  EXPECT_LT(std::abs(json["mean_bias"].get<double>()), 0.02);
  EXPECT_GT(json["z"]["within_1.96"].get<double>(), 0.9);
  ASSERT_EQ(json["largest"].size(), 10u);
  EXPECT_TRUE(json["largest"][0]["side"].contains("material"));
  EXPECT_EQ(read_image(folder / "diff.png").width, 32);
  EXPECT_GT(read_image(folder / "diff.png").height, 24);
  const auto info = cli::run(folder, "$LUXEL info truth.vtkhdf");
  EXPECT_NE(info.out.find("path-traced with"), std::string::npos) << info.out;
  EXPECT_NE(info.out.find("luxel reference solved.vtkhdf --error 3% --bounces-from patches"),
            std::string::npos)
      << info.out;
}

TEST(Reference, its_solution_can_be_rendered_and_exported) {
  const auto folder = fresh_folder("reference_files");
  const auto run =
      cli::run(folder, trace + "--samples 64 -o a.vtkhdf -o a.glb && $LUXEL render a.vtkhdf -o a.png " +
                           small + "&& $LUXEL export a.vtkhdf -o b.ply");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, "a.png\nb.ply\n");  // quiet runs name no file
  EXPECT_GT(std::filesystem::file_size(folder / "a.glb"), 0u);
}

TEST(Reference, traces_pictures_and_their_errors) {
  const auto folder = fresh_folder("reference_picture");
  const auto run = cli::run(
      folder, trace + small + "--samples 64 -o a.exr -o a.png --error-picture e.exr --json --seed 4");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto json = Json::parse(run.out);
  EXPECT_EQ(json["picture"]["paths_per_pixel"], 64);
  EXPECT_GT(json["picture"]["error"]["reached"].get<double>(), 0.0);
  EXPECT_FALSE(json.contains("solution")) << "no patch was traced";
  EXPECT_EQ(json["outputs"], Json::array({"a.exr", "a.png", "e.exr"}));
  const auto picture = read_image(folder / "a.exr");
  const auto error = read_image(folder / "e.exr");
  EXPECT_GT(mean_color(picture).g, 0.0f);
  EXPECT_GT(mean_color(error).g, 0.0f);
  EXPECT_LT(mean_color(error).g, mean_color(picture).g);
}

// The lamp of the file has the lumens that Ke gives it, so the mean light is near that of plain colour; its
// colour is not.
TEST(Reference, a_spectrum_is_solved_shown_traced_and_compared) {
  const auto folder = fresh_folder("reference_spectrum");
  const std::string spectral = "--spectral cornell-spectra.csv --bands 12 ";
  const std::string view = "--width 32 --height 24 --eye 0,0.2744,1.08 --target 0,0.2744,-0.2796 --fov 30 ";
  const auto baked = cli::run(
      folder, "$LUXEL bake cornell-box.obj --max-edge 0.2 --error 3% -o plain.vtkhdf -o plain.exr " + view +
                  "&& $LUXEL bake cornell-box.obj --max-edge 0.2 --error 3% -o a.vtkhdf -o a.exr -o a.ply " +
                  spectral + view + "--json");
  ASSERT_EQ(baked.code, 0) << baked.err;
  const auto lamp = baked.err.find("lamp 'lamp': 95.");
  EXPECT_NE(lamp, std::string::npos) << baked.err;
  EXPECT_NE(baked.err.find("lamp 'lamp': 95.", lamp + 1), std::string::npos) << baked.err;
  const auto json = Json::parse(baked.out.substr(baked.out.find('{')));
  ASSERT_EQ(json["solution"]["wavelengths_nm"].size(), 12u);
  EXPECT_EQ(json["solution"]["wavelengths_nm"][11], 700.0);
  EXPECT_EQ(json["solution"]["bands"][0], "400 nm");
  const auto plain = mean_color(read_image(folder / "plain.exr"));
  const auto shown = mean_color(read_image(folder / "a.exr"));
  EXPECT_NEAR(luminance(shown) / luminance(plain), 1.0f, 0.1f);
  EXPECT_GT(shown.r, 1.1f * plain.r);
  EXPECT_LT(shown.b, 0.7f * plain.b);
  EXPECT_GE(shown.b, 0.0f);

  const auto info = cli::run(folder, "$LUXEL info a.vtkhdf");
  EXPECT_NE(info.out.find("12 bands, wavelengths from 400 to 700 nm"), std::string::npos) << info.out;
  const auto traced = cli::run(folder, "$LUXEL reference cornell-box.obj --max-edge 0.2 --quiet " + spectral +
                                           "--samples 256 --bounces-from patches -o b.vtkhdf && "
                                           "$LUXEL compare b.vtkhdf a.vtkhdf --json --quiet");
  ASSERT_EQ(traced.code, 0) << traced.err;
  EXPECT_EQ(Json::parse(traced.out.substr(traced.out.find('{')))["agree"], true) << traced.out;
  const auto other = cli::run(folder, "$LUXEL compare plain.vtkhdf a.vtkhdf --json --quiet");
  ASSERT_EQ(other.code, 0) << other.err;
  EXPECT_EQ(Json::parse(other.out)["agree"], false) << other.out;

  const auto alone = cli::run(folder, "$LUXEL bake cornell-box.obj -o a.png --bands 12");
  EXPECT_EQ(alone.code, 2);
  EXPECT_NE(alone.err.find("--bands needs --spectral FILE"), std::string::npos) << alone.err;
}

TEST(Reference, gives_the_same_bytes_on_any_number_of_threads) {
  const auto folder = fresh_folder("reference_threads");
  for (const char* n : {"1", "2", "5"}) {
    const std::string t(n);
    const auto run = cli::run(
        folder, trace + small + "--samples 32 --threads " + t + " -o " + t + ".vtkhdf -o " + t + ".exr");
    ASSERT_EQ(run.code, 0) << run.err;
    for (const char* ending : {".vtkhdf", ".exr"})
      EXPECT_EQ(read_file(folder / (t + ending)), read_file(folder / (std::string("1") + ending)))
          << t << ending;
  }
}

TEST(Reference, that_is_interrupted_writes_what_it_has_and_says_so) {
  const auto folder = fresh_folder("reference_interrupt");
  const auto run =
      run_interrupted(folder, "$LUXEL reference cornell-box.obj --max-edge 0.2 --error 0.001% -o a.vtkhdf",
                      "grep -q materials stderr.txt", "2");
  EXPECT_EQ(run.code, 3) << run.err;
  EXPECT_NE(run.err.find("warning: stopped: writing the light so far"), std::string::npos) << run.err;
  EXPECT_EQ(run.out, "a.vtkhdf\n");
}

TEST(Reference, refuses_what_would_do_nothing) {
  const auto folder = fresh_folder("reference_misuse");
  ASSERT_EQ(cli::run(folder, quiet_bake + "--error 5% -o a.vtkhdf").code, 0);
  for (const char* line :
       {"cornell-box.obj", "cornell-box.obj -o a.txt", "cornell-box.obj -o a.vtkhdf --error 0",
        "a.vtkhdf -o b.vtkhdf --max-edge 0.1", "cornell-box.obj -o b.vtkhdf --error-picture e.exr",
        "cornell-box.obj -o b.exr --error-picture e.png"})
    EXPECT_EQ(cli::run(folder, std::string("$LUXEL reference ") + line).code, 2) << line;
}

TEST(Gather, makes_a_picture_near_the_plain_one_and_repeats) {
  const auto folder = fresh_folder("gather");
  const auto run = cli::run(
      folder, quiet_bake +
                  "--error 2% -o a.vtkhdf && for n in 1 3; do $LUXEL render a.vtkhdf --gather 25 --quiet " +
                  small +
                  "--threads $n -o g$n.exr || exit 9; done && cmp g1.exr g3.exr && $LUXEL render a.vtkhdf -o "
                  "p.exr --quiet " +
                  small + "&& $LUXEL compare p.exr g1.exr --json");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto json = Json::parse(run.out.substr(run.out.find('{')));
  EXPECT_LT(std::abs(json["mean_bias"].get<double>()), 0.1) << run.out;
  EXPECT_GT(json["relative_rms"].get<double>(), 0.0) << "it is another picture";
}

TEST(CompareCommand, tells_what_it_cannot_compare_in_one_sentence) {
  const auto folder = fresh_folder("compare_misuse");
  ASSERT_EQ(
      cli::run(folder,
               quiet_bake + "--error 5% -o a.vtkhdf -o a.png " + small +
                   "&& $LUXEL bake cornell-box.obj --max-edge 0.3 --error 5% --quiet -o b.vtkhdf -o b.png "
                   "--width 16 --height 16")
          .code,
      0);
  const auto meshes = cli::run(folder, "$LUXEL compare a.vtkhdf b.vtkhdf");
  EXPECT_EQ(meshes.code, 1);
  EXPECT_NE(meshes.err.find("luxel: the solutions are of different meshes"), std::string::npos) << meshes.err;
  EXPECT_EQ(std::count(meshes.err.begin(), meshes.err.end(), '\n'), 1);
  const auto sizes = cli::run(folder, "$LUXEL compare a.png b.png");
  EXPECT_EQ(sizes.code, 1);
  EXPECT_NE(sizes.err.find("different sizes, 32 x 24 and 16 x 16"), std::string::npos) << sizes.err;
  EXPECT_EQ(cli::run(folder, "$LUXEL compare a.png b.vtkhdf").code, 2);
  EXPECT_EQ(cli::run(folder, "$LUXEL compare a.png").code, 2);
  const auto same = cli::run(folder, "$LUXEL compare a.vtkhdf a.vtkhdf");
  EXPECT_EQ(same.code, 0);
  EXPECT_NE(same.out.find("relative RMS 0 %"), std::string::npos) << same.out;
}

}  // namespace
}  // namespace luxel::cli
