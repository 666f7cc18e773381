// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/painter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "luxel/render/sky_look.h"
#include "luxel/viewer/side_values.h"

namespace luxel {
namespace {

bool is_of_sides(Show show) {
  return show == Show::standard_error || show == Show::patch_size || show == Show::level ||
         show == Show::difference || show == Show::unshot;
}

// Values shown at a sample of the vertices: the brighter of both sides.
std::vector<float> vertex_values(const SessionLight& light, bool lux) {
  const auto& patches = *light.mesh.patches;
  const auto colours = patches.colours();
  std::vector<float> values;
  for (std::size_t v = 0; v < light.smooth->size(); v += light.smooth->size() / 20'000 + 1) {
    const auto both = value_of({static_cast<std::uint32_t>(v), 0}, {},
                               lux ? VertexValue::lux : VertexValue::watts, patches, colours, *light.smooth);
    values.push_back(std::max(both.front.x, both.back.x));
  }
  return values;
}

// The scale chosen by the user, made valid.
ValueScale chosen_scale(const Look& look, bool logarithmic, ColourMap map) {
  ValueScale scale{.low = look.low, .high = look.high, .logarithmic = logarithmic, .map = map};
  if (logarithmic && !(scale.low > 0.0f)) scale.low = 1e-3f * std::abs(scale.high);
  if (!(scale.high > scale.low)) scale.high = scale.low + 1.0f;
  return scale;
}

}  // namespace

void Painter::update(std::uint64_t scene, const std::shared_ptr<const SessionMesh>& mesh,
                     const std::shared_ptr<const SessionLight>& light, const Look& look,
                     const std::shared_ptr<const LightDifference>& difference) {
  mesh_ = mesh;
  light_ = light;
  if (!mesh_) return;
  if (scene != scene_ || mesh_->geometry != geometry_) {
    scene_ = scene;
    geometry_ = mesh_->geometry;
    light_number_ = 0;
    vertex_value_.reset();
    sides_ = {};
    side_values_.reset();
    scale_.reset();
    surfaces_.set_mesh(mesh_->patches);
  }
  update_light(look);
  update_side_values(look, difference);
  update_scale(look);
  const bool is_of_light = light_ && light_->mesh.geometry == geometry_;
  luminaires_.set(is_of_light ? light_->mesh.patches : mesh_->patches);
}

void Painter::update_light(const Look& look) {
  if (!light_ || light_->mesh.geometry != geometry_ || !light_->smooth) return;
  auto what = vertex_value_.value_or(VertexValue::radiance);
  if (look.show == Show::light) what = VertexValue::radiance;
  if (look.show == Show::irradiance) what = look.lux ? VertexValue::lux : VertexValue::watts;
  if (light_->number == light_number_ && what == vertex_value_) return;
  surfaces_.set_light(light_->mesh.patches, light_->smooth, what);
  light_number_ = light_->number;
  vertex_value_ = what;
}

void Painter::update_side_values(const Look& look, const std::shared_ptr<const LightDifference>& difference) {
  if (auto done = values_.take(); done && done->patches == mesh_->patches.get()) {
    side_values_ = std::move(done->values);
    if (side_values_->empty()) side_values_.reset();
    surfaces_.set_side_values(side_values_);
    scale_.reset();
  }
  if (!is_of_sides(look.show) || values_.is_busy()) return;
  const Sides wanted{look.show, look.lux, is_of_light(look.show) && light_ ? light_->number : 0,
                     look.show == Show::difference ? difference.get() : nullptr};
  if (wanted == sides_) return;
  sides_ = wanted;
  values_.start([show = look.show, lux = look.lux, mesh = mesh_, light = light_, difference] {
    return FoundValues{mesh->patches.get(), std::make_shared<const std::vector<float>>(side_values(
                                                show, lux, *mesh->patches, light.get(), difference.get()))};
  });
}

void Painter::update_scale(const Look& look) {
  const bool is_sides = is_of_sides(look.show);
  if (!is_sides && look.show != Show::irradiance) {
    scale_.reset();
    return;
  }
  const void* const values = is_sides ? static_cast<const void*>(side_values_.get()) : light_.get();
  const Scaled wanted{look.show, look.lux,  look.logarithmic, look.automatic_scale,
                      look.low,  look.high, look.isolines,    look.automatic_scale ? values : nullptr};
  if (wanted == scaled_ && scale_) return;
  scaled_ = wanted;
  const auto map = look.show == Show::difference ? ColourMap::difference : ColourMap::heat;
  const bool logarithmic = look.logarithmic && map == ColourMap::heat && look.show != Show::level;
  if (!look.automatic_scale) {
    scale_ = chosen_scale(look, logarithmic, map);
  } else if (is_sides) {
    scale_ = side_values_ ? automatic_value_scale(*side_values_, logarithmic, map) : ValueScale{.map = map};
  } else {
    scale_ =
        light_ ? automatic_value_scale(vertex_values(*light_, look.lux), logarithmic, map) : ValueScale();
  }
  scale_->isolines = look.isolines;
}

bool Painter::upload(double seconds) { return surfaces_.upload(seconds) && !values_.is_busy(); }

Paint Painter::paint(const Look& look) const {
  if (is_of_sides(look.show)) return side_values_ ? Paint::patches : Paint::grey;
  switch (look.show) {
    case Show::light:
      return Paint::light;
    case Show::irradiance:
      return Paint::smooth;
    case Show::sides:
      return Paint::sides;
    default:
      return Paint::grey;
  }
}

// Measures the luminance of each pixel and its surroundings, which the local operator needs before drawing.
void Painter::look_around(Canvas& canvas, const Viewpoint& from, const PicturePart& part, EdgeSmoothing edges,
                          const Tile& all) {
  if (!canvas.local) canvas.local = std::make_unique<LocalTone>();
  canvas.local->begin(drawn_size(part.size, edges));
  const SurfaceView view{
      .projection = projection(from.pose, from.space, from.box, from.aspect, tile_of(part, all), from.empty),
      .eye = from.pose.eye,
      .paint = Paint::curve_input,
      .tone = from.tone};
  draw_sky(view, from.space);
  surfaces_.draw(view);
  draw_luminaires(view);
  canvas.local->finish(from.tone, static_cast<float>(pixel_step(edges)));
}

void Painter::draw(Canvas& canvas, const Look& look, const Viewpoint& from, const DrawnPart& drawn) {
  const auto& part = drawn.part;
  const auto edges = drawn.edges;
  const auto painted = paint(look);
  const bool is_local = from.tone.options.op == ToneOperator::reinhard_local && painted == Paint::light &&
                        surfaces_.shows_radiance();
  const auto around = with_margin(part, LocalTone::reach);
  const PixelOffset offset{part.begin.left - around.begin.left, part.begin.bottom - around.begin.bottom};
  if (is_local) look_around(canvas, from, around, edges, drawn.all);
  canvas.frame.begin(part.size, Vec3(0.012f), edges);
  const auto to_screen =
      projection(from.pose, from.space, from.box, from.aspect, tile_of(part, drawn.all), from.empty);
  const SurfaceView view{.projection = to_screen,
                         .eye = from.pose.eye,
                         .paint = painted,
                         .tone = from.tone,
                         .local = is_local ? canvas.local.get() : nullptr,
                         .from = offset,
                         .scale = scale_.value_or(ValueScale()),
                         .wires = look.wires};
  draw_sky(view, from.space);
  surfaces_.draw(view);
  draw_luminaires(view);
  marks_.draw(to_screen, drawn.point_size, true);
}

// Grey while surfaces have no light.
void Painter::draw_luminaires(SurfaceView view) {
  if (view.paint == Paint::light && !surfaces_.shows_radiance()) view.paint = Paint::grey;
  luminaires_.draw(view);
}

// Draws nothing while there is no light.
void Painter::draw_sky(const SurfaceView& view, const Space& space) const {
  if (!mesh_ || !mesh_->patches->has_sky() || !light_) return;
  const auto radiance = in_gamut(mesh_->patches->colours().rgb(mesh_->patches->mean_sky()));
  if (radiance != Vec3(0.0f)) sky_.draw(view, radiance, ground_look(*mesh_->patches), space.up);
}

}  // namespace luxel
