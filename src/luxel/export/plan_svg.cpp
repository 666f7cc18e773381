// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/plan_svg.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "luxel/export/floor_outline.h"
#include "luxel/export/svg_sheet.h"
#include "luxel/lighting/svg_parts.h"

namespace luxel {
namespace {

constexpr const char* dimension_line = "stroke=\"#666\" stroke-width=\"1\"";
constexpr const char* halo =
    "stroke=\"#fff\" stroke-width=\"3\" paint-order=\"stroke\" stroke-linejoin=\"round\"";

std::string luminaire_svg(const PlacedLuminaire& luminaire, std::size_t number, const SvgSheet& sheet) {
  auto low = sheet.at(luminaire.opening[0]), high = low;
  for (const auto& corner : luminaire.opening) {
    low = glm::min(low, sheet.at(corner));
    high = glm::max(high, sheet.at(corner));
  }
  const auto text = fmt::format("{}", number);
  constexpr double digit = 0.75, min_size = 7.0;  // width over the text size; units
  const auto digits = digit * static_cast<double>(text.size());
  const auto size = high - low;
  const auto inside = std::min({SvgSheet::text_size, size.x / digits, size.y});
  const auto letters = inside >= min_size ? inside : SvgSheet::text_size;
  const auto needed = digits * letters;
  auto at = 0.5 * (low + high);
  if (inside < min_size) {  // beside it or below it
    if (size.y > size.x)
      at.x = high.x + 0.5 * needed + 2.0;
    else
      at.y = high.y + 0.7 * SvgSheet::text_size;
  }
  return fmt::format("<path d=\"{}\" fill=\"#ffe79a\" stroke=\"#6b5200\" stroke-width=\"1\"/>\n",
                     sheet.path_of(luminaire.opening)) +
         svg_text(at, text, letters, halo);
}

std::string observer_svg(const PlanObserver& observer, const SvgSheet& sheet) {
  const auto eye = sheet.at({observer.eye.x, observer.eye.y});
  const PlanPoint view(observer.view.x, -observer.view.y), aside(-view.y, view.x);
  const auto tip = eye + 26.0 * view, neck = eye + 18.0 * view;
  auto svg = svg_line(eye, neck, "stroke=\"#1f5fa8\" stroke-width=\"2\"");
  svg += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\" fill=\"#1f5fa8\"/>\n", tip.x,
                     tip.y, neck.x + 5.0 * aside.x, neck.y + 5.0 * aside.y, neck.x - 5.0 * aside.x,
                     neck.y - 5.0 * aside.y);
  return svg + svg_text(eye + 12.0 * view + 13.0 * aside, observer.name, SvgSheet::text_size,
                        std::string("fill=\"#1f5fa8\" font-weight=\"bold\" ") + halo);
}

std::string dimensions(const PlanPoint& size, const SvgSheet& sheet) {
  const auto top = sheet.bottom() - sheet.scale() * size.y;
  const auto y = sheet.bottom() + 14.0, x = sheet.left() - 14.0;
  auto svg = svg_line({sheet.left(), y}, {sheet.right(), y}, dimension_line);
  for (const auto end : {sheet.left(), sheet.right()})
    svg += svg_line({end, y - 4.0}, {end, y + 4.0}, dimension_line);
  svg += svg_text({0.5 * (sheet.left() + sheet.right()), y}, fmt::format("{:.2f} m", size.x),
                  SvgSheet::text_size, halo);
  svg += svg_line({x, top}, {x, sheet.bottom()}, dimension_line);
  for (const auto end : {top, sheet.bottom()})
    svg += svg_line({x - 4.0, end}, {x + 4.0, end}, dimension_line);
  const auto middle = 0.5 * (top + sheet.bottom());
  return svg + svg_text({x, middle}, fmt::format("{:.2f} m", size.y), SvgSheet::text_size,
                        fmt::format("transform=\"rotate(-90 {:.1f} {:.1f})\" {}", x, middle, halo));
}

std::string scale_bar(const SvgSheet& sheet) {
  const auto length = round_length(0.25 * (sheet.right() - sheet.left()) / sheet.scale());  // m
  const auto y = sheet.bottom() + 36.0, end = sheet.left() + length * sheet.scale();
  return svg_line({sheet.left(), y}, {end, y}, "stroke=\"#222\" stroke-width=\"3\"") +
         svg_text({end + 22.0, y}, fmt::format("{:g} m", length), SvgSheet::text_size);
}

}  // namespace

std::string plan_svg(const RoomData& room, const LuminaireList& luminaires,
                     const std::vector<PlanObserver>& observers) {
  const auto [low, high] = box_of(room.outline);
  const SvgSheet sheet(low, high, 52.0);
  auto svg = sheet.begin("Plan of the room with its luminaires");
  for (const auto& loop : room.outline)
    svg += fmt::format("<path d=\"{}\" fill=\"#fafafa\" stroke=\"#222\" stroke-width=\"2\"/>\n",
                       sheet.path_of(loop));
  for (std::size_t i = 0; i < luminaires.placed.size(); ++i)
    svg += luminaire_svg(luminaires.placed[i], i + 1, sheet);
  for (const auto& observer : observers) svg += observer_svg(observer, sheet);
  return svg + dimensions(high - low, sheet) + scale_bar(sheet) + "</svg>\n";
}

}  // namespace luxel
