// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/photometry_text.h"

#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace luxel {
namespace {

using Json = nlohmann::ordered_json;

// Relative difference of the two fluxes from which on the text has both.
constexpr double notable = 0.005;

const char* name(OpeningShape shape) {
  switch (shape) {
    case OpeningShape::point:
      return "point";
    case OpeningShape::rectangle:
      return "rectangle";
    case OpeningShape::ellipse:
      return "ellipse";
    case OpeningShape::box:
      return "box";
    case OpeningShape::vertical_cylinder:
      return "vertical cylinder";
    case OpeningShape::cylinder_along_x:
      return "cylinder along X";
    case OpeningShape::cylinder_along_y:
      return "cylinder along Y";
    case OpeningShape::ellipsoid:
      return "ellipsoid";
    case OpeningShape::vertical_disk:
      return "vertical disk";
  }
  return "point";
}

const char* name(GoniometerType type) {
  return type == GoniometerType::c ? "C" : type == GoniometerType::b ? "B" : "A";
}

std::string shape_as_text(const LuminousOpening& opening) {
  const auto& s = opening.size;
  switch (opening.shape) {
    case OpeningShape::point:
      return "a point";
    case OpeningShape::rectangle:
      return fmt::format("{:.4g} m along X, {:.4g} m along Y", s.x, s.y);
    case OpeningShape::ellipse:
      if (s.x == s.y) return fmt::format("a disk of {:.4g} m", s.x);
      return fmt::format("an ellipse, {:.4g} m along X, {:.4g} m along Y", s.x, s.y);
    default:
      return fmt::format("{}, {:.4g} m along X, {:.4g} m along Y, {:.4g} m high", name(opening.shape), s.x,
                         s.y, s.z);
  }
}

std::string line(const char* label, const std::string& text) {
  return text.empty() ? std::string() : fmt::format("  {:<18} {}\n", label, text);
}

std::string lamp_as_text(const LampSet& lamp) {
  auto text = fmt::format("{:g} x {}", lamp.count, lamp.name.empty() ? "lamp" : lamp.name);
  if (lamp.flux > 0.0) text += fmt::format(", {:.6g} lm", lamp.flux);
  if (lamp.watts > 0.0) text += fmt::format(", {:g} W", lamp.watts);
  if (!lamp.colour.empty() && lamp.colour != "0") text += ", colour " + lamp.colour;
  if (!lamp.colour_rendering.empty() && lamp.colour_rendering != "0") text += ", Ra " + lamp.colour_rendering;
  return text;
}

std::optional<double> efficiency_of(const Photometry& p) {
  const auto* lamp = p.lamp();
  if (p.absolute || !lamp || !(lamp->flux > 0.0)) return std::nullopt;
  return p.intensity.zonal_flux() / lamp->flux;
}

std::optional<double> efficacy_of(const Photometry& p) {
  const auto* lamp = p.lamp();
  if (!lamp || !(lamp->watts > 0.0)) return std::nullopt;
  return p.intensity.zonal_flux() / lamp->watts;
}

std::string plane_as_text(const PlaneFigures& plane) {
  if (!(plane.maximum > 0.0)) return "no light";
  return fmt::format("beam {:.1f}°, field {:.1f}°, maximum {:.5g} cd", plane.beam_angle, plane.field_angle,
                     plane.maximum);
}

Json plane_as_json(const std::string& plane, const PlaneFigures& figures) {
  return {{"plane", plane},
          {"beam_angle", figures.beam_angle},
          {"field_angle", figures.field_angle},
          {"maximum", figures.maximum}};
}

Json number_or_null(const std::optional<double>& number) { return number ? Json(*number) : Json(nullptr); }

}  // namespace

std::string PhotometryText::as_text() const {
  const auto& p = *photometry;
  const auto& i = p.intensity;
  const auto zonal = i.zonal_flux(), linear = i.linear_flux();
  auto flux = fmt::format("{:.2f} lm", zonal);
  if (std::abs(linear - zonal) > notable * zonal)
    flux += fmt::format(" by the zonal rule; {:.2f} lm if intensity is linear between the angles", linear);
  auto text = fmt::format("{}: {}, type {}, {} photometry\n", p.file, p.format, name(i.type()),
                          p.absolute ? "absolute" : "relative");
  text += line("luminous flux", flux);
  if (const auto efficiency = efficiency_of(p))
    text += line("efficiency",
                 fmt::format("{:.1f} % of the lamps' {:.6g} lm", 100.0 * *efficiency, p.lamp()->flux));
  if (const auto efficacy = efficacy_of(p)) text += line("efficacy", fmt::format("{:.1f} lm/W", *efficacy));
  text += line("downwards", fmt::format("{:.1f} % of the flux", 100.0 * figures.downward_fraction));
  const bool is_c = i.type() == GoniometerType::c;
  text += line("maximum", fmt::format("{:.6g} cd at {} {:g}, {} {:g}", i.maximum(), is_c ? "gamma" : "V",
                                      figures.vertical, is_c ? "C" : "H", figures.horizontal));
  text += line(name_of_plane(i.type(), MainPlane::x).c_str(), plane_as_text(figures.x));
  text += line(name_of_plane(i.type(), MainPlane::y).c_str(), plane_as_text(figures.y));
  text += line("opening", shape_as_text(p.opening));
  text += line("maker", p.maker) + line("luminaire", p.luminaire) + line("catalogue", p.catalogue) +
          line("test report", p.test_report);
  for (std::size_t k = 0; k < p.lamps.size(); ++k) {
    const auto label = p.lamps.size() == 1 ? std::string("lamps") : fmt::format("lamp set {}", k + 1);
    text += line(label.c_str(),
                 lamp_as_text(p.lamps[k]) + (p.lamps.size() > 1 && k == p.lamp_set ? " (used)" : ""));
  }
  return text;
}

std::string PhotometryText::as_json() const {
  const auto& p = *photometry;
  const auto& i = p.intensity;
  Json lamps = Json::array();
  for (const auto& lamp : p.lamps)
    lamps.push_back({{"count", lamp.count},
                     {"flux", lamp.flux},
                     {"watts", lamp.watts},
                     {"name", lamp.name},
                     {"colour", lamp.colour},
                     {"colour_rendering", lamp.colour_rendering}});
  Json json = {
      {"command", "photometry"},
      {"file", p.file},
      {"format", p.format},
      {"luminous_flux", i.zonal_flux()},
      {"linear_flux", i.linear_flux()},
      {"efficiency", number_or_null(efficiency_of(p))},
      {"efficacy", number_or_null(efficacy_of(p))},
      {"downward_fraction", figures.downward_fraction},
      {"maximum",
       {{"intensity", i.maximum()},
        {"vertical_angle", figures.vertical},
        {"horizontal_angle", figures.horizontal}}},
      {"planes",
       {plane_as_json(name_of_plane(i.type(), MainPlane::x), figures.x),
        plane_as_json(name_of_plane(i.type(), MainPlane::y), figures.y)}},
      {"type", name(i.type())},
      {"absolute", p.absolute},
      {"vertical_angles", i.vertical().size()},
      {"horizontal_angles", i.horizontal().size()},
      {"opening",
       {{"shape", name(p.opening.shape)}, {"size", {p.opening.size.x, p.opening.size.y, p.opening.size.z}}}},
      {"maker", p.maker},
      {"luminaire", p.luminaire},
      {"catalogue", p.catalogue},
      {"test_report", p.test_report},
      {"lamps", lamps},
      {"lamp_set", p.lamps.empty() ? 0 : p.lamp_set + 1},
      {"header_flux", p.header_flux > 0.0 ? Json(p.header_flux) : Json(nullptr)},
      {"warnings", p.warnings},
      {"outputs", output.empty() ? Json::array() : Json::array({output})}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace luxel
