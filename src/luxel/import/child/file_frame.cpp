// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/child/file_frame.h"

#include <cmath>

#include "luxel/core/error.h"

namespace luxel {
namespace {

// Unit vector of an axis that FBX gives as a number (0: x, 1: y, 2: z) and a sign.
aiVector3D axis_of(const aiMetadata& data, const char* axis, const char* sign, int otherwise) {
  int number = otherwise, direction = 1;
  data.Get(axis, number);
  data.Get(sign, direction);
  if (number < 0 || number > 2) number = otherwise;
  aiVector3D unit;
  unit[static_cast<unsigned>(number)] = direction < 0 ? -1.0f : 1.0f;
  return unit;
}

// FBX states which axes point up and to the right; the third follows, since its coordinates are right-handed.
aiMatrix4x4 fbx_frame(const aiMetadata& data) {
  constexpr float metres_per_centimetre = 0.01f;  // UnitScaleFactor counts in centimetres
  const auto up = axis_of(data, "UpAxis", "UpAxisSign", 1);
  auto right = axis_of(data, "CoordAxis", "CoordAxisSign", 0);
  if (std::abs(up * right) > 0.5f) right = up.x == 0.0f ? aiVector3D(1, 0, 0) : aiVector3D(0, 0, 1);
  const auto front = right ^ up;
  float unit = 1.0f;
  data.Get("UnitScaleFactor", unit);
  if (!(unit > 0.0f && std::isfinite(unit)))
    throw InputError("expected a UnitScaleFactor above 0, found another number");
  const float s = unit * metres_per_centimetre;
  return {s * right.x, s * right.y, s * right.z, 0, s * up.x, s * up.y, s * up.z, 0,
          s * front.x, s * front.y, s * front.z, 0, 0,        0,        0,        1};
}

}  // namespace

aiMatrix4x4 file_frame(const ForeignFile& file) {
  if (file.format == ForeignFormat::fbx && file.scene->mMetaData) return fbx_frame(*file.scene->mMetaData);
  if (file.format == ForeignFormat::max_3ds) return {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1};
  return {};
}

}  // namespace luxel
