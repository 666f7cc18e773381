// SPDX-License-Identifier: Apache-2.0
#include "luxel/image/false_colours.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/percentile.h"

namespace luxel {
namespace {

// sRGB codes at equal steps: "inferno" of N. Smith and S. van der Walt (CC0).
constexpr std::array<std::uint32_t, 9> heat = {0x000004, 0x210c4a, 0x57106e, 0x8a226a, 0xbc3754,
                                               0xe45a31, 0xf98e09, 0xf9cb35, 0xfcffa4};

Vec3 heat_colour(double fraction) {
  const auto code = false_colour(fraction);
  return {srgb_decode(code.r), srgb_decode(code.g), srgb_decode(code.b)};
}

// Letters of 5 x 7 pixels; a row is five bits, the highest one on the left.
constexpr int letter_width = 5, letter_height = 7;
constexpr std::string_view letters = "0123456789.lxcdm/";
constexpr std::array<std::array<std::uint8_t, letter_height>, letters.size()> shapes = {{
    {14, 17, 19, 21, 25, 17, 14},  // 0
    {4, 12, 4, 4, 4, 4, 14},       // 1
    {14, 17, 1, 2, 4, 8, 31},      // 2
    {31, 2, 4, 2, 1, 17, 14},      // 3
    {2, 6, 10, 18, 31, 2, 2},      // 4
    {31, 16, 30, 1, 1, 17, 14},    // 5
    {6, 8, 16, 30, 17, 17, 14},    // 6
    {31, 1, 2, 4, 8, 8, 8},        // 7
    {14, 17, 17, 14, 17, 17, 14},  // 8
    {14, 17, 17, 15, 1, 2, 12},    // 9
    {0, 0, 0, 0, 0, 12, 12},       // .
    {12, 4, 4, 4, 4, 4, 14},       // l
    {0, 0, 17, 10, 4, 10, 17},     // x
    {0, 0, 14, 16, 16, 17, 14},    // c
    {1, 1, 13, 19, 17, 17, 15},    // d
    {0, 0, 26, 21, 21, 17, 17},    // m
    {0, 1, 2, 4, 8, 16, 0},        // /
}};

class Legend {
 public:
  Legend(Image& image, const FalseColourScale& scale)
      : image_(image), scale_(scale), size_(std::max(1, image.height / 360)) {}

  void draw() {
    constexpr int bar = 10, gap = 4, columns = 7, values = 6;
    const int width = size_ * (bar + 3 * gap + columns * (letter_width + 1));
    const int left = image_.width - width, line = size_ * (letter_height + 2 * gap);
    fill(left, 0, width, image_.height, Vec3(1.0f));
    const int top = 2 * line, bottom = image_.height - line;
    for (int y = top; y < bottom; ++y) {
      const auto fraction = 1.0 - (y + 0.5 - top) / (bottom - top);
      fill(left + size_ * gap, y, size_ * bar, 1, heat_colour(fraction));
    }
    const int text = left + size_ * (bar + 2 * gap);
    write(scale_.unit, left + size_ * gap, size_ * gap);
    for (int k = 0; k < values; ++k) {
      const auto fraction = static_cast<double>(k) / (values - 1);
      const auto y = bottom - static_cast<int>(std::lround(fraction * (bottom - top)));
      fill(left + size_ * (gap + bar), y, size_ * 2, size_, Vec3(0.0f));
      const auto value = fraction * scale_.high;
      write(value >= 100.0 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value), text,
            y - size_ * letter_height / 2);
    }
  }

 private:
  void fill(int x, int y, int width, int height, const Vec3& colour) {
    for (int j = std::max(0, y); j < std::min(image_.height, y + height); ++j)
      for (int i = std::max(0, x); i < std::min(image_.width, x + width); ++i) image_.at(i, j) = colour;
  }
  void write(const std::string& text, int x, int y) {
    for (const char c : text) {
      const auto which = letters.find(c);
      for (int j = 0; which != std::string_view::npos && j < letter_height; ++j)
        for (int i = 0; i < letter_width; ++i)
          if ((shapes[which][static_cast<std::size_t>(j)] >> (letter_width - 1 - i) & 1) != 0)
            fill(x + size_ * i, y + size_ * j, size_, size_, Vec3(0.0f));
      x += size_ * (letter_width + 1);
    }
  }

  Image& image_;
  const FalseColourScale& scale_;
  int size_;  // pixels per pixel of a letter
};

}  // namespace

Vec3 false_colour(double fraction) {
  const auto place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(heat.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(place), heat.size() - 2);
  const auto t = static_cast<float>(place - static_cast<double>(i));
  Vec3 colour(0.0f);
  for (int k = 0; k < 3; ++k) {
    const auto code = [&](std::uint32_t rgb) {
      return static_cast<float>(rgb >> (16 - 8 * k) & 0xffu) / 255.0f;
    };
    colour[k] = (1.0f - t) * code(heat[i]) + t * code(heat[i + 1]);
  }
  return colour;
}

FalseColourScale automatic_scale(const std::vector<double>& values, const std::string& unit) {
  std::vector<double> lit;
  std::copy_if(values.begin(), values.end(), std::back_inserter(lit),
               [](double v) { return v > 0.0 && std::isfinite(v); });
  if (lit.empty()) return {1.0, unit};
  const auto high = percentile(std::move(lit), 0.98);
  const auto power = std::pow(10.0, std::floor(std::log10(high)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= high) return {step * power, unit};
  return {10.0 * power, unit};
}

Image false_colours(const std::vector<double>& values, int width, int height, const FalseColourScale& scale) {
  assert(scale.high > 0.0);
  constexpr float grey = 0.2f;
  constexpr int min_width = 240, min_height = 180;
  Image image(width, height);
  assert(values.size() == image.pixels.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    image.pixels[i] = std::isnan(values[i]) ? Vec3(grey) : heat_colour(values[i] / scale.high);
  if (width >= min_width && height >= min_height) Legend(image, scale).draw();
  return image;
}

}  // namespace luxel
