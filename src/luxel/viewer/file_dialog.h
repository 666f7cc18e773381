// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "luxel/viewer/file_browser.h"

namespace luxel {

// Purpose and defaults of a file dialog.
struct FileRequest {
  std::string title = {}, button = {};  // "Open", for instance
  std::vector<std::string> endings =
      {};                             // of the files that are listed; the first one is added to a new name
  std::filesystem::path folder = {};  // where it begins; empty: the current one
  std::string name = {};              // that is suggested
  bool is_new = false;                // to be written, else one that exists
  std::function<void(const std::filesystem::path&)> choose = {};
};

// A dialog in the window that lists a folder, drawn between Gui::begin() and Gui::draw(). One at a time.
class FileDialog {
 public:
  void ask(FileRequest request);
  bool is_open() const { return request_.has_value(); }
  void draw();

 private:
  void list();
  void name_line();
  void take();  // enters the named folder, or chooses the named file
  void set_name(const std::string& name);
  std::filesystem::path chosen() const;
  bool replaces() const;

  std::optional<FileRequest> request_;
  std::optional<FileBrowser> browser_;
  std::array<char, 1024> name_{};
  bool begins_ = false;
};

}  // namespace luxel
