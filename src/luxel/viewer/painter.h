// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "luxel/session/session_snapshot.h"
#include "luxel/viewer/background_task.h"
#include "luxel/viewer/frame.h"
#include "luxel/viewer/lines.h"
#include "luxel/viewer/local_tone.h"
#include "luxel/viewer/look.h"
#include "luxel/viewer/luminaire_bodies.h"
#include "luxel/viewer/sky_backdrop.h"
#include "luxel/viewer/surfaces.h"

namespace luxel {

// Eye, scene and tone curve of a picture.
struct Viewpoint {
  Pose pose;
  Space space;
  Bounds box;
  ToneCurve tone;
  float aspect = 1.0f;  // of the picture
  float empty = 0.0f;   // see projection(), m
};

// Target of drawing.
struct Canvas {
  DrawnFrame frame;
  std::unique_ptr<LocalTone> local;  // made on first use
};

// A part of a picture, and its resolution.
struct DrawnPart {
  PicturePart part;
  EdgeSmoothing edges;
  float point_size;  // pixels
  Tile all = {};     // the whole picture that the part is of, see shifted_tile()
};

// Uploads the scene to the graphics card in the chosen display, and draws it.
class Painter {
 public:
  // scene: its number, which differs between scenes. difference: from a second solution, or null.
  void update(std::uint64_t scene, const std::shared_ptr<const SessionMesh>& mesh,
              const std::shared_ptr<const SessionLight>& light, const Look& look,
              const std::shared_ptr<const LightDifference>& difference);
  // Uploads for about this many seconds. Returns true where everything is uploaded and shown.
  bool upload(double seconds);

  // Draws into the canvas, which is then resolved.
  void draw(Canvas& canvas, const Look& look, const Viewpoint& from, const DrawnPart& drawn);

  // Compiles programs in advance, see Surfaces.
  void try_programs() const { surfaces_.try_programs(); }
  void set_marks(const Marks& marks) { marks_.set(marks); }
  // The scale of the current false colours; nothing where there are none.
  std::optional<ValueScale> scale() const { return scale_; }

 private:
  void update_light(const Look& look);
  void update_side_values(const Look& look, const std::shared_ptr<const LightDifference>& difference);
  void update_scale(const Look& look);
  Paint paint(const Look& look) const;
  void draw_sky(const SurfaceView& view, const Space& space) const;
  void draw_luminaires(SurfaceView view);
  void look_around(Canvas& canvas, const Viewpoint& from, const PicturePart& part, EdgeSmoothing edges,
                   const Tile& all);

  Surfaces surfaces_;
  SkyBackdrop sky_;
  LuminaireBodies luminaires_;
  MarkBuffer marks_;
  std::shared_ptr<const SessionMesh> mesh_;
  std::shared_ptr<const SessionLight> light_;
  std::uint64_t scene_ = 0, geometry_ = 0;

  std::uint64_t light_number_ = 0;
  std::optional<VertexValue> vertex_value_;
  // The last request for side values.
  struct Sides {
    Show show = Show::light;
    bool lux = false;
    std::uint64_t light = 0;
    const void* difference = nullptr;
    bool operator==(const Sides&) const = default;
  } sides_;
  struct FoundValues {
    const void* patches;  // that they are of
    std::shared_ptr<const std::vector<float>> values;
  };
  BackgroundTask<FoundValues> values_;
  std::shared_ptr<const std::vector<float>> side_values_;
  // Inputs of the current scale.
  struct Scaled {
    Show show = Show::light;
    bool lux = false, logarithmic = false, automatic = false;
    float low = 0.0f, high = 0.0f;
    int isolines = 0;
    const void* values = nullptr;
    bool operator==(const Scaled&) const = default;
  } scaled_;
  std::optional<ValueScale> scale_;
};

}  // namespace luxel
