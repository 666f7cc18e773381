// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/material_library.h"

#include <algorithm>

#include <fmt/format.h>

#include "luxel/import/text.h"

namespace luxel {
namespace {

bool is_plain_file(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

void add_file(const std::filesystem::path& path, MaterialLibrary& library) {
  const auto source = path.string();
  if (std::find(library.files.begin(), library.files.end(), source) != library.files.end()) return;
  library.files.push_back(source);
  for (auto& material : read_mtl(read_text(path, source), source)) {
    auto name = material.name;
    library.entries.try_emplace(std::move(name),
                                MaterialLibrary::Entry{std::move(material), path.parent_path()});
  }
}

}  // namespace

MaterialLibrary read_libraries(std::span<const NamedLine> statements, const std::filesystem::path& obj_path,
                               const Context& context) {
  MaterialLibrary library;
  const auto folder = obj_path.parent_path();
  for (const auto& [operands, line] : statements) {
    // The operands may be one name with blanks or several names; existing files decide.
    if (const auto whole = find_file(folder, operands)) {
      add_file(*whole, library);
      continue;
    }
    std::string_view words = operands;
    for (auto word = take_word(words); !word.empty(); word = take_word(words)) {
      if (const auto path = find_file(folder, std::string(word)))
        add_file(*path, library);
      else
        context.warn(fmt::format("{}:{}: the material file '{}' was not found beside the OBJ file",
                                 obj_path.string(), line, word));
    }
  }
  return library;
}

std::optional<std::filesystem::path> find_file(const std::filesystem::path& folder, const std::string& name) {
  if (name.empty()) return std::nullopt;
  auto slashed = name;
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  for (const auto& candidate :
       {folder / name, folder / slashed, folder / std::filesystem::path(slashed).filename()})
    if (is_plain_file(candidate)) return candidate;
  return std::nullopt;
}

}  // namespace luxel
