// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/difference_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "luxel/core/percentile.h"
#include "luxel/render/pinhole.h"

namespace luxel {
namespace {

const Vec3 paper(0.02f);
const Vec3 ink(0.85f);
const Vec3 nothing(0.1f);

Vec3 colour_of(float fraction, float scale) {
  if (std::isnan(fraction)) return nothing;
  const auto s = fraction / scale;
  const Vec3 full = s > 0.0f ? Vec3(0.75f, 0.03f, 0.02f) : Vec3(0.02f, 0.1f, 0.75f);
  const auto strength = std::min(1.0f, std::fabs(s));
  const auto beyond =
      std::clamp(0.5f * (std::fabs(s) - 1.0f), 0.0f, 0.7f);  // beyond the scale: darkened to 0.3
  return (Vec3(1.0f) + strength * (full - Vec3(1.0f))) * (1.0f - beyond);
}

// Dots of a character, five by seven, one byte per row.
struct Glyph {
  char character;
  std::array<unsigned char, 7> rows;
};
constexpr int glyph_width = 5, glyph_height = 7;
constexpr Glyph glyphs[] = {
    {'0', {0x0e, 0x11, 0x13, 0x15, 0x19, 0x11, 0x0e}}, {'1', {0x04, 0x0c, 0x04, 0x04, 0x04, 0x04, 0x0e}},
    {'2', {0x0e, 0x11, 0x01, 0x02, 0x04, 0x08, 0x1f}}, {'3', {0x1f, 0x02, 0x04, 0x02, 0x01, 0x11, 0x0e}},
    {'4', {0x02, 0x06, 0x0a, 0x12, 0x1f, 0x02, 0x02}}, {'5', {0x1f, 0x10, 0x1e, 0x01, 0x01, 0x11, 0x0e}},
    {'6', {0x06, 0x08, 0x10, 0x1e, 0x11, 0x11, 0x0e}}, {'7', {0x1f, 0x01, 0x02, 0x04, 0x08, 0x08, 0x08}},
    {'8', {0x0e, 0x11, 0x11, 0x0e, 0x11, 0x11, 0x0e}}, {'9', {0x0e, 0x11, 0x11, 0x0f, 0x01, 0x02, 0x0c}},
    {'.', {0x00, 0x00, 0x00, 0x00, 0x00, 0x0c, 0x0c}}, {'-', {0x00, 0x00, 0x00, 0x1f, 0x00, 0x00, 0x00}},
    {'+', {0x00, 0x04, 0x04, 0x1f, 0x04, 0x04, 0x00}}, {'%', {0x18, 0x19, 0x02, 0x04, 0x08, 0x13, 0x03}}};

int text_width(std::string_view text, int dot) {
  return static_cast<int>(text.size()) * (glyph_width + 1) * dot - dot;
}

void write_text(Image& image, std::string_view text, int left, int top, int dot) {
  for (const auto c : text) {
    for (const auto& glyph : glyphs)
      for (int y = 0; glyph.character == c && y < glyph_height * dot; ++y)
        for (int x = 0; x < glyph_width * dot; ++x) {
          const bool is_dark = (glyph.rows[static_cast<std::size_t>(y / dot)] >> (4 - x / dot)) & 1;
          const int px = left + x, py = top + y;
          if (is_dark && px >= 0 && px < image.width && py < image.height) image.at(px, py) = ink;
        }
    left += (glyph_width + 1) * dot;
  }
}

// Draws a bar of all colours from -scale to +scale across the picture, with five numbers below it.
void draw_legend(Image& image, int top, float scale, int dot) {
  const auto margin = std::min(image.width / 8, 4 * text_width("-100%", dot) / 5);
  const auto bar_width = image.width - 2 * margin;
  const auto bar_top = top + 4 * dot;
  for (int x = 0; x < bar_width; ++x) {
    const auto fraction =
        scale * (2.0f * (static_cast<float>(x) + 0.5f) / static_cast<float>(bar_width) - 1.0f);
    for (int y = 0; y < 8 * dot; ++y) image.at(margin + x, bar_top + y) = colour_of(fraction, scale);
  }
  const bool is_narrow = image.width < 6 * text_width("+0.05%", dot);
  for (int i = -2; i <= 2; i += is_narrow ? 2 : 1) {
    const auto percent = 50.0 * i * static_cast<double>(scale);
    const auto text = i == 0 ? std::string("0") : fmt::format("{:+.4g}%", percent);
    const auto middle = margin + bar_width * (i + 2) / 4;
    write_text(image, text, middle - text_width(text, dot) / 2, bar_top + 10 * dot, dot);
  }
}

}  // namespace

Image difference_picture(std::span<const float> fractions, int width, int height, float scale) {
  const int dot = std::max(1, width / 480);
  const int legend = 24 * dot;
  Image image(width, height + legend, paper);
  for (std::size_t i = 0; i < fractions.size(); ++i) image.pixels[i] = colour_of(fractions[i], scale);
  draw_legend(image, height, scale, dot);
  return image;
}

float automatic_scale(std::span<const float> fractions) {
  constexpr double least = 1e-6;
  std::vector<float> sizes;
  for (const auto s : fractions)
    if (!std::isnan(s)) sizes.push_back(std::fabs(s));
  if (sizes.empty()) return 0.01f;
  const auto size = std::clamp(static_cast<double>(percentile(std::move(sizes), 0.95)), least, 1e6);
  double power = least;
  while (10.0 * power <= size) power *= 10.0;
  for (const double step : {1.0, 2.0, 5.0})
    if (size <= step * power * (1.0 + 1e-6)) return static_cast<float>(step * power);
  return static_cast<float>(10.0 * power);
}

std::vector<float> seen_fractions(const PatchSet& patches, std::span<const float> of_side,
                                  const Tracer& tracer, const Camera& camera, int width, int height) {
  const Pinhole pinhole(camera, width, height);
  std::vector<float> fractions;
  fractions.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto hit = tracer.nearest(pinhole.ray(x + 0.5, y + 0.5));
      const auto is_lit = hit && (!hit.back || patches.material_of(hit.patch).two_sided);
      fractions.push_back(is_lit ? of_side[std::size_t{2} * hit.patch + (hit.back ? 1 : 0)]
                                 : std::numeric_limits<float>::quiet_NaN());
    }
  return fractions;
}

}  // namespace luxel
