// SPDX-License-Identifier: Apache-2.0
#include "support/truth_scenes.h"

#include <cmath>

namespace luxel::truth {

SceneBuilder& SceneBuilder::material(const std::string& name, float reflectance, float emittance,
                                     bool two_sided) {
  return material(name, Vec3(reflectance), Vec3(emittance), two_sided);
}

SceneBuilder& SceneBuilder::material(const std::string& name, const Vec3& reflectance, const Vec3& emittance,
                                     bool two_sided) {
  if (scene_.groups.empty()) scene_.groups.push_back("default");
  scene_.source = "built in a test";
  scene_.materials.push_back({name, reflectance, emittance, two_sided});
  return *this;
}

std::uint32_t SceneBuilder::vertex(const Vec3& p) {
  scene_.positions.push_back(p);
  return static_cast<std::uint32_t>(scene_.positions.size() - 1);
}

SceneBuilder& SceneBuilder::triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto i = vertex(a);
  const auto j = vertex(b);
  const auto k = vertex(c);
  scene_.triangles.push_back({i, j, k});
  scene_.triangle_material.push_back(static_cast<MaterialId>(scene_.materials.size() - 1));
  scene_.triangle_line.push_back(0);
  scene_.triangle_group.push_back(0);
  return *this;
}

SceneBuilder& SceneBuilder::quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return triangle(a, b, c).triangle(a, c, d);
}

Scene cube(const std::array<Wall, 6>& walls, float s) {
  SceneBuilder b;
  const auto wall = [&](const char* name, const Wall& w) { b.material(name, w.reflectance, w.emittance); };
  wall("floor", walls[0]);
  b.quad({0, 0, 0}, {s, 0, 0}, {s, s, 0}, {0, s, 0});
  wall("ceiling", walls[1]);
  b.quad({0, s, s}, {s, s, s}, {s, 0, s}, {0, 0, s});
  wall("wall_x0", walls[2]);
  b.quad({0, 0, 0}, {0, s, 0}, {0, s, s}, {0, 0, s});
  wall("wall_x1", walls[3]);
  b.quad({s, 0, s}, {s, s, s}, {s, s, 0}, {s, 0, 0});
  wall("wall_y0", walls[4]);
  b.quad({0, 0, s}, {s, 0, s}, {s, 0, 0}, {0, 0, 0});
  wall("wall_y1", walls[5]);
  b.quad({0, s, 0}, {s, s, 0}, {s, s, s}, {0, s, s});
  return b.scene();
}

Scene cube_a() { return cube({Wall{}, Wall{0.5f, 1.0f}, Wall{}, Wall{}, Wall{}, Wall{}}); }

Scene plates() {
  SceneBuilder b;
  b.material("lower", 0.5f, 1.0f).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  b.material("upper", 0.5f, 0.0f).quad({0, 1, 1}, {1, 1, 1}, {1, 0, 1}, {0, 0, 1});
  return b.scene();
}

Scene l_room() {
  SceneBuilder b;
  b.material("floor_corner", 0.3f, 0.0f).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  b.material("floor_lit", 0.3f, 0.0f).quad({1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0});
  b.material("floor_dark", 0.3f, 0.0f).quad({0, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0});
  b.material("ceiling", 0.7f, 0.0f)
      .quad({0, 1, 1}, {1, 1, 1}, {1, 0, 1}, {0, 0, 1})
      .quad({1, 1, 1}, {2, 1, 1}, {2, 0, 1}, {1, 0, 1})
      .quad({0, 2, 1}, {1, 2, 1}, {1, 1, 1}, {0, 1, 1});
  b.material("wall_y0", 0.5f, 0.0f)
      .quad({0, 0, 1}, {1, 0, 1}, {1, 0, 0}, {0, 0, 0})
      .quad({1, 0, 1}, {2, 0, 1}, {2, 0, 0}, {1, 0, 0});
  b.material("end_x2", 0.5f, 1.0f).quad({2, 0, 1}, {2, 1, 1}, {2, 1, 0}, {2, 0, 0});
  b.material("inner_y1", 0.5f, 0.0f).quad({1, 1, 0}, {2, 1, 0}, {2, 1, 1}, {1, 1, 1});
  b.material("inner_x1", 0.5f, 0.0f).quad({1, 1, 1}, {1, 2, 1}, {1, 2, 0}, {1, 1, 0});
  b.material("end_y2", 0.5f, 0.0f).quad({0, 2, 0}, {1, 2, 0}, {1, 2, 1}, {0, 2, 1});
  b.material("wall_x0", 0.5f, 0.0f)
      .quad({0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1})
      .quad({0, 1, 0}, {0, 2, 0}, {0, 2, 1}, {0, 1, 1});
  return b.scene();
}

Scene sphere(int rings, float cap) {
  SceneBuilder b;
  const auto at = [&](int ring, int segment) {
    const double theta = M_PI * ring / rings;
    const double phi = M_PI * (segment % (2 * rings)) / rings;
    if (ring == 0 || ring == rings) return Vec3(0.0f, 0.0f, ring == 0 ? 1.0f : -1.0f);
    return Vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
  };
  for (const bool emits : {true, false}) {
    b.material(emits ? "cap" : "shell", 0.5f, emits ? 1.0f : 0.0f);
    for (int r = 0; r < rings; ++r)
      for (int s = 0; s < 2 * rings; ++s) {
        const auto p = at(r, s), q = at(r + 1, s), o = at(r + 1, s + 1), n = at(r, s + 1);
        if ((std::min(p.z, q.z) > cap) != emits) continue;
        if (r + 1 < rings) b.triangle(p, o, q);  // seen from inside
        if (r > 0) b.triangle(p, n, o);
      }
  }
  return b.scene();
}

Scene furnace(const Vec3& walls, const Vec3& block) {
  auto scene = cube({});
  SceneBuilder b;
  b.material("walls", walls, Vec3(1.0f) - walls);
  for (const auto& t : scene.triangles)
    b.triangle(scene.positions[t[0]], scene.positions[t[1]], scene.positions[t[2]]);
  b.material("block", block, Vec3(1.0f) - block);
  const float l = 0.3f, h = 0.6f;  // hovers in the middle, normals outwards
  const Vec3 p[8] = {{l, l, l}, {h, l, l}, {h, h, l}, {l, h, l}, {l, l, h}, {h, l, h}, {h, h, h}, {l, h, h}};
  b.quad(p[3], p[2], p[1], p[0]).quad(p[4], p[5], p[6], p[7]).quad(p[0], p[1], p[5], p[4]);
  b.quad(p[1], p[2], p[6], p[5]).quad(p[2], p[3], p[7], p[6]).quad(p[3], p[0], p[4], p[7]);
  return b.scene();
}

double mean_irradiance(const PatchSet& patches, const std::vector<float>& irradiance,
                       const std::string& material) {
  double sum = 0.0;
  double area = 0.0;
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (patches.material_of(p).name == material) {
      area += patches.area[p];
      sum += static_cast<double>(patches.area[p]) * irradiance[p * patches.band_count()];
    }
  return sum / area;
}

}  // namespace luxel::truth
