// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/text_font.h"

#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string_view>
#include <vector>

namespace luxel {
namespace {

constexpr const char* usual_folders = "/usr/local/share:/usr/share";
// Below fonts/truetype, as Debian's packages fonts-dejavu-core, fonts-noto-core, fonts-liberation,
// fonts-liberation2 and fonts-open-sans have them.
constexpr std::array names = {"dejavu/DejaVuSans.ttf", "noto/NotoSans-Regular.ttf",
                              "liberation/LiberationSans-Regular.ttf",
                              "liberation2/LiberationSans-Regular.ttf", "open-sans/OpenSans-Regular.ttf"};

// Returns whether the file begins as a TrueType font does: Dear ImGui ends the program at others.
bool is_true_type(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  char head[4] = {};
  return stream.read(head, sizeof head) &&
         std::string_view(head, sizeof head) == std::string_view("\0\1\0\0", 4);
}

}  // namespace

std::optional<std::filesystem::path> find_text_font(const std::string& data_folders) {
  std::istringstream folders(data_folders.empty() ? usual_folders : data_folders);
  std::vector<std::filesystem::path> roots;
  for (std::string folder; std::getline(folders, folder, ':');)
    if (!folder.empty()) roots.emplace_back(folder);
  for (const auto* name : names)
    for (const auto& root : roots)
      if (auto file = root / "fonts/truetype" / name; is_true_type(file)) return file;
  return std::nullopt;
}

std::optional<std::filesystem::path> find_text_font() {
  const char* folders = std::getenv("XDG_DATA_DIRS");
  return find_text_font(folders == nullptr ? "" : folders);
}

}  // namespace luxel
