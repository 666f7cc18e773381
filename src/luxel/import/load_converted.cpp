// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/load_converted.h"

#include "luxel/core/ending_of.h"
#include "luxel/import/converter.h"
#include "luxel/import/load_gltf.h"

namespace luxel {

bool is_converted(const std::filesystem::path& path) {
  const auto ending = ending_of(path);
  return ending == ".fbx" || ending == ".dae" || ending == ".3ds";
}

Scene load_converted(const std::filesystem::path& path, const LoadOptions& options, const Context& context) {
  const auto limits = converter_limits(std::filesystem::file_size(path));
  auto glb = converted_file(path, find_converter(), limits, context);
  if (!glb) return {};
  auto scene = load_gltf(std::move(*glb), path, options, context);
  if (ending_of(path) == ".3ds") scene.up = Vec3(0.0f);  // the format does not define it
  return scene;
}

}  // namespace luxel
