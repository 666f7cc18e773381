// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/material_library.h"

#include <algorithm>

#include <fmt/format.h>

#include "luxel/import/text.h"

namespace luxel {
namespace {

void add_library(const std::filesystem::path& path, MaterialLibrary& library) {
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
                               const SceneFolder& folder, const Context& context) {
  MaterialLibrary library;
  for (const auto& [operands, line] : statements) {
    const auto take = [&, where = line](const std::string& name) {
      const auto found = folder.find(obj_path.parent_path(), name);
      if (found.file) add_library(*found.file, library);
      if (!found.file && found.is_outside)
        refuse_outside(fmt::format("{}:{}", obj_path.string(), where),
                       fmt::format("the material file '{}'", name));
      return found.file.has_value();
    };
    // The operands may be one name with blanks or several names; existing files decide.
    if (take(operands)) continue;
    std::string_view words = operands;
    for (auto word = take_word(words); !word.empty(); word = take_word(words))
      if (!take(std::string(word)))
        context.warn(fmt::format("{}:{}: the material file '{}' was not found beside the OBJ file",
                                 obj_path.string(), line, word));
  }
  return library;
}

}  // namespace luxel
