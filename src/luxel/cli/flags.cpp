// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/flags.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

namespace luxel {
namespace {

struct Flag {
  Setting setting;
  std::string_view option;
};

constexpr Flag flags[] = {
    {Setting::bands, "--bands"},
    {Setting::contacts, "--contacts"},
    {Setting::eye, "--eye"},
    {Setting::flip, "--flip"},
    {Setting::focus, "--focus"},
    {Setting::force, "--force"},
    {Setting::glass, "--glass"},
    {Setting::light_group, "--light-group"},
    {Setting::max_edge, "--max-edge"},
    {Setting::reflectance_limit, "--max-reflectance"},
    {Setting::memory, "--memory"},
    {Setting::method, "--method"},
    {Setting::min_factor, "--min-factor"},
    {Setting::one_sided, "--one-sided"},
    {Setting::orient, "--orient"},
    {Setting::rays, "--rays"},
    {Setting::scale, "--scale"},
    {Setting::seed, "--seed"},
    {Setting::sky, "--sky"},
    {Setting::spectral, "--spectral"},
    {Setting::target, "--target"},
    {Setting::weld, "--weld"},
};

}  // namespace

std::string flag_of(const Hint& hint) {
  const auto flag = std::find_if(std::begin(flags), std::end(flags),
                                 [&](const Flag& f) { return f.setting == hint.setting; });
  if (flag == std::end(flags)) return {};
  return hint.value.empty() ? std::string(flag->option) : fmt::format("{} {}", flag->option, hint.value);
}

std::string with_flags(const std::string& sentence, const std::vector<Hint>& hints) {
  if (hints.empty()) return sentence;
  std::string text;
  for (const auto& hint : hints) text += (text.empty() ? "" : ", ") + flag_of(hint);
  return fmt::format("{} ({})", sentence, text);
}

std::string with_flags(const std::exception& error) { return with_flags(error.what(), hints_of(error)); }

}  // namespace luxel
