// SPDX-License-Identifier: Apache-2.0
// Luminaires in the window: openings, photometric solids, what is under the cursor, colours that keep lumens.
#include <algorithm>
#include <cmath>

#include "luxel/photometry/photometry.h"

#include "cli/view_fixture.h"

namespace luxel::cli {
namespace {

// A room of 6 x 4 x 2.8 m with a panel of 0.6 x 0.6 m below its ceiling and a pendant.
class ViewLuminaires : public testing::Test {
 protected:
  void SetUp() override {
    without_leak_check();
    folder_ = fresh_folder(testing::UnitTest::GetInstance()->current_test_info()->name());
    std::ofstream(folder_ / "s.txt") << "close\n";
    const auto tried = cli::run(
        folder_, "$LUXEL room 6x4x2.8 -o room.obj && $LUXEL view room.obj --off-screen --script s.txt");
    if (tried.err.find("off screen") != std::string::npos) GTEST_SKIP() << tried.err;
    for (const char* name : {"led-panel.ies", "linear-pendant.ies"})
      std::filesystem::copy_file(std::filesystem::path(LUXEL_SOURCE_DIR "/scenes/luminaires") / name,
                                 folder_ / name);
    std::ofstream(folder_ / "list.csv") << "file,x,y,z,group\n"
                                           "led-panel.ies,1.5,2,2.795,panel\n"
                                           "linear-pendant.ies,4,2,2,pendant\n";
  }
  Outcome view(const std::string& script, const std::string& options = "") {
    std::ofstream(folder_ / "s.txt") << "set panel off\nset keys off\n" << script;
    return cli::run(folder_,
                    "$LUXEL view room.obj --luminaires list.csv --error 10% --max-edge 0.4 "
                    "--mesh-error none --off-screen --script s.txt " +
                        look_ + options);
  }
  Image picture(const std::string& name) const { return read_image(folder_ / name); }
  double lumens_of(const char* name) const {
    return load_photometry((folder_ / name).string()).intensity.linear_flux();
  }

  // Both luminaires are in view: the panel at the left.
  const std::string look_ = "--width 320 --height 240 --eye 3,0.3,1.2 --target 3,2.5,2.3 --fov 80 ";
  std::filesystem::path folder_;
};

TEST_F(ViewLuminaires, their_openings_are_those_of_a_picture) {
  const auto done = view("wait finished\nwait 300 frames\nsnapshot view.png\n", "--tone clamp --exposure -6");
  ASSERT_EQ(done.code, 0) << done.err;
  const auto baked = cli::run(folder_,
                              "$LUXEL bake room.obj --luminaires list.csv --error 10% --max-edge 0.4 "
                              "--mesh-error none --tone clamp --exposure -6 -o bake.png --quiet " +
                                  look_);
  ASSERT_EQ(baked.code, 0) << baked.err;
  const auto shown = picture("view.png"), expected = picture("bake.png");
  EXPECT_LT(difference(shown, expected), 0.004);
  // The surfaces are dark by this exposure, so that bright pixels are those of the openings.
  const auto bright = [](const Image& image) {
    return std::count_if(image.pixels.begin(), image.pixels.end(), [](const auto& p) { return p.g > 0.1f; });
  };
  EXPECT_GT(bright(expected), 1000);
  EXPECT_NEAR(static_cast<double>(bright(shown)), static_cast<double>(bright(expected)),
              0.02 * static_cast<double>(bright(expected)));
}

// The curve is fitted to all that is in view, bright openings included.
TEST_F(ViewLuminaires, count_in_the_automatic_exposure_as_in_a_picture) {
  const auto done = view("wait finished\nwait 300 frames\nsnapshot view.png\n");
  ASSERT_EQ(done.code, 0) << done.err;
  const auto baked = cli::run(folder_,
                              "$LUXEL bake room.obj --luminaires list.csv --error 10% --max-edge 0.4 "
                              "--mesh-error none -o bake.png --quiet " +
                                  look_);
  ASSERT_EQ(baked.code, 0) << baked.err;
  EXPECT_LT(difference(picture("view.png"), picture("bake.png")), 0.01);
}

TEST_F(ViewLuminaires, are_dimmed_coloured_and_named_with_their_lumens) {
  const auto panel = lumens_of("led-panel.ies"), pendant = lumens_of("linear-pendant.ies");
  const auto expect = [](const char* group, double lumens) {
    return "wait finished\nwait 3 frames\nexpect luminaire " + std::string(group) + " " +
           std::to_string(lumens) + "\n";
  };
  const auto done =
      view("wait finished\nwait 300 frames\nmove 60 75\n" + expect("panel", panel) + "lamp panel 0.4\n" +
           expect("panel", 0.4 * panel) +                          //
           "lamp panel 1 1,0.1,0.05\n" + expect("panel", panel) +  // a colour keeps lumens
           "lamp panel 0.5 0.1,0.1,0.8\n" + expect("panel", 0.5 * panel) + "snapshot blue.png\n" +
           "lamp panel 1 1,1,1\nmove 237 123\n" + expect("pendant", pendant) +
           "lamp pendant 0\nwait finished\nwait 60 frames\nset help off\nexpect no-error\n");
  EXPECT_EQ(done.code, 0) << done.err;
  const auto missed =
      view("wait finished\nwait 5 frames\nmove 160 200\nwait 3 frames\nexpect luminaire panel 1\n");
  EXPECT_NE(missed.err.find("no luminaire is under the cursor"), std::string::npos) << missed.err;
}

TEST_F(ViewLuminaires, their_solids_are_on_a_key) {
  const auto done = view(
      "set automatic-exposure off\nwait finished\nwait 300 frames\nsnapshot off.png\n"
      "key C\nwait 20 frames\nsnapshot on.png\nset solids off\nwait 20 frames\nsnapshot again.png\n"
      "menu View/Overlays/Photometric solids\nwait 20 frames\nsnapshot menu.png\n");
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_GT(difference(picture("off.png"), picture("on.png")), 2e-3);
  EXPECT_LT(difference(picture("off.png"), picture("again.png")), 1e-4);
  EXPECT_LT(difference(picture("on.png"), picture("menu.png")), 1e-4);
}

}  // namespace
}  // namespace luxel::cli
