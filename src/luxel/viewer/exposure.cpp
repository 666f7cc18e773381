// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/exposure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "luxel/render/sky_colours.h"
#include "luxel/render/visible_luminaires.h"
#include "luxel/scene/band_colours.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {
namespace {

constexpr int columns = 36, rows = 23;
constexpr double reaction = 0.12;  // s, time constant: for two thirds of a change

// Radiance of a grid of rays through the view.
struct Seen {
  Image radiance{columns, rows};  // W/(m² sr)
  SkyPixels sky;
};

Seen seen_light(const SessionLight& light, const Pose& pose, const Space& space, float aspect) {
  const auto& patches = *light.mesh.patches;
  const auto colours = patches.colours();
  const auto bands = patches.band_count();
  const SkyColours sky(patches, colours);
  const VisibleLuminaires luminaires(patches, colours);
  Seen seen;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const auto at = [](int i, int n) {
        return 2.0f * (static_cast<float>(i) + 0.5f) / static_cast<float>(n) - 1.0f;
      };
      const auto ray = sight(pose, space, aspect, at(x, columns), at(y, rows));
      const auto hit = light.mesh.tracer->nearest({ray.origin, ray.direction});
      auto& pixel = seen.radiance.at(x, y);
      if (!luminaires.empty()) {
        const auto bright = luminaires.first({ray.origin, ray.direction}, hit.distance);
        if (bright) {
          pixel = in_gamut(bright->radiance);
          continue;
        }
      }
      if (!hit) {
        pixel = in_gamut(sky.at(Vec3d(ray.direction)));
        seen.sky.pixels.push_back(static_cast<std::uint32_t>(y * columns + x));
        seen.sky.fraction.push_back(1.0f);
        continue;
      }
      const auto of = [&](SideId side) {
        return light.solution.irradiance.of(side).data() + hit.patch * bands;
      };
      pixel = in_gamut(radiance_of(patches.material_of(hit.patch), hit.back,
                                   {of(hit.side()), of(hit.side().opposite())}, colours,
                                   texture_ratio_of_patch(patches, hit.patch)));
    }
  return seen;
}

}  // namespace

void Exposure::forget() { base_.reset(); }

ToneCurve Exposure::curve(const ToneOptions& options, bool automatic, const SessionLight* light,
                          const SeenFrom& from, double seconds) {
  ToneCurve curve{.options = options};
  if (options.op == ToneOperator::clamp) {
    is_settled_ = true;
    curve.scale = std::exp2(options.exposure);
    return curve;
  }
  const bool is_other = fitted_.op != options.op || fitted_.key != options.key;
  if ((automatic || !base_ || is_other) && light != nullptr && light->mesh.tracer) {
    auto plain = options;
    plain.exposure = 0.0f;
    const auto seen = seen_light(*light, from.pose, from.space, from.aspect);
    const float goal = std::log(fit_curve(seen.radiance, seen.sky, plain).scale);
    const auto fraction = static_cast<float>(1.0 - std::exp(-seconds / reaction));
    base_ = base_ && !is_other ? *base_ + fraction * (goal - *base_) : goal;
    is_settled_ = std::abs(*base_ - goal) < 0.01f;
    if (is_settled_) base_ = goal;
    fitted_ = options;
  }
  curve.scale = std::exp(base_.value_or(0.0f)) * std::exp2(options.exposure);
  return curve;
}

}  // namespace luxel
