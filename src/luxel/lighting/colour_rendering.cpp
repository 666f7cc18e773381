// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/colour_rendering.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

#include "luxel/patch/lamp_surfaces.h"

namespace luxel {
namespace {

struct Group {
  std::string_view name;
  double low, high;
};

constexpr std::array<Group, 6> groups = {
    {{"1A", 90, 100}, {"1B", 80, 89}, {"2A", 70, 79}, {"2B", 60, 69}, {"3", 40, 59}, {"4", 20, 39}}};

Figure figure_of(double low, double high) { return {low, low, high}; }

// The file that does not state Ra; empty: all do. least: of those that do.
std::string find_least(const PatchSet& patches, std::optional<Figure>& least) {
  std::string silent;
  for (const auto& lamp : patches.point_lights) {
    if (lamp.light.kind != PointLightKind::luminaire) continue;
    const auto* set = lamp.light.photometry->lamp();
    const auto Ra = set == nullptr ? std::nullopt : colour_rendering_of(set->colour_rendering);
    if (!Ra)
      silent = std::filesystem::path(lamp.light.photometry->file).filename().string();
    else if (!least || Ra->low < least->low)
      least = Ra;
  }
  return silent;
}

}  // namespace

std::optional<Figure> colour_rendering_of(const std::string& text) {
  std::string word;
  for (const char c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.')
      word += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    else if (!word.empty() && word != "RA" && word != "CRI")
      break;
  for (const std::string_view prefix : {"RA", "CRI"})
    if (word.starts_with(prefix)) word.erase(0, prefix.size());
  for (const auto& group : groups)
    if (word == group.name) return figure_of(group.low, group.high);
  double value = 0.0;
  const auto* end = word.data() + word.size();
  const auto read = std::from_chars(word.data(), end, value);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  constexpr double min_index = 20.0, max_index = 100.0;
  if (value >= min_index && value <= max_index) return figure_of(value, value);
  constexpr double min_code = 700.0, max_code = 999.0;  // "840": tens of Ra, hundreds of kelvin
  if (value < min_code || value > max_code) return std::nullopt;
  const auto tens = 10.0 * static_cast<double>(static_cast<int>(value) / 100);
  return figure_of(tens, tens + 9.0);
}

Verdict judge_colour_rendering(const PatchSet& patches, double required) {
  std::optional<Figure> least;
  const auto silent = find_least(patches, least);
  auto verdict = judge("Ra", least.value_or(Figure{}), required);
  if (least && verdict.compliance == Compliance::not_met) {
    verdict.note = "least of the luminaires";
    return verdict;
  }
  const auto unknown = [&](std::string note) {
    verdict.compliance = Compliance::not_known;
    verdict.more_rays = verdict.solution_factor = std::nullopt;
    verdict.note = std::move(note);
    return verdict;
  };
  if (!silent.empty()) return unknown(fmt::format("the file {} does not state it", silent));
  if (!least) return unknown("there are no luminaires with photometric files");
  if (!find_lamp_surfaces(patches).empty()) return unknown("the scene has surfaces that emit");
  if (verdict.compliance == Compliance::cannot_be_told)
    return unknown(fmt::format("the files state {:g} to {:g}", least->low, least->high));
  verdict.note = "least of the luminaires";
  return verdict;
}

}  // namespace luxel
