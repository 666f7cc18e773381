// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <imgui.h>

#include "luxel/viewer/layout.h"
#include "luxel/viewer/panels.h"

namespace luxel {
namespace {

// An editable line of text, and its initial suggestion.
struct PathLine {
  std::array<char, 400> text{};
  std::string said;

  void suggest(const std::string& path) {
    if (path == said) return;
    said = path;
    text.fill('\0');
    path.copy(text.data(), text.size() - 1);
  }
};

// Names derived from the scene's: cornell-box.png, and so on.
std::string named_like(const Viewer& viewer, const char* ending) {
  return std::filesystem::path(viewer.session.title()).stem().string() + ending;
}

}  // namespace

void files_section(Viewer& viewer) {
  if (!viewer.session.mesh() || !ImGui::CollapsingHeader("Files")) return;
  static PathLine picture, solution, model, other;  // static, as there is only one window
  static int times = 1;
  picture.suggest(named_like(viewer, "-view.png"));
  solution.suggest(named_like(viewer, "-view.vtkhdf"));
  model.suggest(named_like(viewer, "-view.glb"));
  const auto line = [](const char* button, PathLine& path) {
    ImGui::PushID(button);
    ImGui::SetNextItemWidth(em(12.5f));
    ImGui::InputText("##path", path.text.data(), path.text.size());
    ImGui::SameLine();
    const bool pressed = ImGui::Button(button);
    ImGui::PopID();
    return pressed && path.text[0] != '\0';
  };
  if (line("picture", picture)) {
    auto size = viewer.pixels();
    size.width *= times, size.height *= times;
    viewer.save_picture(picture.text.data(), size);
  }
  if (const auto* making = viewer.picture())
    ImGui::ProgressBar(static_cast<float>(making->done()), ImVec2(-1.0f, 0.0f),
                       making->is_drawn() ? "writing" : "drawing");
  ImGui::SliderInt("times the window", &times, 1, 8);
  if (line("solution", solution)) viewer.save_solution(solution.text.data());
  if (line("GLB", model)) viewer.export_glb(model.text.data());
  if (line("compare", other)) {
    viewer.compare(other.text.data());
    viewer.look.show = Show::difference;
  }
  if (!viewer.queries.compared_with.empty())
    ImGui::TextDisabled("beside %s", viewer.queries.compared_with.filename().string().c_str());
}

}  // namespace luxel
