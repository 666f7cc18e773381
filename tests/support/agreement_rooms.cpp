// SPDX-License-Identifier: Apache-2.0
#include "support/agreement_rooms.h"

#include <string>

#include "luxel/patch/make_patches.h"

#include "support/truth_scenes.h"

namespace luxel::truth {
namespace {

constexpr bool one_sided = false;

// The faces of a box: seen from inside, or from outside.
void box(SceneBuilder& b, const Vec3& l, const Vec3& h, bool inside) {
  const Vec3 p[8] = {{l.x, l.y, l.z}, {h.x, l.y, l.z}, {h.x, h.y, l.z}, {l.x, h.y, l.z},
                     {l.x, l.y, h.z}, {h.x, l.y, h.z}, {h.x, h.y, h.z}, {l.x, h.y, h.z}};
  const int faces[6][4] = {{0, 1, 2, 3}, {7, 6, 5, 4}, {4, 5, 1, 0},
                           {5, 6, 2, 1}, {6, 7, 3, 2}, {7, 4, 0, 3}};
  for (const auto& f : faces)
    inside ? b.quad(p[f[0]], p[f[1]], p[f[2]], p[f[3]]) : b.quad(p[f[3]], p[f[2]], p[f[1]], p[f[0]]);
}

// A lamp that looks down, at a height z.
void lamp_below(SceneBuilder& b, float x0, float y0, float x1, float y1, float z) {
  b.quad({x0, y1, z}, {x1, y1, z}, {x1, y0, z}, {x0, y0, z});
}

PatchSet cut(const SceneBuilder& b, float max_edge) {
  return make_patches(b.scene(), {.max_edge = max_edge});
}

// A closed cube under a luminous ceiling.
PatchSet luminous_ceiling() {
  SceneBuilder b;
  b.material("walls", 0.5f, 0.0f, one_sided);
  b.quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  b.quad({0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}).quad({1, 0, 1}, {1, 1, 1}, {1, 1, 0}, {1, 0, 0});
  b.quad({0, 0, 1}, {1, 0, 1}, {1, 0, 0}, {0, 0, 0}).quad({0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1});
  b.material("ceiling", 0.5f, 1.0f, one_sided);
  lamp_below(b, 0, 0, 1, 1, 1);
  return cut(b, 0.36f);
}

// Two plates, open all round.
PatchSet open_plates() {
  SceneBuilder b;
  b.material("lower", 0.5f, 1.0f).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  b.material("upper", 0.5f, 0.0f).quad({0, 1, 1}, {1, 1, 1}, {1, 0, 1}, {0, 0, 1});
  return cut(b, 0.36f);
}

// Light that comes round a corner.
PatchSet l_shaped() { return make_patches(l_room(), {.max_edge = 0.72f}); }

// A closed cube with a lamp and a two-sided sheet hung below it: a deep shadow.
PatchSet hung_sheet() {
  SceneBuilder b;
  b.material("walls", 0.5f, 0.0f, one_sided);
  box(b, {0, 0, 0}, {1, 1, 1}, true);
  b.material("lamp", 0.2f, 10.0f, one_sided);
  lamp_below(b, 0.35f, 0.35f, 0.65f, 0.65f, 0.9f);
  b.material("sheet", 0.4f, 0.0f)
      .quad({0.25f, 0.25f, 0.45f}, {0.75f, 0.3f, 0.5f}, {0.75f, 0.75f, 0.55f}, {0.25f, 0.7f, 0.5f});
  return cut(b, 0.5f);
}

// A closed box that reflects 0.9, so that light takes fifty bounces to die; coloured, with a block in it.
PatchSet bright_box() {
  SceneBuilder b;
  b.material("walls", Vec3(0.9f, 0.88f, 0.8f), Vec3(0.0f), one_sided);
  box(b, {0, 0, 0}, {1.5f, 1, 1}, true);
  b.material("lamp", 0.3f, 5.0f, one_sided);
  lamp_below(b, 0.5f, 0.3f, 0.9f, 0.7f, 0.95f);
  b.material("block", Vec3(0.9f), Vec3(0.0f), one_sided);
  box(b, {0.2f, 0.2f, 0.1f}, {0.5f, 0.7f, 0.5f}, false);
  return cut(b, 1.1f);
}

// Sixteen lamps of all colours over a floor and a wall, some with a shade: open to the sky.
PatchSet many_lamps() {
  SceneBuilder b;
  b.material("ground", 0.6f, 0.0f).quad({0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0});
  b.material("wall", Vec3(0.7f, 0.5f, 0.3f), Vec3(0.0f)).quad({0, 2, 0}, {2, 2, 0}, {2, 2, 1}, {0, 2, 1});
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const auto x = 0.15f + 0.5f * static_cast<float>(i), y = 0.15f + 0.5f * static_cast<float>(j);
      const auto z = 0.5f + 0.1f * static_cast<float>((i + 2 * j) % 4);
      b.material(
          "lamp " + std::to_string(4 * i + j), Vec3(0.1f),
          Vec3(2.0f + static_cast<float>(i), 2.0f + static_cast<float>(j), 6.0f - static_cast<float>(i)));
      lamp_below(b, x, y, x + 0.2f, y + 0.2f, z);
    }
  b.material("shade", 0.5f, 0.0f)
      .quad({0.1f, 0.1f, 0.3f}, {0.6f, 0.1f, 0.3f}, {0.6f, 0.6f, 0.3f}, {0.1f, 0.6f, 0.3f});
  return cut(b, 0.51f);
}

// Three two-sided sheets one behind the other, lit from one end, in the open.
PatchSet louvre() {
  SceneBuilder b;
  b.material("lamp", 0.0f, 3.0f).quad({0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1});
  b.material("sheets", Vec3(0.8f, 0.5f, 0.2f), Vec3(0.0f));
  for (const auto x : {0.4f, 0.8f, 1.2f}) {
    const auto y = x < 0.5f || x > 1.0f ? 0.0f : 0.4f;
    b.quad({x, y, 0}, {x, y + 0.6f, 0}, {x + 0.1f, y + 0.6f, 1}, {x + 0.1f, y, 1});
  }
  return cut(b, 0.51f);
}

// Two rooms, one lit, and a door between them in a thin two-sided wall.
PatchSet two_rooms() {
  SceneBuilder b;
  b.material("walls", 0.7f, 0.0f, one_sided);
  box(b, {0, 0, 0}, {2, 1, 1}, true);
  b.material("partition", 0.7f, 0.0f);
  b.quad({1, 0, 0}, {1, 0.6f, 0}, {1, 0.6f, 1}, {1, 0, 1})
      .quad({1, 0.6f, 0.8f}, {1, 1, 0.8f}, {1, 1, 1}, {1, 0.6f, 1});
  b.material("lamp", 0.3f, 8.0f, one_sided);
  lamp_below(b, 0.3f, 0.3f, 0.7f, 0.7f, 0.95f);
  return cut(b, 0.72f);
}

// Plates of which one turns its black back, so that light escapes, is absorbed and is lost there.
PatchSet turned_plates() {
  SceneBuilder b;
  b.material("lamp", 0.5f, 1.0f, one_sided).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  b.material("turned", 0.5f, 0.0f, one_sided).quad({0, 0, 1}, {0.5f, 0, 1}, {0.5f, 1, 1}, {0, 1, 1});
  b.material("upper", 0.5f, 0.0f, one_sided).quad({0.5f, 1, 1}, {1, 1, 1}, {1, 0, 1}, {0.5f, 0, 1});
  return cut(b, 0.36f);
}

// The L-shaped room in daylight: no lamp, a window in its end wall, and a blue shade before it.
PatchSet sky_window() {
  SceneBuilder b;
  b.material("walls", Vec3(0.6f, 0.5f, 0.4f), Vec3(0.0f), one_sided);
  b.quad({0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}).quad({1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0});
  b.quad({0, 2, 1}, {1, 2, 1}, {1, 0, 1}, {0, 0, 1}).quad({1, 1, 1}, {2, 1, 1}, {2, 0, 1}, {1, 0, 1});
  b.quad({0, 0, 0}, {0, 2, 0}, {0, 2, 1}, {0, 0, 1}).quad({0, 0, 1}, {2, 0, 1}, {2, 0, 0}, {0, 0, 0});
  b.quad({0, 2, 0}, {1, 2, 0}, {1, 2, 1}, {0, 2, 1}).quad({1, 2, 0}, {1, 1, 0}, {1, 1, 1}, {1, 2, 1});
  b.quad({1, 1, 0}, {2, 1, 0}, {2, 1, 1}, {1, 1, 1});
  b.quad({2, 1, 0}, {2, 0, 0}, {2, 0, 0.2f}, {2, 1, 0.2f});
  b.quad({2, 0.1f, 0.2f}, {2, 0, 0.2f}, {2, 0, 1}, {2, 0.1f, 1});
  b.quad({2, 1, 0.2f}, {2, 0.9f, 0.2f}, {2, 0.9f, 1}, {2, 1, 1});
  b.material("shade", Vec3(0.2f, 0.4f, 0.8f), Vec3(0.0f));
  b.quad({2.2f, 0.1f, 0.7f}, {2.6f, 0.1f, 0.6f}, {2.6f, 0.9f, 0.6f}, {2.2f, 0.9f, 0.7f});
  auto scene = b.scene();
  scene.sky = Vec3(0.8f, 0.9f, 1.2f);
  return make_patches(scene, {.max_edge = 1.1f});
}

}  // namespace

const std::vector<AgreementRoom>& agreement_rooms() {
  static const std::vector<AgreementRoom> rooms = {{"luminous_ceiling", luminous_ceiling},
                                                   {"open_plates", open_plates},
                                                   {"l_shaped", l_shaped},
                                                   {"hung_sheet", hung_sheet},
                                                   {"bright_box", bright_box},
                                                   {"many_lamps", many_lamps},
                                                   {"louvre", louvre},
                                                   {"two_rooms", two_rooms},
                                                   {"turned_plates", turned_plates},
                                                   {"sky_window", sky_window}};
  return rooms;
}

}  // namespace luxel::truth
