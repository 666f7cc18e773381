// SPDX-License-Identifier: Apache-2.0
// `luxel view` by scripts: off screen, and in a window of a virtual display.
#include "cli/view_fixture.h"

namespace luxel::cli {
namespace {

TEST_F(View, its_light_is_that_of_a_baked_picture) {
  const auto shown = run("s.txt", "set panel off\nwait finished\nset help off\nwait 300 frames\n",
                         "--snapshot view.png --tone clamp --exposure 1");
  ASSERT_EQ(shown.code, 0) << shown.err;
  const auto baked =
      cli::run(folder_, "$LUXEL bake cornell-box.obj --max-edge 0.1 --error 10% --width 320 --height 240 " +
                            camera + "--tone clamp --exposure 1 -o bake.png --quiet");
  ASSERT_EQ(baked.code, 0) << baked.err;
  // The key line, which is not in the baked picture, and what lies behind the box are left out.
  const auto crop = [](const Image& whole) {
    Image part(190, 190);
    for (int y = 0; y < 190; ++y)
      for (int x = 0; x < 190; ++x) part.at(x, y) = whole.at(x + 65, y + 20);
    return part;
  };
  EXPECT_LT(difference(crop(picture("view.png")), crop(picture("bake.png"))), 0.01);
}

TEST_F(View, each_choice_shows_something_else) {
  const std::vector<std::string> choices = {
      "show grey",       "show sides", "show irradiance", "show standard-error",
      "show patch-size", "show level", "wires on",        "normals on",
      "boxes on",        "rays on",    "samples on",      "faults on",
      "tone clamp",      "help on"};
  std::string script = "set panel off\nwait finished\nmove 160 200\nwait 300 frames\nsnapshot plain.png\n";
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const auto& choice = choices[i];
    const bool is_switch = choice.ends_with(" on");
    script += "set " + choice + "\nwait finished\nwait 3 frames\nsnapshot " + std::to_string(i) + ".png\n";
    script += is_switch ? "set " + choice.substr(0, choice.size() - 2) + "off\n" : "";
    script += "set show light\nset tone neutral\n";
  }
  const auto done =
      run("s.txt", script + "wait finished\nwait 60 frames\nsnapshot again.png\n", "--off-screen");
  ASSERT_EQ(done.code, 0) << done.err;
  const auto plain = picture("plain.png");
  for (std::size_t i = 0; i < choices.size(); ++i)
    EXPECT_GT(difference(plain, picture(std::to_string(i) + ".png")), 2e-5) << choices[i];
  EXPECT_LT(difference(plain, picture("again.png")), 1e-3);
}

TEST_F(View, lamps_colours_and_bounces_change_the_light_and_can_be_undone) {
  const auto done =
      run("s.txt",
          "set panel off\nset automatic-exposure off\nset tone clamp\nwait finished\nwait 300 frames\n"
          "snapshot all.png\n"
          "lamp lamp 0.2\nwait finished\nsnapshot dim.png\n"
          "lamp lamp 1\npaint white 0.1,0.1,0.9\nwait finished\nsnapshot blue.png\n"
          "paint white 0.7,0.7,0.7\nbounces 0\nwait finished\nsnapshot direct.png\n"
          "save light.vtkhdf\npicture 900 500 large.png\nwait finished\nexpect no-error\n",
          "--off-screen");
  ASSERT_EQ(done.code, 0) << done.err;
  const auto mean = [&](const char* name) { return mean_color(picture(name)); };
  EXPECT_LT(mean("dim.png").g, 0.7f * mean("all.png").g);
  EXPECT_GT(mean("blue.png").b, 1.3f * mean("blue.png").g);
  EXPECT_LT(mean("direct.png").g, mean("all.png").g);
  EXPECT_EQ(picture("large.png").width, 900);
  EXPECT_EQ(cli::run(folder_, "$LUXEL info light.vtkhdf").code, 0);
}

TEST_F(View, keys_and_the_mouse_do_what_they_say) {
  const auto done =
      run("s.txt",
          "set panel off\nwait finished\nwait 300 frames\nsnapshot 0.png\n"  // exposure takes its time
          "key tab\nhold W 0.3\nmove 10 10\nmove 60 10\nwait 5 frames\nkey tab\nsnapshot 1.png\n"
          "key H\nwait 30 frames\nsnapshot 2.png\n"
          "down control\nwheel 4\nup control\nwait 60 frames\nsnapshot 3.png\n"
          "key page-down\nkey page-down\nkey page-down\nkey page-down\nwait 60 frames\n"
          "move 160 120\nwheel 4\nwait 5 frames\nsnapshot nearer.png\nwheel -4\n"
          "down shift\ndrag 90 120 240 130\nup shift\nwait 3 frames\nsnapshot 4.png\nkey escape\n"
          "resize 400 300\nwait 3 frames\nsnapshot 5.png\nkey P\nwait 3 frames\nclick 40 80\n"
          "drop nothing.obj\nwait error\nexpect error no such file\nkey enter\n"
          "drop cornell-box.mtl\nwait 60 frames\nexpect mesh\n",
          "--off-screen");
  ASSERT_EQ(done.code, 0) << done.err;
  const auto start = picture("0.png");
  EXPECT_GT(difference(start, picture("1.png")), 0.01);
  EXPECT_LT(difference(start, picture("2.png")), 0.02);
  EXPECT_GT(mean_color(picture("3.png")).g, 1.1f * mean_color(start).g);
  EXPECT_GT(difference(start, picture("nearer.png")), 0.01);
  EXPECT_GT(difference(start, picture("4.png")), 5e-3);
  EXPECT_EQ(picture("5.png").width, 400);
}

TEST_F(View, closing_at_any_moment_ends_it_and_saves_if_asked) {
  for (const char* moment : {"", "wait 2 frames\n", "wait mesh\n", "wait light\n"})
    EXPECT_EQ(run("s.txt", std::string(moment) + "close\n", "--off-screen --error 0.01%").code, 0) << moment;
  const auto saved = run("s.txt", "wait light\nclose\n", "--off-screen --error 0.01% --save kept.vtkhdf");
  ASSERT_EQ(saved.code, 0) << saved.err;
  EXPECT_NE(saved.err.find("kept.vtkhdf is written"), std::string::npos) << saved.err;
  const auto again =
      cli::run(folder_, "$LUXEL view kept.vtkhdf --width 160 --height 120 --snapshot kept.png");
  EXPECT_EQ(again.code, 0) << again.err;
  const auto no_display = cli::run(folder_, "env -u DISPLAY -u WAYLAND_DISPLAY $LUXEL view kept.vtkhdf");
  EXPECT_NE(no_display.err.find("luxel render kept.vtkhdf -o out.png"), std::string::npos) << no_display.err;
}

TEST_F(View, what_cannot_be_is_one_clear_sentence) {
  EXPECT_NE(run("s.txt", "jump\n", "--off-screen").err.find("s.txt:1: there is no verb 'jump'"),
            std::string::npos);
  const auto missing = cli::run(folder_, "$LUXEL view none.obj --snapshot a.png");
  EXPECT_EQ(missing.code, 1);
  EXPECT_NE(missing.err.find("none.obj: "), std::string::npos) << missing.err;
  const auto no_display = cli::run(folder_, "env -u DISPLAY -u WAYLAND_DISPLAY $LUXEL view cornell-box.obj");
  EXPECT_EQ(no_display.code, 1);
  EXPECT_NE(no_display.err.find("there is no display"), std::string::npos) << no_display.err;
  EXPECT_NE(no_display.err.find("luxel bake cornell-box.obj -o out.png"), std::string::npos)
      << no_display.err;
  const auto old =
      cli::run(folder_, "MESA_GL_VERSION_OVERRIDE=2.1 $LUXEL view cornell-box.obj --snapshot a.png");
  EXPECT_EQ(old.code, 1);
  EXPECT_NE(old.err.find("no OpenGL 3.3"), std::string::npos) << old.err;
}

// A virtual display: the server chooses its number, so that tests that start together do not collide.
std::string with_display(const std::string& command) {
  return "Xvfb -displayfd 3 -screen 0 800x600x24 +extension GLX -nolisten tcp 3> display 2> server.txt & "
         "server=$!; until [ -s display ]; do kill -0 $server || exit 9; sleep 0.05; done; "
         "export DISPLAY=:$(cat display); " +
         command + "; code=$?; kill $server; wait $server; rm display; exit $code";
}

TEST_F(View, a_window_shows_what_is_drawn_off_screen) {
  if (cli::run(folder_, "command -v Xvfb").code != 0) GTEST_SKIP() << "Xvfb is not installed";
  // The window has the display's cursor somewhere.
  const std::string script = "wait finished\nset show irradiance\nmove 160 230\nwait 60 frames\nsnapshot ";
  ASSERT_EQ(run("a.txt", script + "off.png\n", "--off-screen").code, 0);
  std::ofstream(folder_ / "b.txt") << script << "window.png\nclose\n";
  const auto window = cli::run(folder_, with_display(view + camera + "--script b.txt"));
  ASSERT_EQ(window.code, 0) << window.err;
  EXPECT_LT(difference(picture("off.png"), picture("window.png")), 0.02);
  const auto old =
      cli::run(folder_, with_display("MESA_GL_VERSION_OVERRIDE=2.1 $LUXEL view cornell-box.obj"));
  EXPECT_EQ(old.code, 1);
  EXPECT_NE(old.err.find("no OpenGL 3.3"), std::string::npos) << old.err;
}

}  // namespace
}  // namespace luxel::cli
