// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "luxel/core/ending_of.h"
#include "luxel/viewer/viewer.h"

// Files that are dropped, and dialogs for those that are opened, saved and exported.

namespace luxel {
namespace {

const std::vector<std::string> scene_endings = {".obj", ".gltf", ".glb", ".ply",   ".stl",
                                                ".fbx", ".dae",  ".3ds", ".vtkhdf"};

}  // namespace

// Several files that belong together may be dropped at once: a scene, its materials and its textures.
void Viewer::drop(const std::string& files) {
  std::istringstream paths(files);
  std::string first;
  for (std::string path; std::getline(paths, path);) {
    if (first.empty()) first = path;
    if (std::find(scene_endings.begin(), scene_endings.end(), ending_of(path)) != scene_endings.end())
      return open(path);
  }
  if (!first.empty()) open(first);
}

void Viewer::ask_open() {
  const auto folder = session.has_scene() ? session->file().parent_path() : std::filesystem::path();
  file_dialog.ask({.title = "Open a scene or a solution",
                   .button = "Open",
                   .endings = scene_endings,
                   .folder = folder,
                   .choose = [this](const std::filesystem::path& file) { open(file); }});
}

void Viewer::ask_compare() {
  file_dialog.ask({.title = "Compare with a second solution",
                   .button = "Compare",
                   .endings = {".vtkhdf"},
                   .folder = session->file().parent_path(),
                   .choose = [this](const std::filesystem::path& file) {
                     compare(file);
                     look.show = Show::difference;
                   }});
}

// A name like the scene's, beside it.
void Viewer::ask_save(const char* title, const char* ending,
                      std::function<void(const std::filesystem::path&)> save) {
  file_dialog.ask({.title = title,
                   .button = "Save",
                   .endings = {ending},
                   .folder = session->file().parent_path(),
                   .name = std::filesystem::path(session.title()).stem().string() + "-view" + ending,
                   .is_new = true,
                   .choose = std::move(save)});
}

void Viewer::ask_save_solution() {
  ask_save("Save the solution", ".vtkhdf", [this](const auto& file) { save_solution(file); });
}

void Viewer::ask_save_picture() {
  ask_save("Save a picture of this view", ".png", [this](const auto& file) { save_picture(file, pixels()); });
}

void Viewer::ask_export() {
  ask_save("Export the lit mesh as GLB", ".glb", [this](const auto& file) { export_glb(file); });
}

}  // namespace luxel
