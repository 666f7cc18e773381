// SPDX-License-Identifier: Apache-2.0
// Parts of the menus that need no graphics card: a history of changes, recent files, a list of a folder, a
// font.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "luxel/viewer/edit_history.h"
#include "luxel/viewer/file_browser.h"
#include "luxel/viewer/recent_files.h"
#include "luxel/viewer/text_font.h"

namespace luxel {
namespace {

TEST(EditHistory, changes_are_undone_and_redone_in_order) {
  EditHistory<int> history;
  history.reset(1);
  history.note(1);
  EXPECT_FALSE(history.can_undo());
  history.note(2);
  history.note(3);
  EXPECT_EQ(history.undo(), 2);
  history.note(2);  // as it is: no change
  EXPECT_EQ(history.undo(), 1);
  EXPECT_FALSE(history.can_undo());
  EXPECT_EQ(history.redo(), 2);
  history.note(5);  // undone states are gone
  EXPECT_FALSE(history.can_redo());
  EXPECT_EQ(history.undo(), 2);
  for (int i = 10; i < 1000; ++i) history.note(i);
  for (std::size_t i = 1; i < EditHistory<int>::max_states; ++i) history.undo();
  EXPECT_FALSE(history.can_undo());
}

class Folder : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string("luxel-") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void write(const std::string& name, const std::string& text = "") {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  std::filesystem::path folder_;
};

TEST_F(Folder, recent_files_are_stored_the_newest_first_and_once) {
  const auto store = folder_ / "state/luxel/recent-files";
  RecentFiles recent(store);
  EXPECT_TRUE(recent.files().empty());
  for (int i = 0; i < 12; ++i) recent.add(folder_ / ("room-" + std::to_string(i) + ".obj"));
  recent.add(folder_ / "sub/../room-5.obj");
  EXPECT_EQ(recent.files().size(), RecentFiles::max_files);
  EXPECT_EQ(recent.files()[0], folder_ / "room-5.obj");
  EXPECT_EQ(recent.files()[1], folder_ / "room-11.obj");
  EXPECT_EQ(RecentFiles(store).files(), recent.files());
  recent.clear();
  EXPECT_TRUE(RecentFiles(store).files().empty());
}

TEST_F(Folder, recent_files_that_cannot_be_stored_last_as_long_as_the_window) {
  write("file");
  RecentFiles recent(folder_ / "file/recent-files");  // no folder
  recent.add("a.obj");
  EXPECT_EQ(recent.files().size(), 1u);
  EXPECT_TRUE(RecentFiles(folder_ / "file/recent-files").files().empty());
}

TEST_F(Folder, a_browser_lists_folders_and_files_with_the_endings) {
  for (const char* name : {"b.obj", "a.OBJ", "room.mtl", ".hidden.obj", "sub/in.obj", "zoo/x"}) write(name);
  FileBrowser browser(folder_, {".obj"});
  std::string names;
  for (const auto& entry : browser.entries()) names += entry.name + (entry.is_folder ? "/ " : " ");
  EXPECT_EQ(names, "sub/ zoo/ a.OBJ b.obj ");
  browser.enter("sub");
  EXPECT_EQ(browser.folder(), folder_ / "sub");
  ASSERT_EQ(browser.entries().size(), 1u);
  EXPECT_EQ(browser.path_of("in.obj"), folder_ / "sub/in.obj");
  EXPECT_EQ(browser.path_of("../b.obj"), folder_ / "b.obj");
  browser.enter("..");
  EXPECT_EQ(browser.folder(), folder_);
  browser.enter("/");
  browser.enter("..");
  EXPECT_EQ(browser.folder(), "/");
  EXPECT_EQ(browser.error(), "");
}

TEST_F(Folder, a_browser_stays_where_it_is_when_a_folder_cannot_be_read) {
  write("b.obj");
  FileBrowser browser(folder_, {});
  browser.enter("missing");
  EXPECT_NE(browser.error().find("missing cannot be read: "), std::string::npos) << browser.error();
  EXPECT_EQ(browser.folder(), folder_);
  EXPECT_EQ(browser.entries().size(), 1u);
}

TEST_F(Folder, a_font_is_found_in_the_data_folders_if_it_is_one) {
  EXPECT_FALSE(find_text_font(folder_.string()));
  write("one/fonts/truetype/dejavu/DejaVuSans.ttf", "this is no font");
  EXPECT_FALSE(find_text_font((folder_ / "one").string()));
  write("two/fonts/truetype/liberation/LiberationSans-Regular.ttf", std::string("\0\1\0\0rest", 8));
  EXPECT_EQ(find_text_font((folder_ / "one").string() + "::" + (folder_ / "two").string()),
            folder_ / "two/fonts/truetype/liberation/LiberationSans-Regular.ttf");
}

}  // namespace
}  // namespace luxel
