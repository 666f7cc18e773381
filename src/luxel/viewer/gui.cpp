// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/gui.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <iterator>
#include <string>

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "luxel/core/error.h"
#include "luxel/viewer/text_font.h"

namespace luxel {
namespace {

constexpr float text_height = 15.0f;      // points
constexpr float built_in_height = 13.0f;  // of the built-in font, its native size

// Latin, Greek, Cyrillic and punctuation, for names of files and materials. Ends with 0.
constexpr ImWchar glyphs[] = {0x20,   0x17f,  0x370,  0x3ff,  0x400,  0x4ff, 0x2010,
                              0x2044, 0x2190, 0x2193, 0x2212, 0x2212, 0};

// Tab is left out: it switches between the two modes, not between fields.
void map_keys(ImGuiIO& io) {
  const std::pair<int, Key> keys[] = {{ImGuiKey_LeftArrow, key::left},
                                      {ImGuiKey_RightArrow, key::right},
                                      {ImGuiKey_UpArrow, key::up},
                                      {ImGuiKey_DownArrow, key::down},
                                      {ImGuiKey_PageUp, key::page_up},
                                      {ImGuiKey_PageDown, key::page_down},
                                      {ImGuiKey_Home, key::home},
                                      {ImGuiKey_End, key::end},
                                      {ImGuiKey_Insert, key::insert},
                                      {ImGuiKey_Delete, key::del},
                                      {ImGuiKey_Backspace, key::backspace},
                                      {ImGuiKey_Enter, key::enter},
                                      {ImGuiKey_Escape, key::escape},
                                      {ImGuiKey_A, 'A'},
                                      {ImGuiKey_C, 'C'},
                                      {ImGuiKey_V, 'V'},
                                      {ImGuiKey_X, 'X'},
                                      {ImGuiKey_Y, 'Y'},
                                      {ImGuiKey_Z, 'Z'}};
  std::fill(std::begin(io.KeyMap), std::end(io.KeyMap), -1);
  for (const auto& [theirs, ours] : keys) io.KeyMap[theirs] = ours;
}

void share_clipboard(ImGuiIO& io, Screen& screen) {
  io.ClipboardUserData = &screen;
  io.SetClipboardTextFn = [](void* to, const char* text) { static_cast<Screen*>(to)->set_clipboard(text); };
  io.GetClipboardTextFn = [](void* from) -> const char* {
    static std::string text;  // ImGui reads it after the call
    text = static_cast<Screen*>(from)->clipboard();
    return text.c_str();
  };
}

}  // namespace

Gui::Gui(Screen& screen) : screen_(screen) {
  ImGui::CreateContext();
  auto& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // panels have their default places, on every host
  io.LogFilename = nullptr;
  io.BackendPlatformName = "luxel";
  map_keys(io);
  share_clipboard(io, screen);
  if (!ImGui_ImplOpenGL3_Init("#version 330 core")) {
    ImGui::DestroyContext();
    throw DeviceError("the panels could not be made: OpenGL could not be loaded a second time");
  }
  set_scale(screen.text_scale(), screen.text_scale());
}

Gui::~Gui() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext();
}

// pixels: height of a text of one point; units: the same in the cursor's units, which differ where a unit is
// several pixels.
void Gui::set_scale(float pixels, float units) {
  pixels_ = pixels;
  units_ = units;
  auto& io = ImGui::GetIO();
  io.Fonts->Clear();
  const auto file = find_text_font();
  const auto* font =
      file ? io.Fonts->AddFontFromFileTTF(file->c_str(), std::round(text_height * pixels), nullptr, glyphs)
           : nullptr;
  if (font == nullptr) {
    ImFontConfig built_in;
    built_in.SizePixels = std::round(built_in_height * pixels);
    io.Fonts->AddFontDefault(&built_in);
  }
  io.FontGlobalScale = units / pixels;
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
  auto style = ImGuiStyle();
  ImGui::StyleColorsDark(&style);
  style.WindowRounding = 6.0f;
  style.PopupRounding = 4.0f;
  style.FrameRounding = 3.0f;
  style.GrabRounding = 3.0f;
  style.WindowBorderSize = 0.0f;
  style.Colors[ImGuiCol_WindowBg] = ImVec4(0.07f, 0.08f, 0.10f, 0.88f);
  style.Colors[ImGuiCol_PopupBg] = ImVec4(0.07f, 0.08f, 0.10f, 0.98f);
  style.Colors[ImGuiCol_MenuBarBg] = ImVec4(0.09f, 0.10f, 0.13f, 1.0f);
  style.Colors[ImGuiCol_Header] = ImVec4(0.20f, 0.26f, 0.36f, 0.8f);
  style.Colors[ImGuiCol_PlotHistogram] = ImVec4(0.20f, 0.42f, 0.66f, 1.0f);  // progress
  style.ScaleAllSizes(units);
  ImGui::GetStyle() = style;
}

void Gui::handle(const Event& event, bool free_cursor) {
  auto& io = ImGui::GetIO();
  const auto button = static_cast<int>(event.button);
  switch (event.kind) {
    case Event::Kind::key:
      if (event.key <= 0 || event.key >= key::count) return;
      io.KeysDown[event.key] = event.down;
      io.KeyShift = io.KeysDown[key::shift];
      io.KeyCtrl = io.KeysDown[key::control];
      io.KeyAlt = io.KeysDown[key::alt];
      return;
    case Event::Kind::text:
      io.AddInputCharactersUTF8(event.text.c_str());
      return;
    case Event::Kind::move:
      io.MousePos = free_cursor ? ImVec2(event.at.x, event.at.y) : ImVec2(-FLT_MAX, -FLT_MAX);
      return;
    case Event::Kind::button:
      down_[button] = event.down && free_cursor;
      clicked_[button] |= down_[button];
      return;
    case Event::Kind::wheel:
      if (!free_cursor) return;
      io.MouseWheelH += event.at.x;
      io.MouseWheel += event.at.y;
      return;
    default:
      return;
  }
}

void Gui::begin(double seconds) {
  auto& io = ImGui::GetIO();
  const auto size = screen_.size(), pixels = screen_.pixels();
  const float scale = screen_.text_scale();
  const float units = scale * static_cast<float>(size.width) / static_cast<float>(pixels.width);
  if (scale != pixels_ || units != units_) set_scale(scale, units);
  io.DisplaySize = ImVec2(static_cast<float>(size.width), static_cast<float>(size.height));
  io.DisplayFramebufferScale = ImVec2(static_cast<float>(pixels.width) / io.DisplaySize.x,
                                      static_cast<float>(pixels.height) / io.DisplaySize.y);
  io.DeltaTime = static_cast<float>(seconds > 1e-4 ? seconds : 1e-4);
  for (int i = 0; i < 3; ++i) {
    io.MouseDown[i] = down_[i] || clicked_[i];
    clicked_[i] = false;
  }
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
}

void Gui::draw() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

bool Gui::wants_mouse() const { return ImGui::GetIO().WantCaptureMouse; }
bool Gui::wants_keys() const { return ImGui::GetIO().WantTextInput || has_popup(); }
bool Gui::is_typing() const { return ImGui::GetIO().WantTextInput; }
bool Gui::is_editing() const { return ImGui::IsAnyItemActive(); }
bool Gui::is_pressed() const { return down_[0] || down_[1] || down_[2]; }
bool Gui::has_popup() const {
  return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

}  // namespace luxel
