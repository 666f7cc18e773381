// SPDX-License-Identifier: Apache-2.0
// Reinhard's local operator as the graphics card does it, off screen, compared with the processor's on the
// same radiance.
#include "luxel/viewer/local_tone.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "luxel/viewer/frame.h"
#include "luxel/viewer/surfaces.h"

#include "support/lit_patches.h"
#include "support/off_screen.h"

namespace luxel {
namespace {

// Squares of two pixels per side; no size is a multiple of four, so that halves and quarters have odd edges.
constexpr ScreenSize squares{125, 63};
constexpr ScreenSize size{250, 126};

// Irradiance of a square, W/m²: a dim room with some grain, a window a hundred times as bright, a lamp.
float irradiance_at(int x, int y) {
  const float grain = 0.8f + 0.4f * static_cast<float>((x * 37 + y * 101) % 17) / 16.0f;
  if (x >= 70 && x < 100 && y >= 20 && y < 50) return 300.0f * (x % 10 == 0 ? 0.1f : grain);
  if (x >= 20 && x < 23 && y >= 40 && y < 43) return 30'000.0f;
  return (0.2f + 4.0f * static_cast<float>(x) / 125.0f) * grain;
}

// They fill the screen without a projection.
test::LitPatches sheet() {
  test::LitPatches lit({test::plain_material("paper", 0.8f)});
  for (int y = 0; y < squares.height; ++y)
    for (int x = 0; x < squares.width; ++x) {
      const auto corner = [&](int dx, int dy) {
        return lit.vertex(Vec3(2.0f * static_cast<float>(x + dx) / squares.width - 1.0f,
                               2.0f * static_cast<float>(y + dy) / squares.height - 1.0f, 0.0f));
      };
      const auto a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
      lit.patch({a, b, c}, irradiance_at(x, y));
      lit.patch({a, c, d}, irradiance_at(x, y));
    }
  return lit;
}

Image radiance() {
  Image image(size.width, size.height);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      image.at(x, y) = Vec3(0.8f * irradiance_at(x / 2, (size.height - 1 - y) / 2) / pi);
  return image;
}

class LocalToneOnACard : public test::OffScreen {
 protected:
  LocalToneOnACard() : OffScreen(size) {}

  void set_up() override {
    const auto lit = sheet();
    const auto patches = std::make_shared<PatchSet>(lit.patches);
    surfaces_ = std::make_unique<Surfaces>();
    surfaces_->set_mesh(patches);
    surfaces_->set_light(patches, std::make_shared<SmoothLight>(make_smooth_light(lit.patches, lit.solution)),
                         VertexValue::radiance);
    while (!surfaces_->upload(1.0)) {
    }
  }

  // Light of the whole picture, or of a part with the necessary margin.
  Image draw(const ToneCurve& curve, const PicturePart& part = {size, {}, size}) {
    const auto around = with_margin(part, LocalTone::reach);
    const auto to_screen = [](const PicturePart& what) {
      const auto tile = tile_of(what);
      Mat4 matrix(1.0f);
      matrix[0][0] = 2.0f / (tile.right - tile.left);
      matrix[1][1] = 2.0f / (tile.top - tile.bottom);
      matrix[3][0] = -(tile.right + tile.left) / (tile.right - tile.left);
      matrix[3][1] = -(tile.top + tile.bottom) / (tile.top - tile.bottom);
      return matrix;
    };
    LocalTone local;
    local.begin(around.size);
    surfaces_->draw({.projection = to_screen(around), .paint = Paint::curve_input, .tone = curve});
    local.finish(curve, 1.0f);
    DrawnFrame frame;
    frame.begin(part.size, Vec3(0.0f), EdgeSmoothing::rough);
    surfaces_->draw({.projection = to_screen(part),
                     .paint = Paint::light,
                     .tone = curve,
                     .local = &local,
                     .from = {part.begin.left - around.begin.left, part.begin.bottom - around.begin.bottom}});
    frame.resolve();
    return frame.read();
  }

  std::unique_ptr<Surfaces> surfaces_;
};

// Codes of a screen, of 255, by which a pixel differs.
std::vector<int> differences(const Image& a, const Image& b) {
  std::vector<int> codes;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    codes.push_back(std::abs(srgb_code(a.pixels[i].g) - srgb_code(b.pixels[i].g)));
  return codes;
}
double mean(const std::vector<int>& codes) {
  return std::accumulate(codes.begin(), codes.end(), 0.0) / static_cast<double>(codes.size());
}

// The blurs of scales 0 to 3 are the processor's; wider ones are near. So a pixel uses the light of another
// scale only where contrast is about the minimum that counts, epsilon (level + V), and each scale passed by
// then changes V by no more than that: together from scale 3 on, whose level is 2^phi key / 1.6^6 and falls
// by 1.6^2 with each, by epsilon (1.64 level + 5 V). What is seen is L / (1 + V).
double max_change(double V, double key) {
  const double level = 256.0 * key / std::pow(1.6, 6.0);
  return 0.05 * (1.64 * level + 5.0 * V) / (1.0 + V);
}

TEST_F(LocalToneOnACard, it_is_the_processors_picture) {
  const auto light = radiance();
  const std::vector<float> weights(light.pixels.size(), 1.0f);
  for (const float exposure : {0.0f, 3.0f, -2.0f}) {
    const ToneOptions options{.op = ToneOperator::reinhard_local, .exposure = exposure};
    const auto curve = fit_curve(light.pixels, weights, options);
    const auto drawn = draw(curve), expected = tone_map(light, options);
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < light.pixels.size(); ++i) {
      const double L = static_cast<double>(curve.scale * light.pixels[i].g);
      const double seen = expected.pixels[i].g;
      const double most = max_change(L / seen - 1.0, 0.18 * std::exp2(static_cast<double>(exposure)));
      const auto code = [](double value) { return srgb_code(static_cast<float>(value)); };
      const int it = srgb_code(drawn.pixels[i].g);
      beyond += it < code(seen * (1.0 - most)) - 1 || it > code(seen * (1.0 + most)) + 1 ? 1 : 0;
    }
    EXPECT_EQ(beyond, 0u) << "pixels, of " << light.pixels.size() << " at exposure " << exposure;
    // That is rare; elsewhere blurs that are near give light that is near.
    auto codes = differences(drawn, expected);
    std::sort(codes.begin(), codes.end());
    EXPECT_LE(codes[codes.size() * 99 / 100], 3) << exposure;
    EXPECT_LE(mean(codes), 0.25) << exposure;
  }
}

TEST_F(LocalToneOnACard, it_is_not_the_global_operator) {
  const auto light = radiance();
  const std::vector<float> weights(light.pixels.size(), 1.0f);
  const ToneOptions options{.op = ToneOperator::reinhard_local, .exposure = 3.0f};
  auto global = options;
  global.op = ToneOperator::reinhard;
  EXPECT_GT(mean(differences(draw(fit_curve(light.pixels, weights, options)), tone_map(light, global))), 3.0);
}

TEST_F(LocalToneOnACard, a_part_with_its_margin_is_as_in_the_whole) {
  const ToneCurve curve{{.op = ToneOperator::reinhard_local}, 0.3f};
  const PicturePart part{size, {100, 40}, {40, 24}};
  const auto whole = draw(curve), its = draw(curve, part);
  for (int y = 0; y < part.size.height; ++y)
    for (int x = 0; x < part.size.width; ++x) {
      const auto& there = whole.at(100 + x, size.height - 40 - part.size.height + y);
      EXPECT_NEAR(srgb_code(its.at(x, y).g), srgb_code(there.g), 1) << x << ", " << y;
    }
}

}  // namespace
}  // namespace luxel
