// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/luminaire_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/patch/lamp_surfaces.h"

namespace luxel {
namespace {

constexpr double min_drawn = 0.1;  // m: smaller openings are drawn so large
constexpr int round_corners = 24;  // of an ellipse

bool is_round(OpeningShape shape) {
  return shape == OpeningShape::point || shape == OpeningShape::ellipse ||
         shape == OpeningShape::vertical_cylinder || shape == OpeningShape::ellipsoid;
}

std::vector<PlanPoint> drawn_opening(const PointLight& light, const Vec3d& position, const PlanAxes& axes) {
  const auto& opening = light.photometry->opening;
  const auto along_x = axes.in_plan(Vec3d(light.local_x));
  const auto along_y = axes.in_plan(Vec3d(light.local_y));
  const PlanPoint at(position.x, position.y);
  const auto half_x = 0.5 * std::max(min_drawn, opening.size.x) * PlanPoint(along_x.x, along_x.y);
  const auto half_y = 0.5 * std::max(min_drawn, opening.size.y) * PlanPoint(along_y.x, along_y.y);
  if (!is_round(opening.shape))
    return {at - half_x - half_y, at + half_x - half_y, at + half_x + half_y, at - half_x + half_y};
  std::vector<PlanPoint> corners;
  for (int i = 0; i < round_corners; ++i) {
    const auto angle = 2.0 * std::numbers::pi * i / round_corners;
    corners.push_back(at + std::cos(angle) * half_x + std::sin(angle) * half_y);
  }
  return corners;
}

std::size_t type_of(const PointLight& light, std::vector<LuminaireType>& types) {
  const double dimming = static_cast<double>(light.dimming);
  const double maintenance = static_cast<double>(light.maintenance);
  for (std::size_t t = 0; t < types.size(); ++t)
    if (types[t].photometry == light.photometry && types[t].dimming == dimming &&
        types[t].maintenance == maintenance)
      return t;
  types.push_back({light.photometry, 0, dimming, maintenance, {}, {}});
  return types.size() - 1;
}

void add_ugr_table(LuminaireType& type) {
  try {
    type.ugr = ugr_table(*type.photometry);
  } catch (const InputError& error) {
    type.why_no_ugr = error.what();
  }
}

void add_totals(LuminaireList& list) {
  double watts = 0.0;
  bool is_known = !list.types.empty();
  for (const auto& type : list.types) {
    const auto count = static_cast<double>(type.count);
    list.flux += count * type.flux();
    if (const auto of_one = type.watts())
      watts += count * *of_one;
    else
      is_known = false;
  }
  if (is_known) list.watts = watts;
}

}  // namespace

std::optional<double> LuminaireType::watts() const {
  const auto* lamp = photometry->lamp();
  if (lamp == nullptr || !(lamp->watts > 0.0)) return std::nullopt;
  return lamp->watts;
}

std::string LuminaireType::name() const {
  return photometry->luminaire.empty() ? std::filesystem::path(photometry->file).filename().string()
                                       : photometry->luminaire;
}

LuminaireList list_luminaires(const PatchSet& patches, const PlanAxes& axes) {
  LuminaireList list;
  for (const auto& lamp : patches.point_lights) {
    const auto& light = lamp.light;
    if (light.kind != PointLightKind::luminaire) {
      ++list.other_lights;
      continue;
    }
    PlacedLuminaire placed;
    placed.type = type_of(light, list.types);
    ++list.types[placed.type].count;
    placed.position = axes.in_plan(patches.in_file(light.position));
    const auto x = axes.in_plan(Vec3d(light.local_x));
    placed.turn = std::atan2(x.y, x.x) * 180.0 / std::numbers::pi;
    placed.opening = drawn_opening(light, placed.position, axes);
    list.placed.push_back(std::move(placed));
  }
  for (auto& type : list.types) add_ugr_table(type);
  list.lamp_surfaces = find_lamp_surfaces(patches).size();
  add_totals(list);
  return list;
}

std::string text_of(const LuminousOpening& opening) {
  constexpr std::array names = {"point",
                                "rectangle",
                                "ellipse",
                                "box",
                                "upright cylinder",
                                "cylinder along X",
                                "cylinder along Y",
                                "ellipsoid",
                                "upright disk"};
  std::string text = names[static_cast<std::size_t>(opening.shape)];
  if (opening.shape == OpeningShape::point) return text;
  text += fmt::format(", {:.3g} × {:.3g}", opening.size.x, opening.size.y);
  if (opening.size.z > 0.0) text += fmt::format(" × {:.3g}", opening.size.z);
  return text + " m";
}

}  // namespace luxel
