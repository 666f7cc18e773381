// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenes/made_scene.h"

namespace luxel::scenes {

// The scenes, each in the file of its name. The same on every call; points are not yet rounded.
MadeScene cornell_box();
MadeScene reading_room_scene();
MadeScene office();
MadeScene classroom();
MadeScene art_gallery();
MadeScene stairwell();
MadeScene courtyard();
MadeScene street();
MadeScene cafe();
MadeScene chapel();
MadeScene study();

}  // namespace luxel::scenes
