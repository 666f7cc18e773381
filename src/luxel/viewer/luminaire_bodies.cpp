// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/luminaire_bodies.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "luxel/photometry/luminaire_mesh.h"
#include "luxel/photometry/opening.h"
#include "luxel/scene/band_colours.h"
#include "luxel/trace/point_sight.h"
#include "luxel/viewer/gl_object.h"
#include "luxel/viewer/surface_shaders.h"

namespace luxel {
namespace {

constexpr int face_steps = 4;  // of a flat face, for its radiance from near by
// Distance in radii beyond which a body is seen in nearly one direction and has one radiance.
constexpr double far = 20.0;

constexpr std::string_view vertex_shader = R"(
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 colour;
uniform mat4 projection;
uniform vec3 eye;
out vec3 radiance;
void main() {
  const float recess = 5e-3;       // m
  const float resolution = 1e-6;   // some steps of the depth buffer, which are longer than that far away
  vec3 way = eye - place;
  float distance = max(length(way), 1e-6);
  vec4 nearer = projection * vec4(place + way * min(0.5, recess / distance), 1.0);
  gl_Position = projection * vec4(place, 1.0);
  gl_Position.z = (nearer.z / nearer.w - resolution) * gl_Position.w;
  radiance = colour;
}
)";

// Without emission nothing is visible.
constexpr std::string_view fragment_shader = R"(
in vec3 radiance;
out vec4 pixel;
void main() {
  if (max(radiance.r, max(radiance.g, radiance.b)) <= 0.0) discard;
#ifdef GREY
  pixel = vec4(1.0, 0.93, 0.75, 1.0);
#else
  pixel = toned(radiance);
#endif
}
)";

GlProgram program(std::string_view define) {
  return {vertex_shader, std::string(tone_shader).append(fragment_shader), define};
}

struct Body {
  const PointLight* light = nullptr;
  LuminousOpening opening;           // as it is shown
  Vec3d colour{0.0};                 // W/sr where the distribution is largest
  std::size_t first = 0, count = 0;  // vertices
};

}  // namespace

struct LuminaireBodies::State {
  std::shared_ptr<const PatchSet> patches;
  std::vector<Body> bodies;
  std::vector<Vec3> places, colours;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::optional<Vec3> seen_from;  // what `colours` are for

  GlVertexArray array;
  GlBuffer place_buffer, colour_buffer, corner_buffer;
  GlProgram light = program(""), light_locally = program("#define LOCAL"),
            curve_input = program("#define INPUT"), grey = program("#define GREY");

  void add(const BandPointLight& lamp, const BandColours& of_bands);
  void send() const;
  void look_from(const Vec3& eye);
  Vec3 radiance(const Body& body, const Vec3d& way) const {
    return in_gamut(body.colour * relative_radiance(*body.light, body.opening, glm::normalize(way)));
  }
  const GlProgram& program_for(const SurfaceView& view) const {
    if (view.paint == Paint::curve_input) return curve_input;
    if (view.paint == Paint::grey) return grey;
    return view.local != nullptr ? light_locally : light;
  }
};

LuminaireBodies::LuminaireBodies() : state_(std::make_unique<State>()) {}
LuminaireBodies::~LuminaireBodies() = default;

void LuminaireBodies::State::add(const BandPointLight& lamp, const BandColours& of_bands) {
  Body body{&lamp.light, shown_opening(lamp.light.photometry->opening), of_bands.rgb(lamp.intensity),
            places.size()};
  const auto mesh = opening_mesh(body.opening, face_steps);
  for (const auto& at : mesh.positions) places.push_back(Vec3(from_local_axes(lamp.light, Vec3d(at))));
  const auto first = static_cast<std::uint32_t>(body.first);
  for (const auto& t : mesh.triangles) triangles.push_back({first + t[0], first + t[1], first + t[2]});
  body.count = mesh.positions.size();
  bodies.push_back(body);
}

void LuminaireBodies::State::send() const {
  const auto put = [](GLenum target, const GlBuffer& buffer, const auto& values, GLenum use) {
    glBindBuffer(target, buffer.name());
    glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof values[0]), values.data(), use);
  };
  const auto attribute = [](GLuint number) {
    glVertexAttribPointer(number, 3, GL_FLOAT, GL_FALSE, sizeof(Vec3), nullptr);
    glEnableVertexAttribArray(number);
  };
  glBindVertexArray(array.name());
  put(GL_ARRAY_BUFFER, place_buffer, places, GL_STATIC_DRAW);
  attribute(0);
  put(GL_ARRAY_BUFFER, colour_buffer, colours, GL_DYNAMIC_DRAW);
  attribute(1);
  put(GL_ELEMENT_ARRAY_BUFFER, corner_buffer, triangles, GL_STATIC_DRAW);
}

void LuminaireBodies::set(const std::shared_ptr<const PatchSet>& patches) {
  auto& s = *state_;
  if (patches == s.patches) return;
  s.patches = patches;
  s.bodies.clear(), s.places.clear(), s.triangles.clear();
  s.seen_from.reset();
  if (!patches) return;
  const auto colours = patches->colours();
  for (const auto& lamp : patches->point_lights)
    if (lamp.light.kind == PointLightKind::luminaire) s.add(lamp, colours);
  s.colours.assign(s.places.size(), Vec3(0.0f));
  if (!s.places.empty()) s.send();
}

// The radiance of each vertex towards the eye.
void LuminaireBodies::State::look_from(const Vec3& eye) {
  if (seen_from == eye) return;
  seen_from = eye;
  for (const auto& body : bodies) {
    const auto to_eye = Vec3d(eye) - Vec3d(body.light->position);
    const bool is_far = glm::length(to_eye) > far * bounding_radius(body.opening);
    const auto whole = is_far ? radiance(body, to_eye) : Vec3(0.0f);
    for (auto v = body.first; v < body.first + body.count; ++v)
      colours[v] = is_far ? whole : radiance(body, Vec3d(eye - places[v]));
  }
  glBindBuffer(GL_ARRAY_BUFFER, colour_buffer.name());
  glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(colours.size() * sizeof(Vec3)), colours.data());
}

void LuminaireBodies::draw(const SurfaceView& view) {
  auto& s = *state_;
  if (s.bodies.empty()) return;
  if (view.paint != Paint::light && view.paint != Paint::curve_input && view.paint != Paint::grey) return;
  s.look_from(view.eye);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  const auto& chosen = s.program_for(view);
  chosen.use();
  set_tone(chosen, view);
  chosen.set("projection", view.projection);
  chosen.set("eye", view.eye);
  glBindVertexArray(s.array.name());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * s.triangles.size()), GL_UNSIGNED_INT, nullptr);
}

}  // namespace luxel
