// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/sky_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "luxel/core/error.h"
#include "luxel/core/trig.h"
#include "luxel/image/image_file.h"
#include "luxel/scene/luminous_efficacy.h"

namespace luxel {
namespace {

constexpr double spot_contrast =
    100.0;  // over the mean radiance: seldom found by rays, and then far too bright
constexpr double spot_width = 6.0 * std::numbers::pi / 180.0;
constexpr std::size_t max_spots = 8;

// A point of the picture, [0, 1)² from its upper left corner, as a direction in local axes.
Vec3d direction_at(double x, double y) {
  const auto up = sin_cos((0.5 - y) * std::numbers::pi), around = sin_cos(x * 2.0 * std::numbers::pi);
  return {up.cosine * around.sine, up.cosine * around.cosine, up.sine};
}

// The pixels of a picture with the directions and the solid angles that they have.
class Panorama {
 public:
  explicit Panorama(const Image& image) : image_(image) {}

  std::size_t size() const { return image_.pixels.size(); }
  Vec3d direction(std::size_t pixel, double dx = 0.5, double dy = 0.5) const {
    return direction_at((static_cast<double>(column(pixel)) + dx) / image_.width,
                        (static_cast<double>(row(pixel)) + dy) / image_.height);
  }
  double solid_angle(std::size_t pixel) const {
    const auto sine = [this](double y) { return sin_cos((0.5 - y / image_.height) * std::numbers::pi).sine; };
    const auto y = static_cast<double>(row(pixel));
    return 2.0 * std::numbers::pi / image_.width * (sine(y) - sine(y + 1.0));
  }
  // Nearest pixel.
  std::size_t pixel_at(const Vec3d& d) const {
    const auto turns = std::atan2(d.x, d.y) / (2.0 * std::numbers::pi);
    const auto x = turns - std::floor(turns);
    const auto y = 0.5 - std::asin(std::clamp(d.z, -1.0, 1.0)) / std::numbers::pi;
    const auto clamped = [](double at, int n) { return std::clamp(static_cast<int>(at * n), 0, n - 1); };
    return static_cast<std::size_t>(clamped(y, image_.height)) * static_cast<std::size_t>(image_.width) +
           static_cast<std::size_t>(clamped(x, image_.width));
  }
  const Vec3& radiance(std::size_t pixel) const { return image_.pixels[pixel]; }

 private:
  std::size_t row(std::size_t pixel) const { return pixel / static_cast<std::size_t>(image_.width); }
  std::size_t column(std::size_t pixel) const { return pixel % static_cast<std::size_t>(image_.width); }

  const Image& image_;
};

double mean_luminance(const Panorama& panorama) {
  double sum = 0.0;
  for (std::size_t i = 0; i < panorama.size(); ++i)
    sum += panorama.solid_angle(i) * static_cast<double>(luminance(panorama.radiance(i)));
  return sum / (4.0 * std::numbers::pi);
}

struct Spot {
  Vec3d brightest{0.0};  // unit
  Vec3d towards{0.0};    // sum over pixels, weighted by their light
  Vec3d light{0.0};      // W/m²
  double solid_angle = 0.0;
};

// Moves radiance that is too bright for a patch into spots: the pixels keep the limit.
std::vector<Spot> take_spots(const Panorama& panorama, Image& image) {
  const auto limit = spot_contrast * mean_luminance(panorama);
  std::vector<std::pair<float, std::size_t>> bright;
  for (std::size_t i = 0; i < panorama.size(); ++i)
    if (const auto own = luminance(panorama.radiance(i)); static_cast<double>(own) > limit)
      bright.emplace_back(own, i);
  std::sort(bright.begin(), bright.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second < b.second;
  });
  std::vector<Spot> spots;
  for (const auto& [own, pixel] : bright) {
    const auto direction = panorama.direction(pixel);
    auto at = std::find_if(spots.begin(), spots.end(), [&](const Spot& s) {
      return glm::dot(s.brightest, direction) > sin_cos(0.5 * std::numbers::pi - spot_width).sine;
    });
    if (at == spots.end()) {
      if (spots.size() == max_spots) continue;
      spots.push_back({direction});
      at = spots.end() - 1;
    }
    const auto kept = static_cast<float>(limit) / own;
    const auto light = panorama.solid_angle(pixel) * Vec3d((1.0f - kept) * image.pixels[pixel]);
    at->light += light;
    at->towards += static_cast<double>(luminance(Vec3(light))) * direction;
    at->solid_angle += panorama.solid_angle(pixel);
    image.pixels[pixel] *= kept;
  }
  return spots;
}

// The mean over each patch: of the pixels whose centres lie in it, or of points in it where pixels are
// coarse.
std::vector<Vec3> patch_means(const Panorama& panorama, const SkyPatches& patches) {
  std::vector<Vec3d> sum(patches.size(), Vec3d(0.0));
  std::vector<double> angle(patches.size(), 0.0);
  for (std::size_t i = 0; i < panorama.size(); ++i) {
    const auto patch = patches.patch_of(patches.in_scene_axes(panorama.direction(i)));
    const auto own = panorama.solid_angle(i);
    sum[patch] += own * Vec3d(panorama.radiance(i));
    angle[patch] += own;
  }
  constexpr int points = 4;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    if (angle[p] > 0.5 * patches.solid_angle(p) || !(patches.solid_angle(p) > 0.0)) continue;
    sum[p] = Vec3d(0.0);
    angle[p] = points * points;
    for (int i = 0; i < points * points; ++i) {
      const auto d = patches.direction(p, {(i % points + 0.5) / points, (i / points + 0.5) / points});
      sum[p] += Vec3d(panorama.radiance(panorama.pixel_at(patches.in_local_axes(d))));
    }
  }
  std::vector<Vec3> means;
  for (std::size_t p = 0; p < sum.size(); ++p)
    means.push_back(angle[p] > 0.0 ? Vec3(sum[p] / angle[p]) : Vec3(0.0f));
  return means;
}

double open_illuminance(const SkyPicture& picture, const SkyPatches& patches) {
  double lux = 0.0;
  for (std::size_t p = 0; p < patches.size(); ++p)
    lux += std::max(0.0, patches.projected_solid_angle(p)) * luminous_efficacy *
           static_cast<double>(luminance(picture.radiance[p]));
  for (const auto& spot : picture.spots)
    lux +=
        std::max(0.0, spot.towards.z) * luminous_efficacy * static_cast<double>(luminance(spot.irradiance));
  return lux;
}

}  // namespace

SkyPicture read_sky_picture(const std::filesystem::path& path, const SkyPatches& patches,
                            double horizontal_illuminance) {
  auto image = read_image(path);
  for (auto& pixel : image.pixels) pixel = glm::max(pixel, Vec3(0.0f));
  const Panorama panorama(image);
  const auto spots = take_spots(panorama, image);
  SkyPicture picture{patch_means(panorama, patches), {}};
  for (const auto& spot : spots)
    picture.spots.push_back({glm::normalize(spot.towards),
                             std::clamp(std::sqrt(spot.solid_angle / std::numbers::pi), 1e-4, 0.1),
                             Vec3(spot.light)});
  if (!(horizontal_illuminance > 0.0)) return picture;
  const auto lux = open_illuminance(picture, patches);
  if (!(lux > 0.0))
    throw InputError(path.string(),
                     "the upper half of this picture of the sky is black, so it cannot give an illuminance");
  const auto scale = static_cast<float>(horizontal_illuminance / lux);
  for (auto& radiance : picture.radiance) radiance *= scale;
  for (auto& spot : picture.spots) spot.irradiance *= scale;
  return picture;
}

}  // namespace luxel
