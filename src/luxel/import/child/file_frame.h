// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <assimp/matrix4x4.h>

#include "luxel/import/child/foreign_file.h"

namespace luxel {

// Returns the left factor of the root node's transform that brings the scene to metres with +Y up. Assimp
// applies it itself for COLLADA; for FBX it only reports the unit and the axes. 3DS states neither: the
// matrix restores the coordinates of the file, which Assimp turns.
aiMatrix4x4 file_frame(const ForeignFile& file);

}  // namespace luxel
