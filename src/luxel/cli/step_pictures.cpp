// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/step_pictures.h"

#include <filesystem>

#include <fmt/format.h>

#include "luxel/image/image_file.h"
#include "luxel/render/render.h"

namespace luxel {
namespace {

// The options that show any picture with the exposure of this one.
ToneOptions exposed_as(const Picture& picture, const ToneOptions& tone) {
  auto options = tone;
  if (options.op == ToneOperator::reinhard_local) options.op = ToneOperator::reinhard;
  options.scale = fit_curve(picture.radiance, picture.sky, options).scale;
  options.exposure = 0.0f;
  return options;
}

}  // namespace

StepPictures::StepPictures(std::string folder) : folder_(std::move(folder)) {
  if (folder_.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error)
    throw DeviceError(fmt::format("--each-step: cannot make the folder {}: {}", folder_, error.message()));
}

void StepPictures::add(const Solution& light) {
  if (!folder_.empty()) steps_.push_back({light.irradiance});
}

std::vector<std::string> StepPictures::write(const Baked& baked, const Tracer& tracer,
                                             const std::optional<Camera>& camera,
                                             const OutputSettings& settings, const Workplace& place) const {
  std::vector<std::string> files;
  if (steps_.empty()) return files;
  const auto& context = place.context;
  auto& console = place.console;
  const auto& look = settings.look;
  const auto& picture = settings.picture;
  return place.record.stage("steps", [&](auto&) {
    const auto from = camera ? *camera : camera_of(picture, look, baked, tracer, context);
    const auto draw = [&](const Step& step) {
      auto light = baked.solution;
      light.irradiance = step.irradiance;
      return render_picture(baked.patches, make_smooth_light(baked.patches, light, look.smooth, context),
                            tracer, from, picture.render, context);
    };
    const auto tone = exposed_as(draw(steps_.back()), look.tone);
    const auto monitor = console.monitor(false);
    for (const auto& step : steps_) {
      const auto shown = draw(step);
      files.push_back(
          (std::filesystem::path(folder_) / fmt::format("step-{:03}.png", files.size() + 1)).string());
      write_png(files.back(), tone_map(shown.radiance, tone, shown.edges, shown.sky));
      tell(monitor, {"steps", static_cast<double>(files.size()) / static_cast<double>(steps_.size())});
    }
    console.clear_bar();
    return files;
  });
}

}  // namespace luxel
