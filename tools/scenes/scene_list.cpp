// SPDX-License-Identifier: Apache-2.0
#include "scenes/scene_list.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "scenes/places/places.h"
#include "scenes/shapes/split.h"

namespace luxel::scenes {
namespace {

constexpr std::array scenes = {
    NamedScene{"cornell-box", "the Cornell box", cornell_box},
    NamedScene{"reading-room", "a furnished room in the evening, with lamps and a window",
               reading_room_scene},
    NamedScene{"office", "eight desks under ceiling luminaires", office},
    NamedScene{"classroom", "daylight and sun from one side", classroom},
    NamedScene{"art-gallery", "skylights and wall washers", art_gallery},
    NamedScene{"stairwell", "a winding staircase round an open well", stairwell},
    NamedScene{"courtyard", "a cloister with a fountain, under sun and sky", courtyard},
    NamedScene{"street", "a lane of houses, under sun and sky", street},
    NamedScene{"cafe", "pendant lamps and a bar in the evening", cafe},
    NamedScene{"chapel", "columns, a vault, and the sun through windows", chapel},
    NamedScene{"study", "a small room with a sun and a spot, for glTF", study},
};

}  // namespace

std::span<const NamedScene> scene_list() { return scenes; }

MadeScene make_scene(std::string_view name, int detail) {
  const auto found =
      std::find_if(scenes.begin(), scenes.end(), [&](const NamedScene& scene) { return scene.name == name; });
  if (found == scenes.end()) throw std::out_of_range("no scene is named " + std::string(name));
  auto made = found->make();
  for (auto& object : made.objects) {
    object.mesh = rounded(object.mesh);
    if (detail > 1) object.mesh = rounded(split(object.mesh, detail));
  }
  return made;
}

}  // namespace luxel::scenes
