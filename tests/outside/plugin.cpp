// SPDX-License-Identifier: Apache-2.0
// Code that a plug-in of another program would contain: a complete bake.
#include <luxel/luxel.h>

extern "C" std::size_t patches_of(const char* path) {
  return luxel::bake(luxel::load_scene(path)).patches.size();
}
