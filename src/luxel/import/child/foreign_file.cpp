// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/child/foreign_file.h"

#include <string_view>

#include <assimp/BaseImporter.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <fmt/format.h>

#include "luxel/core/ending_of.h"
#include "luxel/core/error.h"

namespace luxel {
namespace {

ForeignFormat format_of(const std::filesystem::path& path) {
  const auto ending = ending_of(path);
  if (ending == ".fbx") return ForeignFormat::fbx;
  if (ending == ".dae") return ForeignFormat::collada;
  if (ending == ".3ds") return ForeignFormat::max_3ds;
  throw InputError(fmt::format("expected a file that ends in .fbx, .dae or .3ds, found '{}'", ending));
}

bool reads(const Assimp::BaseImporter& importer, std::string_view ending) {
  std::string_view all = importer.GetInfo()->mFileExtensions;  // divided by blanks
  while (!all.empty()) {
    const auto end = all.find(' ');
    if (all.substr(0, end) == ending) return true;
    if (end == all.npos) break;
    all.remove_prefix(end + 1);
  }
  return false;
}

// Assimp otherwise chooses a reader by the contents of the file. Its readers of other formats are less well
// tested.
void keep_one_reader(Assimp::Importer& importer, std::string_view ending) {
  for (auto i = importer.GetImporterCount(); i-- > 0;) {
    auto* reader = importer.GetImporter(i);
    if (reads(*reader, ending)) continue;
    importer.UnregisterLoader(reader);
    delete reader;  // UnregisterLoader() leaves it to the caller
  }
}

// In COLLADA, ids are unique and names are what people read.
void read(ForeignFile& file, bool names_from_ids) {
  file.importer = std::make_unique<Assimp::Importer>();
  auto& importer = *file.importer;
  keep_one_reader(importer, ending_of(file.path).substr(1));
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_ANIMATIONS, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, !names_from_ids);
  file.scene = importer.ReadFile(file.path.string(), aiProcess_TransformUVCoords);
  if (!file.scene || !file.scene->mRootNode) {
    const std::string reason = importer.GetErrorString();
    throw InputError(reason.empty() ? "no scene found" : reason);
  }
}

// Assimp places lamps and cameras at the node of their name.
bool are_places_unique(const aiScene& scene) {
  const auto is_unique = [&](const aiString& name) {
    return nodes_named(*scene.mRootNode, name).size() <= 1;
  };
  for (unsigned i = 0; i < scene.mNumLights; ++i)
    if (!is_unique(scene.mLights[i]->mName)) return false;
  for (unsigned i = 0; i < scene.mNumCameras; ++i)
    if (!is_unique(scene.mCameras[i]->mName)) return false;
  return true;
}

}  // namespace

ForeignFile read_foreign(const std::filesystem::path& path) {
  ForeignFile file;
  file.path = path;
  file.format = format_of(path);
  read(file, false);
  if (file.format == ForeignFormat::collada && !are_places_unique(*file.scene)) read(file, true);
  return file;
}

std::vector<const aiNode*> nodes_named(const aiNode& root, const aiString& name) {
  std::vector<const aiNode*> found, stack = {&root};
  while (!stack.empty()) {
    const auto* node = stack.back();
    stack.pop_back();
    if (node->mName == name) found.push_back(node);
    for (auto i = node->mNumChildren; i-- > 0;) stack.push_back(node->mChildren[i]);
  }
  return found;
}

}  // namespace luxel
