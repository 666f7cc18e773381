// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/import/load_scene.h"
#include "luxel/photometry/photometry.h"
#include "luxel/scene/scene.h"

namespace luxel {

// A luminaire, or an array of equal ones, as a list or a material places it.
struct LuminairePlacement {
  std::shared_ptr<const Photometry> photometry;
  std::string group;                  // name of its light group
  Vec3d position = Vec3d(0.0);        // m, of the photometric centre, in the coordinates of the scene's file
  std::optional<Vec3d> direction;     // where it aims, of any length above 0; nothing: straight down
  double rotation = 0.0;              // degrees about the aim, anticlockwise seen from behind the luminaire
  double dimming = 1.0;               // part of its flux, 0 or more
  double maintenance = 1.0;           // (0, 1]
  Vec3d colour = Vec3d(1.0);          // linear sRGB; only its ratios count
  std::size_t columns = 1, rows = 1;  // of an array
  Vec3d column_step = Vec3d(0.0), row_step = Vec3d(0.0);  // m
};

// Photometric files, each read once. Relays their warnings.
class PhotometryStore {
 public:
  explicit PhotometryStore(const Context& context) : context_(context) {}
  std::shared_ptr<const Photometry> load(const std::filesystem::path& path, const PhotometryOptions& options);
  // Reads bytes in memory; name: for errors and for the user.
  std::shared_ptr<const Photometry> parse(const std::string& bytes, const std::string& name,
                                          const PhotometryOptions& options);

 private:
  std::shared_ptr<const Photometry> checked(Photometry photometry) const;

  const Context& context_;
  struct Entry {
    std::filesystem::path path;
    PhotometryOptions options;
    std::shared_ptr<const Photometry> photometry;
  };
  std::vector<Entry> read_;
};

// Reads a list of luminaires, a CSV file with the columns file, x, y, z and, where needed, aim_x, aim_y,
// aim_z (a point) or dir_x, dir_y, dir_z (a direction), rotation, dimming, maintenance, group, red, green,
// blue, lamp_set, turn (degrees, PhotometryOptions::rotate), columns, rows, step_x, step_y (m). Files are
// relative to the list's folder. Throws InputError with file and line.
std::vector<LuminairePlacement> read_luminaires(const std::filesystem::path& path, const Vec3& up,
                                                PhotometryStore& store);

// An array over the whole scene: half a step from the edges of its box.
LuminairePlacement place_over(const LuminaireGrid& grid, const Scene& scene, const Vec3& up,
                              PhotometryStore& store);

// Adds a placement's luminaires to the scene. up: unit, (0, 1, 0) or (0, 0, 1).
void add_luminaires(const LuminairePlacement& placement, const Vec3& up, Scene& scene);

// Materials that have the name of a photometric file beside the scene's (such as panel.ies): each connected
// component of their triangles is replaced by a luminaire at its centre that faces as the component does.
// The triangles stay, and light passes through them.
void replace_by_luminaires(const std::filesystem::path& scene_file, const Vec3& up, PhotometryStore& store,
                           Scene& scene);

}  // namespace luxel
