// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/frame.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "luxel/viewer/framebuffer.h"
#include "luxel/viewer/full_screen_triangle.h"

namespace luxel {
namespace {

constexpr std::string_view copy_shader = R"(
uniform sampler2D source;
uniform float strength;
out vec4 pixel;
void main() { pixel = vec4(texelFetch(source, ivec2(gl_FragCoord.xy), 0).rgb, strength); }
)";

}  // namespace

struct DrawnFrame::State {
  // Four samples per pixel; created on first use.
  struct Sampled {
    ScreenSize size{0, 0};
    GlRenderbuffer colour, depth;
    GlFramebuffer frame;
  } sampled;
  // A quarter or a ninth of the pixels; created on first use.
  struct Coarse {
    ScreenSize size{0, 0};
    GlRenderbuffer colour, depth;
    GlFramebuffer frame;
  } coarse;
  // One sample per pixel; the mean of several pictures.
  ScreenSize size{0, 0}, mean_size{0, 0};
  GlTexture pixels, mean;
  GlRenderbuffer depth;
  GlFramebuffer resolved, mean_frame;
  FullScreenTriangle covers;
  GlProgram copy{FullScreenTriangle::vertex_shader, copy_shader};
  EdgeSmoothing edges = EdgeSmoothing::sampled;

  void resize(ScreenSize to);
  void resize_sampled(ScreenSize to);
  void resize_coarse(ScreenSize to);
  void resize_mean(ScreenSize to);
  const GlFramebuffer& drawn_into() const;
  void cover(const GlTexture& with, float strength) const;
};

void DrawnFrame::State::resize(ScreenSize to) {
  texture_storage(pixels, GL_SRGB8_ALPHA8, to);
  glBindFramebuffer(GL_FRAMEBUFFER, resolved.name());
  attach(GL_COLOR_ATTACHMENT0, pixels);
  attach_rendered(nullptr, depth, 0, to);
  check_complete(to);
  size = to;
}

void DrawnFrame::State::resize_sampled(ScreenSize to) {
  GLint most = 1;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  glBindFramebuffer(GL_FRAMEBUFFER, sampled.frame.name());
  attach_rendered(&sampled.colour, sampled.depth, std::min(4, static_cast<int>(most)), to);
  check_complete(to);
  sampled.size = to;
}

void DrawnFrame::State::resize_coarse(ScreenSize to) {
  glBindFramebuffer(GL_FRAMEBUFFER, coarse.frame.name());
  attach_rendered(&coarse.colour, coarse.depth, 0, to);
  check_complete(to);
  coarse.size = to;
}

const GlFramebuffer& DrawnFrame::State::drawn_into() const {
  if (pixel_step(edges) > 1) return coarse.frame;
  return edges == EdgeSmoothing::sampled ? sampled.frame : resolved;
}

void DrawnFrame::State::resize_mean(ScreenSize to) {
  texture_storage(mean, GL_RGBA16F, to);
  glBindFramebuffer(GL_FRAMEBUFFER, mean_frame.name());
  attach(GL_COLOR_ATTACHMENT0, mean);
  check_complete(to);
  mean_size = to;
}

void DrawnFrame::State::cover(const GlTexture& with, float strength) const {
  copy.use();
  copy.set("source", 0);
  copy.set("strength", strength);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, with.name());
  covers.draw();
}

DrawnFrame::DrawnFrame() : state_(std::make_unique<State>()) {}
DrawnFrame::~DrawnFrame() = default;

void DrawnFrame::begin(ScreenSize size, const Vec3& background, EdgeSmoothing edges) {
  auto& s = *state_;
  if (size != s.size) s.resize(size);
  if (edges == EdgeSmoothing::sampled && size != s.sampled.size) s.resize_sampled(size);
  const auto drawn = drawn_size(size, edges);
  if (pixel_step(edges) > 1 && drawn != s.coarse.size) s.resize_coarse(drawn);
  s.edges = edges;
  glBindFramebuffer(GL_FRAMEBUFFER, s.drawn_into().name());
  glViewport(0, 0, drawn.width, drawn.height);
  glEnable(GL_FRAMEBUFFER_SRGB);
  glEnable(GL_MULTISAMPLE);
  glDisable(GL_SCISSOR_TEST);
  glDepthMask(GL_TRUE);
  glClearColor(background.r, background.g, background.b, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void DrawnFrame::resolve() {
  const auto& s = *state_;
  if (s.edges != EdgeSmoothing::rough) {
    const bool is_coarse = pixel_step(s.edges) > 1;
    const auto from = is_coarse ? s.coarse.size : s.size;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, s.drawn_into().name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, s.resolved.name());
    glBlitFramebuffer(0, 0, from.width, from.height, 0, 0, s.size.width, s.size.height, GL_COLOR_BUFFER_BIT,
                      is_coarse ? GL_LINEAR : GL_NEAREST);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, s.resolved.name());
  glViewport(0, 0, s.size.width, s.size.height);
  glDisable(GL_FRAMEBUFFER_SRGB);
  glDisable(GL_DEPTH_TEST);
}

void DrawnFrame::join(int count) {
  auto& s = *state_;
  if (s.mean_size != s.size) s.resize_mean(s.size);
  glBindFramebuffer(GL_FRAMEBUFFER, s.mean_frame.name());
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  s.cover(s.pixels, 1.0f / static_cast<float>(count + 1));
  glDisable(GL_BLEND);
  glBindFramebuffer(GL_FRAMEBUFFER, s.resolved.name());
}

void DrawnFrame::show_joined() {
  auto& s = *state_;
  glBindFramebuffer(GL_FRAMEBUFFER, s.resolved.name());
  glViewport(0, 0, s.size.width, s.size.height);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
  glEnable(GL_FRAMEBUFFER_SRGB);
  s.cover(s.mean, 1.0f);
  glDisable(GL_FRAMEBUFFER_SRGB);
}

void DrawnFrame::wait() const { glFinish(); }

ScreenImage DrawnFrame::read_codes() const {
  const auto& [width, height] = state_->size;
  std::vector<std::uint8_t> fours(static_cast<std::size_t>(width) * height * 4);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, state_->resolved.name());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, fours.data());
  ScreenImage image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * 3)};
  for (int y = 0; y < height; ++y) {
    // OpenGL counts rows from the bottom.
    const auto* from = fours.data() + static_cast<std::size_t>(height - 1 - y) * width * 4;
    auto* to = image.codes.data() + image.index(0, y);
    for (int x = 0; x < width; ++x, from += 4, to += 3) std::copy_n(from, 3, to);
  }
  return image;
}

Image DrawnFrame::read() const {
  const auto seen = read_codes();
  std::array<float, 256> linear;
  for (std::size_t code = 0; code < linear.size(); ++code)
    linear[code] = srgb_decode(static_cast<float>(code) / 255.0f);
  Image image(seen.width, seen.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const auto* code = seen.codes.data() + 3 * i;
    image.pixels[i] = Vec3(linear[code[0]], linear[code[1]], linear[code[2]]);
  }
  return image;
}

int pixel_step(EdgeSmoothing edges) {
  if (edges == EdgeSmoothing::coarsest) return 3;
  return edges == EdgeSmoothing::coarse ? 2 : 1;
}

ScreenSize drawn_size(ScreenSize size, EdgeSmoothing edges) {
  const auto step = pixel_step(edges);
  return {(size.width + step - 1) / step, (size.height + step - 1) / step};
}

Tile tile_of(const PicturePart& part, const Tile& whole) {
  const auto at = [](float low, float high, int pixel, int pixels) {
    return low + (high - low) * static_cast<float>(pixel) / static_cast<float>(pixels);
  };
  const auto x = [&](int pixel) { return at(whole.left, whole.right, pixel, part.whole.width); };
  const auto y = [&](int pixel) { return at(whole.bottom, whole.top, pixel, part.whole.height); };
  const auto& [left, bottom] = part.begin;
  return {x(left), x(left + part.size.width), y(bottom), y(bottom + part.size.height)};
}

PicturePart with_margin(const PicturePart& part, int margin) {
  const PixelOffset begin{std::max(0, part.begin.left - margin), std::max(0, part.begin.bottom - margin)};
  const auto end = [&](int its_end, int end_of_all) { return std::min(end_of_all, its_end + margin); };
  return {part.whole,
          begin,
          {end(part.begin.left + part.size.width, part.whole.width) - begin.left,
           end(part.begin.bottom + part.size.height, part.whole.height) - begin.bottom}};
}

Tile shifted_tile(int shift, ScreenSize size) {
  // One in each row and each column of 16 x 16; columns in the order of their reversed bits, so that the
  // first pictures are spread, too.
  constexpr std::array<int, shifts> columns = {0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15};
  const auto number = shift % shifts;
  const auto centre = [](int place) { return (static_cast<float>(place) + 0.5f) / shifts - 0.5f; };
  const Vec2 place(centre(columns[static_cast<std::size_t>(number)]), centre((7 * number + 3) % shifts));
  const auto off = place * 2.0f / Vec2(size.width, size.height);
  return {-1.0f + off.x, 1.0f + off.x, -1.0f + off.y, 1.0f + off.y};
}

}  // namespace luxel
