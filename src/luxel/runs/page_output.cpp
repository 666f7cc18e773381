// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/page_output.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "luxel/export/export_page.h"
#include "luxel/runs/bake_settings.h"
#include "luxel/runs/outputs.h"
#include "luxel/solve/relight.h"

namespace luxel {
namespace {

// The light of each group of lamps alone.
std::vector<GroupLight> light_of_groups(const Baked& baked, const std::shared_ptr<const SampleState>& samples,
                                        const Tracer& tracer, const SmoothOptions& smooth,
                                        const Context& context) {
  const auto groups = baked.patches.group_count();
  const auto bands = baked.patches.band_count();
  std::vector<GroupLight> lights;
  if (!samples || groups < 2) return lights;
  Relighter relighter(baked.patches, tracer, samples, sampled_options_of(baked.solution.provenance), context);
  for (std::size_t g = 0; g < groups; ++g) {
    std::vector<float> weight(groups * bands, 0.0f);
    std::fill_n(weight.begin() + static_cast<std::ptrdiff_t>(g * bands), bands, 1.0f);
    relighter.set_lamps(std::move(weight));
    auto solution = relighter.light();
    auto light = make_smooth_light(baked.patches, solution, smooth, context);
    lights.push_back({std::move(solution), std::move(light)});
  }
  return lights;
}

}  // namespace

SampledOptions sampled_options_of(const Provenance& provenance) {
  BakeSettings settings;
  OptionSet all("bake", "");
  settings.declare(all);
  all.restore(provenance.options);
  return settings.light.sampled;
}

void write_page(const std::string& output, const PageInput& input, const LookSettings& look,
                const Tracer& tracer, const Context& context) {
  const auto& [baked, light, samples, hidden_sides, camera] = input;
  const auto groups = light_of_groups(baked, samples, tracer, look.smooth, context);
  PageOptions options{.tone = look.tone, .title = look.title, .camera = camera};
  options.hidden_backs = hidden_sides.back;
  if (options.title.empty()) options.title = std::filesystem::path(output).stem().string();
  options.camera.up = up_of(look, baked.patches);  // a plan's own up is for a still picture
  export_page(output, baked.patches, baked.solution, light, groups, options);
}

}  // namespace luxel
