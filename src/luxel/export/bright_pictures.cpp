// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/bright_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "luxel/image/codec.h"
#include "luxel/image/image.h"
#include "luxel/image/image_file.h"
#include "luxel/patch/side.h"
#include "luxel/scene/band_colours.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {
namespace {

constexpr double rare = 1e-3;         // part of an area that may be too dark
constexpr float worth_it = 1.02f;     // smaller gains are not seen
constexpr float largest_gain = 8.0f;  // of pictures that are nearly black
constexpr float knee = 0.85f;

// Where the light on a picture needs vertex colours above 1.
struct BrightPlaces {
  double area = 0.0;                            // m², of all of the picture
  double too_bright = 0.0;                      // m², in any channel
  std::vector<std::pair<double, Vec3>> needed;  // the area of each patch there, and its vertex colour
};

// Returns the part of the pixels that has each code of a channel.
std::array<double, 256> histogram(const Raster& picture, int channel) {
  std::array<double, 256> part{};
  for (const auto& code : picture.codes) ++part[code[static_cast<std::size_t>(channel)]];
  for (auto& p : part) p /= static_cast<double>(picture.codes.size());
  return part;
}

// Returns what a gain of one channel loses: the mean part of the light that is missing on the surfaces that
// remain too dark, and in the pixels that become white.
double loss(float gain, int channel, const BrightPlaces& places, const std::array<double, 256>& pixels) {
  double missing = 0.0;
  for (const auto& [area, needed] : places.needed)
    missing += area * std::max(0.0, 1.0 - static_cast<double>(gain / needed[channel]));
  double white = 0.0;
  for (std::size_t code = 0; code < pixels.size(); ++code) {
    const auto bright = gain * srgb_decode(static_cast<float>(code) / 255.0f);
    if (bright > 1.0f) white += pixels[code] * static_cast<double>(1.0f - 1.0f / bright);
  }
  return missing / places.area + white;
}

// Returns the gains that lose least; each makes one of the codes of the picture white.
Vec3 best_gains(const Raster& picture, const BrightPlaces& places) {
  Vec3 best(1.0f);
  if (picture.codes.empty()) return best;
  for (int c = 0; c < 3; ++c) {
    const auto pixels = histogram(picture, c);
    auto smallest = loss(1.0f, c, places, pixels);
    for (std::size_t code = 255; code > 0; --code) {
      if (pixels[code] == 0.0) continue;
      const auto gain = std::min(largest_gain, 1.0f / srgb_decode(static_cast<float>(code) / 255.0f));
      if (const auto found = loss(gain, c, places, pixels); found < smallest) {
        smallest = found;
        best[c] = gain;
      }
      if (gain == largest_gain) break;
    }
  }
  return best;
}

// From half a code of 255 to 1.
Vec3 picture_mean(const PatchSet& patches, std::size_t patch) {
  constexpr float darkest = 0.5f / 255.0f;
  const auto& material = patches.material_of(patch);
  const auto& factor = material.textures.reflectance_factor;
  const auto ratio = texture_ratio_of_patch(patches, patch);
  Vec3 mean(1.0f);
  for (int b = 0; b < 3; ++b)
    if (factor[b] > 0.0f)
      mean[b] =
          std::clamp(reflectance_at(material, ratio, static_cast<std::size_t>(b)) / factor[b], darkest, 1.0f);
  return mean;
}

std::vector<Vec3> picture_gains(const PatchSet& patches, const Solution& solution, const ToneCurve& curve) {
  std::vector<Vec3> gains(patches.textures.size(), Vec3(1.0f));
  if (is_proportional(curve) || gains.empty() || !patches.has_colours()) return gains;
  std::vector<BrightPlaces> places(gains.size());
  const auto colours = patches.colours();
  const auto bands = colours.bands();
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto& material = patches.material_of(p);
    if (!material.textures.reflectance) continue;
    const auto mean = picture_mean(patches, p);
    Vec3 radiance(0.0f);
    for (const bool back : {false, true}) {
      const std::span radiosity(solution.radiosity.of(back));
      radiance = glm::max(radiance, in_gamut(colours.rgb(radiosity.subspan(p * bands, bands))) / pi);
    }
    const auto needed = curve(radiance) / mean;
    auto& on_picture = places[material.textures.reflectance->texture];
    const auto area = static_cast<double>(patches.area[p]);
    on_picture.area += area;
    if (std::max({needed.r, needed.g, needed.b}) <= worth_it) continue;
    on_picture.too_bright += area;
    on_picture.needed.emplace_back(area, needed);
  }
  for (std::size_t t = 0; t < gains.size(); ++t)
    if (places[t].too_bright > rare * places[t].area)
      gains[t] = best_gains(*patches.textures[t].raster, places[t]);
  for (auto& gain : gains)
    if (std::max({gain.r, gain.g, gain.b}) < worth_it) gain = Vec3(1.0f);
  return gains;
}

// Alpha stays.
Raster brightened(const Raster& picture, const Vec3& gain) {
  std::array<std::array<std::uint8_t, 256>, 3> table{};
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t code = 0; code < 256; ++code)
      table[c][code] = srgb_code(
          std::min(1.0f, gain[static_cast<int>(c)] * srgb_decode(static_cast<float>(code) / 255.0f)));
  auto result = picture;
  for (auto& code : result.codes)
    for (std::size_t c = 0; c < 3; ++c) code[c] = table[c][code[c]];
  return result;
}

}  // namespace

Vec3 mean_of_picture(const PatchSet& patches, const PatchesOfTriangles& of_triangles,
                     const RoundTripPart& part) {
  Vec3d sum(0.0);
  double area = 0.0;
  for (const auto t : part.triangles)
    for (auto p = of_triangles.begin(t); p < of_triangles.end(t); ++p) {
      const auto weight = static_cast<double>(patches.area[p]);
      sum += weight * Vec3d(picture_mean(patches, p));
      area += weight;
    }
  return area > 0.0 ? Vec3(sum / area) : Vec3(1.0f);
}

bool is_proportional(const ToneCurve& curve) {
  return curve.options.op == ToneOperator::clamp || curve.options.op == ToneOperator::maximum;
}

float soft_limit(float channel, float largest) {
  if (channel <= knee || largest <= 1.0f) return std::min(channel, 1.0f);
  const auto along = std::min(1.0f, (channel - knee) / (largest - knee));
  return 1.0f - (1.0f - knee) * std::pow(1.0f - along, (largest - knee) / (1.0f - knee));
}

Vec3 colour_over_picture(const Vec3& colour, const Vec3& mean) {
  const auto needed = colour / mean;
  const auto most = std::max({needed.r, needed.g, needed.b});
  if (!(most > knee)) return needed;
  return soft_limit(most, 1.0f / std::min({mean.r, mean.g, mean.b})) / most * needed;
}

BrightPictures::BrightPictures(GltfWriter& copy, const PatchSet& patches, const Solution& solution,
                               const ToneCurve& curve)
    : copy_(copy), textures_(patches.textures), gains_(picture_gains(patches, solution, curve)) {}

void BrightPictures::put(const std::string& material, std::uint32_t texture) {
  if (gains_[texture] == Vec3(1.0f)) return;
  const auto place = material + "/pbrMetallicRoughness/baseColorTexture/index";
  const auto [made, is_new] = copies_.try_emplace(texture, 0);
  if (is_new) made->second = add_brighter(fmt::format("/textures/{}", copy_.index_at(place)), texture);
  copy_.put(place, made->second);
}

std::size_t BrightPictures::add_brighter(const std::string& old, std::uint32_t texture) {
  constexpr int quality = 95;  // at which no difference is seen
  const auto picture = brightened(*textures_[texture].raster, gains_[texture]);
  const bool is_jpeg =
      copy_.has(old + "/source") &&
      copy_.text_at(fmt::format("/images/{}/mimeType", copy_.index_at(old + "/source")), "") == "image/jpeg";
  const auto image = copy_.add_picture(is_jpeg ? encode_jpeg(picture, quality) : png_of(picture),
                                       is_jpeg ? "image/jpeg" : "image/png", textures_[texture].name);
  const auto number = copy_.append_copy("/textures", old);
  const auto brighter = fmt::format("/textures/{}", number);
  copy_.erase(brighter + "/extensions");  // other encodings of the same picture
  copy_.put(brighter + "/source", image);
  return number;
}

}  // namespace luxel
