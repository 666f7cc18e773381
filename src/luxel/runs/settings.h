// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "luxel/image/tone.h"
#include "luxel/import/load_scene.h"
#include "luxel/patch/make_patches.h"
#include "luxel/render/render.h"
#include "luxel/runs/daylight_settings.h"
#include "luxel/runs/option_set.h"
#include "luxel/scene/camera.h"
#include "luxel/solve/refine_to_light.h"
#include "luxel/solve/solve_light.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {

// The options of the commands, by theme. Each struct fills the library's own options; declare() adds its
// flags to a command. There is no second list of defaults.

struct SceneSettings {
  std::string file;
  LoadOptions load;  // except its sky
  DaylightSettings daylight;
  PatchOptions patches;
  // Declares options of the input and of its reading; the second also those of the mesh.
  void declare_scene(OptionSet& set, const char* what_it_takes = "the mesh (OBJ with MTL, glTF)");
  void declare(OptionSet& set, const char* what_it_takes = "the mesh (OBJ with MTL, glTF)");
  // Declare options of the commands that solve; the first right after declare(), the others where the options
  // of light begin.
  void declare_contacts(OptionSet& set);
  void declare_sky(OptionSet& set);
  void declare_luminaires(OptionSet& set);
  void declare_spectra(OptionSet& set);
  // Throws UsageError where options contradict each other.
  void check() const;
  LoadOptions load_options() const;
};

// For commands that refine patches by the light.
struct RefineSettings {
  static constexpr double automatic = -1.0;
  double mesh_error = automatic;  // a fraction; 0: the patches stay as they are
  std::size_t max_patches = RefineOptions().max_patches;

  // Returns whether patches are refined. can_refine: whether the method refines by default.
  bool is_on(bool can_refine) const { return mesh_error == automatic ? can_refine : mesh_error > 0.0; }
  // Returns the options of the refinement of this number of initial patches.
  RefineOptions options(std::size_t patches) const;
  void declare(OptionSet& set);
};

struct LightSettings : LightOptions {
  bool joins_faces = false;   // dense
  std::string focus = "all";  // where the seen error matters, see patch/focus.h
  std::string each_step;      // folder for a picture after every step; empty: none
  bool force = false;         // allows solves that take days
  // Throws UsageError where nothing would end the run, or options contradict each other.
  void check() const;
  void declare(OptionSet& set);
  // Separate from the others, since they do not change the light: they are listed under the heading Run.
  void declare_run(OptionSet& set);
  // Bounds and memory of a sampled run, which may change when it is resumed.
  void declare_bounds(OptionSet& set);
  void declare_memory(OptionSet& set);

 private:
  void declare_method(OptionSet& set);
  void declare_rays(OptionSet& set);
  void declare_error_and_time(OptionSet& set);
  void declare_ray_budget(OptionSet& set);
  void declare_classical(OptionSet& set);
  void declare_tolerance(OptionSet& set);
  void declare_sampled(OptionSet& set);
  void declare_variance_reduction(OptionSet& set);
  void declare_shooting(OptionSet& set);
};

struct PictureSettings {
  static constexpr float automatic_fov = 0.0f;
  std::optional<Vec3d> eye, target;    // m, in the file's coordinates
  float vertical_fov = automatic_fov;  // degrees
  RenderOptions render;
  int gather = 0;  // rays per pixel of a final gather; 0: none
  std::string quantity = "radiance";
  double max_value = 0.0;  // lx or cd/m²: end of the scale of false colours; 0: automatic
  bool is_given() const { return eye && target; }
  // Throws UsageError where the camera is invalid: call it before a long solve.
  void check() const;
  // Camera and size; then how a solution is drawn.
  void declare_view(OptionSet& set);
  void declare_camera(OptionSet& set);
  void declare(OptionSet& set);
  void declare_gather(OptionSet& set);
  void declare_quantity(OptionSet& set);
};

struct LookSettings {
  std::string up = "auto";
  SmoothOptions smooth{.lights_hidden = true};
  ToneOptions tone;
  std::string title;  // of a page; empty: the file's name
  void declare_up(OptionSet& set);
  void declare_title(OptionSet& set);
  void declare(OptionSet& set);
};

// File types to which a solution can be written.
inline constexpr const char* picture_kinds = ".png .exr .hdr";
inline constexpr const char* mesh_kinds = ".glb .ply .html .vtkhdf";
inline constexpr const char* all_kinds = ".glb .ply .html .png .exr .hdr .vtkhdf";

// Settings of the execution and outputs of a command. They do not change the light, so a solution
// does not record them.
struct RunSettings {
  static constexpr const char* heading = "Run";
  std::vector<std::string> outputs;
  int threads = 0;
  bool json = false;
  bool quiet = false;
  bool verbose = false;  // also reports the stages
  std::string progress = "auto";
  bool opens = false;  // a written file, on the desktop
  std::string report;
  // kinds: the endings -o takes, for the help.
  void declare(OptionSet& set, const std::string& kinds);
};

}  // namespace luxel
