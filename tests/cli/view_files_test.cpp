// SPDX-License-Identifier: Apache-2.0
// Files that come and go while `luxel view` is open: scenes dropped on the window, pictures of any size.
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "cli/view_fixture.h"
#include "support/small_gltf.h"

namespace luxel::cli {
namespace {

// A red floor of 2 x 2 m under a lamp.
SmallGltf small_room() {
  SmallGltf gltf;
  gltf.points({-1, 0, -1, -1, 0, 1, 1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0, -1});
  gltf.points({-0.3f, 1, -0.3f, 0.3f, 1, -0.3f, 0.3f, 1, 0.3f});
  gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":0},"material":0},)"
                R"({"attributes":{"POSITION":1},"material":1}]})";
  gltf.rest =
      R"(,"materials":[{"name":"ground","pbrMetallicRoughness":{"baseColorFactor":[0.8,0.1,0.1,1],"metallicFactor":0}},)"
      R"({"name":"bulb","emissiveFactor":[1,1,1]}],"scenes":[{"nodes":[0]}],"scene":0)";
  return gltf;
}

class ViewFiles : public View {
 protected:
  void write(const std::string& name, const std::string& bytes) {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }
};

TEST_F(ViewFiles, a_gltf_scene_dropped_on_the_window_is_lit_and_shown) {
  write("room.gltf", small_room().text());
  write("room.glb", small_room().glb());
  for (const std::string ending : {"gltf", "glb"}) {
    // The script would end at a missing material, so this is the other scene.
    const auto done = run("s.txt",
                          "set panel off\nwait finished\nsnapshot box.png\n"
                          "drop room." +
                              ending +
                              "\nwait finished\nexpect light\nexpect no-error\n"
                              "snapshot room.png\npaint ground 0.1,0.1,0.8\nlamp bulb 2\nwait finished\n"
                              "snapshot blue.png\nexpect no-error\nsave room.vtkhdf\nwait finished\n",
                          "--off-screen");
    ASSERT_EQ(done.code, 0) << ending << ": " << done.err;
    EXPECT_GT(difference(picture("box.png"), picture("room.png")), 0.02) << ending;
    const auto red = mean_color(picture("room.png")), blue = mean_color(picture("blue.png"));
    EXPECT_GT(red.r, 1.5f * red.b) << ending;
    EXPECT_GT(blue.b, 1.5f * blue.r) << ending;
    EXPECT_EQ(cli::run(folder_, "$LUXEL info room.vtkhdf").code, 0) << ending;
  }
}

TEST_F(ViewFiles, without_a_scene_the_window_is_empty_until_one_is_dropped) {
  write("s.txt", "wait 3 frames\ndrop cornell-box.obj\nwait light\nexpect light\nexpect no-error\n");
  const auto done = cli::run(folder_, "$LUXEL view --off-screen --max-edge 0.1 --error 20% --script s.txt");
  EXPECT_EQ(done.code, 0) << done.err;
  const auto refused = cli::run(folder_, "$LUXEL view --snapshot view.png");
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("need a scene"), std::string::npos) << refused.err;
}

// The box beside a floor of 2 side² triangles, which takes many frames to read.
std::string large_scene(const std::string& box, int side) {
  std::string text = box;
  for (int i = 0; i <= side; ++i)
    for (int j = 0; j <= side; ++j) text += fmt::format("v {} 0 {}\n", 10.0 + 0.001 * i, 0.001 * j);
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const int corner = (i - side - 1) * (side + 1) + j;  // from the end, as relative indices
      text += fmt::format("f {} {} {} {}\n", corner, corner + 1, corner + side + 2, corner + side + 1);
    }
  return text;
}

// Found by random actions: the waits ended with the scene that was still shown, and the lamps went with it.
TEST_F(ViewFiles, scripts_wait_for_the_scene_that_is_being_opened) {
  std::ifstream file(folder_ / "cornell-box.obj");
  const std::string box{std::istreambuf_iterator<char>(file), {}};
  write("large.obj", large_scene(box, 100));
  for (const std::string event : {"mesh", "light", "view"}) {
    const auto done =
        run("s.txt", "wait light\nwait view\ndrop large.obj\nwait " + event + "\nexpect file large.obj\n",
            "--off-screen");
    EXPECT_EQ(done.code, 0) << event << ": " << done.err;
  }
}

TEST_F(ViewFiles, a_broken_gltf_file_is_a_dialog_and_what_was_there_stays) {
  const auto whole = small_room().glb();
  write("cut.glb", whole.substr(0, whole.size() - 20));
  write("words.gltf", "this is no scene");
  for (const std::string name : {"cut.glb", "words.gltf"}) {
    const auto done = run("s.txt",
                          "set panel off\nwait finished\nset automatic-exposure off\n"
                          "wait 300 frames\nsnapshot before.png\ndrop " +
                              name + "\nwait error\nexpect error " + name +
                              "\nwait 20 frames\nsnapshot dialog.png\nkey enter\nwait 20 frames\n"
                              "snapshot after.png\npaint white 0.2,0.2,0.9\nwait finished\nexpect light\n",
                          "--off-screen");
    ASSERT_EQ(done.code, 0) << name << ": " << done.err;
    EXPECT_GT(difference(picture("before.png"), picture("dialog.png")), 0.01) << name;
    EXPECT_LT(difference(picture("before.png"), picture("after.png")), 1e-3) << name;
  }
}

TEST_F(ViewFiles, a_picture_made_of_tiles_has_no_seams_under_any_tone_curve) {
  // A processor draws tiles of 512 pixels, from the bottom; the local operator sees 48 beyond each.
  const auto done = run("s.txt",
                        "set panel off\nwait finished\nwait 300 frames\n"
                        "picture 640 560 reinhard.png\nexpect no-error\n"
                        "set tone reinhard-local\nset exposure 2\nwait 300 frames\n"
                        "picture 640 560 local.png\npicture 641 559 odd.png\nexpect no-error\n",
                        "--off-screen");
  ASSERT_EQ(done.code, 0) << done.err;
  for (const std::string name : {"local.png", "odd.png", "reinhard.png"}) {
    const auto image = picture(name);
    ASSERT_NEAR(image.width, 640, 1);
    // From a column, or a row, to the one before it: no more at a tile's edge than near it.
    const auto across = [&](int x) {
      double sum = 0.0;
      for (int y = 0; y < image.height; ++y)
        sum += std::abs(srgb_encode(image.at(x, y).g) - srgb_encode(image.at(x - 1, y).g));
      return sum;
    };
    const auto down = [&](int y) {
      double sum = 0.0;
      for (int x = 0; x < image.width; ++x)
        sum += std::abs(srgb_encode(image.at(x, y).g) - srgb_encode(image.at(x, y - 1).g));
      return sum;
    };
    const int row = image.height - 512;
    EXPECT_LT(across(512), 2.0 * std::max(across(509), across(515)) + 1.0) << name;
    EXPECT_LT(down(row), 2.0 * std::max(down(row - 3), down(row + 3)) + 1.0) << name;
  }
  EXPECT_GT(difference(picture("local.png"), picture("reinhard.png")), 0.01);
}

TEST_F(ViewFiles, a_picture_that_cannot_be_is_a_sentence) {
  const auto done = run("s.txt",
                        "wait finished\npicture 20000 10 wide.png\nexpect error 16384 pixels a side\n"
                        "picture 100 100 none/small.png\nexpect error none/small.png\n",
                        "--off-screen");
  EXPECT_EQ(done.code, 0) << done.err;
}

TEST_F(ViewFiles, a_picture_under_way_is_finished_when_the_window_is_closed) {
  const auto done = run("s.txt", "wait finished\nkey f12\nclose\n", "--off-screen");
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(picture("cornell-box.obj.png").width, 320);
}

}  // namespace
}  // namespace luxel::cli
