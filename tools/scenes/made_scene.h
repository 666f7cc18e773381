// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scenes/shapes/mesh.h"

namespace luxel::scenes {

// A camera from which the scene looks good.
struct View {
  const char* name;
  Vec3d eye, target;    // m
  double vertical_fov;  // degrees
};

// A light without a surface. glTF has it (KHR_lights_punctual), OBJ does not.
struct PunctualLight {
  enum Kind { sun, point, spot };
  Kind kind;
  const char* name;
  Vec3d position;    // m; of no use to a sun
  Vec3d direction;   // the way its light goes; of no use to a point
  double intensity;  // a sun's illuminance on what faces it, lx; of the others luminous intensity, cd
  Vec3d colour;      // linear sRGB, at most 1
  double outer_degrees = 45.0;  // of a spot: angle between its axis and its boundary
};

// A scene as it is written. Lengths in metres, Y up, floor at y = 0.
struct MadeScene {
  std::string title = {};  // one sentence
  std::string sky = {};    // the value of --sky that suits it; empty: it has lamps and needs none
  std::vector<Object> objects = {};
  std::vector<View> views = {};  // the best one first
  std::vector<PunctualLight> lights = {};

  void add_closed(std::string name, Mesh mesh) {
    objects.push_back({std::move(name), std::move(mesh), true});
  }
  void add_open(std::string name, Mesh mesh) { objects.push_back({std::move(name), std::move(mesh), false}); }
};

}  // namespace luxel::scenes
