// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/import/load_scene.h"

namespace luxel {

// A folder for the files of one test, empty at first and removed with it, and load_scene()'s messages on it.
class SceneFiles {
 public:
  SceneFiles() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string("luxel_") + test->test_suite_name() + "_" + test->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~SceneFiles() {
    std::error_code error;
    std::filesystem::remove_all(folder_, error);
  }
  SceneFiles(const SceneFiles&) = delete;
  SceneFiles& operator=(const SceneFiles&) = delete;

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }

  void write(const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories(path(name).parent_path());
    std::filesystem::remove(path(name));  // to write over a file makes some file systems wait for the disk
    std::ofstream(path(name), std::ios::binary) << bytes;
  }

  // The warnings of this load are kept, without the folder's name.
  Scene load(const std::string& name, const LoadOptions& options = {}) {
    warnings_.clear();
    const auto log = [this](const Message& message) { warnings_.push_back(without_folder(message.text)); };
    return load_scene(path(name), options, Context().with_log(log));
  }
  Scene load_text(const std::string& obj, const LoadOptions& options = {}) {
    write("room.obj", obj);
    return load("room.obj", options);
  }

  // The sentence with which the file is refused, without the folder's name.
  std::string refusal(const std::string& name, const LoadOptions& options = {}) {
    try {
      load(name, options);
    } catch (const InputError& error) {
      return without_folder(error.what());
    }
    return "loaded without complaint";
  }
  std::string refusal_of_text(const std::string& obj, const LoadOptions& options = {}) {
    write("room.obj", obj);
    return refusal("room.obj", options);
  }

  const std::vector<std::string>& warnings() const { return warnings_; }
  std::string all_warnings() const {
    std::string all;
    for (const auto& warning : warnings_) all += warning + "\n";
    return all;
  }

 private:
  std::string without_folder(std::string text) const {
    const auto prefix = folder_.string() + "/";
    for (auto at = text.find(prefix); at != std::string::npos; at = text.find(prefix))
      text.erase(at, prefix.size());
    return text;
  }

  std::filesystem::path folder_;
  std::vector<std::string> warnings_;
};

}  // namespace luxel
