// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/ugr_settings.h"

#include <array>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/runs/quantity.h"

namespace luxel {
namespace {

std::string text_of(const Vec3d& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }

Vec3d parse_direction(const char* option, const std::string& text) {
  const auto direction = parse_three(text);
  if (!direction || !(glm::length(*direction) > 0.0))
    throw UsageError(
        fmt::format("{}: expected a direction dx,dy,dz that is not 0,0,0, not '{}'", option, text));
  return glm::normalize(*direction);
}

}  // namespace

void UgrSettings::declare(OptionSet& set) {
  set.heading("Observers");
  Declaration observer{
      "observer", "EYE:DIRECTION",
      "an observer: its eye, m, and where it looks, such as 2,0.3,1.2:0,1,0; repeatable",
      [this](const std::string& text) {
        const auto colon = text.find(':');
        const auto eye = parse_three(text.substr(0, colon));
        if (colon == std::string::npos || !eye)
          throw UsageError(fmt::format(
              "--observer: expected an eye and a direction x,y,z:dx,dy,dz such as 2,0.3,1.2:0,1,0, not '{}'",
              text));
        observers.add(*eye, parse_direction("--observer", text.substr(colon + 1)));
      },
      [this] {
        std::string text;
        for (std::size_t i = 0; i < observers.position.size(); ++i)
          text += fmt::format("{}{}:{}", i == 0 ? "" : "\n", text_of(observers.position[i]),
                              text_of(observers.normal[i]));
        return text;
      }};
  observer.many = true;
  set.add(std::move(observer));
  set.add_text("observers", "FILE", file,
               "CSV file of observers: x,y,z,nx,ny,nz on each line: the eye, m, and where it looks; a first "
               "line with these names may select columns");
  set.add({"grid", "CORNER:CORNER:CORNER:NxM",
           "observers on a parallelogram, in the middles of its cells, as for probe; each looks in all "
           "directions of --view",
           [this](const std::string& text) {
             grid = parse_grid(text);
             if (!grid && !text.empty())
               throw UsageError(fmt::format(
                   "--grid: expected three corners that are not on a line and a number of cells, such "
                   "as 0,0,1.2:4,0,1.2:0,3,1.2:4x3, not '{}'",
                   text));
           },
           [this] {
             return grid ? fmt::format("{}:{}:{}:{}x{}", text_of(grid->corner), text_of(grid->first),
                                       text_of(grid->second), grid->columns, grid->rows)
                         : std::string();
           }});
  Declaration view{"view", "dx,dy,dz",
                   "--grid: where its observers look; repeatable; without it both ways along both sides",
                   [this](const std::string& text) { views.push_back(parse_direction("--view", text)); },
                   [this] {
                     std::string text;
                     for (const auto& v : views) text += (text.empty() ? "" : "\n") + text_of(v);
                     return text;
                   }};
  view.many = true;
  set.add(std::move(view));
  set.heading("Requirements");
  set.add_number("require-ugr", "UGR", require_ugr, 0.0, 100.0,
                 "largest UGR that observers may have, such as 19; 0: none");
  set.add_text(
      "areas", "FILE", areas,
      "TOML or glTF file of calculation areas: the UGR that they require is judged by the observers in them");
  set.add_texts("requirements", "FILE", requirements,
                "--areas: TOML file with more [requirement.NAME] tables; may be repeated");
  set.heading("Light");
  set.add_fraction("error", glare.error,
                   "standard error of the background's sampling per observer, relative, such as 2% or 0.02");
  set.add_number("rays", "count", glare.max_rays, 1024u, 1u << 30,
                 "maximum number of cosine rays per observer, for the background");
  set.add_number("lamp-rays", "count", glare.lamp_rays, 1u, 65536u,
                 "shadow rays per observer and lamp, which find how much of it is visible");
  set.add_count("seed", glare.seed, "seed of the random numbers; other seeds give independent errors");
}

void UgrSettings::check() const {
  if (observers.position.empty() && file.empty() && !grid)
    throw UsageError("no observers: give --observer EYE:DIRECTION, --observers FILE or --grid");
  if (!requirements.empty() && areas.empty()) throw UsageError("--requirements belongs to --areas");
  if (!views.empty() && !grid) throw UsageError("--view belongs to --grid");
}

PointList UgrSettings::all() const {
  auto list = observers;
  if (!file.empty()) {
    const auto of_file = read_points(file, Vec3d(0.0));
    for (std::size_t i = 0; i < of_file.position.size(); ++i) {
      if (!(glm::length(of_file.normal[i]) > 0.0))
        throw InputError(file,
                         "expected where observers look: x,y,z,nx,ny,nz on each line, or columns nx, ny, nz");
      list.add(of_file.position[i], of_file.normal[i]);
    }
  }
  if (grid) {
    auto directions = views;
    if (directions.empty())
      for (const auto& side : {grid->first - grid->corner, grid->second - grid->corner})
        for (const double sign : {1.0, -1.0})
          directions.push_back(sign * glm::normalize(side) + Vec3d(0.0));  // no -0
    const auto eyes = points_of(*grid, Vec3d(0.0, 0.0, 1.0));
    for (const auto& eye : eyes.position)
      for (const auto& direction : directions) list.add(eye, direction);
  }
  return list;
}

}  // namespace luxel
