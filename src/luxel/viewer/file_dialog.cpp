// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/file_dialog.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include <imgui.h>

#include "luxel/core/ending_of.h"
#include "luxel/viewer/layout.h"

namespace luxel {

void FileDialog::ask(FileRequest request) {
  browser_.emplace(request.folder, request.endings);
  request_ = std::move(request);
  set_name(request_->name);
  begins_ = true;
}

void FileDialog::set_name(const std::string& name) {
  name_.fill('\0');
  name.copy(name_.data(), name_.size() - 1);
}

std::filesystem::path FileDialog::chosen() const {
  auto path = browser_->path_of(name_.data());
  if (request_->is_new && !request_->endings.empty() && ending_of(path).empty())
    path += request_->endings.front();
  return path;
}

bool FileDialog::replaces() const {
  std::error_code error;
  return request_->is_new && name_[0] != '\0' && std::filesystem::is_regular_file(chosen(), error);
}

void FileDialog::list() {
  const auto folder = browser_->folder().string();
  ImGui::TextWrapped("%s", folder.c_str());
  ImGui::BeginChild("##files", ImVec2(0.0f, em(16.0f)), true);
  std::filesystem::path enter;
  const auto row = [&](const std::string& name, bool is_folder) {
    const auto label = is_folder ? name + "/" : name;
    if (!ImGui::Selectable(label.c_str(), name == name_.data(), ImGuiSelectableFlags_AllowDoubleClick))
      return;
    if (is_folder) {
      enter = name;
    } else {
      set_name(name);
      if (ImGui::IsMouseDoubleClicked(0) && !request_->is_new) take();
    }
  };
  row("..", true);
  // A copy: a choice closes the dialog.
  for (const auto& entry : std::vector(browser_->entries())) {
    if (!request_) break;
    row(entry.name, entry.is_folder);
  }
  ImGui::EndChild();
  if (request_ && !enter.empty()) browser_->enter(enter);
}

void FileDialog::take() {
  if (name_[0] == '\0') return;
  std::error_code error;
  if (std::filesystem::is_directory(browser_->path_of(name_.data()), error)) {
    browser_->enter(name_.data());
    set_name("");
    return;
  }
  const auto path = chosen();
  const auto choose = std::move(request_->choose);
  request_.reset();
  ImGui::CloseCurrentPopup();
  choose(path);
}

void FileDialog::name_line() {
  if (!browser_->error().empty()) ImGui::TextWrapped("%s", browser_->error().c_str());
  if (begins_) ImGui::SetKeyboardFocusHere();
  begins_ = false;
  ImGui::SetNextItemWidth(-em(12.0f));
  const bool is_entered =
      ImGui::InputText("##name", name_.data(), name_.size(),
                       ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ImGui::SameLine();
  const bool replaces_one = replaces();
  if (ImGui::Button(replaces_one ? "Replace" : request_->button.c_str(), ImVec2(em(5.5f), 0.0f)) ||
      is_entered)
    return take();
  ImGui::SameLine();
  if (ImGui::Button("Cancel", ImVec2(em(5.5f), 0.0f)) ||
      ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
    request_.reset();
    ImGui::CloseCurrentPopup();
  } else if (replaces_one) {
    ImGui::TextDisabled("A file of this name exists.");
  } else {
    ImGui::TextDisabled("%s",
                        request_->is_new ? "A file name, or a path." : "A file of the list, or a path.");
  }
}

void FileDialog::draw() {
  if (!request_) return;
  const auto title = request_->title;
  if (!ImGui::IsPopupOpen(title.c_str())) ImGui::OpenPopup(title.c_str());
  const auto& display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(display.x * 0.5f, display.y * 0.5f), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSize(ImVec2(std::min(em(40.0f), display.x - em(1.0f)), 0.0f));
  if (!ImGui::BeginPopupModal(title.c_str(), nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove))
    return;
  list();
  if (request_) name_line();
  ImGui::EndPopup();
}

}  // namespace luxel
