// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/setting_options.h"

#include <algorithm>
#include <iterator>

namespace luxel {
namespace {

struct SettingOption {
  Setting setting;
  std::string_view option;
};

constexpr SettingOption options[] = {
    {Setting::allow_outside, "allow-outside"},
    {Setting::bands, "bands"},
    {Setting::contacts, "contacts"},
    {Setting::eye, "eye"},
    {Setting::flip, "flip"},
    {Setting::focus, "focus"},
    {Setting::force, "force"},
    {Setting::glass, "glass"},
    {Setting::layout, "layout"},
    {Setting::light_group, "light-group"},
    {Setting::max_contacts, "max-contacts"},
    {Setting::max_edge, "max-edge"},
    {Setting::reflectance_limit, "max-reflectance"},
    {Setting::memory, "memory"},
    {Setting::method, "method"},
    {Setting::min_factor, "min-factor"},
    {Setting::one_sided, "one-sided"},
    {Setting::orient, "orient"},
    {Setting::rays, "rays"},
    {Setting::scale, "scale"},
    {Setting::seed, "seed"},
    {Setting::sky, "sky"},
    {Setting::spectral, "spectral"},
    {Setting::target, "target"},
    {Setting::texels_per_metre, "texels-per-metre"},
    {Setting::weld, "weld"},
};

}  // namespace

std::string_view option_of(Setting setting) {
  const auto found = std::find_if(std::begin(options), std::end(options),
                                  [&](const SettingOption& o) { return o.setting == setting; });
  return found == std::end(options) ? std::string_view() : found->option;
}

}  // namespace luxel
