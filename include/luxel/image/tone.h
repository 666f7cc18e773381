// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "luxel/image/image.h"

namespace luxel {

/// Reinhard et al. 2002: E. Reinhard, M. Stark, P. Shirley, J. Ferwerda, "Photographic Tone Reproduction for
/// Digital Images", ACM Transactions on Graphics 21(3), SIGGRAPH 2002.
///
/// Khronos PBR Neutral: Khronos Group, "PBR Neutral Tone Mapper", specification of 2024. Its offset of 0.04
/// takes off the reflection at the surface of dielectrics, which diffuse surfaces do not have; it is left
/// out.
enum class ToneOperator {
  neutral,   ///< Khronos PBR Neutral: colours up to 0.76 stay as they are, brighter ones go towards white
  maximum,   ///< divide by the largest channel of all colours: nothing is cut
  clamp,     ///< cut at 1
  reinhard,  ///< Reinhard et al. 2002, global, equation 3 with key; eq. 4 where white is given
  reinhard_local,  ///< Reinhard et al. 2002, dodging and burning, equations 5 to 9; pictures only
};

inline constexpr int tone_operators = 5;

/// The words of the command line: neutral, reinhard, reinhard-local, maximum, clamp.
std::string_view name(ToneOperator op);
std::optional<ToneOperator> tone_operator(std::string_view word);

/// neutral: the 90th percentile of the luminance is mapped to 0.6, but the log-average to 0.25 at least and
/// 0.5 at most: a white room is white, and a room with a bright window is not dark. Colours darker than a
/// hundredth of that percentile, such as insides of furniture, do not count in the average. Reinhard's
/// operators: 0.18, as in their paper.
inline constexpr float automatic_key = 0.0f;

struct ToneOptions {
  ToneOperator op = ToneOperator::neutral;
  float exposure = 0.0f;            ///< stops, applied before the curve: 2^exposure; -64 to 64
  float key = automatic_key;        ///< what the log-average luminance is mapped to, (0, 1]; or automatic_key
  std::optional<float> scale = {};  ///< radiance to curve input without the exposure; nothing: fitted
  float white = 0.0f;               ///< smallest luminance shown as white after keying; 0: none (equation 3)

  bool operator==(const ToneOptions&) const = default;
};

/// A tone curve fitted to the colours to display; then applied to each colour. Display-referred results are
/// linear RGB in [0, 1], not yet sRGB encoded. Hue is kept: luminance is mapped, colour scaled with it, then
/// clamped; neutral maps the largest channel, and mixes colours brighter than the display with white.
struct ToneCurve {
  ToneOptions options;
  float scale = 1.0f;  ///< radiance to curve input, exposure included

  /// Never NaN: NaN and negative channels count as 0, infinite ones as very bright.
  Vec3 operator()(const Vec3& radiance) const;
};

/// weights: the visible area (m², or pixels) behind each colour; the log-average is over area, not over
/// patches. It excludes colours without light, not finite, or without a positive weight. radiance.size() ==
/// weights.size(). The scale is
///   maximum: 2^exposure / largest channel    clamp: 2^exposure    others: 2^exposure key / log-average
/// An empty or black input gives scale 1. reinhard_local is fitted like reinhard. Throws InputError where an
/// option is out of its range.
ToneCurve fit_curve(std::span<const Vec3> radiance, std::span<const float> weights,
                    const ToneOptions& options = {});

/// The pixels on edges between bright and dark: a tone curve of their mean would show the edge as stairs,
/// since the bright side outweighs the dark one. The curve of each part keeps the edge smooth.
struct EdgePixels {
  std::size_t parts = 0;              ///< per pixel, of equal area
  std::vector<std::uint32_t> pixels;  ///< indices into Image::pixels, ascending
  std::vector<Vec3> radiance;         ///< [pixel][part], W/(m² sr)
};

/// The pixels that see the sky. A uniform sky has one radiance in all directions, which a display would show
/// as a grey wall: it is shown with a horizon instead (render/render.h), and the exposure is that of the
/// surfaces.
struct SkyPixels {
  std::vector<std::uint32_t> pixels;  ///< indices into Image::pixels, ascending
  std::vector<float> fraction;        ///< of the pixel that the sky covers, (0, 1]
  std::vector<Vec3> radiance;         ///< of the whole pixel, as displays show it, W/(m² sr)
};

/// Weights of the pixels for fit_curve(): 1, less the fraction that the sky covers. Where surfaces cover less
/// than a fiftieth of the picture, all are 1.
std::vector<float> exposure_weights(const Image& radiance, const SkyPixels& sky);

/// The curve for a picture: each pixel has these weights.
ToneCurve fit_curve(const Image& radiance, const SkyPixels& sky, const ToneOptions& options = {});

/// A scene-referred picture (radiance) made displayable: linear RGB in [0, 1]. Every pixel weighs the same,
/// the sky nothing (exposure_weights).
/// edges: pixels whose parts are mapped one by one, then averaged.
/// reinhard_local darkens a pixel by the light around it, so that detail stays in bright and in dark parts;
/// about a tenth of a second for 1280 x 960. Throws as fit_curve() does.
Image tone_map(const Image& radiance, const ToneOptions& options = {}, const EdgePixels& edges = {},
               const SkyPixels& sky = {});

}  // namespace luxel
