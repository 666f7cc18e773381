// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/child/foreign_pictures.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include <fmt/format.h>

namespace luxel {
namespace {

std::string in_small_letters(std::string text) {
  for (auto& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// Returns the file of this name in a folder, whatever its capitals.
std::optional<std::filesystem::path> in_folder(const std::filesystem::path& folder, const std::string& name) {
  std::error_code error;
  if (std::filesystem::is_regular_file(folder / name, error)) return folder / name;
  const auto wanted = in_small_letters(name);
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (in_small_letters(entry.path().filename().string()) == wanted) return entry.path();
  return std::nullopt;
}

}  // namespace

std::filesystem::path find_picture(std::string name, const std::filesystem::path& file) {
  std::replace(name.begin(), name.end(), '\\', '/');
  constexpr std::string_view scheme = "file://";
  if (name.starts_with(scheme)) name.erase(0, scheme.size());
  const std::filesystem::path given(name);
  const auto folder = file.parent_path().empty() ? std::filesystem::path(".") : file.parent_path();
  std::error_code error;
  const auto own_name = given.filename().string();
  if (own_name.empty()) return given;
  if (given.is_relative() && std::filesystem::is_regular_file(folder / given, error)) return given;
  const auto unpacked = file.stem().string() + ".fbm";
  for (const auto& place :
       {std::filesystem::path(), std::filesystem::path("textures"), std::filesystem::path(unpacked)})
    if (const auto found = in_folder(folder / place, own_name)) return place / found->filename();
  if (given.is_absolute() && std::filesystem::is_regular_file(given, error))
    return std::filesystem::relative(given, folder, error);
  return own_name;
}

std::string uri_of(const std::filesystem::path& path) {
  std::string uri;
  for (const char c : path.generic_string())
    if (std::isalnum(static_cast<unsigned char>(c)) ||
        std::string_view("/._-~").find(c) != std::string_view::npos)
      uri += c;
    else
      uri += fmt::format("%{:02X}", static_cast<unsigned char>(c));
  return uri;
}

std::optional<std::size_t> ForeignPictures::image(const aiString& name) {
  const auto [place, is_new] = images_.try_emplace(name.C_Str());
  if (is_new) place->second = add(name);
  return place->second;
}

std::optional<std::size_t> ForeignPictures::add(const aiString& name) {
  const auto* embedded = file_.scene->GetEmbeddedTexture(name.C_Str());
  if (!embedded) {
    const auto path = find_picture(name.C_Str(), file_.path);
    return glb_.append("/images", {{"uri", uri_of(path)}, {"name", path.filename().string()}});
  }
  if (embedded->mHeight != 0 || embedded->mWidth == 0) {
    file_.messages.push_back(fmt::format(
        "warning the embedded picture '{}' is not PNG, JPEG or the like, passed over", name.C_Str()));
    return std::nullopt;
  }
  const std::string_view bytes(reinterpret_cast<const char*>(embedded->pcData), embedded->mWidth);
  // The type is recognised by the bytes where the picture is read.
  return glb_.add_picture(bytes, bytes.starts_with("\xff\xd8") ? "image/jpeg" : "image/png", name.C_Str());
}

}  // namespace luxel
