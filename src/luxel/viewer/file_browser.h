// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace luxel {

// A folder and its entries that can be chosen: its folders, and its files with certain endings.
// Hidden ones are left out.
class FileBrowser {
 public:
  struct Entry {
    std::string name;
    bool is_folder = false;
  };

  // endings: as ending_of() has them; none: all files.
  FileBrowser(const std::filesystem::path& folder, std::vector<std::string> endings);

  const std::filesystem::path& folder() const { return folder_; }  // absolute
  const std::vector<Entry>& entries() const { return entries_; }   // folders first, by name
  const std::string& error() const { return error_; }  // a sentence; empty: the folder could be read
  // Goes to a folder, from this one; "..": the one above. Where it cannot be read, this one stays, and
  // error() has the reason.
  void enter(const std::filesystem::path& folder);
  // Returns the path of a typed name, relative to this folder.
  std::filesystem::path path_of(const std::string& name) const;

 private:
  std::vector<std::string> endings_;
  std::filesystem::path folder_;
  std::vector<Entry> entries_;
  std::string error_;
};

}  // namespace luxel
