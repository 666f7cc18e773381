// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/surfaces.h"

#include <array>
#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include "luxel/image/local_scales.h"
#include "luxel/viewer/background_task.h"
#include "luxel/viewer/mesh_buffers.h"
#include "luxel/viewer/surface_shaders.h"

namespace luxel {
namespace {

struct Light {
  std::shared_ptr<const PatchSet> patches;
  std::shared_ptr<const SmoothLight> light;
  VertexValue what = VertexValue::radiance;
};

GlTexture colour_texture(ColourMap map) {
  GlTexture texture;
  std::array<Vec3, 256> colours;
  for (std::size_t i = 0; i < colours.size(); ++i)
    colours[i] = map_colour(map, static_cast<float>(i) / 255.0f);
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, 256, 1, 0, GL_RGB, GL_FLOAT, colours.data());
  for (const auto side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTexParameteri(GL_TEXTURE_2D, side, GL_CLAMP_TO_EDGE);
  for (const auto size : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, size, GL_LINEAR);
  return texture;
}

void prepare_depth() {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
}

GlProgram surface_program(std::string_view define) {
  return {surface_vertex_shader, std::string(tone_shader).append(surface_fragment_shader), define};
}

// As tone_shader has it.
int curve_number(ToneOperator op) {
  if (op == ToneOperator::neutral) return 2;
  return op == ToneOperator::reinhard || op == ToneOperator::reinhard_local ? 1 : 0;
}

}  // namespace

struct Surfaces::State {
  std::shared_ptr<const PatchSet> patches;
  // The cuts of the patches, found in a thread of their own before the patches are drawn.
  struct Cuts {
    std::shared_ptr<const PatchSet> patches;  // that they are of
    std::vector<PatchCut> cuts;
  };
  std::optional<Cuts> cuts;
  BackgroundTask<Cuts> finding;
  std::optional<MeshBuffers> preview;  // until there is a mesh for values

  // The mesh for values, the light it was made from, and its values: drawn, being uploaded or waiting.
  std::shared_ptr<const SmoothLight> topology;
  std::optional<MeshBuffers> mesh;
  std::unique_ptr<ValueBuffer> values, coming_values;
  Light shown, coming, waiting;

  std::shared_ptr<const std::vector<float>> side_values, coming_side_values;
  std::unique_ptr<SideTexture> side_texture, coming_side_texture;

  GlTexture heat = colour_texture(ColourMap::heat), difference = colour_texture(ColourMap::difference);
  GlProgram grey = surface_program(""), light = surface_program("#define LIGHT"),
            light_locally = surface_program("#define LIGHT\n#define LOCAL"),
            curve_input = surface_program("#define LIGHT\n#define INPUT"),
            smooth = surface_program("#define SMOOTH"), of_patches = surface_program("#define PATCHES"),
            sides = surface_program("#define SIDES"), wires = surface_program("#define WIRES");

  bool has_cuts(double seconds);
  bool step();
  bool light_step();
  bool shows_radiance() const { return values && shown.what == VertexValue::radiance; }
  const GlProgram& program(const SurfaceView& view) const;
  const MeshBuffers* drawn() const { return values ? &*mesh : preview ? &*preview : nullptr; }
};

Surfaces::Surfaces() : state_(std::make_unique<State>()) {}
Surfaces::~Surfaces() = default;

void Surfaces::set_mesh(std::shared_ptr<const PatchSet> patches) {
  auto& s = *state_;
  s.values.reset(), s.coming_values.reset(), s.mesh.reset();
  s.side_texture.reset(), s.coming_side_texture.reset();
  s.side_values.reset(), s.coming_side_values.reset(), s.topology.reset();
  s.shown = s.coming = s.waiting = {};
  s.preview.reset();
  s.cuts.reset();
  s.patches = std::move(patches);
}

void Surfaces::set_light(std::shared_ptr<const PatchSet> lit, std::shared_ptr<const SmoothLight> light,
                         VertexValue what) {
  state_->waiting = {std::move(lit), std::move(light), what};
}

void Surfaces::set_side_values(std::shared_ptr<const std::vector<float>> values) {
  auto& s = *state_;
  s.coming_side_texture.reset();
  s.coming_side_values = std::move(values);
}

// Waits up to this many seconds for the cuts of the patches.
bool Surfaces::State::has_cuts(double seconds) {
  if (cuts) return true;
  if (!finding.is_busy()) finding.start([of = patches] { return Cuts{of, cut_at_hanging_vertices(*of)}; });
  finding.wait(seconds);
  auto found = finding.take();
  if (!found || found->patches != patches) return false;
  cuts = std::move(found);
  preview.emplace(*patches, cuts->cuts);
  return true;
}

bool Surfaces::State::light_step() {
  if (!coming.light) {
    if (!waiting.light) return false;
    coming = std::exchange(waiting, {});
    if (!mesh) {
      topology = coming.light;
      mesh.emplace(*patches, cuts->cuts, *topology);
    }
  }
  if (mesh->go_on()) return true;
  if (!coming_values)
    coming_values =
        std::make_unique<ValueBuffer>(*coming.patches, *coming.light, coming.what, mesh->vertices());
  if (coming_values->go_on()) return true;
  mesh->take_values(coming_values->buffer());
  values = std::move(coming_values);
  preview.reset();
  shown = std::exchange(coming, {});
  return true;
}

bool Surfaces::State::step() {
  if (preview && preview->go_on()) return true;
  if (light_step()) return true;
  if (!coming_side_values) return false;
  if (!coming_side_texture)
    coming_side_texture = std::make_unique<SideTexture>(*patches, cuts->cuts, *coming_side_values);
  if (coming_side_texture->go_on()) return true;
  side_texture = std::move(coming_side_texture);
  side_values = std::exchange(coming_side_values, nullptr);
  return true;
}

bool Surfaces::upload(double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  if (!state_->patches) return true;
  if (!state_->has_cuts(seconds)) return false;
  while (std::chrono::duration<double>(Clock::now() - begin).count() < seconds)
    if (!state_->step()) return true;
  return false;
}

bool Surfaces::has_light() const { return state_->values != nullptr; }
bool Surfaces::has_side_values() const { return state_->side_texture != nullptr; }
bool Surfaces::shows_radiance() const { return state_->shows_radiance(); }

const GlProgram& Surfaces::State::program(const SurfaceView& view) const {
  switch (view.paint) {
    case Paint::light:
      if (shows_radiance()) return view.local != nullptr ? light_locally : light;
      break;
    case Paint::curve_input:
      if (shows_radiance()) return curve_input;
      break;
    case Paint::smooth:
      if (values && shown.what != VertexValue::radiance) return smooth;
      break;
    case Paint::patches:
      if (side_texture) return of_patches;
      break;
    case Paint::sides:
      return sides;
    case Paint::grey:
      break;
  }
  return grey;
}

void Surfaces::try_programs() const {
  constexpr std::array<Vec3, 6> places{};
  constexpr std::array<GLuint, 3> corners{};
  const GlVertexArray array;
  const GlBuffer place_buffer, corner_buffer;
  glBindVertexArray(array.name());
  glBindBuffer(GL_ARRAY_BUFFER, place_buffer.name());
  glBufferData(GL_ARRAY_BUFFER, sizeof places, places.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, corner_buffer.name());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof corners, corners.data(), GL_STATIC_DRAW);
  const auto draw_by = [&](const GlProgram& program, GLuint attributes) {
    for (GLuint i = 0; i < attributes; ++i) {
      glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, (i == 0 ? 1 : 2) * sizeof(Vec3), nullptr);
      glEnableVertexAttribArray(i);
    }
    program.use();
    glDrawElements(GL_TRIANGLES, corners.size(), GL_UNSIGNED_INT, nullptr);
  };
  prepare_depth();
  draw_by(state_->grey, 1);
  draw_by(state_->light, 3);
}

void set_tone(const GlProgram& program, const SurfaceView& view) {
  program.set("tone_scale", view.tone.scale);
  program.set("white", view.tone.options.white);
  program.set("curve", curve_number(view.tone.options.op));
  program.set("brightest", LocalScales::brightest);
  program.set("around", 2);
  program.set("from", view.from.left, view.from.bottom);
  if (view.local != nullptr) view.local->use(2);
}

void Surfaces::draw(const SurfaceView& view) {
  auto& s = *state_;
  const auto* mesh = s.drawn();
  if (mesh == nullptr) return;
  prepare_depth();
  const auto& program = s.program(view);
  program.use();
  program.set("projection", view.projection);
  program.set("eye", view.eye);
  set_tone(program, view);
  program.set("low", view.scale.low);
  program.set("high", view.scale.high);
  program.set("logarithmic", view.scale.logarithmic ? 1 : 0);
  program.set("isolines", view.scale.isolines);
  program.set("colours", 0);
  program.set("values", 1);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, s.side_texture ? s.side_texture->texture().name() : 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, (view.scale.map == ColourMap::heat ? s.heat : s.difference).name());
  mesh->draw();
  if (!view.wires) return;
  s.wires.use();
  s.wires.set("projection", view.projection);
  s.wires.set("ink", view.paint == Paint::light ? Vec3(0.9f, 0.45f, 0.02f) : Vec3(0.01f));
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  mesh->draw_patches();
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

}  // namespace luxel
