// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/sky_backdrop.h"

#include <string>
#include <string_view>

#include "luxel/render/sky_look.h"
#include "luxel/viewer/surface_shaders.h"

namespace luxel {
namespace {

constexpr std::string_view vertex_shader = R"(
uniform mat4 from_screen;
uniform vec3 eye;
out vec3 ray;
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  vec4 far = from_screen * vec4(corner, 1.0, 1.0);
  ray = far.xyz / far.w - eye;
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";

// As sky_look() has it.
constexpr std::string_view fragment_shader = R"(
in vec3 ray;
out vec4 pixel;
uniform vec3 sky, zenith, at_zenith;
uniform float below, haze;
void main() {
  float height = dot(normalize(ray), zenith);
  vec3 look = height < 0.0 ? vec3(mix(1.0, below, min(1.0, -height / haze)))
                           : mix(at_zenith, vec3(1.0), pow(1.0 - min(1.0, height), 5.0));
  pixel = toned(look * sky);
}
)";

GlProgram program(std::string_view define) {
  return {vertex_shader, std::string(tone_shader).append(fragment_shader), define};
}

}  // namespace

SkyBackdrop::SkyBackdrop()
    : plain_(program("")), local_(program("#define LOCAL")), curve_input_(program("#define INPUT")) {}

void SkyBackdrop::draw(const SurfaceView& view, const Vec3& radiance, double ground,
                       const Vec3& zenith) const {
  const auto& chosen = view.paint == Paint::curve_input ? curve_input_
                       : view.local != nullptr          ? local_
                                                        : plain_;
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  chosen.use();
  set_tone(chosen, view);
  chosen.set("from_screen", glm::inverse(view.projection));
  chosen.set("eye", view.eye);
  chosen.set("sky", radiance);
  chosen.set("zenith", zenith);
  chosen.set("at_zenith", Vec3(SkyLook::zenith[0], SkyLook::zenith[1], SkyLook::zenith[2]));
  chosen.set("below", static_cast<float>(ground));
  chosen.set("haze", static_cast<float>(SkyLook::haze));
  covers_.draw();
}

}  // namespace luxel
