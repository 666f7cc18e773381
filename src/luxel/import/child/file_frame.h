// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <assimp/matrix4x4.h>

#include "luxel/import/child/foreign_file.h"

namespace luxel {

// What the transform of the root node is multiplied by, on the left, so that the scene is in metres and +Y is
// up. Assimp does so itself for COLLADA; for FBX it only reports the unit and the axes. 3DS states neither:
// the matrix restores the coordinates of the file, which Assimp turns.
aiMatrix4x4 file_frame(const ForeignFile& file);

}  // namespace luxel
