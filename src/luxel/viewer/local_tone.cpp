// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/local_tone.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "luxel/image/curve.h"
#include "luxel/image/local_scales.h"
#include "luxel/viewer/framebuffer.h"
#include "luxel/viewer/full_screen_triangle.h"
#include "luxel/viewer/local_tone_shaders.h"

namespace luxel {
namespace {

constexpr int longest = 8;  // of a blur, texels to either side

// The blurs that one picture of the scene serves: a whole one, or one of halves or quarters.
struct Group {
  int first, count;  // of LocalScales
  float texel;       // in pixels of the full size
  // Blur by the reduction and by the interpolation between texels, square texels: (n² - 1) / 12 square
  // pixels for a mean of n x n, and t (1 - t) between two texels, t from the centre of a pixel to a texel's.
  float own_variance;
};
constexpr std::array<Group, 3> groups = {
    Group{0, 4, 1.0f, 0.0f}, {4, 2, 2.0f, (0.25f + 0.75f) / 4.0f}, {6, 3, 4.0f, (1.25f + 2.75f) / 16.0f}};

// Gaussian weights, cut at three standard deviations as gaussian_blur() does: [texels off][blur].
struct Weights {
  std::array<std::array<float, 4>, longest + 1> of{};
  int radius = 1;
};

Weights weights_of(const Group& group, double pixel) {
  Weights weights;
  weights.of[0].fill(1.0f);
  for (int k = 0; k < group.count; ++k) {
    const double wanted =
        LocalScales::smallest * std::pow(LocalScales::ratio, group.first + k) / (pixel * group.texel);
    const double variance = wanted * wanted - static_cast<double>(group.own_variance);
    if (!(variance > 0.0)) continue;  // it is blurred enough as it is
    const double sigma = std::sqrt(variance);
    const int radius = std::clamp(static_cast<int>(std::ceil(3.0 * sigma)), 1, longest);
    for (int j = 1; j <= radius; ++j) {
      const double u = j / sigma;
      weights.of[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)] =
          static_cast<float>(std::exp(-0.5 * u * u));
    }
    weights.radius = std::max(weights.radius, radius);
  }
  return weights;
}

ScreenSize half_of(ScreenSize size) { return {(size.width + 1) / 2, (size.height + 1) / 2}; }

// A texture that programs write, and read with or without interpolation.
struct Target {
  GlTexture texture;
  GlFramebuffer frame;

  void resize(ScreenSize size, GLint format) {
    texture_storage(texture, format, size);
    for (const auto side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
      glTexParameteri(GL_TEXTURE_2D, side, GL_CLAMP_TO_EDGE);
    if (format == GL_R32F)
      for (const auto channel : {GL_TEXTURE_SWIZZLE_G, GL_TEXTURE_SWIZZLE_B, GL_TEXTURE_SWIZZLE_A})
        glTexParameteri(GL_TEXTURE_2D, channel, GL_RED);
    glBindFramebuffer(GL_FRAMEBUFFER, frame.name());
    attach(GL_COLOR_ATTACHMENT0, texture);
    check_complete(size);
  }
};

void bind(const Target& target, int unit) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, target.texture.name());
  glActiveTexture(GL_TEXTURE0);
}

}  // namespace

struct LocalTone::State {
  // Luminances of one size, and their blurs along rows, then along columns too.
  struct Level {
    ScreenSize size;
    Target inputs, rows, blurs;
  };
  ScreenSize size{0, 0};
  std::array<Level, groups.size()> levels;
  GlRenderbuffer depth;
  Target chosen;
  FullScreenTriangle covers;
  GlProgram halve{FullScreenTriangle::vertex_shader, halve_shader},
      blur{FullScreenTriangle::vertex_shader, blur_shader},
      choose{FullScreenTriangle::vertex_shader, choose_shader};

  void resize(ScreenSize to);
  void run(const Target& source, const Target& target, ScreenSize its_size) const;
  void blur_level(const Level& level, const Weights& weights) const;
};

void LocalTone::State::resize(ScreenSize to) {
  auto its_size = to;
  for (auto& level : levels) {
    level.size = its_size;
    level.inputs.resize(its_size, GL_R32F);
    level.rows.resize(its_size, GL_RGBA32F);
    level.blurs.resize(its_size, GL_RGBA32F);
    if (&level != &levels.front()) filter_between_texels(level.blurs.texture);
    its_size = half_of(its_size);
  }
  chosen.resize(to, GL_R32F);
  glBindFramebuffer(GL_FRAMEBUFFER, levels.front().inputs.frame.name());
  attach_rendered(nullptr, depth, 0, to);
  check_complete(to);
  size = to;
}

// Draws one texture into another with the program in use.
void LocalTone::State::run(const Target& source, const Target& target, ScreenSize its_size) const {
  glBindFramebuffer(GL_FRAMEBUFFER, target.frame.name());
  glViewport(0, 0, its_size.width, its_size.height);
  bind(source, 0);
  covers.draw();
}

void LocalTone::State::blur_level(const Level& level, const Weights& weights) const {
  blur.use();
  blur.set("source", 0);
  blur.set("radius", weights.radius);
  blur.set("weights", weights.of.front().data(), longest + 1);
  blur.set("down", 0);
  run(level.inputs, level.rows, level.size);
  blur.set("down", 1);
  run(level.rows, level.blurs, level.size);
}

LocalTone::LocalTone() : state_(std::make_unique<State>()) {}
LocalTone::~LocalTone() = default;

void LocalTone::begin(ScreenSize size) {
  auto& s = *state_;
  if (size != s.size) s.resize(size);
  glBindFramebuffer(GL_FRAMEBUFFER, s.levels.front().inputs.frame.name());
  glViewport(0, 0, size.width, size.height);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void LocalTone::finish(const ToneCurve& curve, float pixel) {
  auto& s = *state_;
  glDisable(GL_DEPTH_TEST);
  s.halve.use();
  s.halve.set("source", 0);
  for (std::size_t i = 1; i < s.levels.size(); ++i)
    s.run(s.levels[i - 1].inputs, s.levels[i].inputs, s.levels[i].size);
  for (std::size_t i = 0; i < s.levels.size(); ++i)
    s.blur_level(s.levels[i], weights_of(groups[i], static_cast<double>(pixel)));
  const double key = reinhard_key(curve.options) * std::exp2(static_cast<double>(curve.options.exposure));
  s.choose.use();
  s.choose.set("fine", 0);
  s.choose.set("halves", 1);
  s.choose.set("quarters", 2);
  s.choose.set("sharpness", static_cast<float>(std::exp2(LocalScales::phi) * key));
  s.choose.set("epsilon", LocalScales::epsilon);
  s.choose.set("ratio2", static_cast<float>(LocalScales::ratio * LocalScales::ratio));
  bind(s.levels[1].blurs, 1);
  bind(s.levels[2].blurs, 2);
  s.run(s.levels[0].blurs, s.chosen, s.size);
}

void LocalTone::use(int unit) const { bind(state_->chosen, unit); }

}  // namespace luxel
