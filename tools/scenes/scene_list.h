// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "scenes/made_scene.h"

namespace luxel::scenes {

struct NamedScene {
  const char* name;
  const char* about;  // a few words
  MadeScene (*make)();
};

// All scenes by name, in the order of the gallery.
std::span<const NamedScene> scene_list();

// The scene with its points rounded to a micrometre. detail: 1 or more; every triangle is cut in detail² of
// the same shape, so the surfaces and the light on them stay the same. Throws std::out_of_range for an
// unknown name.
MadeScene make_scene(std::string_view name, int detail = 1);

}  // namespace luxel::scenes
