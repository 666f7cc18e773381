// SPDX-License-Identifier: Apache-2.0
// The menus of `luxel view`, by scripts: undoing of lamps and colours, dialogs for files, sizes of the
// window.
#include "cli/view_fixture.h"

namespace luxel::cli {
namespace {

TEST_F(View, changes_of_lamps_and_colours_are_undone_and_redone) {
  const auto done =
      run("s.txt",
          "set panel off\nset automatic-exposure off\nset tone clamp\nwait finished\n"
          "wait 300 frames\nsnapshot own.png\n"
          "lamp lamp 0.2\nwait finished\nlamp lamp 0.5\npaint white 0.1,0.1,0.9\nwait finished\n"
          "snapshot blue.png\n"
          "down control\nkey Z\nwait finished\nexpect lamp lamp 0.5\nkey Z\n"
          "expect lamp lamp 0.2\nwait finished\nkey Z\nkey Z\nup control\nwait finished\n"
          "expect lamp lamp 1\nsnapshot undone.png\n"
          "down control\ndown shift\nkey Z\nkey Z\nup shift\nexpect lamp lamp 0.5\n"
          "key Y\nup control\nwait finished\nsnapshot redone.png\n"
          "menu Light/Undo\nwait finished\nmenu Light/Undo\nexpect lamp lamp 0.2\n"
          "menu Light/Redo\nexpect lamp lamp 0.5\nmenu Light/As in the file\nexpect lamp lamp 1\n"
          "wait finished\nsnapshot file.png\nmenu Light/Lamps/lamp\nexpect lamp lamp 0\n"
          "wait finished\nmenu Light/Lamps/lamp\nexpect lamp lamp 1\nexpect no-error\n",
          "--off-screen");
  ASSERT_EQ(done.code, 0) << done.err;
  const auto own = picture("own.png"), blue = picture("blue.png");
  EXPECT_GT(difference(own, blue), 0.05);
  EXPECT_LT(difference(own, picture("undone.png")), 1e-3);
  EXPECT_LT(difference(own, picture("file.png")), 1e-3);
  EXPECT_LT(difference(blue, picture("redone.png")), 1e-3);
}

TEST_F(View, entries_of_menus_that_cannot_be_chosen_are_a_sentence) {
  const auto none = run("s.txt", "wait finished\nmenu Light/Undo\n", "--off-screen");
  EXPECT_NE(none.err.find("s.txt:2: the menu entry 'Light/Undo' cannot be chosen now"), std::string::npos)
      << none.err;
  const auto unknown = run("s.txt", "wait mesh\nmenu File/Print\n", "--off-screen");
  EXPECT_NE(unknown.err.find("there is no menu entry 'File/Print'"), std::string::npos) << unknown.err;
}

TEST_F(View, files_are_opened_and_saved_by_dialogs) {
  std::filesystem::copy_file(folder_ / "cornell-box.obj", folder_ / "other.obj");
  const auto done =
      run("s.txt",
          "wait finished\nmenu File/Save solution...\nwait 5 frames\nsnapshot dialog.png\n"
          "key escape\nwait 5 frames\nsnapshot closed.png\n"
          "menu File/Export...\nwait 5 frames\nkey enter\nwait finished\nexpect no-error\n"
          "down control\nkey O\nup control\nwait 5 frames\ntype other.obj\nkey enter\n"
          "wait 5 frames\nwait finished\nexpect file other.obj\nexpect light\n"
          "menu File/Open...\nwait 5 frames\ntype none.obj\nkey enter\nwait error\n"
          "expect error none.obj\nkey enter\nwait 5 frames\nexpect file other.obj\n"
          "menu Help/About Luxel\nwait 5 frames\nkey escape\n"
          "menu View/Full screen\nmenu View/Panels/Line of keys\nwait 5 frames\nmenu File/Quit\n",
          "--off-screen --width 900 --height 700");
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_GT(difference(picture("dialog.png"), picture("closed.png")), 0.01);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "cornell-box-view.glb"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "cornell-box-view.vtkhdf"));
}

TEST_F(View, of_several_files_that_are_dropped_the_scene_is_opened) {
  std::filesystem::copy_file(folder_ / "cornell-box.obj", folder_ / "other.obj");
  std::filesystem::create_directory(folder_ / "empty");
  const auto done =
      run("s.txt",
          "wait finished\nsave kept.vtkhdf\nwait finished\nexpect no-error\n"
          "drop other.obj\nwait 5 frames\nwait finished\nexpect file other.obj\n"
          "drop kept.vtkhdf\nwait 5 frames\nwait finished\nexpect file kept.vtkhdf\nexpect light\n"
          "drop empty\nwait error\nexpect error empty\nkey enter\nwait 5 frames\n"
          "expect file kept.vtkhdf\nexpect light\n",
          "--off-screen");
  EXPECT_EQ(done.code, 0) << done.err;
}

// The text of the panel grows with the scale, in a picture of the same size.
TEST_F(View, text_and_panels_grow_with_the_scale) {
  const std::string script = "wait finished\nset show grey\nwait 60 frames\nsnapshot ";
  for (const std::string scale : {"1", "2"})
    ASSERT_EQ(
        run("s.txt", script + scale + ".png\n", "--off-screen --width 1366 --height 768 --ui-scale " + scale)
            .code,
        0);
  // The menu bar is bluish; the background of the scene is grey.
  const auto bar = [&](const std::string& name) {
    const auto image = picture(name);
    int y = 0;
    while (y < image.height && srgb_code(image.at(1360, y).b) > srgb_code(image.at(1360, y).r) + 5) ++y;
    return y;
  };
  EXPECT_NEAR(bar("1.png"), 21, 2);
  EXPECT_NEAR(bar("2.png"), 42, 2);
  EXPECT_NE(run("s.txt", "close\n", "--off-screen --ui-scale 9").err.find("--ui-scale"), std::string::npos);
}

}  // namespace
}  // namespace luxel::cli
